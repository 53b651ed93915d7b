#include "brindle/solver.h"

#include <numeric>

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "brindle/phases/multilevel.h"
#include "brindle/phases/parsed_words.h"
#include "brindle/phases/relaxation.h"
#include "brindle/waves/averaged_levels.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::flip_half;
using testing_support::wavy_surface;
using testing_support::WavySurface;

const Vec3 kTiltedAxis(0.3f, 0.9f, 0.2f);

PhaseSolution solve(const WavySurface& surface, const SolverOptions& options) {
  SolverData data;
  if (options.solver == Solver::averaged) {
    data.averaged =
        averaged_levels(*surface.neighborhood, surface.waves,
                        {surface.normals, vertex_areas(surface.mesh)}, PhaseShiftKind::aligned);
  }
  return solve_phases(surface.graph(), options, {}, data);
}

SolverOptions options_for(Solver solver) {
  SolverOptions options;
  options.solver = solver;
  return options;
}

/// Tests that hold for every solver in this build.
struct EverySolver : testing::TestWithParam<Solver> {
  SolverOptions options = options_for(GetParam());
  void SetUp() override {
    if (!is_available(GetParam())) GTEST_SKIP() << "this build has no CHOLMOD";
  }
};

TEST_P(EverySolver, GivesUnitPhases) {
  for (const Complex& z : solve(wavy_surface("torus,resolution=40", kTiltedAxis, 12), options).z) {
    ASSERT_NEAR(std::abs(z), 1, 1e-5);
  }
}

TEST_P(EverySolver, ReportsTheEnergyOfItsPhases) {
  const auto surface = wavy_surface("torus,resolution=40", kTiltedAxis, 12);
  const PhaseSolution solution = solve(surface, options);
  EXPECT_DOUBLE_EQ(solution.energy, energy(surface.graph(), solution.z));
  EXPECT_LT(solution.energy, 0.06);
  EXPECT_GT(solution.iterations, 0);
}

TEST_P(EverySolver, CyclesNeverRaiseTheEnergy) {
  auto surface = wavy_surface("torus,resolution=60", kTiltedAxis, 18);
  flip_half(surface.waves, 6);
  double last = solve(surface, options).energy;
  for (const int cycles : {1, 2, 6}) {
    options.cycles = cycles;
    const PhaseSolution solution = solve(surface, options);
    EXPECT_LE(solution.energy, last + 1e-9);
    EXPECT_DOUBLE_EQ(solution.energy, energy(surface.graph(), solution.z));
    last = solution.energy;
  }
}

TEST_P(EverySolver, IsTheSameForEveryNumberOfThreadsAndEveryRun) {
  const auto surface = wavy_surface("sphere,resolution=30", kTiltedAxis, 20);
  const ThreadLimit two(2);
  const PhaseSolution together = solve(surface, options);
  EXPECT_EQ(solve(surface, options).z, together.z);
  const ThreadLimit one(1);
  EXPECT_EQ(solve(surface, options).z, together.z);
}

TEST_P(EverySolver, LeavesVerticesWithoutAWaveAlone) {
  auto surface = wavy_surface("plane,resolution=12", Vec3(1, 0, 0), 4);
  for (Index i = 0; i < 40; ++i) surface.waves.directions[i] = Vec3::Zero();
  for (const Complex& z : solve(surface, options).z) ASSERT_NEAR(std::abs(z), 1, 1e-5);
}

TEST_P(EverySolver, SolvesASingleTriangleAndNothing) {
  WavySurface triangle;
  triangle.mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  triangle.mesh.triangles = {{0, 1, 2}};
  triangle.normals = vertex_normals(triangle.mesh);
  triangle.neighborhood = std::make_shared<const Adjacency>(vertex_neighborhood(triangle.mesh));
  triangle.waves = {triangle.mesh.positions,
                    projected_direction_field(kTiltedAxis, triangle.normals),
                    constant_frequency_field(0.2f, 3)};
  options.epsilon = 1e-6f;
  EXPECT_LT(solve(triangle, options).energy, 1e-4);

  PhaseGraph nothing;
  nothing.adjacency = std::make_shared<const Adjacency>();
  if (options.solver == Solver::averaged) return;  // needs levels, which no surface gives here
  for (const int cycles : {0, 1}) {
    options.cycles = cycles;
    EXPECT_TRUE(solve_phases(nothing, options).z.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Solver, EverySolver,
                         testing::Values(Solver::multilevel, Solver::relaxation, Solver::averaged,
                                         Solver::global),
                         [](const auto& param) { return std::string(name_of(param.param)); });

/// Tests that hold for the solvers that find the optimum wherever it is exact.
struct OptimalSolver : EverySolver {};

TEST_P(OptimalSolver, FindsAPlaneWaveExactly) {
  EXPECT_LT(solve(wavy_surface("plane,resolution=60", Vec3(1, 0.4f, 0), 30), options).energy, 1e-6);
}

TEST_P(OptimalSolver, FindsAWaveThatFitsACylinderExactly) {
  // Twelve periods around, by a direction along the circles; then along the axis.
  auto surface = wavy_surface("cylinder,resolution=96", Vec3(0, 0, 1), 10);
  EXPECT_LT(solve(surface, options).energy, 1e-6);
  surface.waves.directions =
      rotated(surface.waves.directions, surface.normals, static_cast<float>(M_PI / 2));
  // Around, chords are straight: the polygon's perimeter is what twelve periods have to fit.
  const float perimeter = 96 * 2 * 0.5f * std::sin(static_cast<float>(M_PI) / 96);
  surface.waves.frequencies = constant_frequency_field(12 / perimeter, surface.mesh.vertex_count());
  EXPECT_LT(solve(surface, options).energy, 1e-6);
}

TEST_P(OptimalSolver, DoesNotCareWhichWayDirectionsPoint) {
  auto surface = wavy_surface("torus,resolution=60", kTiltedAxis, 15);
  const PhaseSolution before = solve(surface, options);
  const auto flipped = flip_half(surface.waves, 11);
  const PhaseSolution after = solve(surface, options);
  EXPECT_NEAR(after.energy, before.energy, 0.1 * before.energy);
  // The same pattern: Im z is what a flip leaves unchanged.
  if (options.solver == Solver::multilevel) {
    for (std::size_t i = 0; i < flipped.size(); ++i) {
      ASSERT_NEAR(after.z[i].imag(), before.z[i].imag(), 2e-2) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Solver, OptimalSolver, testing::Values(Solver::multilevel, Solver::global),
                         [](const auto& param) { return std::string(name_of(param.param)); });

TEST(Relaxation, EnergyNeverRisesWithoutMomentum) {
  auto surface = wavy_surface("sphere,resolution=24", kTiltedAxis, 20);
  flip_half(surface.waves, 3);
  SolverOptions options = options_for(Solver::relaxation);
  options.momentum = 0;
  options.epsilon = 1e-5f;
  const PhaseSolution solution = solve(surface, options);
  ASSERT_GT(solution.energy_per_iteration.size(), 20u);
  for (std::size_t k = 1; k < solution.energy_per_iteration.size(); ++k) {
    EXPECT_LE(solution.energy_per_iteration[k], solution.energy_per_iteration[k - 1] + 1e-9);
  }
}

TEST(Relaxation, StopsLaterAndLowerForASmallerEpsilon) {
  const auto surface = wavy_surface("sphere,resolution=24", kTiltedAxis, 20);
  double last_energy = 1;
  int last_iterations = 0;
  for (const float epsilon : {0.1f, 0.02f, 0.001f}) {
    SolverOptions options = options_for(Solver::relaxation);
    options.epsilon = epsilon;
    const PhaseSolution solution = solve(surface, options);
    EXPECT_LT(solution.energy, last_energy);
    EXPECT_GT(solution.iterations, last_iterations);
    last_energy = solution.energy;
    last_iterations = solution.iterations;
  }
}

TEST(Relaxation, KeepsASolutionThatItIsGiven) {
  const auto surface = wavy_surface("plane,resolution=30", Vec3(1, 0, 0), 10);
  const PhaseGraph graph = surface.graph();
  const PhaseSolution exact = solve_phases(graph);
  const PhaseSolution kept = relax(graph, options_for(Solver::relaxation), exact.z);
  for (std::size_t i = 0; i < exact.z.size(); ++i) {
    EXPECT_LT(std::abs(kept.z[i] - exact.z[i]), 2e-3);
  }
}

TEST(Averaged, IsBetterThanRelaxationAlone) {
  const auto surface = wavy_surface("sphere,resolution=48", kTiltedAxis, 20);
  EXPECT_LT(solve(surface, options_for(Solver::averaged)).energy,
            0.7 * solve(surface, options_for(Solver::relaxation)).energy);
}

TEST(Averaged, SaysWhatItNeeds) {
  const auto surface = wavy_surface("plane,resolution=5", kTiltedAxis, 5);
  EXPECT_THROW(solve_phases(surface.graph(), options_for(Solver::averaged)), Error);
}

/// The number of threads of OpenBLAS, if that is what this build runs on.
struct OpenBlasThreads {
  using Get = int();
  using Set = void(int);
  Get* get = reinterpret_cast<Get*>(dlsym(RTLD_DEFAULT, "openblas_get_num_threads"));
  Set* set = reinterpret_cast<Set*>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
  int before = get ? get() : 0;
  ~OpenBlasThreads() {
    if (set) set(before);
  }
};

TEST(Global, IsTheSameHoweverManyThreadsThereAreAndBlasHas) {
  if (!is_available(Solver::global)) GTEST_SKIP() << "this build has no CHOLMOD";
  // Large enough for dense blocks that BLAS would share among threads.
  const auto surface = wavy_surface("sphere,resolution=60", kTiltedAxis, 20);
  const OpenBlasThreads blas;
  std::vector<Complex> first;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    if (blas.set) blas.set(threads);
    const std::vector<Complex> z = solve(surface, options_for(Solver::global)).z;
    if (first.empty()) first = z;
    EXPECT_EQ(z, first) << threads;
    if (blas.get) {
      EXPECT_EQ(blas.get(), threads) << "not put back";
    }
  }
}

TEST(Multilevel, IsAsGoodAsTheGlobalOptimum) {
  if (!is_available(Solver::global)) GTEST_SKIP() << "this build has no CHOLMOD";
  for (const char* shape :
       {"sphere,resolution=24", "torus,resolution=80", "mobius,resolution=16"}) {
    const auto surface = wavy_surface(shape, kTiltedAxis, 25);
    // Two sweeps leave a little where the optimum has next to no energy.
    EXPECT_LE(solve(surface, options_for(Solver::multilevel)).energy,
              1.05 * solve(surface, options_for(Solver::global)).energy + 5e-5)
        << shape;
  }
}

TEST(Multilevel, MoreSweepsNeverRaiseTheEnergy) {
  const auto surface = wavy_surface("sphere,resolution=24", kTiltedAxis, 25);
  SolverOptions options;
  double last = 1;
  for (const int sweeps : {1, 2, 8}) {
    options.sweeps = sweeps;
    const double now = solve(surface, options).energy;
    EXPECT_LT(now, last);
    last = now;
  }
}

TEST(Multilevel, CyclesApproachTheOptimum) {
  auto surface = wavy_surface("sphere,resolution=24", kTiltedAxis, 25);
  flip_half(surface.waves, 8);
  SolverOptions options;
  const double first = solve(surface, options).energy;
  options.cycles = 6;
  EXPECT_LT(solve(surface, options).energy, 0.8 * first);
}

TEST(Multilevel, AnchorsPullPhasesToTheirs) {
  const auto surface = wavy_surface("plane,resolution=30", Vec3(1, 0, 0), 10);
  PhaseGraph graph = surface.graph();
  const Complex turn = std::polar(1.0f, 1.0f);
  const PhaseSolution free = solve_phases(graph);
  for (const Complex& z : free.z) graph.anchor.push_back(0.5f * turn * z);
  const PhaseSolution anchored = solve_phases(graph);
  for (std::size_t i = 0; i < free.z.size(); ++i) {
    EXPECT_LT(std::abs(anchored.z[i] - turn * free.z[i]), 2e-3);
  }
}

TEST(SolverOptions, OutOfRangeAreRefused) {
  const auto surface = wavy_surface("plane,resolution=4", kTiltedAxis, 5);
  const auto refused = [&](auto change) {
    SolverOptions options = options_for(Solver::relaxation);
    change(options);
    EXPECT_THROW(solve_phases(surface.graph(), options), Error);
  };
  refused([](SolverOptions& o) { o.epsilon = -1; });
  refused([](SolverOptions& o) { o.epsilon = std::numeric_limits<float>::quiet_NaN(); });
  refused([](SolverOptions& o) { o.momentum = 1; });
  refused([](SolverOptions& o) { o.max_iterations = 0; });
  refused([](SolverOptions& o) { o.sweeps = -1; });
  refused([](SolverOptions& o) { o.cycles = -1; });
  refused([](SolverOptions& o) { o.global_iterations = 0; });
}

TEST(Solver, IsCancelledByItsProgressCallback) {
  const auto surface = wavy_surface("sphere,resolution=12", kTiltedAxis, 10);
  const Progress stop([](std::string_view, double) { return false; });
  for (const Solver solver : {Solver::multilevel, Solver::relaxation}) {
    EXPECT_THROW(solve_phases(surface.graph(), options_for(solver), stop), Cancelled);
  }
}

TEST(Solver, IsFoundByName) {
  EXPECT_EQ(parse_solver("global"), Solver::global);
  EXPECT_EQ(name_of(Solver::averaged), "averaged");
  EXPECT_FALSE(parse_solver("magic"));
}

}  // namespace
}  // namespace brindle
