#include "brindle/phase_graph.h"

#include <random>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::flip_half;
using testing_support::wavy_surface;

const Vec3 kTiltedAxis(0.3f, 0.9f, 0.2f);

std::vector<Complex> random_phases(std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> angle(0, 6.2831853f);
  std::vector<Complex> z(count);
  for (Complex& z_i : z) z_i = std::polar(1.0f, angle(random));
  return z;
}

TEST(PhaseGraph, CouplingsAreSymmetric) {
  auto surface = wavy_surface("torus,resolution=40", kTiltedAxis, 12);
  flip_half(surface.waves, 1);
  for (const auto kind :
       {PhaseShiftKind::aligned, PhaseShiftKind::common_source, PhaseShiftKind::trapezoid}) {
    const PhaseGraph graph = surface.graph(kind);
    const Adjacency& adjacency = *graph.adjacency;
    std::size_t reflecting = 0;
    for (Index i = 0; i < graph.node_count(); ++i) {
      for (Index edge = adjacency.offsets[i]; edge < adjacency.offsets[i + 1]; ++edge) {
        const Index j = adjacency.neighbors[edge];
        const auto row = adjacency.of(j);
        const Index back = adjacency.offsets[j] +
                           static_cast<Index>(std::ranges::lower_bound(row, i) - row.begin());
        ASSERT_EQ(graph.reflecting[edge], graph.reflecting[back]);
        const Complex expected =
            graph.reflecting[edge] ? graph.coupling[edge] : std::conj(graph.coupling[edge]);
        ASSERT_LT(std::abs(graph.coupling[back] - expected), 1e-4f) << name_of(kind);
        reflecting += graph.reflecting[edge];
      }
    }
    EXPECT_GT(reflecting, 0u);
  }
}

TEST(PhaseGraph, EnergyOfRandomPhasesIsAboutOneHalf) {
  const auto surface = wavy_surface("sphere,resolution=20", kTiltedAxis, 10);
  const PhaseGraph graph = surface.graph();
  EXPECT_NEAR(energy(graph, random_phases(graph.node_count())), 0.5, 0.02);
}

TEST(PhaseGraph, EnergyOfWhatIsNoNumberIsNone) {
  const auto surface = wavy_surface("sphere,resolution=12", kTiltedAxis, 10);
  PhaseGraph graph = surface.graph();
  std::vector<Complex> z = random_phases(graph.node_count());
  z[7] = std::nanf("");
  EXPECT_TRUE(std::isnan(energy(graph, z)));
  z[7] = 1;
  graph.coupling[5] = {0, std::nanf("")};
  EXPECT_TRUE(std::isnan(energy(graph, z)));
  graph.coupling.assign(graph.coupling.size(), Complex(0));
  EXPECT_EQ(energy(graph, z), 0);
}

TEST(PhaseGraph, EnergyStaysWhenDirectionsAreTurnedRoundWithTheirPhases) {
  auto surface = wavy_surface("sphere,resolution=12", kTiltedAxis, 10);
  std::vector<Complex> z = random_phases(surface.mesh.vertex_count());
  const double before = energy(surface.graph(), z);
  const auto flipped = flip_half(surface.waves, 2);
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (flipped[i]) z[i] = -std::conj(z[i]);
  }
  EXPECT_NEAR(energy(surface.graph(), z), before, 1e-6);
}

TEST(PhaseGraph, EnergyOfAPlaneWaveIsZero) {
  const auto surface = wavy_surface("plane,resolution=30", Vec3(1, 2, 0), 15);
  std::vector<Complex> z;
  for (std::size_t i = 0; i < surface.mesh.vertex_count(); ++i) {
    const float along = surface.waves.directions[i].dot(surface.mesh.positions[i]);
    z.push_back(std::polar(1.0f, 6.2831853f * surface.waves.frequencies[i] * along));
  }
  EXPECT_LT(energy(surface.graph(), z), 1e-8);
}

TEST(PhaseGraph, AVertexWithoutAWaveHasNoInfluence) {
  auto surface = wavy_surface("plane,resolution=10", Vec3(1, 0, 0), 5);
  surface.waves.directions[17] = Vec3::Zero();
  const PhaseGraph graph = surface.graph();
  for (Index edge = graph.adjacency->offsets[17]; edge < graph.adjacency->offsets[18]; ++edge) {
    EXPECT_EQ(graph.coupling[edge], Complex(0));
  }
}

TEST(PhaseGraph, EdgeWeightsMultiplyCouplings) {
  const auto surface = wavy_surface("plane,resolution=5", Vec3(1, 0, 0), 5);
  const std::vector<float> twice(surface.neighborhood->directed_edge_count(), 2.0f);
  const PhaseGraph once = surface.graph();
  const PhaseGraph doubled =
      build_phase_graph(surface.neighborhood, surface.waves, PhaseShiftKind::aligned, twice);
  for (std::size_t edge = 0; edge < twice.size(); ++edge) {
    EXPECT_LT(std::abs(doubled.coupling[edge] - 2.0f * once.coupling[edge]), 1e-6f);
  }
}

TEST(PhaseGraph, RefusesWavesOfAnotherSurface) {
  auto surface = wavy_surface("plane,resolution=5", Vec3(1, 0, 0), 5);
  surface.waves.frequencies.pop_back();
  EXPECT_THROW(surface.graph(), Error);
}

}  // namespace
}  // namespace brindle
