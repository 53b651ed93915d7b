#include "brindle/phases/sliced_kernels.h"

#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "brindle/phases/hierarchy.h"
#include "instruction_sets.h"
#include "reflecting_graph.h"

namespace brindle {
namespace {

TEST(ConjugateBit, IsKeptBesideTheValue) {
  for (const bool bit : {false, true}) {
    const Complex value = with_conjugate_bit(Complex(-0.6f, 0.8f), bit);
    EXPECT_EQ(conjugate_bit(value), bit);
    EXPECT_NEAR(value.real(), -0.6f, 1e-7);
    EXPECT_EQ(value.imag(), 0.8f);
  }
}

#ifdef BRINDLE_HAS_HIGHWAY

/// A hierarchy with reflecting edges, anchors and, in its gauges, conjugates.
Hierarchy reflecting_hierarchy() {
  Hierarchy hierarchy = build_hierarchy(testing_support::reflecting_graph(true));
  std::mt19937 random(3);
  std::normal_distribution<float> component;
  for (Complex& z : hierarchy.levels[0].z) {
    z = std::polar(1.0f, 6.2831853f * component(random));
  }
  return hierarchy;
}

void expect_same_bits(const std::vector<Complex>& a, const std::vector<Complex>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(std::memcmp(&a[i], &b[i], sizeof(Complex)), 0) << i << ": " << a[i] << b[i];
  }
}

void expect_same_sweeps(const Hierarchy& hierarchy) {
  for (const Level& level : hierarchy.levels) {
    for (const float over_relaxation : {1.0f, 1.5f}) {
      std::vector<Complex> a = level.z, b = level.z;
      for (Index c = 0; c < level.layout().color_count(); ++c) {
        for (const SliceRange& color : level.layout().ranges_of(c)) {
          portable::sweep_slices(level.layout(), level.couplings, a.data(), over_relaxation, color);
          simd::sweep_slices(level.layout(), level.couplings, b.data(), over_relaxation, color);
        }
      }
      expect_same_bits(a, b);
    }
  }
}

TEST(SlicedKernels, VectorsSweepLikePortableCode) {
  const Hierarchy hierarchy = reflecting_hierarchy();
  testing_support::on_every_instruction_set([&] { expect_same_sweeps(hierarchy); });
}

void expect_same_relaxation(const Level& level) {
  std::vector<Complex> a = level.z, b = level.z;
  std::vector<Complex> m_a(a.size()), m_b(b.size());
  for (int iteration = 0; iteration < 3; ++iteration) {
    for (Index c = 0; c < level.layout().color_count(); ++c) {
      for (const SliceRange& color : level.layout().ranges_of(c)) {
        const double drop_a = portable::relax_slices(level.layout(), level.couplings, a.data(),
                                                     0.2f, m_a.data(), color);
        const double drop_b =
            simd::relax_slices(level.layout(), level.couplings, b.data(), 0.2f, m_b.data(), color);
        EXPECT_EQ(drop_a, drop_b);
      }
    }
  }
  expect_same_bits(a, b);
  expect_same_bits(m_a, m_b);
}

TEST(SlicedKernels, VectorsRelaxLikePortableCode) {
  const Hierarchy hierarchy = reflecting_hierarchy();
  testing_support::on_every_instruction_set([&] { expect_same_relaxation(hierarchy.levels[0]); });
}

/// The rows that add to a coarse block, in their gauges, where its rounds look for them.
std::vector<Complex> gauged_rows(const Level& fine, Index block) {
  const SumSchedule& sources = fine.aggregation().sources;
  std::vector<Complex> gauged(sources.places);
  Complex* row = gauged.data() + kLanes;
  for (const SliceRange& run : sources.runs_of(block)) {
    portable::gauge_slices(fine.layout(), fine.couplings, fine.gauge.data(), row, run);
    row += (fine.layout().column_begin[run.end] - fine.layout().column_begin[run.begin]) * kLanes;
  }
  return gauged;
}

void expect_equal_sums(const Level& fine, const Level& coarse, Index block) {
  const SumSchedule& sources = fine.aggregation().sources;
  const std::vector<Complex> gauged = gauged_rows(fine, block);
  const std::size_t floats = 2 * coarse.layout().entry_count();
  std::vector<float> sums_a(floats), sums_b(floats);
  std::vector<std::uint8_t> marked_a(coarse.layout().slice_count()), marked_b = marked_a;
  const SliceRange slices = coarse.layout().block(block);
  portable::sum_slices(coarse.layout(), sources.round_begin.data(), sources.entry.data(),
                       gauged.data(), sums_a.data(), marked_a.data(), slices);
  simd::sum_slices(coarse.layout(), sources.round_begin.data(), sources.entry.data(), gauged.data(),
                   sums_b.data(), marked_b.data(), slices);
  EXPECT_EQ(sums_a, sums_b);
  EXPECT_EQ(marked_a, marked_b);
  for (Index slice = slices.begin; slice < slices.end; ++slice) {
    if (!marked_a[slice]) continue;
    std::vector<Complex> b_a(std::size_t{coarse.layout().width(slice * kLanes)} * kLanes);
    std::vector<Complex> b_b = b_a;
    portable::sum_marked_slice(coarse.layout(), sources.round_begin.data(), sources.entry.data(),
                               gauged.data(), b_a.data(), slice);
    simd::sum_marked_slice(coarse.layout(), sources.round_begin.data(), sources.entry.data(),
                           gauged.data(), b_b.data(), slice);
    EXPECT_EQ(b_a, b_b);
    EXPECT_TRUE(std::ranges::any_of(b_a, [](Complex b) { return b != Complex(0); }));
  }
}

void expect_same_coarsening(const Level& fine, const Level& coarse) {
  const SliceRange slices{0, fine.layout().slice_count()};

  std::vector<Complex> gauge_a = fine.gauge, gauge_b = fine.gauge;
  const GaugeSchedule& rounds = fine.aggregation().gauges;
  for (const SliceRange& groups : rounds.ranges) {
    portable::gauge_members(fine.couplings, rounds, gauge_a.data(), groups);
    simd::gauge_members(fine.couplings, rounds, gauge_b.data(), groups);
  }
  expect_same_bits(gauge_a, gauge_b);

  std::vector<Complex> gauged_a(fine.layout().entry_count() + 1), gauged_b = gauged_a;
  portable::gauge_slices(fine.layout(), fine.couplings, fine.gauge.data(), gauged_a.data(), slices);
  simd::gauge_slices(fine.layout(), fine.couplings, fine.gauge.data(), gauged_b.data(), slices);
  expect_same_bits(gauged_a, gauged_b);

  for (Index block = 0; block < coarse.layout().block_count(); ++block) {
    expect_equal_sums(fine, coarse, block);
  }

  std::vector<Complex> z_a(fine.layout().slot_count()), z_b = z_a;
  portable::prolong_slices(fine.gauge.data(), fine.aggregation().coarse_slot.data(),
                           coarse.z.data(), z_a.data(), slices);
  simd::prolong_slices(fine.gauge.data(), fine.aggregation().coarse_slot.data(), coarse.z.data(),
                       z_b.data(), slices);
  expect_same_bits(z_a, z_b);
}

TEST(SlicedKernels, VectorsGaugeSumAndProlongLikePortableCode) {
  const Hierarchy hierarchy = reflecting_hierarchy();
  testing_support::on_every_instruction_set([&] {
    for (std::size_t l = 0; l + 1 < hierarchy.levels.size(); ++l) {
      expect_same_coarsening(hierarchy.levels[l], hierarchy.levels[l + 1]);
    }
  });
}

#endif  // BRINDLE_HAS_HIGHWAY

}  // namespace
}  // namespace brindle
