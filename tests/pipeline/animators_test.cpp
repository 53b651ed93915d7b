/// What all animators promise alike (docs/library.md).
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/cross_animator.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_animator.h"
#include "brindle/texture_animator.h"
#include "brindle/threads.h"
#include "progress_reports.h"

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

/// Phases at all corners, as they are turned there.
Phases corners_of(const TextureWaves& waves) {
  Phases z;
  for (const auto* all : {&waves.u, &waves.v}) {
    for (const CornerWaves& corners : *all) {
      for (const CornerWave& corner : corners) z.push_back(corner.z);
    }
  }
  return z;
}

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
  static bool unchanged(StripeAnimator& animator, const FrameInput& input) {
    return animator.frame(input).unchanged;
  }
  static std::vector<double> energies(const StripeAnimator& a) { return {a.energy()}; }
};

struct OfTextures {
  using Animator = TextureAnimator;
  static std::vector<Phases> next(TextureAnimator& animator, const FrameInput& input) {
    const TextureFrameResult frame = animator.frame({input, {}, {}});
    return {copy_of(frame.u.z), copy_of(frame.v.z), corners_of(frame.pattern.waves)};
  }
  static std::vector<std::vector<float>> frequencies(TextureAnimator& a, const FrameInput& input) {
    const TextureFrameResult frame = a.frame({input, {}, {}});
    const auto u = frame.u.frequencies, v = frame.v.frequencies;
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
  static bool unchanged(TextureAnimator& animator, const FrameInput& input) {
    const TextureFrameResult frame = animator.frame({input, {}, {}});
    return frame.u.unchanged && frame.v.unchanged;
  }
  static std::vector<double> energies(const TextureAnimator& a) {
    return {a.energy_u(), a.energy_v()};
  }
};

struct OfCrosses {
  using Animator = CrossAnimator;
  static std::vector<Phases> next(CrossAnimator& animator, const FrameInput& input) {
    const CrossFrameResult frame = animator.frame({input, {}});
    return {copy_of(frame.stripes.z), corners_of(frame.waves)};
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
  static bool unchanged(CrossAnimator& animator, const FrameInput& input) {
    return animator.frame({input, {}}).stripes.unchanged;
  }
  static std::vector<double> energies(const CrossAnimator& a) { return {a.energy()}; }
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

TYPED_TEST(EveryAnimator, RestartForgetsTheLastFrame) {
  Turning turning;
  for (const int cycles : {0, 2}) {
    AnimatorOptions options;
    options.cycles = cycles;
    auto used = TypeParam::made(turning.surface, options);
    auto fresh = TypeParam::made(turning.surface, options);
    const auto first = TypeParam::next(fresh, turning.frame(0));
    used.restart();  // before there is anything to forget
    EXPECT_EQ(TypeParam::next(used, turning.frame(0)), first);
    TypeParam::next(used, turning.frame(1));
    used.restart();
    EXPECT_EQ(TypeParam::next(used, turning.frame(0)), first);
  }
}

TYPED_TEST(EveryAnimator, IsTheSameForEveryNumberOfThreads) {
  Turning turning{make_surface(make_shape("sphere,resolution=24"))};
  std::vector<std::vector<Phases>> results;
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    auto animator = TypeParam::made(turning.surface);
    for (const int number : {0, 1}) TypeParam::next(animator, turning.frame(number));
    results.push_back(TypeParam::next(animator, turning.frame(16)));
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

/// Whatever stops a frame, the animator is as it was before: what later frames are says so.
template <class Kind>
struct InterruptedFrame : testing::Test {
  using Animator = typename Kind::Animator;

  Surface surface = make_surface(make_shape("sphere,resolution=7"));
  WaveSet first{surface.mesh.positions, smooth_direction_field(surface),
                FrequencyField(surface.mesh.vertex_count(), 12)};
  WaveSet second = first, third = first;
  AnimatorOptions options = {};

  /// Three inputs that differ in everything.
  InterruptedFrame() {
    second.directions = rotated(first.directions, surface.normals, 0.4f);
    for (std::size_t i = 0; i < second.directions.size(); ++i) {
      if (i % 3 == 0) second.directions[i] = -second.directions[i];
      second.frequencies[i] *= 1.01f;
    }
    third.directions = rotated(first.directions, surface.normals, 2.0f);
    for (Vec3& p : third.positions) p.x() *= 1.1f;
  }

  static FrameInput input_of(const WaveSet& waves) {
    return {waves.positions, waves.directions, waves.frequencies};
  }

  template <class Body>
  void for_options(const Body& body) {
    for (const FrameSolver solver : {FrameSolver::multilevel, FrameSolver::relaxation}) {
      for (const auto& [cycles, slack] : {std::pair(0, 0.0f), {3, 0.0f}, {2, 0.2f}}) {
        options.solver = solver;
        options.cycles = cycles;
        options.slack = slack;
        SCOPED_TRACE(testing::Message() << "solver " << static_cast<int>(solver) << ", cycles "
                                        << cycles << ", slack " << slack);
        body();
      }
    }
  }

  Animator animator() const { return Kind::made(surface, options); }

  /// Of an animator after these frames.
  Animator after(std::initializer_list<const WaveSet*> frames) const {
    Animator started = animator();
    for (const WaveSet* waves : frames) Kind::next(started, input_of(*waves));
    return started;
  }

  static std::vector<double> energies(const Animator& animator) {
    try {
      return Kind::energies(animator);
    } catch (const Error&) {
      return {};  // there is no frame
    }
  }

  struct Seen {
    std::vector<Phases> z;
    std::vector<double> energies;
    bool operator==(const Seen&) const = default;
  };
  static Seen see(Animator& animator, const WaveSet& waves) {
    std::vector<Phases> z = Kind::next(animator, input_of(waves));
    return {std::move(z), energies(animator)};
  }

  /// Cancels a frame at every report of progress that it makes, each time of an animator that
  /// `start` hands over, and lets `expect` look at what is left of it.
  template <class Start, class Expect>
  void cancel_everywhere(const WaveSet& waves, const Start& start, const Expect& expect) const {
    Animator undisturbed = start();
    testing_support::Reports all;
    Kind::heard(undisturbed, input_of(waves), all.progress());
    EXPECT_GE(all.count(), options.solver == FrameSolver::multilevel ? options.cycles + 1 : 1);
    for (const int k : testing_support::reports_to_cancel(all.count())) {
      SCOPED_TRACE(k);
      Animator cancelled = start();
      testing_support::Reports reports(k);
      EXPECT_THROW(Kind::heard(cancelled, input_of(waves), reports.progress()), Cancelled);
      expect(cancelled);
    }
  }
};
TYPED_TEST_SUITE(InterruptedFrame, Kinds);

TYPED_TEST(InterruptedFrame, FirstLeavesNothingBehind) {
  this->for_options([&] {
    auto undisturbed = this->animator();
    const auto a = this->see(undisturbed, this->first), b = this->see(undisturbed, this->second);
    this->cancel_everywhere(
        this->third, [&] { return this->animator(); },
        [&](auto& cancelled) {
          EXPECT_THROW(TypeParam::energies(cancelled), Error);
          EXPECT_EQ(this->see(cancelled, this->first), a);
          EXPECT_EQ(this->see(cancelled, this->second), b);
        });
  });
}

TYPED_TEST(InterruptedFrame, LaterOneLeavesTheLastOne) {
  this->for_options([&] {
    auto undisturbed = this->animator();
    const auto a = this->see(undisturbed, this->first), b = this->see(undisturbed, this->second);
    const auto c = this->see(undisturbed, this->third);
    for (const WaveSet* tried : {&this->second, &this->third}) {
      this->cancel_everywhere(
          *tried, [&] { return this->after({&this->first}); },
          [&](auto& cancelled) {
            EXPECT_EQ(TypeParam::energies(cancelled), a.energies);
            EXPECT_TRUE(TypeParam::unchanged(cancelled, this->input_of(this->first)));
            EXPECT_EQ(this->see(cancelled, this->second), b);
            EXPECT_EQ(this->see(cancelled, this->third), c);
          });
    }
  });
}

TYPED_TEST(InterruptedFrame, OneAfterARestartLeavesItRestarted) {
  const auto restarted = [&] {
    auto started = this->after({&this->first, &this->second});
    started.restart();
    return started;
  };
  this->for_options([&] {
    auto undisturbed = restarted();
    const auto energies = this->energies(undisturbed);
    const auto a = this->see(undisturbed, this->first), b = this->see(undisturbed, this->second);
    this->cancel_everywhere(this->third, restarted, [&](auto& cancelled) {
      EXPECT_EQ(this->energies(cancelled), energies);
      EXPECT_EQ(this->see(cancelled, this->first), a);
      EXPECT_EQ(this->see(cancelled, this->second), b);
    });
  });
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

/// What was there before is forgotten, and given again; frames after it follow each other.
TYPED_TEST(AnimatorOfLastPhases, GoesOnBitForBit) {
  for (const FrameSolver solver : {FrameSolver::multilevel, FrameSolver::relaxation}) {
    Turning turning;
    AnimatorOptions options;
    options.solver = solver;
    options.lambda = 0.2f;
    auto goes_on = TypeParam::made(turning.surface, options);
    auto resumed = TypeParam::made(turning.surface, options);
    TypeParam::next(resumed, turning.frame(0));  // aggregates follow the first frame
    int number = 0;
    std::vector<Phases> last = TypeParam::next(goes_on, turning.frame(number++));
    // Momenta of the paper's iterations cannot be given: there are none after the first frame.
    if (solver == FrameSolver::multilevel) {
      last = TypeParam::next(goes_on, turning.frame(number++));
    }
    resumed.restart();
    TypeParam::give(resumed, last);
    for (int following = 0; following < 2; ++following, ++number) {
      const std::vector<Phases> expected = TypeParam::next(goes_on, turning.frame(number));
      EXPECT_EQ(TypeParam::next(resumed, turning.frame(number)), expected);
      EXPECT_NE(expected, last);
    }
  }
}

/// A first frame that is cancelled leaves them, too.
template <class Kind>
struct InterruptedGivenFrame : InterruptedFrame<Kind> {};
TYPED_TEST_SUITE(InterruptedGivenFrame, KindsByVertex);

TYPED_TEST(InterruptedGivenFrame, LeavesThem) {
  this->for_options([&] {
    auto before = this->animator();
    const std::vector<Phases> last = this->see(before, this->second).z;
    const auto given = [&] {
      auto started = this->animator();
      TypeParam::give(started, last);
      return started;
    };
    auto undisturbed = given();
    const auto a = this->see(undisturbed, this->first), b = this->see(undisturbed, this->second);
    this->cancel_everywhere(this->third, given, [&](auto& cancelled) {
      EXPECT_EQ(this->see(cancelled, this->first), a);
      EXPECT_EQ(this->see(cancelled, this->second), b);
    });
  });
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
    const std::size_t vertices = turning.surface.mesh.vertex_count();
    for (std::size_t k = 0; k < z.size() && z[k].size() == vertices; ++k) {
      for (std::size_t v = 0; v < vertices; ++v) {
        sum += static_cast<double>(std::abs(std::arg(z[k][v] * std::conj(last[k][v]))));
      }
    }
    return sum;
  };
  const double followed = steps(TypeParam::next(given, turning.frame(1)));
  EXPECT_LT(followed, 0.5 * steps(TypeParam::next(scratch, turning.frame(1))));
  EXPECT_GT(followed, 0);
  std::vector<Phases> bad = last;
  bad[0][3] = 2;
  EXPECT_THROW(TypeParam::give(given, bad), Error);
  bad[0].pop_back();
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
