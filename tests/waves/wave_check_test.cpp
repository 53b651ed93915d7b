#include "brindle/waves/wave_check.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

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
  const auto surface = wavy_surface("sphere,resolution=10", kAxis, 5);
  const auto is_taken = [&](float length, float frequency) {
    WaveSet w = surface.waves;
    w.directions[4] *= length;
    w.frequencies[5] = frequency;
    try {
      check_waves(w.positions, w.directions, w.frequencies);
    } catch (const Error& error) {
      const char* const vertex = length == 1 ? "vertex 5 " : "vertex 4 ";
      EXPECT_NE(std::string(error.what()).find(vertex), std::string::npos) << error.what();
      return false;
    }
    return true;
  };
  // Half a percent either way, and zero.
  for (const float length : {0.996f, 0.999f, 1.0f, 1.001f, 1.004f, 0.0f}) {
    EXPECT_TRUE(is_taken(length, 1)) << length;
  }
  for (const float length : {0.994f, 1.006f, 1e-10f}) EXPECT_FALSE(is_taken(length, 1)) << length;
  const float least = std::numeric_limits<float>::denorm_min();
  const float most = std::numeric_limits<float>::max();
  for (const float frequency : {least, 1e-30f, most}) EXPECT_TRUE(is_taken(1, frequency));
  for (const float frequency : {0.0f, -least, INFINITY}) EXPECT_FALSE(is_taken(1, frequency));
}

/// Directions that stick out of the plane z = 0 by so many degrees, at these shares of vertices.
struct Slant {
  double degrees;
  double share;
};

std::string refusal_of(const std::vector<Slant>& slants) {
  constexpr std::size_t kCount = 1000;
  const std::vector<Vec3> normals(kCount, Vec3(0, 0, 1));
  std::vector<Vec3> directions(kCount, Vec3(1, 0, 0));
  std::size_t next = 0;
  for (const auto& [degrees, share] : slants) {
    const double angle = degrees * std::numbers::pi / 180;
    const auto sign = static_cast<float>(next % 2 == 0 ? 1 : -1);
    const Vec3 slanted(static_cast<float>(std::cos(angle)), 0,
                       sign * static_cast<float>(std::sin(angle)));
    for (std::size_t n = 0; n < static_cast<std::size_t>(share * kCount + 0.5); ++n) {
      directions[next++] = slanted;
    }
  }
  try {
    check_tangent(normals, directions);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(WaveCheck, TakesDirectionsThatAreNearlyTangent) {
  EXPECT_EQ(refusal_of({}), "");
  EXPECT_EQ(refusal_of({{9.9, 1}}), "");                // all, by normals of another kind
  EXPECT_EQ(refusal_of({{55, 0.05}, {30, 0.05}}), "");  // a few, at sharp edges
}

TEST(WaveCheck, RefusesDirectionsThatAreNotTangent) {
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  const std::string upright = refusal_of({{0, 0.1}, {90, 0.001}});
  EXPECT_TRUE(has(upright, "vertex 100 sticks out of the surface by 90 degrees")) << upright;
  EXPECT_TRUE(has(upright, "tangent_directions")) << upright;
  EXPECT_NE(refusal_of({{90, 1}}), "");
  EXPECT_NE(refusal_of({{61, 0.001}}), "");
  const std::string many = refusal_of({{10.2, 0.101}});
  EXPECT_TRUE(has(many, "101 of 1000 by more than 10")) << many;
  EXPECT_EQ(refusal_of({{10.2, 0.1}}), "");
}

TEST(WaveCheck, AsksNothingOfVerticesWithoutANormalOrAWave) {
  const Vec3 up(0, 0, 1), none = Vec3::Zero();
  const std::vector<Vec3> normals{up, none, up}, directions{Vec3(1, 0, 0), up, none};
  EXPECT_NO_THROW(check_tangent(normals, directions));
}

TEST(WaveCheck, WhatIsTurnedAboutNormalsSticksOutByFourDegreesAtMost) {
  const std::vector<Vec3> normals(3, Vec3(0, 0, 1));
  const auto at = [](double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return Vec3(0, static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
  };
  EXPECT_NO_THROW(check_turnable(normals, std::vector<Vec3>{at(0), at(3.9), at(-3.9)}));
  try {
    check_turnable(normals, std::vector<Vec3>{at(0), at(4.1), at(0)});
    ADD_FAILURE() << "4.1 degrees were taken";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("vertex 1 sticks out of the surface by 4.1 degrees"),
              std::string::npos)
        << error.what();
  }
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
