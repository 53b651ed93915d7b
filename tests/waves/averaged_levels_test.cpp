#include "brindle/waves/averaged_levels.h"

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::wavy_surface;

TEST(AveragedLevels, HaveFewerAndFewerNodes) {
  const auto surface = wavy_surface("sphere,resolution=20", Vec3(0, 1, 0.2f), 8);
  const auto levels =
      averaged_levels(*surface.neighborhood, surface.waves,
                      {surface.normals, vertex_areas(surface.mesh)}, PhaseShiftKind::aligned, 6);
  ASSERT_EQ(levels.size(), 6u);
  std::size_t finer = surface.mesh.vertex_count();
  for (const AveragedLevel& level : levels) {
    EXPECT_EQ(level.parent.size(), finer);
    // Pairs at most, so never less than half.
    EXPECT_GE(2 * level.graph.node_count(), finer);
    finer = level.graph.node_count();
  }
  EXPECT_LT(8 * finer, surface.mesh.vertex_count());
}

/// All couplings of all levels but the finest.
std::vector<Complex> coarse_couplings(const testing_support::WavySurface& surface,
                                      std::span<const float> edge_weights) {
  std::vector<Complex> couplings;
  for (const AveragedLevel& level : averaged_levels(*surface.neighborhood, surface.waves,
                                                    {surface.normals, vertex_areas(surface.mesh)},
                                                    PhaseShiftKind::aligned, 4, edge_weights)) {
    const auto& more = level.graph.coupling;
    couplings.insert(couplings.end(), more.begin(), more.end());
  }
  return couplings;
}

TEST(AveragedLevels, CarryTheMeanOfTheEdgeWeights) {
  const auto surface = wavy_surface("sphere,resolution=20", Vec3(0, 1, 0.2f), 8);
  const std::size_t edges = surface.neighborhood->directed_edge_count();
  const std::vector<Complex> plain = coarse_couplings(surface, {});
  EXPECT_EQ(coarse_couplings(surface, std::vector<float>(edges, 1.0f)), plain);
  std::vector<Complex> doubled = plain;
  for (Complex& coupling : doubled) coupling *= 2;
  EXPECT_EQ(coarse_couplings(surface, std::vector<float>(edges, 2.0f)), doubled);
}

TEST(AveragedLevels, WeighEdgesThatAreNotAlike) {
  const auto surface = wavy_surface("sphere,resolution=20", Vec3(0, 1, 0.2f), 8);
  std::vector<float> weights;
  for (Index i = 0; i < surface.neighborhood->node_count(); ++i) {
    for (const Index j : surface.neighborhood->of(i)) {
      weights.push_back(0.5f + 0.1f * static_cast<float>((i * j) % 17));
    }
  }
  const SurfaceElements elements{surface.normals, vertex_areas(surface.mesh)};
  const Adjacency& fine = *surface.neighborhood;
  const auto plain = averaged_levels(fine, surface.waves, elements, PhaseShiftKind::aligned, 1);
  const auto weighted =
      averaged_levels(fine, surface.waves, elements, PhaseShiftKind::aligned, 1, weights);
  const std::vector<Index>& parent = weighted[0].parent;
  const PhaseGraph &coarse = plain[0].graph, &ours = weighted[0].graph;
  for (Index a = 0; a < coarse.node_count(); ++a) {
    for (Index edge = coarse.adjacency->offsets[a]; edge < coarse.adjacency->offsets[a + 1];
         ++edge) {
      const Index b = coarse.adjacency->neighbors[edge];
      double sum = 0, count = 0;
      for (Index i = 0; i < parent.size(); ++i) {
        if (parent[i] != a) continue;
        for (Index e = surface.neighborhood->offsets[i]; e < surface.neighborhood->offsets[i + 1];
             ++e) {
          if (parent[surface.neighborhood->neighbors[e]] != b) continue;
          sum += static_cast<double>(weights[e]);
          count += 1;
        }
      }
      ASSERT_NEAR(std::abs(ours.coupling[edge]),
                  std::abs(coarse.coupling[edge]) * static_cast<float>(sum / count), 1e-5f);
    }
  }
}

TEST(AveragedLevels, RefuseWeightsOfAnotherSurface) {
  const auto surface = wavy_surface("plane,resolution=5", Vec3(0, 1, 0.2f), 4);
  EXPECT_THROW(averaged_levels(*surface.neighborhood, surface.waves,
                               {surface.normals, vertex_areas(surface.mesh)},
                               PhaseShiftKind::aligned, 4, std::vector<float>(3, 1.0f)),
               Error);
}

TEST(AveragedLevels, PassAPlaneWaveDownExactly) {
  const auto surface = wavy_surface("plane,resolution=20", Vec3(1, 0.5f, 0), 8);
  const auto levels =
      averaged_levels(*surface.neighborhood, surface.waves,
                      {surface.normals, vertex_areas(surface.mesh)}, PhaseShiftKind::aligned, 1);
  const AveragedLevel& level = levels[0];
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
