#include "brindle/branch_pairs.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/threads.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::kAxis;

/// Many branches, most of them in pairs that need not be.
struct Knot {
  Surface surface = make_surface(make_shape("trefoil,resolution=28"));
  StripeOptions options;

  StripePattern pattern() const {
    return stripe_pattern(surface, projected_direction_field(kAxis, surface.normals), 8, options);
  }
};

double energy_again(const Surface& surface, const StripePattern& pattern) {
  return energy(build_phase_graph(surface.neighborhood, pattern.waves, pattern.phase_shift),
                pattern.solution.z);
}

TEST(BranchPairs, AreFewerAtNoMoreEnergy) {
  const Knot knot;
  StripePattern pattern = knot.pattern();
  const std::size_t before = pattern.quality.branches;
  const double energy_before = pattern.solution.energy;
  const CancelledBranches merged = cancel_branches(knot.surface, pattern, {0});
  EXPECT_GT(merged.pairs, 2u);
  EXPECT_EQ(merged.branches_before, before);
  EXPECT_LE(merged.branches_after + 2 * merged.pairs, before);
  EXPECT_EQ(merged.branches_after, pattern.quality.branches);
  EXPECT_EQ(merged.energy_before, energy_before);
  EXPECT_LE(merged.energy_after, energy_before * (1 + 1e-6));
  EXPECT_NEAR(merged.energy_after, energy_again(knot.surface, pattern), 1e-9);
  EXPECT_EQ(pattern.quality.field_singularities, knot.pattern().quality.field_singularities);
}

TEST(BranchPairs, GoAsLongAsTheEnergyAllows) {
  const Knot knot;
  std::size_t last = knot.pattern().quality.branches;
  for (const double share : {0.0, 0.1, 0.5}) {
    StripePattern pattern = knot.pattern();
    const CancelledBranches merged = cancel_branches(knot.surface, pattern, {share});
    EXPECT_LE(merged.branches_after, last);
    EXPECT_LE(merged.energy_after, (1 + share + 1e-6) * merged.energy_before);
    last = merged.branches_after;
  }
}

TEST(BranchPairs, AreLookedForAsFarAwayAsIsAsked) {
  // Straight waves, but for one that begins at A and ends at B, 20 periods farther.
  const Surface plane = make_surface(make_shape("plane,width=4,height=1,resolution=160"));
  const std::complex<float> a(-0.99f, 0.006f), b(1.01f, 0.006f);
  StripeOptions options;
  options.solve = [&](const PhaseGraph& graph, const SolverOptions&, const Progress&,
                      const SolverData&) {
    PhaseSolution solution;
    for (const Vec3& at : plane.mesh.positions) {
      const std::complex<float> place(at.x(), at.y());
      const auto z = std::polar(1.0f, 20 * std::numbers::pi_v<float> * at.x()) * (place - a) *
                     std::conj(place - b);
      solution.z.push_back(z / std::abs(z));
    }
    solution.energy = energy(graph, solution.z);
    return solution;
  };
  const StripePattern pattern =
      stripe_pattern(plane, DirectionField(plane.mesh.vertex_count(), Vec3::UnitX()), 10, options);
  ASSERT_EQ(pattern.quality.branches, 2u);
  StripePattern nearer = pattern, farther = pattern;
  EXPECT_EQ(cancel_branches(plane, nearer, {1, 19}).pairs, 0u);
  EXPECT_EQ(nearer.solution.z, pattern.solution.z);
  EXPECT_EQ(cancel_branches(plane, farther, {0, 25}).pairs, 1u);
  EXPECT_EQ(farther.quality.branches, 0u);
  EXPECT_LT(farther.solution.energy, 0.1 * pattern.solution.energy);
}

TEST(BranchPairs, CostLessWhereMoreIsSolvedForAround) {
  const Knot knot;
  StripePattern pattern = knot.pattern(), as_always = pattern, said = pattern, wide = pattern;
  cancel_branches(knot.surface, as_always, {0.2});
  cancel_branches(knot.surface, said, {0.2, 10});
  EXPECT_EQ(as_always.solution.z, said.solution.z);
  cancel_branches(knot.surface, wide, {0.2, 25});
  EXPECT_LT(wide.quality.branches, pattern.quality.branches);
  EXPECT_LT(wide.solution.energy, said.solution.energy);
}

TEST(BranchPairs, OfAnySolverAreTaken) {
  Knot knot;
  for (const Solver solver : {Solver::relaxation, Solver::averaged, Solver::global}) {
    if (!is_available(solver)) continue;
    knot.options.solver.solver = solver;
    StripePattern pattern = knot.pattern();
    const CancelledBranches merged = cancel_branches(knot.surface, pattern, {0.1}, knot.options);
    EXPECT_LE(merged.branches_after, merged.branches_before) << name_of(solver);
    EXPECT_LE(merged.energy_after, 1.1001 * merged.energy_before) << name_of(solver);
    EXPECT_NEAR(merged.energy_after, energy_again(knot.surface, pattern), 1e-9);
  }
}

TEST(BranchPairs, HardlyDependOnHowDirectionsAreSigned) {
  const Knot knot;
  StripePattern pattern = knot.pattern(), other = pattern;
  const auto flipped = testing_support::flip_half(other.waves, 5);
  for (std::size_t v = 0; v < flipped.size(); ++v) {
    if (flipped[v]) other.solution.z[v] = -std::conj(other.solution.z[v]);
  }
  other.corners =
      corner_phases(knot.surface.mesh.triangles, other.waves, other.solution.z, other.phase_shift);
  const CancelledBranches a = cancel_branches(knot.surface, pattern, {0.1});
  const CancelledBranches b = cancel_branches(knot.surface, other, {0.1});
  EXPECT_NEAR(static_cast<double>(a.pairs), static_cast<double>(b.pairs), 1);
}

TEST(BranchPairs, AreTheSameForEveryNumberOfThreads) {
  const Knot knot;
  StripePattern alone = knot.pattern(), together = alone;
  const ThreadLimit one(1);
  cancel_branches(knot.surface, alone, {0.1});
  const ThreadLimit two(2);
  cancel_branches(knot.surface, together, {0.1});
  EXPECT_EQ(alone.solution.z, together.solution.z);
}

TEST(BranchPairs, LeaveFixedPhasesAndPatternsWithoutBranchesAsTheyAre) {
  Knot knot;
  StripePattern pattern = knot.pattern();
  knot.options.fixed_phases = pattern.solution.z;
  const auto before = pattern.solution.z;
  EXPECT_EQ(cancel_branches(knot.surface, pattern, {1}, knot.options).pairs, 0u);
  EXPECT_EQ(pattern.solution.z, before);

  const Surface plane = make_surface(make_shape("plane,resolution=20"));
  StripePattern straight =
      stripe_pattern(plane, projected_direction_field(Vec3::UnitX(), plane.normals), 4);
  const auto z = straight.solution.z;
  EXPECT_EQ(cancel_branches(plane, straight, {1}).pairs, 0u);
  EXPECT_EQ(straight.solution.z, z);
}

TEST(BranchPairs, OfTexturesGoFromBothPatterns) {
  const Knot knot;
  const TextureOptions options{.stripes = knot.options};
  const DirectionField field = projected_direction_field(kAxis, knot.surface.normals);
  TexturePattern texture = texture_pattern(knot.surface, field, 8, options);
  StripePattern u = texture.u, v = texture.v;
  const CancelledBranches of_u = cancel_branches(knot.surface, u, {0.05}),
                          of_v = cancel_branches(knot.surface, v, {0.05});
  ASSERT_GT(of_u.pairs, 0u);
  ASSERT_GT(of_v.pairs, 0u);
  const CancelledBranches merged = cancel_branches(knot.surface, texture, {0.05}, options);
  EXPECT_EQ(texture.u.solution.z, u.solution.z);
  EXPECT_EQ(texture.v.solution.z, v.solution.z);
  EXPECT_EQ(merged.pairs, of_u.pairs + of_v.pairs);
  EXPECT_EQ(merged.branches_after, u.quality.branches + v.quality.branches);
  EXPECT_DOUBLE_EQ(merged.energy_after, u.solution.energy + v.solution.energy);
  // Corners have the waves of the patterns, some of them turned round.
  for (std::size_t t = 0; t < knot.surface.mesh.triangle_count(); ++t) {
    for (int m = 0; m < 3; ++m) {
      const Complex z = u.solution.z[knot.surface.mesh.triangles[t][m]];
      const Complex corner = texture.waves.u[t][m].z;
      EXPECT_TRUE(corner == z || corner == -std::conj(z));
    }
  }
}

TEST(BranchPairs, OfCrossesGoFromBothWavesTogether) {
  for (const char* shape : {"vessels,resolution=36", "molecule,resolution=20"}) {
    const Surface surface = make_surface(make_shape(shape));
    const float diagonal = bounding_box(surface.mesh).diagonal();
    const DirectionField field =
        smooth_direction_field(surface, {.symmetry = 4, .normal_radius = 0.02f * diagonal});
    const WaveSet waves{surface.mesh.positions, field,
                        constant_frequency_field(25 / diagonal, surface.mesh.vertex_count())};
    const CrossPattern before = cross_pattern(surface, waves);
    CrossPattern cross = before;
    const CancelledBranches merged = cancel_branches(surface, cross, {0});
    EXPECT_GT(merged.pairs, 2u) << shape;
    EXPECT_LE(merged.energy_after, merged.energy_before * (1 + 1e-6)) << shape;
    EXPECT_NEAR(merged.energy_after, energy_again(cross.surface, cross.pattern), 1e-9) << shape;
    const std::size_t singular = 2 * cross.cover.singular.size();
    EXPECT_EQ(before.quality.branches, merged.branches_before + singular) << shape;
    EXPECT_EQ(cross.quality.branches, merged.branches_after + singular) << shape;
    EXPECT_EQ(cross.quality.field_singularities, before.quality.field_singularities) << shape;

    CrossPattern kept = before;
    const Progress cancelling([](std::string_view, double) { return false; });
    EXPECT_THROW(cancel_branches(surface, kept, {0}, {}, cancelling), Cancelled);
    EXPECT_EQ(kept.pattern.solution.z, before.pattern.solution.z) << shape;
  }
}

TEST(BranchPairs, RefuseWhatCannotBe) {
  const Knot knot;
  StripePattern pattern = knot.pattern();
  for (const double bad : {-0.1, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(cancel_branches(knot.surface, pattern, {bad}), Error);
  }
  const Surface other = make_surface(make_shape("torus,resolution=16"));
  for (const double bad : {0.0, -1.0, 1001.0, std::nan("")}) {
    EXPECT_THROW(cancel_branches(knot.surface, pattern, {0, bad}), Error);
  }
  EXPECT_THROW(cancel_branches(other, pattern, {0}), Error);
  const auto before = pattern.solution.z;
  const Progress cancelling([](std::string_view, double) { return false; });
  EXPECT_THROW(cancel_branches(knot.surface, pattern, {0}, {}, cancelling), Cancelled);
  EXPECT_EQ(pattern.solution.z, before);
}

}  // namespace
}  // namespace brindle
