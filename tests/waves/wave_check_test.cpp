#include "brindle/waves/wave_check.h"

#include <cmath>

#include <gtest/gtest.h>

#include "bad_waves.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::kAxis;
using testing_support::wavy_surface;

TEST(WaveCheck, RefusesEveryBadValueAndNamesTheFirstVertex) {
  const auto surface = wavy_surface("torus,resolution=80", kAxis, 25);
  // Beyond the first range that a thread works on.
  for (const std::size_t vertex : {std::size_t{5}, surface.waves.positions.size() - 2}) {
    testing_support::expect_refused(surface.waves, vertex, [](const WaveSet& waves) {
      check_waves(waves.positions, waves.directions, waves.frequencies);
    });
    testing_support::expect_refused(surface.waves, vertex, [&](const WaveSet& waves) {
      build_phase_graph(surface.neighborhood, waves);
    });
  }
}

TEST(WaveCheck, TakesUnitVectorsToRoundingAndZero) {
  auto surface = wavy_surface("sphere,resolution=10", kAxis, 5);
  surface.waves.directions[3].setZero();
  surface.waves.directions[4] *= 1.001f;
  surface.waves.frequencies[5] = 1e-30f;
  surface.waves.positions[6] *= 1e15f;
  const WaveSet& w = surface.waves;
  EXPECT_NO_THROW(check_waves(w.positions, w.directions, w.frequencies));
}

TEST(WaveCheck, RefusesEdgeWeightsThatAreNone) {
  const auto surface = wavy_surface("plane,resolution=4", kAxis, 3);
  for (const float bad : {std::nanf(""), -0.1f, INFINITY}) {
    std::vector<float> weights(surface.neighborhood->directed_edge_count(), 0.0f);
    EXPECT_NO_THROW(check_edge_weights(weights));
    weights[7] = bad;
    EXPECT_THROW(check_edge_weights(weights), Error);
    EXPECT_THROW(
        build_phase_graph(surface.neighborhood, surface.waves, PhaseShiftKind::aligned, weights),
        Error);
  }
}

}  // namespace
}  // namespace brindle
