#include "brindle/texture_animator.h"

#include <cmath>

#include <gtest/gtest.h>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/smooth_field.h"
#include "textures.h"

namespace brindle {
namespace {

using namespace testing_support;

TextureFrameInput input_of(const WaveSet& waves) {
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
      const TextureFrameResult frame = animator.frame(input_of(waves));
      TextureOptions options;
      options.oriented = oriented;
      const TexturePattern pattern = texture_pattern(surface, waves, options);
      EXPECT_EQ(frame.orientation, FrameOrientation::afresh);
      EXPECT_EQ(runs(frame.waves), runs(pattern.waves)) << name;
      expect_same_seams(frame.seams, pattern.seams);
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
      const TextureFrameResult result = animator.frame(input_of(next));
      const bool is_kept = result.orientation == FrameOrientation::kept;
      kept += is_kept;
      if (!is_kept && frame > 0) break;
      const TexturePattern afresh = texture_pattern(surface, next);
      ASSERT_EQ(runs(result.waves), runs(afresh.waves)) << name << ", frame " << frame;
      expect_same_seams(result.seams, afresh.seams);
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
    const TextureFrameResult result = animator.frame(input_of(waves));
    EXPECT_EQ(result.seams.unoriented_triangles, 1u) << frame;
    if (frame > 0 && result.orientation == FrameOrientation::continued) {
      EXPECT_EQ(share_that_runs_on(last, result.waves), 1) << frame;
    }
    const TextureSeams afresh = texture_pattern(surface, waves).seams;
    EXPECT_EQ(result.seams.unoriented_triangles, afresh.unoriented_triangles);
    EXPECT_LE(static_cast<double>(result.seams.turned),
              1.5 * static_cast<double>(afresh.turned) + 17)
        << frame;
    last = result.waves;
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
    const TextureFrameResult result = animator.frame(input_of(waves));
    const TextureSeams afresh = texture_pattern(surface, waves).seams;
    EXPECT_EQ(result.seams.unoriented_triangles, afresh.unoriented_triangles);
    EXPECT_LE(static_cast<double>(result.seams.turned),
              1.3 * static_cast<double>(afresh.turned) + 20)
        << frame;
  }
}

TEST(TextureAnimator, SeamsAndQualityAreThoseOfItsWaves) {
  for (const auto& [name, surface, waves] : cases()) {
    TextureAnimator animator(surface);
    for (const float angle : {0.0f, 0.3f, 0.6f}) {
      const WaveSet next = turned_by(surface, waves, angle);
      const TextureFrameResult result = animator.frame(input_of(next));
      const TextureQuality quality =
          measure_texture(surface.mesh, result.waves, PhaseShiftKind::aligned);
      EXPECT_EQ(result.quality.measured_triangles, quality.measured_triangles) << name;
      EXPECT_NEAR(result.quality.angle_mean_deg, quality.angle_mean_deg, 1e-4) << name;
      EXPECT_NEAR(result.quality.area_mean, quality.area_mean, 1e-4) << name;
      std::size_t unoriented = 0;
      for (std::size_t t = 0; t < surface.mesh.triangle_count(); ++t) {
        unoriented += !is_oriented(result.waves, t);
      }
      EXPECT_EQ(result.seams.unoriented_triangles, unoriented) << name;
      EXPECT_EQ(result.u.corners.size(), surface.mesh.triangle_count());
    }
  }
}

TEST(TextureAnimator, DoesNotDependOnThreads) {
  const auto [name, surface, waves] = std::move(cases()[1]);
  std::vector<std::vector<std::array<Vec3, 6>>> results;
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    TextureAnimator animator(surface);
    animator.frame(input_of(waves));
    results.push_back(runs(animator.frame(input_of(turned_by(surface, waves, 0.5f))).waves));
  }
  EXPECT_EQ(results[0], results[1]);
}

TEST(TextureAnimator, RestartedItOrientsAfresh) {
  const auto [name, surface, waves] = std::move(cases()[0]);
  TextureAnimator animator(surface);
  animator.frame(input_of(waves));
  animator.frame(input_of(turned_by(surface, waves, 0.5f)));
  animator.restart();
  const TextureFrameResult again = animator.frame(input_of(waves));
  EXPECT_EQ(again.orientation, FrameOrientation::afresh);
  EXPECT_EQ(runs(again.waves), runs(texture_pattern(surface, waves).waves));
}

TEST(TextureAnimator, RefusesBadInputAndIsAsItWas) {
  const auto [name, surface, waves] = std::move(cases()[0]);
  TextureAnimator animator(surface), untouched(surface);
  animator.frame(input_of(waves));
  untouched.frame(input_of(waves));
  WaveSet bad = waves;
  bad.directions[3] = surface.normals[3];
  EXPECT_THROW(animator.frame(input_of(bad)), Error);
  bad = waves;
  bad.frequencies[5] = -1;
  EXPECT_THROW(animator.frame(input_of(bad)), Error);
  TextureFrameInput short_input = input_of(waves);
  short_input.frequencies_v = std::span(waves.frequencies).first(2);
  EXPECT_THROW(animator.frame(short_input), Error);
  short_input = input_of(waves);
  short_input.normals = std::span(surface.normals).first(2);
  EXPECT_THROW(animator.frame(short_input), Error);
  bad = waves;
  bad.frequencies[0] = std::nanf("");
  TextureFrameInput bad_v = input_of(waves);
  bad_v.frequencies_v = bad.frequencies;
  EXPECT_THROW(animator.frame(bad_v), Error);

  const WaveSet next = turned_by(surface, waves, 0.2f);
  const TextureFrameResult a = animator.frame(input_of(next));
  const TextureFrameResult b = untouched.frame(input_of(next));
  EXPECT_TRUE(std::ranges::equal(a.u.stripes.z, b.u.stripes.z));
  EXPECT_TRUE(std::ranges::equal(a.v.stripes.z, b.v.stripes.z));
  EXPECT_EQ(runs(a.waves), runs(b.waves));
}

TEST(TextureAnimator, NeedsTriangles) { EXPECT_THROW(TextureAnimator(Surface{}), Error); }

}  // namespace
}  // namespace brindle
