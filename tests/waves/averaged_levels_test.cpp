#include "brindle/waves/averaged_levels.h"

#include <gtest/gtest.h>

#include "brindle/geometry/areas.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::wavy_surface;

TEST(AveragedLevels, HaveFewerAndFewerNodes) {
  const auto surface = wavy_surface("sphere,resolution=20", Vec3(0, 1, 0.2f), 8);
  PhaseGraph graph = surface.graph();
  attach_averaged_levels(graph, surface.waves, {surface.normals, vertex_areas(surface.mesh)},
                         PhaseShiftKind::aligned, 6);
  int levels = 0;
  const PhaseGraph* level = &graph;
  for (; level->averaged; level = &level->averaged->graph, ++levels) {
    // Pairs at most, so never less than half.
    EXPECT_GE(2 * level->averaged->graph.node_count(), level->node_count());
  }
  EXPECT_EQ(levels, 6);
  EXPECT_LT(8 * level->node_count(), graph.node_count());
}

TEST(AveragedLevels, PassAPlaneWaveDownExactly) {
  const auto surface = wavy_surface("plane,resolution=20", Vec3(1, 0.5f, 0), 8);
  PhaseGraph graph = surface.graph();
  attach_averaged_levels(graph, surface.waves, {surface.normals, vertex_areas(surface.mesh)},
                         PhaseShiftKind::aligned, 1);
  const AveragedLevel& level = *graph.averaged;
  // A plane wave sampled at the averaged positions: recovered here from any one child.
  std::vector<Complex> coarse(level.graph.node_count(), Complex(0));
  std::vector<Complex> exact;
  for (std::size_t i = 0; i < surface.mesh.vertex_count(); ++i) {
    const float along = surface.waves.directions[i].dot(surface.mesh.positions[i]);
    exact.push_back(std::polar(1.0f, 6.2831853f * surface.waves.frequencies[i] * along));
    coarse[level.parent[i]] = exact[i] * std::conj(level.transfer[i]);
  }
  for (std::size_t i = 0; i < exact.size(); ++i) {
    ASSERT_FALSE(level.transfer_reflects[i]);
    EXPECT_LT(std::abs(level.transfer[i] * coarse[level.parent[i]] - exact[i]), 1e-3f);
  }
  EXPECT_LT(energy(level.graph, coarse), 1e-6);
}

}  // namespace
}  // namespace brindle
