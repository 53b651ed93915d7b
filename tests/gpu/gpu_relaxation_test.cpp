#include "brindle/gpu/gpu_relaxation.h"

#include <cmath>

#include "brindle/phases/relaxation.h"
#include "device.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::flip_half;
using testing_support::kAxis;
using testing_support::wavy_surface;

using GpuRelaxationTest = test::GpuTest;

SolverOptions relaxation(float epsilon) {
  SolverOptions options;
  options.solver = Solver::relaxation;
  options.epsilon = epsilon;
  return options;
}

void expect_same_course(const PhaseSolution& gpu, const PhaseSolution& cpu) {
  ASSERT_EQ(gpu.iterations, cpu.iterations);
  ASSERT_EQ(gpu.energy_per_iteration.size(), cpu.energy_per_iteration.size());
  for (std::size_t i = 0; i < cpu.energy_per_iteration.size(); ++i) {
    ASSERT_NEAR(gpu.energy_per_iteration[i], cpu.energy_per_iteration[i], 1e-5) << i;
  }
  EXPECT_NEAR(gpu.energy_per_iteration.back(), gpu.energy, 1e-5);
}

TEST_F(GpuRelaxationTest, HasTheEnergiesOfTheProcessorInEveryIteration) {
  for (const char* shape : {"torus,resolution=80", "sphere,resolution=40", "trefoil"}) {
    for (const float epsilon : {0.05f, 0.02f, 0.005f}) {
      SCOPED_TRACE(testing::Message() << shape << ", epsilon " << epsilon);
      auto surface = wavy_surface(shape, kAxis, 30);
      flip_half(surface.waves, 11);
      const PhaseGraph graph = surface.graph();
      expect_same_course(device.solver.solve(graph, relaxation(epsilon)),
                         solve_phases(graph, relaxation(epsilon)));
    }
  }
}

TEST_F(GpuRelaxationTest, EverySwitchOfThePaperDoesTheSame) {
  const PhaseGraph graph = wavy_surface("torus,resolution=80", kAxis, 30).graph();
  SolverOptions options = relaxation(0.02f);
  options.momentum = 0;
  expect_same_course(device.solver.solve(graph, options), solve_phases(graph, options));
  options.skip_last_third = false;
  expect_same_course(device.solver.solve(graph, options), solve_phases(graph, options));
  options.seed = 5;
  options.max_iterations = 13;
  options.epsilon = 0;
  const PhaseSolution gpu = device.solver.solve(graph, options);
  EXPECT_EQ(gpu.iterations, 13);
  expect_same_course(gpu, solve_phases(graph, options));
}

TEST_F(GpuRelaxationTest, StartsWhereItIsTold) {
  const PhaseGraph graph = wavy_surface("torus,resolution=80", kAxis, 30).graph();
  const std::vector<Complex> start = solve_phases(graph).z;
  const SolverOptions options = relaxation(0.01f);
  expect_same_course(relax_on_gpu(device.solver.kernels(), graph, options, start),
                     relax(graph, options, start));
}

TEST_F(GpuRelaxationTest, NothingToRelaxIsLeftAlone) {
  auto adjacency = std::make_shared<Adjacency>();
  adjacency->offsets.assign(4, 0);
  const WaveSet waves{std::vector<Vec3>(3, Vec3::Zero()), std::vector<Vec3>(3, Vec3::UnitX()),
                      std::vector<float>(3, 1.0f)};
  const PhaseGraph graph = build_phase_graph(adjacency, waves);
  const PhaseSolution gpu = device.solver.solve(graph, relaxation(0.02f));
  EXPECT_EQ(gpu.iterations, 0);
  EXPECT_EQ(gpu.z, solve_phases(graph, relaxation(0.02f)).z);
}

}  // namespace
}  // namespace brindle
