/// What all animators promise alike (docs/library.md).
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/cross_animator.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_animator.h"
#include "brindle/texture_animator.h"

namespace brindle {
namespace {

constexpr float kFrequency = 6;

/// A field that turns from frame to frame.
struct Turning {
  Surface surface = make_surface(make_shape("torus,resolution=36"));
  DirectionField field = smooth_direction_field(surface);
  FrequencyField frequencies = FrequencyField(surface.mesh.vertex_count(), kFrequency);
  DirectionField now = {};

  FrameInput frame(int number) {
    now = rotated(field, surface.normals, 0.03f * static_cast<float>(number));
    return {surface.mesh.positions, now, frequencies};
  }
};

using Phases = std::vector<Complex>;

Phases copy_of(std::span<const Complex> z) { return {z.begin(), z.end()}; }

struct OfStripes {
  using Animator = StripeAnimator;
  static std::vector<Phases> next(StripeAnimator& animator, const FrameInput& input) {
    return {copy_of(animator.frame(input).z)};
  }
  static std::vector<std::vector<float>> frequencies(StripeAnimator& a, const FrameInput& input) {
    const auto chosen = a.frame(input).frequencies;
    return {{chosen.begin(), chosen.end()}};
  }
  static void heard(StripeAnimator& animator, const FrameInput& input, const Progress& progress) {
    animator.frame(input, progress);
  }
  static StripeAnimator made(const Surface& surface, const AnimatorOptions& options = {}) {
    return StripeAnimator(surface, options);
  }
  static void give(StripeAnimator& animator, const std::vector<Phases>& z) {
    animator.set_last_phases(z[0]);
  }
};

struct OfTextures {
  using Animator = TextureAnimator;
  static std::vector<Phases> next(TextureAnimator& animator, const FrameInput& input) {
    const TextureFrameResult frame = animator.frame({input, {}, {}});
    return {copy_of(frame.u.stripes.z), copy_of(frame.v.stripes.z)};
  }
  static std::vector<std::vector<float>> frequencies(TextureAnimator& a, const FrameInput& input) {
    const TextureFrameResult frame = a.frame({input, {}, {}});
    const auto u = frame.u.stripes.frequencies, v = frame.v.stripes.frequencies;
    return {{u.begin(), u.end()}, {v.begin(), v.end()}};
  }
  static void heard(TextureAnimator& animator, const FrameInput& input, const Progress& progress) {
    animator.frame({input, {}, {}}, progress);
  }
  static void with_normals(TextureAnimator& animator, const FrameInput& input,
                           std::span<const Vec3> normals) {
    animator.frame({.u = input, .normals = normals});
  }
  static TextureAnimator made(const Surface& surface, const AnimatorOptions& options = {}) {
    return TextureAnimator(surface, {.stripes = options});
  }
  static void give(TextureAnimator& animator, const std::vector<Phases>& z) {
    animator.set_last_phases(z[0], z[1]);
  }
};

struct OfCrosses {
  using Animator = CrossAnimator;
  static std::vector<Phases> next(CrossAnimator& animator, const FrameInput& input) {
    return {copy_of(animator.frame({input, {}}).stripes.z)};
  }
  static std::vector<std::vector<float>> frequencies(CrossAnimator& a, const FrameInput& input) {
    const auto chosen = a.frame({input, {}}).stripes.frequencies;
    return {{chosen.begin(), chosen.end()}};
  }
  static void heard(CrossAnimator& animator, const FrameInput& input, const Progress& progress) {
    animator.frame({input, {}}, progress);
  }
  static void with_normals(CrossAnimator& animator, const FrameInput& input,
                           std::span<const Vec3> normals) {
    animator.frame({.waves = input, .normals = normals});
  }
  static CrossAnimator made(const Surface& surface, const AnimatorOptions& options = {}) {
    return CrossAnimator(surface, options);
  }
};

template <class Kind>
struct EveryAnimator : testing::Test {};
using Kinds = testing::Types<OfStripes, OfTextures, OfCrosses>;
TYPED_TEST_SUITE(EveryAnimator, Kinds);

TYPED_TEST(EveryAnimator, TakesAnotherSlackFromFrameToFrame) {
  Turning turning;
  AnimatorOptions options;
  options.slack = 0.3f;
  auto animator = TypeParam::made(turning.surface, options);
  animator.set_slack(0.25f);  // before the first frame, too
  int number = 0;
  for (const float slack : {0.25f, 0.05f, 0.0f, 0.3f}) {
    SCOPED_TRACE(slack);
    animator.set_slack(slack);
    float farthest = 1;
    for (const auto& list : TypeParam::frequencies(animator, turning.frame(number++))) {
      for (const float f : list) {
        farthest = std::max({farthest, f / kFrequency, kFrequency / f});
      }
    }
    EXPECT_LE(farthest, 1 + slack + 1e-5f);
    if (slack == 0.3f) {
      EXPECT_GT(farthest, 1.05f) << "the field has turned: frequencies yield";
    }
  }
  auto without = TypeParam::made(turning.surface);
  EXPECT_THROW(without.set_slack(0.1f), Error);
  EXPECT_THROW(animator.set_slack(-1), Error);
}

/// Over two frames of which each turns crosses so far that they are matched afresh.
TYPED_TEST(EveryAnimator, ProgressOfAFrameNeverFalls) {
  Turning turning;
  for (const float slack : {0.0f, 0.2f}) {
    AnimatorOptions options;
    options.slack = slack;
    options.cycles = 2;
    auto animator = TypeParam::made(turning.surface, options);
    for (const int number : {0, 20}) {
      double done = 0;
      std::vector<std::string> stages;
      TypeParam::heard(animator, turning.frame(number), Progress([&](const ProgressReport& report) {
                         std::vector<std::string> now;
                         for (const JobStage& stage : report.stages) now.push_back(stage.name);
                         EXPECT_TRUE(stages.empty() || now == stages) << report.step;
                         EXPECT_FALSE(now.empty());
                         EXPECT_GE(report.fraction, done) << report.step;
                         EXPECT_LE(report.fraction, 1);
                         stages = now;
                         done = report.fraction;
                         return true;
                       }));
      EXPECT_GT(done, 0);
    }
  }
}

/// Normals that a frame was given are that frame's.
template <class Kind>
struct AnimatorWithNormals : testing::Test {};
using KindsWithNormals = testing::Types<OfTextures, OfCrosses>;
TYPED_TEST_SUITE(AnimatorWithNormals, KindsWithNormals);

TYPED_TEST(AnimatorWithNormals, FramesWithoutThemHaveThoseOfTheSurface) {
  Turning turning;
  const Surface& surface = turning.surface;
  std::vector<Vec3> tilted = surface.normals;
  DirectionField along(tilted.size());
  for (std::size_t i = 0; i < tilted.size(); ++i) {
    const Vec3& d = turning.field[i];
    tilted[i] = (tilted[i] + 0.3f * d).normalized();
    along[i] = (d - d.dot(tilted[i]) * tilted[i]).normalized();
  }
  const FrameInput leaning{surface.mesh.positions, along, turning.frequencies};
  for (const float slack : {0.0f, 0.2f}) {
    AnimatorOptions options;
    options.slack = slack;
    auto used = TypeParam::made(surface, options), fresh = TypeParam::made(surface, options);
    const auto first = TypeParam::next(fresh, turning.frame(0));
    TypeParam::next(used, turning.frame(0));
    TypeParam::with_normals(used, leaning, tilted);  // at the same place
    TypeParam::next(used, turning.frame(0));
    used.restart();
    EXPECT_EQ(TypeParam::next(used, turning.frame(0)), first);
    EXPECT_THROW(TypeParam::next(used, leaning), Error) << "not along the surface's own";
  }
}

template <class Kind>
struct AnimatorOfLastPhases : testing::Test {};
using KindsByVertex = testing::Types<OfStripes, OfTextures>;
TYPED_TEST_SUITE(AnimatorOfLastPhases, KindsByVertex);

/// What was there before is forgotten, and given again.
TYPED_TEST(AnimatorOfLastPhases, GoesOnBitForBit) {
  Turning turning;
  auto goes_on = TypeParam::made(turning.surface), resumed = TypeParam::made(turning.surface);
  TypeParam::next(resumed, turning.frame(0));
  TypeParam::next(goes_on, turning.frame(0));
  const std::vector<Phases> last = TypeParam::next(goes_on, turning.frame(1));
  const std::vector<Phases> expected = TypeParam::next(goes_on, turning.frame(2));
  resumed.restart();
  TypeParam::give(resumed, last);
  EXPECT_EQ(TypeParam::next(resumed, turning.frame(2)), expected);
  EXPECT_NE(expected, last);
}

/// Before any frame, as a program does that was closed in between.
TYPED_TEST(AnimatorOfLastPhases, FollowsFromTheFirstFrame) {
  Turning turning;
  auto first = TypeParam::made(turning.surface);
  const std::vector<Phases> last = TypeParam::next(first, turning.frame(0));
  auto scratch = TypeParam::made(turning.surface), given = TypeParam::made(turning.surface);
  TypeParam::give(given, last);
  const auto steps = [&](const std::vector<Phases>& z) {
    double sum = 0;
    for (std::size_t k = 0; k < z.size(); ++k) {
      for (std::size_t v = 0; v < z[k].size(); ++v) {
        sum += static_cast<double>(std::abs(std::arg(z[k][v] * std::conj(last[k][v]))));
      }
    }
    return sum;
  };
  const double followed = steps(TypeParam::next(given, turning.frame(1)));
  EXPECT_LT(followed, 0.5 * steps(TypeParam::next(scratch, turning.frame(1))));
  EXPECT_GT(followed, 0);
  std::vector<Phases> bad = last;
  bad.back()[3] = 2;
  EXPECT_THROW(TypeParam::give(given, bad), Error);
  bad.back().pop_back();
  EXPECT_THROW(TypeParam::give(given, bad), Error);
}

TEST(CrossAnimatorOfLastPhases, FollowsThoseOfAnotherAnimator) {
  Turning turning;
  CrossAnimator first(turning.surface), given(turning.surface), scratch(turning.surface);
  const CrossFrameResult before = first.frame({turning.frame(0), {}});
  given.set_last_phases(before.cover, before.stripes.z);
  const Phases last = copy_of(before.stripes.z);
  const CrossFrameResult goes_on = first.frame({turning.frame(1), {}});
  const double step = goes_on.stripes.phase_step;
  const CrossFrameResult frame = given.frame({turning.frame(1), {}});
  EXPECT_EQ(frame.matching, CrossMatching::afresh);
  EXPECT_GT(frame.stripes.phase_step, 0);
  EXPECT_LT(frame.stripes.phase_step, 2 * step + 0.02);
  EXPECT_NEAR(given.energy(), first.energy(), 0.1 * first.energy());

  const Surface other = make_surface(make_shape("torus,resolution=20"));
  CrossAnimator on_other(other);
  EXPECT_THROW(on_other.set_last_phases(frame.cover, frame.stripes.z), Error);
  Phases bad = last;
  bad[0] = 2;
  EXPECT_THROW(given.set_last_phases(frame.cover, bad), Error);

  // As many vertices and triangles, but others.
  Mesh renumbered = turning.surface.mesh;
  std::ranges::reverse(renumbered.triangles);
  CrossAnimator of_renumbered(make_surface(renumbered));
  EXPECT_THROW(of_renumbered.set_last_phases(frame.cover, last), Error);
  CrossCover incomplete = frame.cover;
  incomplete.waves.positions.pop_back();
  const CrossFrameResult expected = first.frame({turning.frame(2), {}});
  const Phases as_expected = copy_of(expected.stripes.z);
  CrossAnimator goes_on_alone(turning.surface);
  for (const int number : {0, 1}) goes_on_alone.frame({turning.frame(number), {}});
  EXPECT_THROW(goes_on_alone.set_last_phases(incomplete, last), Error);
  EXPECT_EQ(copy_of(goes_on_alone.frame({turning.frame(2), {}}).stripes.z), as_expected);
}

}  // namespace
}  // namespace brindle
