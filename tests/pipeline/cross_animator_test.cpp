#include "brindle/cross_animator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/cross_texture.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/fragment_phase.h"
#include "brindle/frequency_field.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"

namespace brindle {
namespace {

constexpr float kQuarter = std::numbers::pi_v<float> / 2;

struct CrossedSurface {
  Surface surface;
  WaveSet waves;
};

CrossedSurface crossed(const char* shape, float stripes = 25) {
  Surface surface = make_surface(make_shape(shape));
  const float frequency = frequency_of_stripes(stripes, bounding_box(surface.mesh).diagonal());
  WaveSet waves{surface.mesh.positions, smooth_direction_field(surface, {.symmetry = 4}),
                constant_frequency_field(frequency, surface.mesh.vertex_count())};
  return {std::move(surface), std::move(waves)};
}

CrossFrameInput cross_input_of(const WaveSet& waves) {
  return {{waves.positions, waves.directions, waves.frequencies}, {}};
}

WaveSet turned(const CrossedSurface& c, float radians) {
  WaveSet waves = c.waves;
  waves.directions = rotated(waves.directions, c.surface.normals, radians);
  return waves;
}

/// The same crosses, each given by another one of its directions.
WaveSet renamed(const CrossedSurface& c, WaveSet waves) {
  for (std::size_t i = 0; i < waves.directions.size(); ++i) {
    Vec3& d = waves.directions[i];
    if (i % 3 == 1) d = c.surface.normals[i].cross(d);
    if (i % 5 < 2) d = -d;
  }
  return waves;
}

/// The crosses of the surface turned about an axis, so that their singularities move over it.
WaveSet carried_round(const CrossedSurface& c, float radians) {
  WaveSet waves = c.waves;
  const Eigen::AngleAxisf back(-radians, Vec3(0.36f, 0.48f, 0.8f));
  const Mesh& mesh = c.surface.mesh;
  for (std::size_t i = 0; i < waves.directions.size(); ++i) {
    const Vec3 place = back * mesh.positions[i];
    const auto nearest = std::ranges::min_element(
        mesh.positions, {}, [&](const Vec3& p) { return (p - place).squaredNorm(); });
    const Vec3 direction = back.inverse() * c.waves.directions[nearest - mesh.positions.begin()];
    waves.directions[i] = tangent_direction(direction, c.surface.normals[i]);
  }
  return waves;
}

/// sin Phi of both waves in the middle of every triangle, in ascending order.
std::vector<std::array<float, 2>> shown(const TextureWaves& waves) {
  std::vector<std::array<float, 2>> result;
  for (std::size_t t = 0; t < waves.triangle_count(); ++t) {
    const float u = fragment_phase(waves.u[t], Vec3::Constant(1.0f / 3)).z.imag();
    const float v = fragment_phase(waves.v[t], Vec3::Constant(1.0f / 3)).z.imag();
    result.push_back({std::min(u, v), std::max(u, v)});
  }
  return result;
}

double share_that_differs(const std::vector<std::array<float, 2>>& a,
                          const std::vector<std::array<float, 2>>& b) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < a.size(); ++t) {
    count += std::abs(a[t][0] - b[t][0]) > 0.02f || std::abs(a[t][1] - b[t][1]) > 0.02f;
  }
  return static_cast<double>(count) / static_cast<double>(a.size());
}

const char* const kShapes[] = {"sphere,resolution=12", "box,resolution=16", "torus,resolution=40",
                               "mobius,resolution=24", "sheets,resolution=16"};

TEST(CrossAnimator, TheFirstFrameIsThePatternOfItsCrosses) {
  for (const char* shape : kShapes) {
    SCOPED_TRACE(shape);
    const CrossedSurface c = crossed(shape);
    CrossAnimator animator(c.surface);
    const CrossFrameResult frame = animator.frame(cross_input_of(c.waves));
    const CrossPattern cross = cross_pattern(c.surface, c.waves);
    const CrossTexture texture = cross_texture(c.surface, cross);
    EXPECT_EQ(frame.matching, CrossMatching::afresh);
    EXPECT_NEAR(animator.energy(), cross.pattern.solution.energy,
                0.1 * cross.pattern.solution.energy + 1e-6);
    EXPECT_EQ(frame.mesh.triangles, texture.surface.mesh.triangles);
    EXPECT_EQ(frame.cover.singular, cross.cover.singular);
    EXPECT_EQ(frame.quality.field_singularities, cross.quality.field_singularities);
    EXPECT_EQ(frame.waves.triangle_count(), texture.pattern.waves.triangle_count());
    EXPECT_GT(frame.texture.measured_triangles, frame.mesh.triangle_count() / 2);
    const TextureQuality quality = measure_texture(frame.mesh, frame.waves, PhaseShiftKind::aligned,
                                                   3 * frame.cover.singular.size());
    EXPECT_EQ(frame.texture.measured_triangles, quality.measured_triangles);
    EXPECT_NEAR(frame.texture.angle_mean_deg, quality.angle_mean_deg, 1e-4);
    EXPECT_NEAR(frame.texture.area_mean, quality.area_mean, 1e-5);
  }
}

TEST(CrossAnimator, WhichDirectionACrossIsGivenByMakesNoDifference) {
  for (const char* shape : kShapes) {
    SCOPED_TRACE(shape);
    const CrossedSurface c = crossed(shape);
    CrossAnimator plain(c.surface), other(c.surface);
    for (int k = 0; k < 4; ++k) {
      const WaveSet waves = turned(c, 0.02f * static_cast<float>(k));
      const auto a = shown(plain.frame(cross_input_of(waves)).waves);
      const CrossFrameResult frame =
          other.frame(cross_input_of(k == 0 ? waves : renamed(c, waves)));
      EXPECT_LT(share_that_differs(a, shown(frame.waves)), 0.01) << k;
      EXPECT_EQ(frame.matching, k == 0 ? CrossMatching::afresh : CrossMatching::kept) << k;
    }
    EXPECT_NEAR(plain.energy(), other.energy(), 1e-3 * plain.energy() + 1e-6);
  }
}

TEST(CrossAnimator, CrossesThatTurnTogetherAreMatchedOnce) {
  const CrossedSurface c = crossed("box,resolution=16");
  CrossAnimator animator(c.surface);
  double worst = 0;
  // Once round: every cross comes through all of its names.
  for (int k = 0; k <= 180; ++k) {
    const WaveSet waves = turned(c, 4 * kQuarter * static_cast<float>(k) / 180);
    const CrossFrameResult frame = animator.frame(cross_input_of(waves));
    EXPECT_EQ(frame.matching, k == 0 ? CrossMatching::afresh : CrossMatching::kept) << k;
    if (k % 15 != 0) continue;
    CrossAnimator scratch(c.surface);
    scratch.frame(cross_input_of(waves));
    worst = std::max(worst, animator.energy() - scratch.energy());
  }
  // What the anchors cost, of 1 for phases that know nothing of each other.
  EXPECT_LT(worst, 0.005);
}

TEST(CrossAnimator, PhasesGoOnWhereSingularitiesMove) {
  const CrossedSurface c = crossed("sphere,resolution=20", 30);
  CrossAnimator animator(c.surface);
  int renewed = 0;
  double step = 0;
  for (int k = 0; k < 8; ++k) {
    const WaveSet waves = carried_round(c, 0.01f * static_cast<float>(k));
    const CrossFrameResult frame = animator.frame(cross_input_of(waves));
    renewed += frame.matching == CrossMatching::renewed;
    if (k > 0) step = std::max(step, frame.stripes.phase_step);
    EXPECT_EQ(frame.cover.triangles,
              cross_cover(*c.surface.neighborhood, c.surface.mesh.triangles, frame.cover.waves)
                  .triangles);
  }
  EXPECT_GT(renewed, 2);
  // Phases that know nothing of each other are pi / 2 apart on average.
  EXPECT_LT(step, 0.9);
}

TEST(CrossAnimator, WeightsOfEdgesCountOnBothSheets) {
  const CrossedSurface c = crossed("box,resolution=16");
  const auto weight = [](Index i, Index j) {
    return 0.5f + 0.1f * static_cast<float>((i * j) % 10);
  };
  const auto weights_of = [&](const Adjacency& rows, Index waves) {
    std::vector<float> weights;
    for (Index i = 0; i < rows.node_count(); ++i) {
      for (const Index j : rows.of(i)) weights.push_back(weight(i / waves, j / waves));
    }
    return weights;
  };
  AnimatorOptions options;
  options.edge_weights = weights_of(*c.surface.neighborhood, 1);
  CrossAnimator animator(c.surface, options);
  const CrossFrameResult frame = animator.frame(cross_input_of(c.waves));
  options.edge_weights = weights_of(*frame.cover.neighborhood, 2);
  StripeAnimator on_cover(frame.cover.neighborhood, options);
  const WaveSet& waves = frame.cover.waves;
  const FrameResult expected =
      on_cover.frame({waves.positions, waves.directions, waves.frequencies});
  EXPECT_TRUE(std::ranges::equal(frame.stripes.z, expected.z));
  CrossAnimator plain(c.surface);
  EXPECT_FALSE(std::ranges::equal(plain.frame(cross_input_of(c.waves)).stripes.z, expected.z));
}

TEST(CrossAnimator, SlackLowersTheEnergy) {
  const CrossedSurface c = crossed("sphere,resolution=20", 40);
  AnimatorOptions options;
  options.slack = Slack(0.25f);
  CrossAnimator plain(c.surface), relaxed(c.surface, options);
  for (int k = 0; k < 3; ++k) {
    const WaveSet waves = turned(c, 0.02f * static_cast<float>(k));
    plain.frame(cross_input_of(waves));
    const CrossFrameResult frame = relaxed.frame(cross_input_of(waves));
    EXPECT_EQ(frame.stripes.frequencies.size(), 2 * waves.frequencies.size());
  }
  EXPECT_LT(relaxed.energy(), 0.8 * plain.energy());
}

TEST(CrossAnimator, BadFramesLeaveItAsItWas) {
  const CrossedSurface c = crossed("box,resolution=12");
  CrossAnimator animator(c.surface), untouched(c.surface);
  EXPECT_THROW(animator.energy(), Error);
  for (CrossAnimator* a : {&animator, &untouched}) a->frame(cross_input_of(c.waves));
  WaveSet bad = turned(c, 0.3f);
  bad.directions[5].x() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(animator.frame(cross_input_of(bad)), Error);
  bad = turned(c, 0.3f);
  bad.frequencies.pop_back();
  EXPECT_THROW(animator.frame(cross_input_of(bad)), Error);
  const WaveSet next = turned(c, 0.02f);
  const std::vector<Vec3> normals(3, Vec3::UnitZ());
  EXPECT_THROW(animator.frame({{next.positions, next.directions, next.frequencies}, normals}),
               Error);
  const auto z = animator.frame(cross_input_of(next)).stripes.z;
  const auto expected = untouched.frame(cross_input_of(next)).stripes.z;
  EXPECT_TRUE(std::ranges::equal(z, expected));
  EXPECT_THROW(CrossAnimator(Surface{}), Error);

  animator.restart();
  EXPECT_EQ(animator.frame(cross_input_of(next)).matching, CrossMatching::afresh);
}

}  // namespace
}  // namespace brindle
