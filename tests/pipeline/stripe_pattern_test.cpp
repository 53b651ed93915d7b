#include "brindle/stripe_pattern.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <span>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "bad_waves.h"
#include "brindle/base/parallel.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/frequency_field.h"
#include "brindle/geometry/measures.h"
#include "brindle/shapes.h"
#include "brindle/stripe_animator.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::kAxis;

WaveSet waves_along(const Surface& surface, const Vec3& axis, float stripes) {
  const float diagonal = bounding_box(surface.mesh).diagonal();
  return {surface.mesh.positions, projected_direction_field(axis, surface.normals),
          constant_frequency_field(frequency_of_stripes(stripes, diagonal),
                                   surface.mesh.vertex_count())};
}

StripePattern pattern_of(const Surface& surface, float stripes, StripeOptions options = {}) {
  return stripe_pattern(surface, waves_along(surface, kAxis, stripes), options);
}

StripeOptions with_solver(Solver solver, float epsilon = 0.02f) {
  StripeOptions options;
  options.solver.solver = solver;
  options.solver.epsilon = epsilon;
  return options;
}

/// Rounding breaks ties between equally strong couplings in another way, and from there on
/// solutions differ, though not in kind.
void expect_like_quality(const PatternQuality& a, const PatternQuality& b) {
  EXPECT_NEAR(static_cast<double>(a.branches), static_cast<double>(b.branches),
              0.1 * static_cast<double>(b.branches));
  EXPECT_NEAR(a.angle_error_mean_deg, b.angle_error_mean_deg, 0.1 * b.angle_error_mean_deg);
  EXPECT_NEAR(a.spacing_error_mean, b.spacing_error_mean, 0.1 * b.spacing_error_mean);
}

/// Its vertices have masses of a millionth.
TEST(StripePattern, MayHaveAComponentThatIsTinyBesideTheOther) {
  Mesh mesh = make_shape("torus,resolution=24");
  const Mesh large = mesh;
  const auto first = static_cast<Index>(large.vertex_count());
  for (const Vec3& p : large.positions) mesh.positions.push_back(1e-6f * p + Vec3(3, 0, 0));
  for (const Triangle& t : large.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  const Surface surface = make_surface(mesh);
  const DirectionField field = projected_direction_field(Vec3(0.3f, 0.2f, 1), surface.normals);
  for (const Solver solver :
       {Solver::multilevel, Solver::relaxation, Solver::averaged, Solver::global}) {
    if (!is_available(solver)) continue;
    for (const float frequency : {0.5f, 5.0f, 20.0f}) {
      StripeOptions options;
      options.solver.solver = solver;
      const StripePattern pattern = stripe_pattern(surface, field, frequency, options);
      EXPECT_LT(pattern.solution.energy, 0.2) << name_of(solver) << frequency;
      EXPECT_TRUE(std::ranges::all_of(
          pattern.solution.z, [](const Complex& z) { return std::abs(std::abs(z) - 1) < 1e-3f; }));
    }
  }
}

TEST(StripePattern, OfAFlatPlaneHasNoEnergyAndNoBranch) {
  const Surface plane = make_surface(make_shape("plane,resolution=60"));
  for (const float stripes : {5.0f, 60.0f, 300.0f}) {
    const StripePattern pattern = pattern_of(plane, stripes);
    EXPECT_LT(pattern.solution.energy, 1e-6);
    EXPECT_EQ(pattern.quality.branches, 0u);
    EXPECT_LT(pattern.quality.angle_error_mean_deg, 0.1);
  }
}

TEST(StripePattern, CyclesFromTheGlobalPhasesAreNoWorseThanEitherSolver) {
  if (!is_available(Solver::global)) GTEST_SKIP() << "this build has no CHOLMOD";
  const Surface trefoil = make_surface(make_shape("trefoil,resolution=40"));
  StripeOptions options = with_solver(Solver::global);
  const StripePattern global = pattern_of(trefoil, 20, options);
  options.solver.cycles = 20;
  const StripePattern improved = pattern_of(trefoil, 20, options);
  EXPECT_LE(improved.quality.branches, global.quality.branches);
  EXPECT_LT(improved.solution.energy, 0.8 * global.solution.energy);
  EXPECT_LE(improved.solution.energy, pattern_of(trefoil, 20).solution.energy);
}

TEST(StripePattern, OfTheGlobalSolverDoesNotDependOnSigns) {
  if (!is_available(Solver::global)) GTEST_SKIP() << "this build has no CHOLMOD";
  for (const char* shape : {"torus,resolution=40", "trefoil,resolution=30", "sphere"}) {
    const Surface surface = make_surface(make_shape(shape));
    const WaveSet waves = waves_along(surface, kAxis, 30);
    const StripePattern pattern = stripe_pattern(surface, waves, with_solver(Solver::global));
    WaveSet flipped = waves, opposite = waves;
    testing_support::flip_half(flipped, 3);
    for (Vec3& direction : opposite.directions) direction = -direction;
    for (const WaveSet& other : {flipped, opposite}) {
      const StripePattern same = stripe_pattern(surface, other, with_solver(Solver::global));
      EXPECT_NEAR(same.solution.energy, pattern.solution.energy, 1e-6) << shape;
      EXPECT_EQ(same.quality.branches, pattern.quality.branches) << shape;
    }
  }
}

TEST(StripePattern, OfACylinderAlongItsAxisHasNoEnergyAndNoBranch) {
  const Surface cylinder = make_surface(make_shape("cylinder,resolution=80"));
  const StripePattern pattern = stripe_pattern(cylinder, waves_along(cylinder, Vec3(0, 0, 1), 30));
  EXPECT_LT(pattern.solution.energy, 1e-6);
  EXPECT_EQ(pattern.quality.branches, 0u);
}

TEST(StripePattern, DoesNotChangeWhenTheSurfaceIsMovedTurnedAndScaled) {
  const Mesh mesh = make_shape("torus,resolution=100");
  const Surface before = make_surface(mesh);
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(1.1f, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  Mesh moved = mesh;
  for (Vec3& p : moved.positions) p = 3 * (turn * p) + Vec3(2, -5, 1);
  const Surface after = make_surface(std::move(moved));
  WaveSet waves = waves_along(after, turn * kAxis, 30);
  // Scaled back: a turned bounding box has another diagonal.
  waves.frequencies = constant_frequency_field(waves_along(before, kAxis, 30).frequencies[0] / 3,
                                               mesh.vertex_count());
  const StripePattern original = pattern_of(before, 30);
  expect_like_quality(stripe_pattern(after, waves).quality, original.quality);

  // The very same phases are as good on the moved surface.
  const PatternQuality kept = measure_quality(
      after.mesh, waves,
      corner_phases(after.mesh.triangles, waves, original.solution.z, PhaseShiftKind::aligned));
  EXPECT_EQ(kept.branches, original.quality.branches);
  EXPECT_NEAR(kept.angle_error_mean_deg, original.quality.angle_error_mean_deg, 0.01);
  EXPECT_NEAR(kept.spacing_error_mean, original.quality.spacing_error_mean, 1e-4);
}

TEST(StripePattern, HardlyDependsOnTheOrderOfVertices) {
  const Mesh mesh = make_shape("torus,resolution=100");
  const auto count = static_cast<Index>(mesh.vertex_count());
  Mesh reversed = mesh;
  for (Index i = 0; i < count; ++i) reversed.positions[count - 1 - i] = mesh.positions[i];
  for (Triangle& triangle : reversed.triangles) {
    for (Index& vertex : triangle) vertex = count - 1 - vertex;
  }
  expect_like_quality(pattern_of(make_surface(std::move(reversed)), 30).quality,
                      pattern_of(make_surface(mesh), 30).quality);
}

TEST(StripePattern, IsLaidOverSurfacesOfAnyTopology) {
  for (const char* shape :
       {"sheets,resolution=24", "hemisphere,resolution=30", "mobius,resolution=20",
        "pieces,resolution=10", "torus,resolution=90,noise=0.3", "vessels,resolution=40"}) {
    const Surface surface = make_surface(make_shape(shape));
    const StripePattern pattern = pattern_of(surface, 20);
    EXPECT_LT(pattern.solution.energy, 0.1) << shape;
    EXPECT_LT(pattern.quality.branches, surface.mesh.triangle_count() / 20) << shape;
    EXPECT_LT(pattern.quality.angle_error_mean_deg, 20) << shape;
  }
}

TEST(StripePattern, CotangentWeightsLowerTheAngleErrorOfUnevenTriangles) {
  Mesh mesh = make_shape("torus,resolution=100");
  for (Vec3& p : mesh.positions) p.z() *= 3;
  const Surface stretched = make_surface(std::move(mesh));
  StripeOptions cotangent;
  cotangent.weights = EdgeWeights::cotangent;
  EXPECT_LT(pattern_of(stretched, 30, cotangent).quality.angle_error_mean_deg,
            pattern_of(stretched, 30).quality.angle_error_mean_deg);
}

TEST(StripePattern, CotangentWeightsReachTheAveragedLevels) {
  Mesh mesh = make_shape("torus,resolution=60");
  for (Vec3& p : mesh.positions) p.z() *= 3;
  const Surface stretched = make_surface(std::move(mesh));
  StripeOptions options = with_solver(Solver::averaged);
  options.weights = EdgeWeights::cotangent;
  const StripePattern pattern = pattern_of(stretched, 20, options);
  options.solve = [](const PhaseGraph& graph, const SolverOptions& solver, const Progress& progress,
                     const SolverData& data) {
    double largest = 0;
    for (const Complex& coupling : data.averaged[0].graph.coupling) {
      largest = std::max(largest, static_cast<double>(std::abs(coupling)));
    }
    // The paper's own weight is the cosine of an angle.
    EXPECT_GT(largest, 1.1);
    return solve_phases(graph, solver, progress, data);
  };
  EXPECT_EQ(pattern_of(stretched, 20, options).solution.z, pattern.solution.z);
}

TEST(StripePattern, TellsTheTimesOfEverySolver) {
  const Surface torus = make_surface(make_shape("torus,resolution=60"));
  for (const Solver solver : {Solver::multilevel, Solver::relaxation, Solver::averaged}) {
    const StripePattern pattern = pattern_of(torus, 20, with_solver(solver));
    EXPECT_GT(pattern.solution.topology_milliseconds, 0) << name_of(solver);
    EXPECT_GT(pattern.solution.solve_milliseconds, 0) << name_of(solver);
    EXPECT_EQ(pattern.milliseconds.solve, pattern.solution.solve_milliseconds) << name_of(solver);
    EXPECT_GE(pattern.milliseconds.topology, pattern.solution.topology_milliseconds);
  }
}

TEST(StripePattern, RefusesValuesThatNoWaveHas) {
  const Surface torus = make_surface(make_shape("torus,resolution=20"));
  for (const Solver solver : {Solver::multilevel, Solver::relaxation, Solver::averaged}) {
    testing_support::expect_refused(waves_along(torus, kAxis, 10), 5, [&](const WaveSet& waves) {
      stripe_pattern(torus, waves, with_solver(solver));
    });
  }
}

TEST(StripePattern, RefusesWavesThatAreNotTangentOrFarTooFine) {
  const Surface sphere = make_surface(make_shape("sphere,resolution=12"));
  const std::size_t count = sphere.mesh.vertex_count();
  const DirectionField tangent = projected_direction_field({0, 0, 1}, sphere.normals);
  const auto message_of = [&](const DirectionField& field, float frequency) -> std::string {
    std::string from_pattern, from_animator;
    try {
      stripe_pattern(sphere, field, frequency);
    } catch (const Error& error) {
      from_pattern = error.what();
    }
    const FrequencyField frequencies = constant_frequency_field(frequency, count);
    FrameInput input{sphere.mesh.positions, field, frequencies};
    const auto frame = [&](StripeAnimator animator) -> std::string {
      try {
        animator.frame(input);
      } catch (const Error& error) {
        return error.what();
      }
      return "";
    };
    EXPECT_EQ(frame(StripeAnimator(sphere)), from_pattern);
    // Who knows no normals can be told.
    input.normals = sphere.normals;
    EXPECT_EQ(frame(StripeAnimator(sphere.neighborhood)), from_pattern);
    return from_pattern;
  };
  EXPECT_EQ(message_of(tangent, 5), "");
  EXPECT_NE(message_of(sphere.normals, 5).find("sticks out of the surface by 90 degrees"),
            std::string::npos);
  EXPECT_NE(message_of(DirectionField(count, Vec3(0, 0, 1)), 5).find("tangent_directions"),
            std::string::npos);
  const std::string fine = message_of(tangent, 1e30f);
  EXPECT_NE(fine.find("whose frequency is 1e+30"), std::string::npos) << fine;

  // On a sphere that has moved, old normals say nothing.
  DirectionField upright(count, Vec3(0, 0, 1));
  std::vector<Vec3> moved = sphere.mesh.positions;
  for (Vec3& p : moved) p.x() += 1;
  const FrequencyField frequencies = constant_frequency_field(5, count);
  EXPECT_NO_THROW(StripeAnimator(sphere).frame({moved, upright, frequencies}));
  EXPECT_THROW(StripeAnimator(sphere).frame({moved, upright, frequencies, sphere.normals}), Error);
  EXPECT_THROW(StripeAnimator(sphere).frame(
                   {moved, tangent, frequencies, std::span(sphere.normals).first(3)}),
               Error);
}

TEST(StripePattern, TakesDirectionsProjectedAlongNormalsOfAnotherKind) {
  // Normals weighted by nothing differ by up to 20 degrees at a cube's corners, and not in faces.
  Mesh cube;
  for (int v = 0; v < 8; ++v) {
    cube.positions.emplace_back(static_cast<float>(v % 2), static_cast<float>(v / 2 % 2),
                                static_cast<float>(v / 4));
  }
  cube.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  const Surface box = make_surface(subdivide(cube, 3));
  std::vector<Vec3> others(box.mesh.vertex_count(), Vec3::Zero());
  for (const Triangle& t : box.mesh.triangles) {
    const Vec3 normal = (box.mesh.positions[t[1]] - box.mesh.positions[t[0]])
                            .cross(box.mesh.positions[t[2]] - box.mesh.positions[t[0]])
                            .normalized();
    for (const Index v : t) others[v] += normal;
  }
  float least = 1;
  for (std::size_t v = 0; v < others.size(); ++v) {
    others[v].normalize();
    least = std::min(least, others[v].dot(box.normals[v]));
  }
  ASSERT_LT(least, 0.97f);
  EXPECT_NO_THROW(stripe_pattern(box, projected_direction_field({0.3f, 0.5f, 1}, others), 3));
}

TEST(StripePattern, TellsOfAFieldWithoutAnyDirection) {
  const Surface plane = make_surface(make_shape("plane,resolution=10"));
  WaveSet waves = waves_along(plane, kAxis, 10);
  waves.directions.assign(waves.directions.size(), Vec3::Zero());
  const StripePattern pattern = stripe_pattern(plane, waves);
  EXPECT_EQ(pattern.solution.energy, 0);
  EXPECT_EQ(pattern.quality.vertices_without_wave, plane.mesh.vertex_count());
  EXPECT_EQ(pattern_of(plane, 10).quality.vertices_without_wave, 0u);
}

TEST(StripePattern, VerticesWithoutAWaveStayPlainSurface) {
  const Surface plane = make_surface(make_shape("plane,resolution=30"));
  WaveSet waves = waves_along(plane, kAxis, 10);
  for (std::size_t i = 0; i < waves.directions.size() / 2; ++i) waves.directions[i].setZero();
  const StripePattern pattern = stripe_pattern(plane, waves);
  EXPECT_EQ(pattern.quality.branches, 0u);
  EXPECT_GT(std::ranges::count(pattern.corners, TriangleKind::no_wave, &CornerPhases::kind), 0);
}

TEST(StripePattern, RefusesWavesOfAnotherSurface) {
  const Surface plane = make_surface(make_shape("plane,resolution=5"));
  WaveSet waves = waves_along(plane, kAxis, 5);
  waves.directions.pop_back();
  EXPECT_THROW(stripe_pattern(plane, waves), Error);
}

TEST(StripePattern, IsThatOfTheFirstFrameAndOfThePhaseGraph) {
  const Surface torus = make_surface(make_shape("torus,resolution=100,noise=0.2"));
  StripeOptions options;
  options.weights = EdgeWeights::cotangent;
  options.solver.cycles = 1;
  const StripePattern pattern = pattern_of(torus, 30, options);
  AnimatorOptions like;
  like.cycles = 1;
  like.edge_weights = cotangent_weights(torus.mesh, *torus.neighborhood);
  StripeAnimator animator(torus.neighborhood, like);
  const WaveSet& waves = pattern.waves;
  const auto z = animator.frame({waves.positions, waves.directions, waves.frequencies}).z;
  EXPECT_TRUE(std::equal(z.begin(), z.end(), pattern.solution.z.begin(), pattern.solution.z.end()));
  EXPECT_EQ(animator.energy(), pattern.solution.energy);
  const PhaseGraph graph =
      build_phase_graph(torus.neighborhood, waves, PhaseShiftKind::aligned, like.edge_weights);
  EXPECT_NEAR(solve_phases(graph, options.solver).energy, pattern.solution.energy,
              0.02 * pattern.solution.energy);
}

void expect_the_same_for_one_and_two_threads(const Surface& surface) {
  const ThreadLimit two(2);
  const StripePattern together = pattern_of(surface, 40);
  const ThreadLimit one(1);
  const StripePattern alone = pattern_of(surface, 40);
  EXPECT_EQ(together.solution.z, alone.solution.z);
  EXPECT_EQ(together.solution.energy, alone.solution.energy);
  EXPECT_EQ(together.quality.angle_error_mean_deg, alone.quality.angle_error_mean_deg);
}

void expect_fewer_branches_for_a_smaller_epsilon(const Surface& surface) {
  std::size_t last = surface.mesh.triangle_count();
  for (const float epsilon : {0.1f, 0.02f, 0.001f}) {
    const auto now =
        pattern_of(surface, 40, with_solver(Solver::relaxation, epsilon)).quality.branches;
    EXPECT_LT(now, last) << epsilon;
    last = now;
  }
}

/// Surfaces that are hard for stripes: the field's lines converge and part, thin limbs, rims,
/// noise. Bounds are a tenth above what the multilevel solver leaves at 40 stripes.
struct HardShape {
  const char* shape;
  double energy;
  std::size_t branches;
  double angle_error_mean_deg;
};

void PrintTo(const HardShape& shape, std::ostream* out) { *out << shape.shape; }

struct Hard : testing::TestWithParam<HardShape> {
  Surface surface = make_surface(make_shape(GetParam().shape));
};

TEST_P(Hard, StaysWithinItsBounds) {
  const StripePattern pattern = pattern_of(surface, 40);
  EXPECT_LE(pattern.solution.energy, GetParam().energy);
  EXPECT_LE(pattern.quality.branches, GetParam().branches);
  EXPECT_LE(pattern.quality.angle_error_mean_deg, GetParam().angle_error_mean_deg);
}

TEST_P(Hard, FollowsTheFieldBetterThanTheGlobalEigenvector) {
  if (!is_available(Solver::global)) GTEST_SKIP() << "this build has no CHOLMOD";
  const StripePattern ours = pattern_of(surface, 40);
  const StripePattern global = pattern_of(surface, 40, with_solver(Solver::global));
  EXPECT_LE(ours.solution.energy, global.solution.energy);
  EXPECT_LE(ours.quality.angle_error_mean_deg, global.quality.angle_error_mean_deg);
}

TEST_P(Hard, AveragedLevelsRemoveATenthOfTheBranchesOfRelaxation) {
  const auto relaxed = pattern_of(surface, 40, with_solver(Solver::relaxation)).quality.branches;
  const auto averaged = pattern_of(surface, 40, with_solver(Solver::averaged)).quality.branches;
  EXPECT_LE(static_cast<double>(averaged), 0.9 * static_cast<double>(relaxed));
}

TEST_P(Hard, HasFewerBranchesForASmallerEpsilon) {
  expect_fewer_branches_for_a_smaller_epsilon(surface);
}

TEST_P(Hard, IsTheSameForOneAndTwoThreads) { expect_the_same_for_one_and_two_threads(surface); }

INSTANTIATE_TEST_SUITE_P(BuiltIn, Hard,
                         testing::Values(HardShape{"trefoil,resolution=40", 0.0159, 197, 3.5},
                                         HardShape{"vessels,resolution=60", 0.0104, 204, 5.6},
                                         HardShape{"box,resolution=40", 0.0092, 116, 2.2},
                                         HardShape{"torus,resolution=150,noise=0.3", 0.0106, 170,
                                                   3.2}),
                         [](const auto& param) {
                           const std::string shape = param.param.shape;
                           return shape.substr(0, shape.find(','));
                         });

TEST(StripePattern, DoesNotChangeByABitWhenTheSurfaceIsTwiceAsLarge) {
  const Mesh mesh = make_shape("torus,resolution=100,noise=0.2");
  Mesh larger = mesh;
  for (Vec3& p : larger.positions) p *= 2;
  EXPECT_EQ(pattern_of(make_surface(larger), 30).solution.z,
            pattern_of(make_surface(mesh), 30).solution.z);
}

/// Bounds on scanned models, where they are at hand.
struct Model : testing::TestWithParam<const char*> {
  Surface surface;
  void SetUp() override {
    const auto path = std::filesystem::path(BRINDLE_SHARED_MODELS) / GetParam();
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
    surface = make_surface(read_mesh(path).mesh);
  }
};

TEST_P(Model, MultilevelIsAsGoodAsGlobal) {
  if (!is_available(Solver::global)) GTEST_SKIP() << "this build has no CHOLMOD";
  for (const float stripes : {40.0f, 160.0f}) {
    const PatternQuality ours = pattern_of(surface, stripes).quality;
    const PatternQuality global = pattern_of(surface, stripes, with_solver(Solver::global)).quality;
    EXPECT_LE(static_cast<double>(ours.branches), 1.05 * static_cast<double>(global.branches))
        << stripes;
    EXPECT_LE(ours.angle_error_mean_deg, 1.05 * global.angle_error_mean_deg) << stripes;
  }
}

TEST_P(Model, IsTheSameForOneAndTwoThreads) { expect_the_same_for_one_and_two_threads(surface); }

TEST_P(Model, HasFewerBranchesForASmallerEpsilon) {
  expect_fewer_branches_for_a_smaller_epsilon(surface);
}

INSTANTIATE_TEST_SUITE_P(Shared, Model,
                         testing::Values("horse.ply", "nefertiti.obj", "stanford-bunny.obj",
                                         "spot.obj"),
                         [](const auto& param) {
                           std::string name = param.param;
                           std::erase_if(name, [](char c) { return !std::isalnum(c); });
                           return name;
                         });

struct Horse : Model {};

TEST_P(Horse, MeetsTheBoundsOfTheDesign) {
  const StripePattern pattern = pattern_of(surface, 40);
  EXPECT_LE(pattern.solution.energy, 0.0030);
  EXPECT_LE(pattern.quality.branches, 215u);
  EXPECT_LE(pattern.quality.angle_error_mean_deg, 4.5);
}

TEST_P(Horse, AveragedLevelsRemoveAThirdOfTheBranchesOfRelaxation) {
  // The paper's Fig. 15: about 33 %.
  const auto relaxed = pattern_of(surface, 40, with_solver(Solver::relaxation)).quality.branches;
  const auto averaged = pattern_of(surface, 40, with_solver(Solver::averaged)).quality.branches;
  EXPECT_LE(static_cast<double>(averaged), 0.67 * static_cast<double>(relaxed));
}

INSTANTIATE_TEST_SUITE_P(Shared, Horse, testing::Values("horse.ply"),
                         [](const auto&) { return "horse"; });

}  // namespace
}  // namespace brindle
