#include "brindle/texture_animator.h"

#include <cmath>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/smooth_field.h"
#include "progress_reports.h"
#include "textures.h"

namespace brindle {
namespace {

using namespace testing_support;

TextureFrameInput texture_input_of(const WaveSet& waves) {
  return {{waves.positions, waves.directions, waves.frequencies}, {}, {}};
}

WaveSet turned_by(const Surface& surface, WaveSet waves, float radians) {
  waves.directions = rotated(waves.directions, surface.normals, radians);
  return waves;
}

/// Which way round U and V run at the corners.
std::vector<std::array<Vec3, 6>> runs(const TextureWaves& waves) {
  std::vector<std::array<Vec3, 6>> result(waves.triangle_count());
  for (std::size_t t = 0; t < result.size(); ++t) {
    for (int m = 0; m < 3; ++m) {
      result[t][m] = waves.u[t][m].wave.direction;
      result[t][m + 3] = waves.v[t][m].wave.direction;
    }
  }
  return result;
}

void expect_same_seams(const TextureSeams& a, const TextureSeams& b) {
  EXPECT_EQ(a.turned, b.turned);
  EXPECT_EQ(a.mirrored, b.mirrored);
  EXPECT_EQ(a.unoriented_triangles, b.unoriented_triangles);
}

struct Case {
  std::string name;
  Surface surface;
  WaveSet waves;
};

/// Fields with singularities and without, on surfaces with a border, handles, without orientation,
/// and where three sheets meet.
std::vector<Case> cases() {
  std::vector<Case> made;
  for (const char* shape : {"sphere,resolution=12", "torus,resolution=40", "mobius,resolution=40",
                            "sheets,resolution=16", "hemisphere,resolution=10"}) {
    Surface surface = make_surface(make_shape(shape));
    WaveSet waves = waves_of(surface, smooth_direction_field(surface), 12);
    made.push_back({shape, std::move(surface), std::move(waves)});
  }
  return made;
}

TEST(TextureAnimator, TheFirstFrameIsOrientedAsATexturePatternIs) {
  for (const auto& [name, surface, waves] : cases()) {
    for (const bool oriented : {false, true}) {
      TextureAnimator animator(surface, {oriented, {}});
      const TextureFrameResult frame = animator.frame(texture_input_of(waves));
      TextureOptions options;
      options.oriented = oriented;
      const TexturePattern pattern = texture_pattern(surface, waves, options);
      EXPECT_EQ(frame.orientation, FrameOrientation::afresh);
      EXPECT_EQ(runs(frame.pattern.waves), runs(pattern.waves)) << name;
      expect_same_seams(frame.pattern.seams, pattern.seams);
    }
  }
}

TEST(TextureAnimator, WhatIsKeptIsWhatComputingAfreshGives) {
  for (const auto& [name, surface, waves] : cases()) {
    TextureAnimator animator(surface);
    int kept = 0;
    for (int frame = 0; frame < 8; ++frame) {
      // As long as no corner turns round, turning and stretching leaves all kept.
      WaveSet next = turned_by(surface, waves, 2e-4f * static_cast<float>(frame));
      for (float& f : next.frequencies) f *= 1 + 0.01f * static_cast<float>(frame);
      const TextureFrameResult result = animator.frame(texture_input_of(next));
      const bool is_kept = result.orientation == FrameOrientation::kept;
      kept += is_kept;
      if (!is_kept && frame > 0) break;
      const TexturePattern afresh = texture_pattern(surface, next);
      ASSERT_EQ(runs(result.pattern.waves), runs(afresh.waves)) << name << ", frame " << frame;
      expect_same_seams(result.pattern.seams, afresh.seams);
    }
    EXPECT_GT(kept, 0) << name;
  }
}

/// The shares of triangles that ran on as they ran.
double share_that_runs_on(const TextureWaves& before, const TextureWaves& after) {
  std::size_t both = 0, same = 0;
  for (std::size_t t = 0; t < before.triangle_count(); ++t) {
    if (!is_oriented(before, t) || !is_oriented(after, t)) continue;
    ++both;
    Vec3 a = Vec3::Zero(), b = Vec3::Zero();
    for (int m = 0; m < 3; ++m) {
      a += before.u[t][m].wave.direction;
      b += after.u[t][m].wave.direction;
    }
    same += a.dot(b) > 0;
  }
  return static_cast<double>(same) / static_cast<double>(both);
}

TEST(TextureAnimator, TrianglesRunOnWhileSingularitiesMove) {
  // The seam of a half singularity that walks across a plane.
  const Surface surface = make_surface(make_shape("plane,resolution=40"));
  const float size = bounding_box(surface.mesh).diagonal();
  TextureAnimator animator(surface);
  TextureWaves last;
  for (int frame = 0; frame < 30; ++frame) {
    const float way = size * (0.2f * static_cast<float>(frame) / 30 - 0.1f);
    DirectionField field;
    for (const Vec3& p : surface.mesh.positions) {
      const float angle = 0.5f * std::atan2(p.y() - 0.0071f, p.x() + 0.0043f - way);
      // Signs mean nothing: every other frame has them the other way at half of the vertices.
      const float sign = frame % 2 == 1 && p.x() > p.y() ? -1.0f : 1.0f;
      field.emplace_back(sign * std::cos(angle), sign * std::sin(angle), 0);
    }
    const WaveSet waves = waves_of(surface, field, 10);
    const TextureFrameResult result = animator.frame(texture_input_of(waves));
    EXPECT_EQ(result.pattern.seams.unoriented_triangles, 1u) << frame;
    if (frame > 0 && result.orientation == FrameOrientation::continued) {
      EXPECT_EQ(share_that_runs_on(last, result.pattern.waves), 1) << frame;
    }
    const TextureSeams afresh = texture_pattern(surface, waves).seams;
    EXPECT_EQ(result.pattern.seams.unoriented_triangles, afresh.unoriented_triangles);
    EXPECT_LE(static_cast<double>(result.pattern.seams.turned),
              1.5 * static_cast<double>(afresh.turned) + 17)
        << frame;
    last = result.pattern.waves;
  }
}

TEST(TextureAnimator, SeamsThatGrowAreLaidAnew) {
  const Surface surface = make_surface(make_shape("sphere,resolution=16"));
  TextureAnimator animator(surface);
  for (int frame = 0; frame < 40; ++frame) {
    const float angle = 0.08f * static_cast<float>(frame);
    const DirectionField field = projected_direction_field(
        Vec3(std::cos(angle), std::sin(angle), 0.3f * std::sin(2 * angle)), surface.normals);
    const WaveSet waves = waves_of(surface, field, 10);
    const TextureFrameResult result = animator.frame(texture_input_of(waves));
    const TextureSeams afresh = texture_pattern(surface, waves).seams;
    EXPECT_EQ(result.pattern.seams.unoriented_triangles, afresh.unoriented_triangles);
    EXPECT_LE(static_cast<double>(result.pattern.seams.turned),
              1.3 * static_cast<double>(afresh.turned) + 20)
        << frame;
  }
}

TEST(TextureAnimator, SeamsAndQualityAreThoseOfItsWaves) {
  for (const auto& [name, surface, waves] : cases()) {
    TextureAnimator animator(surface);
    for (const float angle : {0.0f, 0.3f, 0.6f}) {
      const WaveSet next = turned_by(surface, waves, angle);
      const TextureFrameResult result = animator.frame(texture_input_of(next));
      const TextureQuality quality =
          measure_texture(surface.mesh, result.pattern.waves, PhaseShiftKind::aligned);
      EXPECT_EQ(result.pattern.quality.measured_triangles, quality.measured_triangles) << name;
      EXPECT_NEAR(result.pattern.quality.angle_mean_deg, quality.angle_mean_deg, 1e-4) << name;
      EXPECT_NEAR(result.pattern.quality.area_mean, quality.area_mean, 1e-4) << name;
      std::size_t unoriented = 0;
      for (std::size_t t = 0; t < surface.mesh.triangle_count(); ++t) {
        unoriented += !is_oriented(result.pattern.waves, t);
      }
      EXPECT_EQ(result.pattern.seams.unoriented_triangles, unoriented) << name;
      EXPECT_EQ(result.pattern.u.corners.size(), surface.mesh.triangle_count());
    }
  }
}

TEST(TextureAnimator, RefusesBadInputAndIsAsItWas) {
  const auto [name, surface, waves] = std::move(cases()[0]);
  TextureAnimator animator(surface), untouched(surface);
  animator.frame(texture_input_of(waves));
  untouched.frame(texture_input_of(waves));
  WaveSet bad = waves;
  bad.directions[3] = surface.normals[3];
  EXPECT_THROW(animator.frame(texture_input_of(bad)), Error);
  bad = waves;
  bad.frequencies[5] = -1;
  EXPECT_THROW(animator.frame(texture_input_of(bad)), Error);
  TextureFrameInput short_input = texture_input_of(waves);
  short_input.frequencies_v = std::span(waves.frequencies).first(2);
  EXPECT_THROW(animator.frame(short_input), Error);
  short_input = texture_input_of(waves);
  short_input.normals = std::span(surface.normals).first(2);
  EXPECT_THROW(animator.frame(short_input), Error);
  bad = waves;
  bad.frequencies[0] = std::nanf("");
  TextureFrameInput bad_v = texture_input_of(waves);
  bad_v.frequencies_v = bad.frequencies;
  EXPECT_THROW(animator.frame(bad_v), Error);

  const WaveSet next = turned_by(surface, waves, 0.2f);
  const TextureFrameResult a = animator.frame(texture_input_of(next));
  const TextureFrameResult b = untouched.frame(texture_input_of(next));
  EXPECT_TRUE(std::ranges::equal(a.u.z, b.u.z));
  EXPECT_TRUE(std::ranges::equal(a.v.z, b.v.z));
  EXPECT_EQ(runs(a.pattern.waves), runs(b.pattern.waves));
}

TEST(TextureAnimator, WithSlackPatternsAreThoseOfStripeAnimators) {
  const auto [name, surface, waves] = std::move(cases()[0]);
  TextureAnimatorOptions options;
  options.stripes.slack = 0.3f;
  options.stripes.slack.branch_penalty.assign(surface.mesh.vertex_count(), 1.0f);
  TextureAnimator animator(surface, options);
  StripeAnimator u(surface, options.stripes);
  std::optional<StripeAnimator> v;
  for (const float angle : {0.0f, 0.3f, 0.6f}) {
    const WaveSet next = turned_by(surface, waves, angle);
    const WaveSet crossing = turned_by(surface, next, std::numbers::pi_v<float> / 2);
    const TextureFrameResult result = animator.frame(texture_input_of(next));
    const FrameResult alone_u = u.frame(texture_input_of(next).u);
    if (!v) v = u.sibling();
    const FrameResult alone_v = v->frame(texture_input_of(crossing).u);
    EXPECT_TRUE(std::ranges::equal(result.u.z, alone_u.z)) << angle;
    EXPECT_TRUE(std::ranges::equal(result.v.z, alone_v.z)) << angle;
    EXPECT_TRUE(std::ranges::equal(result.u.frequencies, alone_u.frequencies)) << angle;
    EXPECT_TRUE(std::ranges::equal(result.v.frequencies, alone_v.frequencies)) << angle;
    EXPECT_GT(result.u.frequency_change.ratio_max, 1.01) << angle;
    // What is drawn and measured is what was chosen; what was asked for is measured beside it.
    for (std::size_t t = 0; t < surface.mesh.triangle_count(); ++t) {
      for (int m = 0; m < 3; ++m) {
        const Index vertex = surface.mesh.triangles[t][m];
        ASSERT_EQ(result.pattern.waves.u[t][m].wave.frequency, alone_u.frequencies[vertex]);
        ASSERT_EQ(result.pattern.waves.v[t][m].wave.frequency, alone_v.frequencies[vertex]);
      }
    }
    EXPECT_LT(result.pattern.u.quality.spacing_error_mean,
              result.pattern.u.quality.spacing_error_wanted_mean);
    EXPECT_EQ(result.pattern.u.quality.branches_in_avoided_area, result.pattern.u.quality.branches);
  }
}

TEST(TextureAnimator, WithoutSlackSpacingIsMeasuredAgainstWhatWasAskedFor) {
  const auto [name, surface, waves] = std::move(cases()[0]);
  TextureAnimator animator(surface);
  const PatternQuality quality = animator.frame(texture_input_of(waves)).pattern.u.quality;
  EXPECT_EQ(quality.spacing_error_wanted_mean, quality.spacing_error_mean);
  EXPECT_EQ(quality.branches_in_avoided_area, std::nullopt);
}

/// An unchanged U is solved no more, and V and the orientation are taken back all the same.
TEST(TextureAnimator, WithAnUnchangedUACancelledFrameLeavesTheLastOne) {
  const auto [name, surface, waves] = std::move(cases()[0]);
  FrequencyField other_v = waves.frequencies;
  for (float& f : other_v) f *= 1.2f;
  TextureFrameInput crossing = texture_input_of(waves);
  crossing.frequencies_v = other_v;
  const WaveSet next = turned_by(surface, waves, 0.4f);
  TextureAnimator cancelled(surface), untouched(surface);
  for (TextureAnimator* a : {&cancelled, &untouched}) a->frame(texture_input_of(waves));
  TextureAnimator counted(surface);
  counted.frame(texture_input_of(waves));
  Reports all;
  EXPECT_TRUE(counted.frame(crossing, all.progress()).u.unchanged);
  Reports last(all.count() - 1);
  EXPECT_THROW(cancelled.frame(crossing, last.progress()), Cancelled);
  const TextureFrameResult a = cancelled.frame(texture_input_of(next));
  const TextureFrameResult b = untouched.frame(texture_input_of(next));
  EXPECT_TRUE(std::ranges::equal(a.u.z, b.u.z));
  EXPECT_TRUE(std::ranges::equal(a.v.z, b.v.z));
  EXPECT_EQ(runs(a.pattern.waves), runs(b.pattern.waves));
}

TEST(TextureAnimator, NeedsTriangles) { EXPECT_THROW(TextureAnimator(Surface{}), Error); }

}  // namespace
}  // namespace brindle
