#include "brindle/gpu_solver.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/quality.h"
#include "device.h"
#include "phase_graphs.h"
#include "test_meshes.h"

namespace brindle {
namespace {

using testing_support::flip_half;
using testing_support::kAxis;
using testing_support::wavy_surface;
using testing_support::WavySurface;

using GpuSolverTest = test::GpuTest;

std::size_t branches_of(const WavySurface& surface, std::span<const Complex> z) {
  const auto corners =
      corner_phases(surface.mesh.triangles, surface.waves, z, PhaseShiftKind::aligned);
  return measure_quality(surface.mesh, surface.waves, corners).branches;
}

/// Energy within 1 % and branches within 3 %, but no fewer than two of them: where rounding decides
/// between two phases that are as good, one pair of branches may stand or fall.
void expect_agreement(const WavySurface& surface, const PhaseSolution& gpu,
                      const PhaseSolution& cpu) {
  EXPECT_NEAR(gpu.energy, cpu.energy, 0.01 * cpu.energy + 1e-7);
  const auto branches = static_cast<double>(branches_of(surface, cpu.z));
  EXPECT_NEAR(static_cast<double>(branches_of(surface, gpu.z)), branches,
              std::max(2.0, 0.03 * branches));
  EXPECT_EQ(gpu.iterations, cpu.iterations);
}

TEST_F(GpuSolverTest, AgreesWithTheProcessorOnEveryShape) {
  for (const auto& [name, mesh] : every_shape()) {
    SCOPED_TRACE(name);
    const auto surface = wavy_surface(name, kAxis, 25);
    const PhaseGraph graph = surface.graph();
    expect_agreement(surface, device.solver.solve(graph), solve_phases(graph));
  }
}

TEST_F(GpuSolverTest, AgreesWhereHalfOfTheDirectionsRunAgainstTheOthers) {
  for (const auto kind :
       {PhaseShiftKind::aligned, PhaseShiftKind::common_source, PhaseShiftKind::trapezoid}) {
    auto surface = wavy_surface("torus,resolution=80", kAxis, 25);
    flip_half(surface.waves, 7);
    const PhaseGraph graph = surface.graph(kind);
    expect_agreement(surface, device.solver.solve(graph), solve_phases(graph));
  }
}

TEST_F(GpuSolverTest, FurtherDescentsLowerTheEnergyAsOnTheProcessor) {
  auto surface = wavy_surface("trefoil", kAxis, 40);
  flip_half(surface.waves, 3);
  const PhaseGraph graph = surface.graph();
  SolverOptions options;
  options.cycles = 3;
  const PhaseSolution once = device.solver.solve(graph), more = device.solver.solve(graph, options);
  EXPECT_LE(more.energy, once.energy * 1.0001);
  expect_agreement(surface, more, solve_phases(graph, options));
}

TEST_F(GpuSolverTest, AgreesOnRealModels) {
  const std::filesystem::path folder = BRINDLE_SHARED_MODELS;
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no models in " << folder;
  for (const char* name : {"horse.ply", "nefertiti.obj", "spot.obj", "stanford-bunny.obj"}) {
    SCOPED_TRACE(name);
    const auto surface = testing_support::wavy_surface(read_mesh(folder / name).mesh, kAxis, 40);
    const PhaseGraph graph = surface.graph();
    expect_agreement(surface, device.solver.solve(graph), solve_phases(graph));
  }
}

TEST_F(GpuSolverTest, GraphsWithoutEdgesOrNodesAreSolved) {
  for (const std::size_t nodes : {std::size_t{0}, std::size_t{3}, std::size_t{5000}}) {
    auto adjacency = std::make_shared<Adjacency>();
    adjacency->offsets.assign(nodes + 1, 0);
    const WaveSet waves{std::vector<Vec3>(nodes, Vec3::Zero()),
                        std::vector<Vec3>(nodes, Vec3::UnitX()), std::vector<float>(nodes, 1.0f)};
    const PhaseGraph graph = build_phase_graph(adjacency, waves);
    EXPECT_EQ(device.solver.solve(graph).z, solve_phases(graph).z);
  }
}

TEST_F(GpuSolverTest, TheSameEveryTime) {
  const PhaseGraph graph = wavy_surface("trefoil", kAxis, 40).graph();
  EXPECT_EQ(device.solver.solve(graph).z, device.solver.solve(graph).z);
}

TEST_F(GpuSolverTest, OtherSolversAndBadOptionsAreErrors) {
  const PhaseGraph graph = wavy_surface("plane,resolution=5", kAxis, 5).graph();
  SolverOptions options;
  options.solver = Solver::averaged;
  EXPECT_THROW(device.solver.solve(graph, options), Error);
  options.solver = Solver::relaxation;
  options.cycles = 1;
  EXPECT_THROW(device.solver.solve(graph, options), Error);
  options = {};
  options.sweeps = -1;
  EXPECT_THROW(device.solver.solve(graph, options), Error);
}

}  // namespace
}  // namespace brindle
