#include "brindle/smooth_field.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "brindle/base/parallel.h"
#include "brindle/carried_phases.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/mesh.h"
#include "brindle/normals.h"
#include "brindle/shapes.h"
#include "brindle/stripe_pattern.h"
#include "brindle/strokes.h"

namespace brindle {
namespace {

/// Triangles whose three directions cannot be oriented alike.
std::size_t singularities(const Surface& surface, const DirectionField& field) {
  std::size_t count = 0;
  for (const Triangle& t : surface.mesh.triangles) {
    count +=
        field[t[0]].dot(field[t[1]]) * field[t[1]].dot(field[t[2]]) * field[t[2]].dot(field[t[0]]) <
        0;
  }
  return count;
}

TEST(SmoothField, IsConstantOnAPlane) {
  const Surface plane = make_surface(make_shape("plane,resolution=40"));
  const DirectionField field = smooth_direction_field(plane);
  for (const Vec3& d : field) EXPECT_NEAR(std::abs(d.dot(field[0])), 1, 1e-4);
}

TEST(SmoothField, IsTangentAndUnit) {
  const Surface surface = make_surface(make_shape("torus,resolution=60"));
  const DirectionField field = smooth_direction_field(surface);
  for (std::size_t i = 0; i < field.size(); ++i) {
    EXPECT_NEAR(field[i].norm(), 1, 1e-5);
    EXPECT_NEAR(field[i].dot(surface.normals[i]), 0, 1e-5);
  }
}

TEST(SmoothField, LineFieldOnASphereHasAtLeastFourSingularitiesAndFewMore) {
  // Each counts one half; they sum to the Euler characteristic, 2.
  const Surface sphere = make_surface(make_shape("sphere,resolution=20"));
  const std::size_t count = singularities(sphere, smooth_direction_field(sphere));
  EXPECT_GE(count, 4u);
  EXPECT_LE(count, 12u);
  EXPECT_EQ(count % 2, 0u);
}

/// Their indices sum to the Euler characteristic, 0; and of all fields without any, which differ
/// by a turn of all directions, stripes close in phase along the one with the least curl.
TEST(SmoothField, OnATorusHasNoSingularityAndStripesAlongItNoBranch) {
  for (const char* shape : {"torus,resolution=80", "torus", "torus,resolution=64,minor=0.2"}) {
    const Surface torus = make_surface(make_shape(shape));
    const DirectionField field = smooth_direction_field(torus);
    EXPECT_EQ(singularities(torus, field), 0u) << shape;
    EXPECT_EQ(stripe_pattern(torus, field, 8.0f).quality.branches, 0u) << shape;
  }
}

TEST(SmoothField, OfATorusHasNoSingularityHoweverFineTheMesh) {
  // Below 10 the tube has four sides: lines across it are at right angles to those of the next
  // side, and nobody can say whether they point alike.
  for (int resolution = 10; resolution <= 140; resolution += resolution < 64 ? 1 : 19) {
    const Surface torus =
        make_surface(make_shape("torus,resolution=" + std::to_string(resolution)));
    EXPECT_EQ(singularities(torus, smooth_direction_field(torus)), 0u) << resolution;
  }
}

TEST(SmoothField, CrossesTheSeamOfAMobiusStrip) {
  const Surface mobius = make_surface(make_shape("mobius,resolution=12"));
  EXPECT_EQ(singularities(mobius, smooth_direction_field(mobius)), 0u);
}

TEST(SmoothField, FollowsCurvatureWhereItIsAnchored) {
  const Surface cylinder = make_surface(make_shape("cylinder,resolution=60"));
  SmoothFieldOptions options;
  options.curvature_anchor = 1;
  for (const Vec3& d : smooth_direction_field(cylinder, options)) {
    EXPECT_LT(std::abs(d.z()), 0.05) << "the larger curvature runs around";
  }
  options.curvature_direction = CurvatureDirection::minimum;
  for (const Vec3& d : smooth_direction_field(cylinder, options)) {
    EXPECT_GT(std::abs(d.z()), 0.99) << "the smaller runs along";
  }
}

TEST(SmoothField, IsTheSameForEveryNumberOfThreads) {
  const Surface surface = make_surface(make_shape("sphere,resolution=30"));
  const ThreadLimit one(1);
  const DirectionField alone = smooth_direction_field(surface);
  const ThreadLimit two(2);
  EXPECT_EQ(smooth_direction_field(surface), alone);
}

/// Points within volumes, and copies that were joined with others at their place.
TEST(SmoothField, VerticesThatNoTriangleUsesDoNotCount) {
  Mesh mesh = make_shape("trefoil,resolution=30");
  const Surface surface = make_surface(mesh);
  mesh.positions.resize(20 * mesh.vertex_count(), Vec3(0, 0, 9));
  const Surface with_others = make_surface(mesh);
  // How solvers group vertices is not, but they end where they do.
  const auto expect_the_same = [&](const SmoothFieldOptions& options, SmoothFieldOptions others) {
    if (!others.last.directions.empty()) {
      others.last.directions.resize(mesh.vertex_count(), Vec3(1, 0, 0));
    }
    DirectionField found = smooth_direction_field(with_others, others);
    found.resize(surface.mesh.vertex_count());
    const DirectionField expected = smooth_direction_field(surface, options);
    EXPECT_LT(field_step(found, expected).mean_deg, 0.2);
    EXPECT_EQ(singularities(surface, found), singularities(surface, expected));
  };
  SmoothFieldOptions options{.curvature_anchor = 0.1f};
  expect_the_same(options, options);
  options.curvature_anchor = 0;
  options.last.directions = curvature_direction_field(
      principal_curvatures(surface.mesh.positions, surface.normals, *surface.neighborhood),
      CurvatureDirection::maximum);
  expect_the_same(options, options);
}

TEST(SmoothField, RefusesAnchorsAndSurfacesThatAreNone) {
  Surface plane = make_surface(make_shape("plane,resolution=6"));
  for (const float bad : {std::nanf(""), -1.0f, INFINITY}) {
    SmoothFieldOptions options;
    options.curvature_anchor = bad;
    EXPECT_THROW(smooth_direction_field(plane, options), Error);
    options = {};
    options.feature_anchor = bad;
    EXPECT_THROW(smooth_direction_field(plane, options), Error);
  }
  plane.mesh.positions[4].x() = INFINITY;
  EXPECT_THROW(smooth_direction_field(plane), Error);
}

TEST(SmoothField, RefusesASymmetryBelowOne) {
  SmoothFieldOptions options;
  options.symmetry = 0;
  EXPECT_THROW(smooth_direction_field(make_surface(make_shape("plane,resolution=4")), options),
               Error);
}

/// The mean over all directions of how far they are from the nearest of two crossed axes, degrees.
double degrees_off_axes(const Surface& surface, const DirectionField& field, const Vec3& axis) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Vec3 along = tangent_direction(axis, surface.normals[i]);
    if (along.isZero(0)) continue;
    const double angle = std::acos(std::min(1.0f, std::abs(field[i].dot(along)))) * 57.29578;
    sum += std::min(angle, 90 - angle);
    ++count;
  }
  return sum / static_cast<double>(count);
}

TEST(SmoothField, CrossesRunAlongTheBoundary) {
  const Surface plane = make_surface(make_shape("plane,resolution=30"));
  const DirectionField field =
      smooth_direction_field(plane, {.symmetry = 4, .feature_anchor = 1.0f});
  EXPECT_LT(degrees_off_axes(plane, field, Vec3::UnitX()), 3);
}

/// A cube whose edges are edges of triangles, standing askew.
Surface cube() {
  Mesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.positions.emplace_back(corner & 1, corner >> 1 & 1, corner >> 2);
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return make_surface(subdivide(std::move(mesh), 4));
}

TEST(SmoothField, CrossesRunAlongTheEdgesOfACube) {
  const Surface surface = cube();
  const auto off_axes = [&](float anchor) {
    const SmoothFieldOptions options{.symmetry = 4, .feature_anchor = anchor};
    return degrees_off_axes(surface, smooth_direction_field(surface, options), Vec3::UnitZ());
  };
  EXPECT_LT(off_axes(1), 3);
  EXPECT_LT(off_axes(1), 0.5 * off_axes(0));
}

TEST(SmoothField, FollowsCreasesThatTrianglesFollowInZigzag) {
  // Without fillets; the grid that this shape comes from leaves no straight edges.
  const Surface box = make_surface(make_shape("box,fillet=0.001,hole=0,resolution=20"));
  const SmoothFieldOptions options{.symmetry = 4, .feature_anchor = 1, .feature_angle_deg = 25};
  EXPECT_LT(degrees_off_axes(box, smooth_direction_field(box, options), Vec3::UnitZ()), 5);
}

TEST(SmoothField, RefusesFeaturesForVectors) {
  const Surface plane = make_surface(make_shape("plane,resolution=5"));
  EXPECT_THROW(smooth_direction_field(plane, {.symmetry = 1, .feature_anchor = 1.0f}), Error);
}

double degrees_between_lines(const Vec3& a, const Vec3& b) {
  return std::acos(std::min(1.0f, std::abs(a.dot(b)))) * 57.29578;
}

/// The field of a plane, whatever the four edges ask for, and a stroke across it.
struct StrokeOnAPlane {
  Surface plane = make_surface(make_shape("plane,resolution=50"));
  Vec3 along = Vec3(2, 1, 0).normalized();
  std::vector<FieldStroke> strokes = {
      {{Eigen::Vector3d(-0.5, -0.25, 0), Eigen::Vector3d(0.5, 0.25, 0)}, 0.2, 2}};

  DirectionField field(bool stroke) const {
    // Held along x at the outer quarter of the plane.
    SmoothFieldOptions options;
    for (Index v = 0; v < plane.mesh.vertex_count(); ++v) {
      if (std::abs(plane.mesh.positions[v].y()) > 0.75f)
        options.anchors.push_back({v, Vec3::UnitX()});
    }
    if (stroke) {
      for (const FieldAnchor& anchor : stroke_anchors(plane, strokes)) {
        options.anchors.push_back(anchor);
      }
    }
    return smooth_direction_field(plane, options);
  }
};

TEST(SmoothField, FollowsAStrokeUnderItAndStaysAsItWasFarAway) {
  const StrokeOnAPlane scene;
  const DirectionField before = scene.field(false), after = scene.field(true);
  const Vec3 across(-scene.along.y(), scene.along.x(), 0);
  std::size_t under = 0, away = 0;
  for (std::size_t v = 0; v < after.size(); ++v) {
    const Vec3& p = scene.plane.mesh.positions[v];
    if (std::abs(p.dot(across)) < 0.05f && std::abs(p.dot(scene.along)) < 0.45f) {
      EXPECT_LT(degrees_between_lines(after[v], scene.along), 3);
      ++under;
    } else if (std::abs(p.y()) > 0.85f) {
      EXPECT_LT(degrees_between_lines(after[v], before[v]), 1);
      ++away;
    }
  }
  EXPECT_GT(under, 50u);
  EXPECT_GT(away, 200u);
}

TEST(SmoothField, IsTheSameForAStrokeReadBackwards) {
  StrokeOnAPlane scene;
  const DirectionField forward = scene.field(true);
  std::reverse(scene.strokes[0].points.begin(), scene.strokes[0].points.end());
  EXPECT_EQ(scene.field(true), forward);
}

TEST(SmoothField, RunsAlongFeaturesWithinTheirRadius) {
  const Surface plane = make_surface(make_shape("plane,resolution=40"));
  const auto field = smooth_direction_field(
      plane, {.feature_anchor = 2, .feature_angle_deg = 40, .feature_radius = 0.3f});
  for (std::size_t v = 0; v < field.size(); ++v) {
    const Vec3& p = plane.mesh.positions[v];
    if (std::abs(p.x()) > 0.4f || std::abs(std::abs(p.y()) - 0.9f) > 0.06f) continue;
    EXPECT_LT(degrees_between_lines(field[v], Vec3::UnitX()), 8);
  }
}

/// A sphere of radius 1 with bumps that are 0.27 long and up to 0.12 high.
Surface bumpy_sphere(float scale = 1) {
  Mesh mesh = make_shape("sphere,resolution=60");
  for (Vec3& p : mesh.positions) {
    const Vec3 q = p.normalized();
    const float bump = std::sin(23 * q.x()) * std::sin(19 * q.y() + 1) * std::sin(21 * q.z() + 2);
    p = scale * (1 + 0.12f * bump) * q;
  }
  return make_surface(std::move(mesh));
}

TEST(SmoothField, HasNoSingularitiesOfBumpsThatItsNormalsAreAveragedOver) {
  const Surface sphere = bumpy_sphere();
  const auto count = [&](float radius) {
    const DirectionField field =
        smooth_direction_field(sphere, {.symmetry = 4, .normal_radius = radius});
    for (std::size_t i = 0; i < field.size(); ++i) {
      EXPECT_NEAR(field[i].norm(), 1, 1e-5);
      EXPECT_NEAR(field[i].dot(sphere.normals[i]), 0, 1e-5);
    }
    return count_singularities(sphere.mesh, field, 4);
  };
  EXPECT_GT(count(0), 100u);
  // Each counts a quarter; they sum to the Euler characteristic, 2.
  EXPECT_LE(count(0.1f), 12u);
  EXPECT_EQ(count(0.5f), 8u);
}

TEST(SmoothField, KeepsSingularitiesThatAShapeDoesNotNeedAway) {
  std::size_t own = 0, averaged = 0;
  for (const char* shape : {"molecule", "vessels"}) {
    const Surface surface = make_surface(make_shape(shape));
    const float radius = 0.01f * bounding_box(surface.mesh).diagonal();
    const auto count = [&](float normal_radius) {
      const auto field =
          smooth_direction_field(surface, {.symmetry = 4, .normal_radius = normal_radius});
      return count_singularities(surface.mesh, field, 4);
    };
    own += count(0);
    averaged += count(radius);
  }
  EXPECT_LT(3 * averaged, 2 * own);
}

TEST(SmoothField, AveragesNormalsOverTheSamePlacesAtEveryScale) {
  const Surface sphere = bumpy_sphere(), large = bumpy_sphere(8);
  const auto field = smooth_direction_field(sphere, {.normal_radius = 0.3f});
  const auto same = smooth_direction_field(large, {.normal_radius = 2.4f});
  double off = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    off += 1 - std::abs(static_cast<double>(field[i].dot(same[i])));
  }
  EXPECT_LT(off / static_cast<double>(field.size()), 1e-3);
}

TEST(SmoothField, OfASmoothSurfaceStaysWhereItsNormalsAreAveraged) {
  const Surface plane = make_surface(make_shape("plane,resolution=30"));
  const DirectionField field = smooth_direction_field(plane, {.normal_radius = 0.2f});
  const DirectionField plain = smooth_direction_field(plane);
  for (std::size_t i = 0; i < field.size(); ++i) {
    EXPECT_NEAR(std::abs(field[i].dot(plain[i])), 1, 1e-5);
  }
  EXPECT_THROW(smooth_direction_field(plane, {.normal_radius = -1}), Error);
  EXPECT_THROW(smooth_direction_field(plane, {.curvature_anchor = 1e30f}), Error);
}

TEST(SmoothField, RefusesAnchorsThatAreNone) {
  const Surface plane = make_surface(make_shape("plane,resolution=4"));
  for (const FieldAnchor& bad :
       {FieldAnchor{1000, Vec3::UnitX(), 1}, FieldAnchor{0, Vec3(NAN, 0, 0), 1},
        FieldAnchor{0, Vec3::UnitX(), INFINITY}}) {
    EXPECT_THROW(smooth_direction_field(plane, {.anchors = {bad}}), Error);
  }
  EXPECT_THROW(smooth_direction_field(plane, {.feature_anchor = 1, .feature_radius = -1}), Error);
}

}  // namespace
}  // namespace brindle
