#include "brindle/texture_animator.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

#include <gtest/gtest.h>

#include "brindle/base/parallel.h"
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
      const TextureFrameResult result = animator.frame(texture_input_of(next));
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
    const TextureFrameResult result = animator.frame(texture_input_of(waves));
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
    const TextureFrameResult result = animator.frame(texture_input_of(waves));
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
      const TextureFrameResult result = animator.frame(texture_input_of(next));
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
    animator.frame(texture_input_of(waves));
    results.push_back(
        runs(animator.frame(texture_input_of(turned_by(surface, waves, 0.5f))).waves));
  }
  EXPECT_EQ(results[0], results[1]);
}

TEST(TextureAnimator, RestartedItOrientsAfresh) {
  const auto [name, surface, waves] = std::move(cases()[0]);
  TextureAnimator animator(surface);
  animator.frame(texture_input_of(waves));
  animator.frame(texture_input_of(turned_by(surface, waves, 0.5f)));
  animator.restart();
  const TextureFrameResult again = animator.frame(texture_input_of(waves));
  EXPECT_EQ(again.orientation, FrameOrientation::afresh);
  EXPECT_EQ(runs(again.waves), runs(texture_pattern(surface, waves).waves));
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
  EXPECT_TRUE(std::ranges::equal(a.u.stripes.z, b.u.stripes.z));
  EXPECT_TRUE(std::ranges::equal(a.v.stripes.z, b.v.stripes.z));
  EXPECT_EQ(runs(a.waves), runs(b.waves));
}

TEST(TextureAnimator, WithSlackPatternsAreThoseOfStripeAnimators) {
  const auto [name, surface, waves] = std::move(cases()[0]);
  TextureAnimatorOptions options;
  options.stripes.slack = 0.3f;
  options.stripes.slack.calm.assign(surface.mesh.vertex_count(), 1.0f);
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
    EXPECT_TRUE(std::ranges::equal(result.u.stripes.z, alone_u.z)) << angle;
    EXPECT_TRUE(std::ranges::equal(result.v.stripes.z, alone_v.z)) << angle;
    EXPECT_TRUE(std::ranges::equal(result.u.stripes.frequencies, alone_u.frequencies)) << angle;
    EXPECT_TRUE(std::ranges::equal(result.v.stripes.frequencies, alone_v.frequencies)) << angle;
    EXPECT_GT(result.u.stripes.frequency_change.ratio_max, 1.01) << angle;
    // What is drawn and measured is what was chosen; what was asked for is measured beside it.
    for (std::size_t t = 0; t < surface.mesh.triangle_count(); ++t) {
      for (int m = 0; m < 3; ++m) {
        const Index vertex = surface.mesh.triangles[t][m];
        ASSERT_EQ(result.waves.u[t][m].wave.frequency, alone_u.frequencies[vertex]);
        ASSERT_EQ(result.waves.v[t][m].wave.frequency, alone_v.frequencies[vertex]);
      }
    }
    EXPECT_LT(result.u.quality.spacing_error_mean, result.u.quality.spacing_error_wanted_mean);
    EXPECT_EQ(result.u.quality.branches_in_calm, result.u.quality.branches);
  }
}

TEST(TextureAnimator, WithoutSlackSpacingIsMeasuredAgainstWhatWasAskedFor) {
  const auto [name, surface, waves] = std::move(cases()[0]);
  TextureAnimator animator(surface);
  const PatternQuality quality = animator.frame(texture_input_of(waves)).u.quality;
  EXPECT_EQ(quality.spacing_error_wanted_mean, quality.spacing_error_mean);
  EXPECT_EQ(quality.branches_in_calm, std::nullopt);
}

/// Whatever stops a frame, both patterns and the orientation are those of the last one.
struct InterruptedTexture : testing::TestWithParam<std::tuple<FrameSolver, float>> {
  Surface surface = make_surface(make_shape("sphere,resolution=7"));
  WaveSet first = waves_of(surface, smooth_direction_field(surface), 12);
  WaveSet second = turned_by(surface, first, 0.4f), third = turned_by(surface, first, 2.0f);
  TextureAnimatorOptions options;

  InterruptedTexture() {
    options.stripes.solver = std::get<0>(GetParam());
    options.stripes.slack = std::get<1>(GetParam());
    options.stripes.cycles = 2;
    for (Vec3& p : third.positions) p.x() *= 1.1f;
  }

  struct Seen {
    std::vector<Complex> u, v;
    std::vector<std::array<Vec3, 6>> runs;
    std::size_t seam;
    FrameOrientation orientation;
    double energy_u, energy_v;
    bool operator==(const Seen&) const = default;
  };
  static Seen see(TextureAnimator& animator, const WaveSet& waves) {
    const TextureFrameResult result = animator.frame(texture_input_of(waves));
    const auto& z_u = result.u.stripes.z;
    const auto& z_v = result.v.stripes.z;
    return {{z_u.begin(), z_u.end()}, {z_v.begin(), z_v.end()}, runs(result.waves),
            result.seams.turned,      result.orientation,       animator.energy_u(),
            animator.energy_v()};
  }

  /// Cancels a frame at every report that it makes, each time of an animator that `start` makes.
  template <class Start, class Expect>
  void cancel_everywhere(const WaveSet& waves, const Start& start, const Expect& expect) const {
    TextureAnimator undisturbed = start();
    Reports all;
    undisturbed.frame(texture_input_of(waves), all.progress());
    EXPECT_GE(all.count(), 1);  // the orientation, where iterations make none
    for (const int k : testing_support::reports_to_cancel(all.count())) {
      SCOPED_TRACE(k);
      TextureAnimator cancelled = start();
      Reports reports(k);
      EXPECT_THROW(cancelled.frame(texture_input_of(waves), reports.progress()), Cancelled);
      expect(cancelled);
    }
  }
};

TEST_P(InterruptedTexture, FirstFrameLeavesNothingBehind) {
  TextureAnimator undisturbed(surface, options);
  const Seen a = see(undisturbed, first), b = see(undisturbed, second);
  cancel_everywhere(
      third, [&] { return TextureAnimator(surface, options); },
      [&](TextureAnimator& cancelled) {
        EXPECT_THROW(cancelled.energy_u(), Error);
        EXPECT_THROW(cancelled.energy_v(), Error);
        EXPECT_EQ(see(cancelled, first), a);
        EXPECT_EQ(see(cancelled, second), b);
      });
}

TEST_P(InterruptedTexture, LaterFrameLeavesTheLastOne) {
  TextureAnimator undisturbed(surface, options);
  see(undisturbed, first);
  const Seen a = see(undisturbed, second);
  const Seen c = see(undisturbed, third);
  const auto started = [&] {
    TextureAnimator animator(surface, options);
    animator.frame(texture_input_of(first));
    animator.frame(texture_input_of(second));
    return animator;
  };
  cancel_everywhere(third, started, [&](TextureAnimator& cancelled) {
    EXPECT_EQ(cancelled.energy_u(), a.energy_u);
    EXPECT_EQ(cancelled.energy_v(), a.energy_v);
    EXPECT_EQ(see(cancelled, third), c);
  });
  // An unchanged U is solved no more, and V and the orientation are taken back all the same.
  WaveSet other_v = second;
  for (float& f : other_v.frequencies) f *= 1.2f;
  const auto with_other_v = [&](const WaveSet& waves) {
    TextureFrameInput input = texture_input_of(waves);
    input.frequencies_v = other_v.frequencies;
    return input;
  };
  TextureAnimator cancelled = started();
  Reports all;
  started().frame(with_other_v(second), all.progress());
  Reports last(all.count() - 1);
  EXPECT_THROW(cancelled.frame(with_other_v(second), last.progress()), Cancelled);
  EXPECT_EQ(see(cancelled, third), c);
}

TEST_P(InterruptedTexture, FrameAfterARestartLeavesItRestarted) {
  const auto restarted = [&] {
    TextureAnimator animator(surface, options);
    animator.frame(texture_input_of(first));
    animator.restart();
    return animator;
  };
  TextureAnimator undisturbed = restarted();
  const Seen a = see(undisturbed, second);
  cancel_everywhere(third, restarted,
                    [&](TextureAnimator& cancelled) { EXPECT_EQ(see(cancelled, second), a); });
}

INSTANTIATE_TEST_SUITE_P(TextureAnimator, InterruptedTexture,
                         testing::Combine(testing::Values(FrameSolver::multilevel,
                                                          FrameSolver::relaxation),
                                          testing::Values(0.0f, 0.2f)));

TEST(TextureAnimator, NeedsTriangles) { EXPECT_THROW(TextureAnimator(Surface{}), Error); }

}  // namespace
}  // namespace brindle
