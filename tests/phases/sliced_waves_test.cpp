#include "brindle/phases/sliced_waves.h"

#include <cmath>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/phases/sliced_kernels.h"
#include "instruction_sets.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

struct Coupled {
  SlicedCouplings couplings;
  std::vector<float> degree;
};

struct SlicedWaves : testing::TestWithParam<PhaseShiftKind> {
  testing_support::WavySurface surface =
      testing_support::wavy_surface("torus,resolution=50", Vec3(0.3f, 0.9f, 0.2f), 60);
  SlicedLayout layout =
      sliced_layout(*surface.neighborhood, greedy_coloring(*surface.neighborhood));
  std::vector<SlicedWave> waves;

  void SetUp() override {
    testing_support::flip_half(surface.waves, 5);
    surface.waves.directions[7].setZero();
    load_waves(layout, surface.waves.positions, surface.waves.directions, surface.waves.frequencies,
               waves);
  }

  template <class Kernel>
  Coupled coupled(const Kernel& kernel) const {
    Coupled result{SlicedCouplings(layout), std::vector<float>(layout.slot_count())};
    kernel(layout, waves.data(), GetParam(), nullptr, result.couplings, result.degree.data(),
           SliceRange{0, layout.slice_count()});
    return result;
  }

  void expect_same(const Coupled& a, const SlicedCouplings& b) const {
    for (Index slice = 0; slice < layout.slice_count(); ++slice) {
      ASSERT_EQ(a.couplings.reflecting_count[slice], b.reflecting_count[slice]);
    }
    for (std::size_t entry = 0; entry < layout.entry_count(); ++entry) {
      ASSERT_LT(std::abs(a.couplings.direct_at(entry) - b.direct_at(entry)), 1e-4f) << entry;
    }
    for (Index slice = 0; slice < layout.slice_count(); ++slice) {
      const auto list_a = a.couplings.reflecting_of(layout, slice);
      const auto list_b = b.reflecting_of(layout, slice);
      for (std::size_t r = 0; r < list_a.size(); ++r) {
        ASSERT_EQ(list_a[r].entry, list_b[r].entry);
        ASSERT_LT(std::abs(list_a[r].b - list_b[r].b), 1e-4f);
      }
    }
  }
};

TEST_P(SlicedWaves, HaveNoEnergyThatHidesWhatIsNoNumber) {
  SlicedCouplings couplings(layout);
  load_couplings(surface.graph(GetParam()), layout, couplings);
  std::vector<Complex> z(layout.slot_count(), Complex(1));
  EXPECT_GT(energy(layout, couplings, z), 0);
  z[layout.slot_of[9]] = std::nanf("");
  EXPECT_TRUE(std::isnan(energy(layout, couplings, z)));
}

TEST_P(SlicedWaves, TurnPhasesWithDirectionsAndBack) {
  auto turned = surface.waves;
  testing_support::flip_half(turned, 8);
  std::vector<Complex> z(layout.slot_count(), Complex(0.6f, 0.8f));
  const std::vector<Complex> before = z;
  std::vector<SlicedWave> next, in_place = waves;
  EXPECT_TRUE(
      load_waves(layout, turned.positions, turned.directions, turned.frequencies, next, waves, z));
  EXPECT_NE(z, before);
  std::vector<Complex> twin = before;
  EXPECT_TRUE(load_waves(layout, turned.positions, turned.directions, turned.frequencies, in_place,
                         in_place, twin));
  EXPECT_EQ(z, twin);
  EXPECT_FALSE(load_waves(layout, turned.positions, turned.directions, turned.frequencies, in_place,
                          next, twin));
  EXPECT_EQ(z, twin);
  turn_phases(waves, next, z);
  EXPECT_EQ(z, before);
}

TEST_P(SlicedWaves, AreCoupledLikeAPhaseGraph) {
  SlicedCouplings expected(layout);
  load_couplings(surface.graph(GetParam()), layout, expected);
  expect_same(coupled(portable::couple_slices), expected);
  expect_same(coupled(kernels::couple_slices), expected);
}

#ifdef BRINDLE_HAS_HIGHWAY

TEST_P(SlicedWaves, VectorsGiveTheNumbersOfPortableCode) {
  // Shifts of thousands of periods.
  for (SlicedWave& wave : waves) wave.root_frequency *= 30;
  const Coupled expected = coupled(portable::couple_slices);
  testing_support::on_every_instruction_set([&] {
    const Coupled result = coupled(simd::couple_slices);
    EXPECT_EQ(result.degree, expected.degree);
    for (std::size_t entry = 0; entry < layout.entry_count(); ++entry) {
      ASSERT_EQ(result.couplings.direct_at(entry), expected.couplings.direct_at(entry)) << entry;
    }
    for (Index slice = 0; slice < layout.slice_count(); ++slice) {
      const auto list_a = result.couplings.reflecting_of(layout, slice);
      const auto list_b = expected.couplings.reflecting_of(layout, slice);
      ASSERT_EQ(list_a.size(), list_b.size());
      for (std::size_t r = 0; r < list_a.size(); ++r) {
        ASSERT_EQ(list_a[r].entry, list_b[r].entry);
        ASSERT_EQ(list_a[r].b, list_b[r].b);
      }
    }
  });
}

#endif

TEST_P(SlicedWaves, DegreesAreSumsOfWeights) {
  const PhaseGraph graph = surface.graph(GetParam());
  const Coupled result = coupled(kernels::couple_slices);
  for (Index node = 0; node < graph.node_count(); ++node) {
    float degree = 0;
    for (Index edge = graph.adjacency->offsets[node]; edge < graph.adjacency->offsets[node + 1];
         ++edge) {
      degree += std::abs(graph.coupling[edge]);
    }
    ASSERT_NEAR(result.degree[layout.slot_of[node]], degree, 1e-4f);
  }
}

INSTANTIATE_TEST_SUITE_P(Kind, SlicedWaves,
                         testing::Values(PhaseShiftKind::aligned, PhaseShiftKind::trapezoid),
                         [](const auto& param) { return std::string(name_of(param.param)); });

TEST(SlicedWavesKind, TheCommonSourceIsRefused) {
  const SlicedLayout layout;
  SlicedCouplings couplings(layout);
  EXPECT_THROW(couple(layout, {}, PhaseShiftKind::common_source, {}, couplings, {}), Error);
}

}  // namespace
}  // namespace brindle
