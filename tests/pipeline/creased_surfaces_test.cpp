// Patterns of parts with flat faces and sharp edges: a wave for every face at a vertex.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/frequency_field.h"
#include "brindle/normals.h"
#include "brindle/pattern_warnings.h"
#include "brindle/quality.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"
#include "brindle/stripe_tracer.h"
#include "brindle/threads.h"
#include "brindle/windings.h"
#include "extruded.h"

namespace brindle {
namespace {

struct Part {
  std::string name;
  Mesh mesh;
};

std::vector<Part> parts() {
  return {{"box", extruded(square_round(4, 1), 2)},
          {"prism", extruded(toothed_circle(6, 1), 2)},
          {"gear with 24 teeth", extruded(toothed_circle(48, 1, 0.85f), 0.3f)},
          {"plate with a hole", extruded_ring(square_round(32, 3), toothed_circle(32, 1), 0.4f)}};
}

StripePattern stripes_along(const Surface& surface, const Vec3& axis, float stripes,
                            const StripeOptions& options = {}) {
  return stripe_pattern(surface, projected_direction_field(axis, surface.normals),
                        frequency_of_stripes(stripes, bounding_box(surface.mesh).diagonal()),
                        options);
}

/// Of the triangles of faces that look up or down.
float largest_error_of_caps(const Surface& surface, const StripePattern& pattern) {
  const std::vector<float> errors = angle_errors_deg(surface.mesh, pattern.waves, pattern.corners);
  float largest = 0;
  for (std::size_t t = 0; t < errors.size(); ++t) {
    if (std::abs(surface.normals[surface.mesh.triangles[t][0]].z()) < 0.9f) continue;
    largest = std::max(largest, errors[t]);
  }
  return largest;
}

AnimatorOptions from_scratch() {
  AnimatorOptions options;
  options.lambda = 0;
  return options;
}

class CreasedPart : public testing::TestWithParam<int> {
 protected:
  Part part = parts()[static_cast<std::size_t>(GetParam())];
  Surface surface = with_creases(part.mesh);
};

// Its edges are longer than a period, and its waves exact along them.
TEST_P(CreasedPart, IsNotWarnedOf) {
  const StripePattern pattern = stripes_along(surface, {1, 0, 0}, 40);
  const WaveMetrics metrics = measure_waves(surface, pattern.waves);
  EXPECT_LT(metrics.edges_per_period_median, 2);
  EXPECT_EQ(quality_warnings(metrics, pattern.quality, surface.mesh.triangle_count()),
            std::vector<std::string>{});
}

TEST_P(CreasedPart, HasStraightStripesAlongItsFaces) {
  for (const float stripes : {20.0f, 40.0f, 100.0f}) {
    const StripePattern pattern = stripes_along(surface, {1, 0, 0}, stripes);
    EXPECT_EQ(pattern.quality.branches, 0u) << part.name << stripes;
    EXPECT_LT(pattern.quality.angle_error_mean_deg, 0.5) << part.name << stripes;
    EXPECT_LT(largest_error_of_caps(surface, pattern), 0.5f) << part.name << stripes;
  }
}

TEST_P(CreasedPart, IsTheSameAsAPhaseGraphAndWhicheverWayDirectionsPoint) {
  const StripePattern direct = stripes_along(surface, {1, 2, 3}, 20);
  StripeOptions as_graph;
  as_graph.solve = solve_phases;
  const StripePattern graph = stripes_along(surface, {1, 2, 3}, 20, as_graph);
  EXPECT_NEAR(direct.solution.energy, graph.solution.energy, 1e-3);
  EXPECT_EQ(direct.quality.branches, graph.quality.branches);
  DirectionField field = projected_direction_field({1, 2, 3}, surface.normals);
  for (std::size_t v = 0; v < field.size(); v += 3) field[v] = -field[v];
  const StripePattern turned = stripe_pattern(
      surface, field, frequency_of_stripes(20, bounding_box(surface.mesh).diagonal()));
  EXPECT_NEAR(turned.solution.energy, direct.solution.energy, 1e-3);
  EXPECT_EQ(turned.quality.branches, direct.quality.branches);
}

TEST_P(CreasedPart, HasOtherSolversThatAgree) {
  const StripePattern direct = stripes_along(surface, {1, 0, 0}, 20);
  for (const Solver solver : {Solver::averaged, Solver::relaxation}) {
    StripeOptions options;
    options.solver.solver = solver;
    EXPECT_LE(stripes_along(surface, {1, 0, 0}, 20, options).quality.angle_error_mean_deg,
              direct.quality.angle_error_mean_deg + 3)
        << part.name << name_of(solver);
  }
}

TEST_P(CreasedPart, HasACalmSmoothField) {
  const DirectionField field = smooth_direction_field(surface);
  const StripePattern pattern = stripe_pattern(
      surface, field, frequency_of_stripes(40, bounding_box(surface.mesh).diagonal()));
  EXPECT_EQ(pattern.quality.branches, 0u) << part.name;
  // On flat faces it is constant.
  for (const Triangle& t : surface.mesh.triangles) {
    if (std::abs(surface.normals[t[0]].z()) < 0.9f) continue;
    EXPECT_GT(std::abs(field[t[0]].dot(field[t[1]])), 0.99f) << part.name;
  }
}

TEST_P(CreasedPart, MovesAsARigidBody) {
  StripeAnimator animator(surface, from_scratch());
  const DirectionField field = projected_direction_field({1, 2, 3}, surface.normals);
  const FrequencyField frequencies = constant_frequency_field(
      frequency_of_stripes(20, bounding_box(surface.mesh).diagonal()), surface.mesh.vertex_count());
  const FrameResult first = animator.frame({surface.mesh.positions, field, frequencies});
  const std::vector<Complex> still(first.z.begin(), first.z.end());
  const double energy = animator.energy();
  // A third of a turn exchanges axes exactly.
  const auto turned = [](std::vector<Vec3> vectors) {
    for (Vec3& v : vectors) v = {v.z(), v.x(), v.y()};
    return vectors;
  };
  animator.restart();
  const std::vector<Vec3> positions = turned(surface.mesh.positions), directions = turned(field);
  animator.frame({positions, directions, frequencies});
  EXPECT_NEAR(animator.energy(), energy, 1e-3) << part.name;
}

TEST_P(CreasedPart, FramesAreStills) {
  StripeAnimator animator(surface, from_scratch());
  const StripePattern still = stripes_along(surface, {1, 2, 3}, 20);
  animator.frame({still.waves.positions, still.waves.directions, still.waves.frequencies});
  EXPECT_NEAR(animator.energy(), still.solution.energy, 1e-3) << part.name;
}

INSTANTIATE_TEST_SUITE_P(Parts, CreasedPart, testing::Range(0, 4),
                         [](const auto& tested) { return "Part" + std::to_string(tested.param); });

// What one wave a vertex makes of the same: else the tests above would show nothing.
TEST(CreasedParts, SwirlWithoutCreases) {
  for (const std::size_t i : {std::size_t{2}, std::size_t{3}}) {
    const StripePattern pattern = stripes_along(make_surface(parts()[i].mesh), {1, 0, 0}, 40);
    EXPECT_GT(pattern.quality.branches, 10u) << parts()[i].name;
    EXPECT_GT(pattern.quality.angle_error_mean_deg, 1) << parts()[i].name;
  }
}

// Along x all faces of a plate ask for the same spacing along their edges, but the wall of the
// hole.
TEST(CreasedParts, HaveStripesThatMeetAtTheirEdges) {
  const Surface surface = with_creases(parts()[3].mesh);
  for (const float stripes : {13.0f, 20.0f, 40.0f}) {
    const StripePattern pattern = stripes_along(surface, {1, 0, 0}, stripes);
    const auto slip = crease_slip(surface, pattern.waves, pattern.solution.z);
    ASSERT_TRUE(slip);
    EXPECT_LT(slip->share, 0.15) << stripes;
    StripeAnimator animator(surface);
    const FrameResult frame = animator.frame(
        {pattern.waves.positions, pattern.waves.directions, pattern.waves.frequencies});
    EXPECT_LT(crease_slip(surface, pattern.waves, frame.z)->share, 0.15) << stripes;
  }
}

bool is_in_flat_face(const Surface& surface, const Triangle& triangle) {
  const Vec3 normal = triangle_normal(surface.mesh, triangle);
  return std::all_of(triangle.begin(), triangle.end(),
                     [&](Index v) { return (surface.normals[v] - normal).norm() < 1e-5f; });
}

TEST(CreasedShapes, HaveNoBranchesOnFlatFaces) {
  for (const std::string shape : {"bracket", "gear"}) {
    for (const int times : {0, 2}) {
      const Surface surface = with_creases(subdivide(make_shape(shape), times));
      for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(1, 2, 3)}) {
        const StripePattern pattern = stripes_along(surface, axis, 40);
        EXPECT_LT(pattern.quality.angle_error_mean_deg, 1.5) << shape << times << axis.y();
        for (std::size_t t = 0; t < pattern.corners.size(); ++t) {
          if (!is_in_flat_face(surface, surface.mesh.triangles[t])) continue;
          EXPECT_FALSE(is_branch(pattern.corners[t].kind)) << shape << times << axis.y();
        }
      }
    }
  }
}

/// A row of square plates with a hole each, sewn together.
Mesh plate_with_holes(int holes) {
  Mesh plate;
  for (int k = 0; k < holes; ++k) {
    Mesh cell = extruded_ring(square_round(16, 1), toothed_circle(16, 0.5f), 0.4f);
    const auto first = static_cast<Index>(plate.vertex_count());
    for (const Vec3& p : cell.positions) {
      const Vec3 moved = p + Vec3(2 * static_cast<float>(k), 0, 0);
      plate.positions.push_back((64 * moved).array().round().matrix() / 64);
    }
    const auto is_seam = [&](const Triangle& t) {
      const auto all_at = [&](float x) {
        return std::all_of(t.begin(), t.end(),
                           [&](Index v) { return std::abs(cell.positions[v].x() - x) < 1e-3f; });
      };
      return (k > 0 && all_at(-1)) || (k + 1 < holes && all_at(1));
    };
    for (const Triangle& t : cell.triangles) {
      if (!is_seam(t)) plate.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
  }
  repair_mesh(plate);
  return plate;
}

/// Vertices on creases.
std::vector<bool> on_creases(const Surface& surface) {
  std::vector<bool> found(surface.mesh.vertex_count());
  for (const CreaseEdge& edge : surface.creases.edges) {
    for (const Index v : edge.first) found[v] = true;
    for (const Index v : edge.second) found[v] = true;
  }
  return found;
}

/// Triangles of faces that are flat as a whole, away from creases.
std::vector<std::size_t> inside_of_flat_faces(const Surface& surface) {
  std::vector<Index> face(surface.mesh.vertex_count());
  std::iota(face.begin(), face.end(), Index{0});
  for (bool changed = true; changed;) {
    changed = false;
    for (const Triangle& t : surface.mesh.triangles) {
      const Index first = std::min({face[t[0]], face[t[1]], face[t[2]]});
      for (const Index v : t) {
        changed = changed || face[v] != first;
        face[v] = first;
      }
    }
  }
  std::vector<bool> is_bent(surface.mesh.vertex_count());
  for (const Triangle& triangle : surface.mesh.triangles) {
    if (!is_in_flat_face(surface, triangle)) is_bent[face[triangle[0]]] = true;
  }
  const std::vector<bool> on_crease = on_creases(surface);
  std::vector<std::size_t> found;
  for (std::size_t t = 0; t < surface.mesh.triangle_count(); ++t) {
    const Triangle& triangle = surface.mesh.triangles[t];
    if (is_bent[face[triangle[0]]]) continue;
    if (std::none_of(triangle.begin(), triangle.end(), [&](Index v) { return on_crease[v]; })) {
      found.push_back(t);
    }
  }
  return found;
}

TEST(CreasedShapes, HaveExactStripesInsideOfFlatFaces) {
  std::vector<Part> tested = parts();
  tested.push_back({"gear", make_shape("gear")});
  tested.push_back({"bracket", make_shape("bracket")});
  tested.push_back({"plate with seven holes", plate_with_holes(7)});
  for (const Part& part : tested) {
    const Surface surface = with_creases(subdivide(part.mesh, 3));
    const std::vector<std::size_t> inside = inside_of_flat_faces(surface);
    EXPECT_GT(inside.size(), 20u) << part.name;
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(1, 2, 3)}) {
      const StripePattern pattern = stripes_along(surface, axis, 40);
      const auto errors = angle_errors_deg(surface.mesh, pattern.waves, pattern.corners);
      float largest = 0;
      for (const std::size_t t : inside) largest = std::max(largest, errors[t]);
      EXPECT_LT(largest, 0.01f) << part.name << axis.y();
    }
  }
}

TEST(CreasedShapes, HaveNoMoreSingularitiesOfCrossFieldsThanWithoutCreases) {
  for (const std::string shape : {"bracket", "gear", "box,resolution=20"}) {
    const auto count = [&](const Surface& surface) {
      SmoothFieldOptions options;
      options.symmetry = 4;
      return count_singularities(surface.mesh, smooth_direction_field(surface, options), 4);
    };
    const Mesh mesh = subdivide(make_shape(shape), 1);
    EXPECT_LE(count(with_creases(mesh)), count(make_surface(mesh))) << shape;
  }
}

TEST(CreasedShapes, HaveCalmSmoothFields) {
  for (const std::string shape : {"bracket", "gear"}) {
    const Surface surface = with_creases(make_shape(shape));
    const StripePattern pattern =
        stripe_pattern(surface, smooth_direction_field(surface),
                       frequency_of_stripes(40, bounding_box(surface.mesh).diagonal()));
    EXPECT_EQ(pattern.quality.branches, 0u) << shape;
  }
}

TEST(CreasedShapes, AreTheSameMovedMirroredAndOnAnyNumberOfThreads) {
  for (const std::string shape : {"bracket", "gear"}) {
    const Mesh mesh = make_shape(shape);
    const Vec3 axis(1, 2, 3);
    const StripePattern as_is = stripes_along(with_creases(mesh), axis, 20);
    const ThreadLimit one(1);
    EXPECT_EQ(stripes_along(with_creases(mesh), axis, 20).solution.z, as_is.solution.z) << shape;
    Eigen::Affine3f motion =
        Eigen::Translation3f(3, -1, 2) * Eigen::AngleAxisf(0.7f, Vec3(2, -1, 1).normalized());
    for (const bool mirrored : {false, true}) {
      Mesh moved = mesh;
      if (mirrored) {
        motion = motion * Eigen::Scaling(Vec3(-1, 1, 1));
        for (Triangle& triangle : moved.triangles) std::swap(triangle[0], triangle[1]);
      }
      for (Vec3& position : moved.positions) position = motion * position;
      const Surface surface = with_creases(moved);
      const StripePattern pattern = stripe_pattern(
          surface, projected_direction_field(motion.linear() * axis, surface.normals),
          frequency_of_stripes(20, bounding_box(mesh).diagonal()));
      EXPECT_EQ(pattern.quality.branches, as_is.quality.branches) << shape << mirrored;
      EXPECT_NEAR(pattern.solution.energy, as_is.solution.energy, 1e-4) << shape << mirrored;
    }
  }
}

TEST(CreasedCurves, RunRoundAPrismOverItsEdges) {
  const Surface surface = with_creases(extruded(toothed_circle(6, 1), 4));
  StripePattern pattern = stripes_along(surface, {0, 0, 1}, 20);
  // Away from the rims, on all faces the same way.
  shift_stripes(surface, 0.3f, pattern);
  const StripeCurves curves = stripe_curves(surface, pattern);
  EXPECT_GT(curves.lines.count(), 10u);
  // Stripes meet at all six edges: rings, but at the caps, which have no wave.
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    EXPECT_NE(curves.lines.closed[line], 0) << line;
  }
  const auto slip = crease_slip(surface, pattern.waves, pattern.solution.z);
  ASSERT_TRUE(slip);
  EXPECT_LT(slip->mean_deg, 5);
  EXPECT_EQ(slip->share, 0);
}

TEST(CreasedCurves, EndAtCreasesWherePhasesDoNotMeet) {
  const Surface surface = with_creases(extruded(square_round(4, 1), 2));
  const StripePattern pattern = stripes_along(surface, {1, 2, 3}, 40);
  const auto slip = crease_slip(surface, pattern.waves, pattern.solution.z);
  ASSERT_TRUE(slip);
  EXPECT_GT(slip->share, 0.05);
  EXPECT_LE(slip->share, 1);
  const StripeCurves curves = stripe_curves(surface, pattern);
  const auto ends = curves.end_counts();
  EXPECT_GT(ends[static_cast<std::size_t>(CurveEnd::crease)], 10u);
  EXPECT_EQ(ends[static_cast<std::size_t>(CurveEnd::boundary)], 0u);
  EXPECT_EQ(
      crease_slip(make_surface(extruded(square_round(4, 1), 2)), pattern.waves, pattern.solution.z),
      std::nullopt);
}

// Rings on the wall of a closed cylinder become spirals, and its caps stay as they are.
TEST(CreasedWindings, AreThoseOfFaces) {
  const Surface surface = with_creases(subdivide(extruded(toothed_circle(32, 1), 3), 2));
  const auto is_on_wall = [&](Index v) { return std::abs(surface.normals[v].z()) < 0.5f; };
  DirectionField field = projected_direction_field({1, 0, 0}, surface.normals);
  for (Index v = 0; v < field.size(); ++v) {
    if (is_on_wall(v)) field[v] = {0, 0, 1};
  }
  const StripePattern rings = stripe_pattern(surface, field, 2.0f);
  const std::vector<SurfaceLoop> loops = surface_loops(surface);
  ASSERT_EQ(loops.size(), 4u);
  for (const Winding& winding : windings(surface, loops, rings)) EXPECT_EQ(winding, 0);
  for (const int periods : {1, -2}) {
    // The wall alone has a way round, so the loop needs no name.
    const WoundPattern wound = wind(surface, rings, std::vector{WantedWinding{"", periods}});
    EXPECT_EQ(wound.pattern.quality.branches, 0u) << periods;
    const std::vector<Winding> after = windings(surface, loops, wound.pattern);
    for (std::size_t i = 0; i < loops.size(); ++i) {
      EXPECT_EQ(after[i], is_on_wall(loops[i].vertices[0]) ? periods : 0) << loops[i].name;
    }
    for (Index v = 0; v < field.size(); ++v) {
      if (is_on_wall(v)) continue;
      EXPECT_EQ(wound.pattern.waves.directions[v], rings.waves.directions[v]) << v;
    }
  }
}

}  // namespace
}  // namespace brindle
