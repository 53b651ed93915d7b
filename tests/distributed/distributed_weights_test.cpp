#include <gtest/gtest.h>

#include "brindle/distributed_stripes.h"
#include "brindle/geometry/measures.h"
#include "brindle/stripe_pattern.h"
#include "ranks.h"
#include "torn_mesh.h"

namespace brindle {
namespace {

using namespace testing_support;

DistributedOptions by_cotangents() {
  DistributedOptions options;
  options.weights = EdgeWeights::cotangent;
  return options;
}

TEST(DistributedWeights, OfOneRankHaveTheBitsOfTheLibrary) {
  if (rank_count() > 1) GTEST_SKIP() << "of one rank";
  const Parts parts(wavy_surface("molecule,resolution=40", kAxis, 40));
  StripeOptions options;
  options.weights = EdgeWeights::cotangent;
  const StripePattern pattern =
      stripe_pattern(make_surface(parts.whole.mesh), parts.whole.waves, options);
  AnimatorOptions weighted;
  weighted.edge_weights = cotangent_weights(parts.whole.mesh, *parts.whole.neighborhood);
  StripeAnimator expected(parts.whole.neighborhood, weighted);
  DistributedStripeAnimator animator(parts.surface(), by_cotangents());
  const FrameResult frame = animator.frame(frame_of(parts.whole.waves));
  EXPECT_TRUE(same_bits(frame.z, std::span<const Complex>(pattern.solution.z)));
  EXPECT_EQ(animator.energy(), pattern.solution.energy);
  expected.frame(frame_of(parts.whole.waves));
  WaveSet next = parts.whole.waves;
  next.directions = rotated(next.directions, parts.whole.normals, 0.1f);
  EXPECT_TRUE(same_bits(expected.frame(frame_of(next)).z, animator.frame(frame_of(next)).z));
}

/// What ranks say of the energy is what the library says of the same phases with the weights of the
/// whole.
TEST(DistributedWeights, AreThoseOfTheWholeHoweverItIsCut) {
  for (Mesh& mesh : std::vector<Mesh>{make_shape("trefoil,resolution=32"), torn_mesh()}) {
    const WavySurface whole = wavy_surface(std::move(mesh), kAxis, 20);
    const std::vector<float> weights = cotangent_weights(whole.mesh, *whole.neighborhood);
    for (const Cut& cut : cuts()) {
      SCOPED_TRACE(cut.name);
      const Parts parts(whole, cut.rank_of_triangle(whole.mesh));
      const DistributedSurface surface = parts.surface();
      for (const std::size_t plan_below : {std::size_t{0}, DistributedOptions().plan_below}) {
        DistributedOptions options = by_cotangents();
        options.gather_below = 300;
        options.plan_below = plan_below;
        DistributedStripeAnimator animator(surface, options);
        const FrameResult frame = animator.frame(frame_of(parts.of_piece(whole.waves)));
        const std::vector<Complex> all = parts.gathered(frame.z, surface.is_own());
        const PhaseGraph graph =
            build_phase_graph(whole.neighborhood, whole.waves, PhaseShiftKind::aligned, weights);
        const double measured = energy(graph, all);
        EXPECT_NEAR(animator.energy(), measured, 1e-5 * measured + 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace brindle
