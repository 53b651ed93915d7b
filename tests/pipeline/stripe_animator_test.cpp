#include "brindle/stripe_animator.h"

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>
#include <tuple>

#include <gtest/gtest.h>

#include "bad_waves.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/pattern_frames.h"
#include "brindle/solver.h"
#include "phase_graphs.h"
#include "progress_reports.h"

#ifdef BRINDLE_HAS_TBB
#include <tbb/task_arena.h>
#endif

namespace {

std::atomic<std::size_t> allocations = 0;

}  // namespace

// Sanitizers have their own operator new.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define BRINDLE_COUNTS_ALLOCATIONS

// Counts what the whole test program allocates. Not inlined, or GCC 12 compares malloc and free
// with the operators that it still sees elsewhere.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

#endif

namespace brindle {
namespace {

using testing_support::flip_half;
using testing_support::kAxis;
using testing_support::Reports;
using testing_support::wavy_surface;
using testing_support::WavySurface;

FrameInput input_of(const WavySurface& surface) {
  return {surface.waves.positions, surface.waves.directions, surface.waves.frequencies};
}

AnimatorOptions with_lambda(float lambda) {
  AnimatorOptions options;
  options.lambda = lambda;
  return options;
}

void zoom(WavySurface& surface) {
  for (float& f : surface.waves.frequencies) f *= 1.01f;
}

TEST(StripeAnimator, FirstFrameIsThatOfTheMultilevelSolver) {
  const auto surface = wavy_surface("torus,resolution=80", kAxis, 25);
  StripeAnimator animator(surface.neighborhood);
  const FrameResult frame = animator.frame(input_of(surface));
  const PhaseSolution solution = solve_phases(surface.graph());
  EXPECT_NEAR(energy(surface.graph(), frame.z), solution.energy, 0.02 * solution.energy);
  EXPECT_EQ(frame.phase_step, 0);
}

TEST(StripeAnimator, UnchangedInputGivesUnchangedPhases) {
  const auto surface = wavy_surface("torus,resolution=80", kAxis, 25);
  StripeAnimator animator(surface.neighborhood);
  const auto first = animator.frame(input_of(surface)).z;
  const std::vector<Complex> z(first.begin(), first.end());
  for (int n = 0; n < 10; ++n) {
    const FrameResult frame = animator.frame(input_of(surface));
    EXPECT_TRUE(frame.unchanged);
    EXPECT_LT(frame.phase_step, 1e-4);
    EXPECT_TRUE(std::ranges::equal(frame.z, z));
  }
}

TEST(StripeAnimator, AnchorsKeepFramesTogetherAtLittleEnergy) {
  auto surface = wavy_surface("sphere,resolution=40", kAxis, 30);
  StripeAnimator anchored(surface.neighborhood);
  StripeAnimator scratch(surface.neighborhood, with_lambda(0));
  double anchored_energy = 0, scratch_energy = 0;
  double anchored_steps = 0, scratch_steps = 0;
  for (int n = 0; n < 30; ++n) {
    surface.waves.directions = rotated(surface.waves.directions, surface.normals, 0.02f);
    const FrameResult a = anchored.frame(input_of(surface));
    const FrameResult b = scratch.frame(input_of(surface));
    anchored_energy += energy(surface.graph(), a.z);
    scratch_energy += energy(surface.graph(), b.z);
    anchored_steps += a.phase_step;
    scratch_steps += b.phase_step;
  }
  EXPECT_LE(anchored_energy, 1.25 * scratch_energy);
  EXPECT_LT(anchored_steps, 0.5 * scratch_steps);
}

TEST(StripeAnimator, TurningDirectionsRoundIsNoChangeOfThePattern) {
  auto surface = wavy_surface("torus,resolution=80", kAxis, 25);
  StripeAnimator animator(surface.neighborhood, with_lambda(0.5f));
  animator.frame(input_of(surface));
  const auto flipped = flip_half(surface.waves, 3);
  EXPECT_LT(animator.frame(input_of(surface)).phase_step, 0.02);
}

TEST(StripeAnimator, FollowsMovingVertices) {
  auto surface = wavy_surface("sphere,resolution=24", kAxis, 20);
  StripeAnimator animator(surface.neighborhood);
  animator.frame(input_of(surface));
  const std::vector<Vec3> rest = surface.waves.positions;
  for (int n = 1; n <= 10; ++n) {
    for (std::size_t i = 0; i < rest.size(); ++i) {
      surface.waves.positions[i] =
          rest[i] * (1 + 0.02f * std::sin(3 * rest[i].x() + 0.2f * static_cast<float>(n)));
    }
    const FrameResult frame = animator.frame(input_of(surface));
    EXPECT_LT(energy(surface.graph(), frame.z), 0.02);
    EXPECT_FALSE(frame.unchanged);
  }
}

TEST(StripeAnimator, PaperModeLagsBehindAFastChange) {
  auto surface = wavy_surface("torus,resolution=120", kAxis, 30);
  AnimatorOptions paper;
  paper.solver = FrameSolver::relaxation;
  StripeAnimator relaxation(surface.neighborhood, paper), multilevel(surface.neighborhood);
  double paper_energy = 0, our_energy = 0;
  for (int n = 0; n < 30; ++n) {
    zoom(surface);
    paper_energy = energy(surface.graph(), relaxation.frame(input_of(surface)).z);
    our_energy = energy(surface.graph(), multilevel.frame(input_of(surface)).z);
  }
  EXPECT_GT(paper_energy, 1.5 * our_energy);
}

TEST(StripeAnimator, SiblingSharesTheTopologyAndSolvesItsOwnField) {
  auto surface = wavy_surface("torus,resolution=80", kAxis, 25);
  StripeAnimator u(surface.neighborhood);
  u.frame(input_of(surface));
  StripeAnimator v = u.sibling();
  surface.waves.directions =
      rotated(surface.waves.directions, surface.normals, static_cast<float>(M_PI / 2));
  const FrameResult frame = v.frame(input_of(surface));
  EXPECT_LT(energy(surface.graph(), frame.z), 1.1 * solve_phases(surface.graph()).energy);
  EXPECT_EQ(v.topology_milliseconds(), 0);
}

/// What a caller sees of a frame.
struct Seen {
  std::vector<Complex> z;
  double energy;
  double phase_step;
  bool operator==(const Seen&) const = default;
};

Seen see(StripeAnimator& animator, const FrameInput& input, const Progress& progress = {}) {
  const FrameResult frame = animator.frame(input, progress);
  return {{frame.z.begin(), frame.z.end()}, animator.energy(), frame.phase_step};
}

/// The momenta of the paper's mode are turned with the phases.
TEST(StripeAnimator, TurningDirectionsRoundInAnyFrameLeavesThePattern) {
  for (const FrameSolver solver : {FrameSolver::multilevel, FrameSolver::relaxation}) {
    AnimatorOptions options = with_lambda(0.1f);
    options.solver = solver;
    WavySurface plain = wavy_surface("torus,resolution=60", kAxis, 20);
    StripeAnimator as_given(plain.neighborhood, options), turned(plain.neighborhood, options);
    for (int number = 0; number < 6; ++number) {
      SCOPED_TRACE(number);
      WavySurface other = plain;
      const std::vector<std::uint8_t> flipped =
          number % 2 == 1 ? flip_half(other.waves, 3)
                          : std::vector<std::uint8_t>(plain.waves.positions.size());
      const auto z = as_given.frame(input_of(plain)).z;
      const auto of_turned = turned.frame(input_of(other)).z;
      float farthest = 0;
      for (std::size_t v = 0; v < z.size(); ++v) {
        const Complex expected = flipped[v] ? -std::conj(z[v]) : z[v];
        farthest = std::max(farthest, std::abs(of_turned[v] - expected));
      }
      EXPECT_LT(farthest, 1e-3f);
      plain.waves.directions = rotated(plain.waves.directions, plain.normals, 0.02f);
    }
  }
}

/// What all animators promise of frames that are cancelled is in animators_test.cpp.
struct Interrupted : testing::TestWithParam<std::tuple<FrameSolver, int>> {
  WavySurface first = wavy_surface("torus,resolution=60", kAxis, 20);
  WavySurface second = first, third = first;
  AnimatorOptions options;

  Interrupted() {
    options.solver = std::get<FrameSolver>(GetParam());
    options.cycles = std::get<int>(GetParam());
    flip_half(second.waves, 3);
    zoom(second);
    third.waves.directions = rotated(third.waves.directions, third.normals, 1.2f);
    for (Vec3& p : third.waves.positions) p.x() *= 1.1f;
  }

  StripeAnimator animator() const { return StripeAnimator(first.neighborhood, options); }

  /// Cancels a frame at every report of progress that it makes, each time of an animator that
  /// `start` hands over, and lets `expect` look at what is left of it.
  template <class Start, class Expect>
  void cancel_everywhere(const WavySurface& input, const Start& start, const Expect& expect) const {
    StripeAnimator undisturbed = start();
    Reports all;
    undisturbed.frame(input_of(input), all.progress());
    EXPECT_GE(all.count(), options.solver == FrameSolver::multilevel ? options.cycles + 1 : 1);
    for (const int k : testing_support::reports_to_cancel(all.count())) {
      SCOPED_TRACE(k);
      StripeAnimator cancelled = start();
      Reports reports(k);
      EXPECT_THROW(cancelled.frame(input_of(input), reports.progress()), Cancelled);
      expect(cancelled);
    }
  }
};

TEST_P(Interrupted, FirstFrameOfASiblingLeavesItsTopology) {
  StripeAnimator u = animator();
  u.frame(input_of(first));
  StripeAnimator undisturbed = u.sibling();
  const Seen v = see(undisturbed, input_of(third));
  cancel_everywhere(
      second, [&] { return u.sibling(); },
      [&](StripeAnimator& cancelled) { EXPECT_EQ(see(cancelled, input_of(third)), v); });
}

TEST_P(Interrupted, BadValuesLeaveTheLastFrame) {
  StripeAnimator undisturbed = animator(), refusing = animator();
  testing_support::expect_refused(first.waves, 5, [&](const WaveSet& bad) {
    refusing.frame({bad.positions, bad.directions, bad.frequencies});
  });
  EXPECT_EQ(see(refusing, input_of(first)), see(undisturbed, input_of(first)));
  testing_support::expect_refused(second.waves, 7, [&](const WaveSet& bad) {
    refusing.frame({bad.positions, bad.directions, bad.frequencies});
  });
  EXPECT_EQ(refusing.energy(), undisturbed.energy());
  EXPECT_TRUE(refusing.frame(input_of(first)).unchanged);
  EXPECT_EQ(see(refusing, input_of(second)), see(undisturbed, input_of(second)));
}

INSTANTIATE_TEST_SUITE_P(StripeAnimator, Interrupted,
                         testing::Combine(testing::Values(FrameSolver::multilevel,
                                                          FrameSolver::relaxation),
                                          testing::Values(0, 3)));

#ifdef BRINDLE_HAS_TBB
TEST(StripeAnimator, MoreThreadsMayWorkOnAFrameThanOnTheFirst) {
  const auto run = [](int first, int later) {
    auto surface = wavy_surface("torus,resolution=200", kAxis, 25);
    StripeAnimator animator(surface.neighborhood);
    tbb::task_arena(first).execute([&] { animator.frame(input_of(surface)); });
    const ThreadLimit threads(later);
    Seen seen;
    for (int n = 0; n < 5; ++n) {
      zoom(surface);
      tbb::task_arena(later).execute([&] { seen = see(animator, input_of(surface)); });
    }
    return seen;
  };
  EXPECT_EQ(run(1, 8), run(1, 1));
}
#endif  // BRINDLE_HAS_TBB

TEST(StripeAnimator, HasNoEnergyBeforeTheFirstFrame) {
  const auto surface = wavy_surface("plane,resolution=5", kAxis, 5);
  StripeAnimator animator(surface.neighborhood);
  EXPECT_THROW(animator.energy(), Error);
  animator.frame(input_of(surface));
  EXPECT_NO_THROW(animator.energy());
  EXPECT_THROW(animator.sibling().energy(), Error);
}

TEST(StripeAnimator, AllocatesNothingAfterTheFirstFrame) {
#ifndef BRINDLE_COUNTS_ALLOCATIONS
  GTEST_SKIP() << "allocations are not counted under a sanitizer";
#endif
  const ThreadLimit one(1);
  for (const float slack : {0.0f, 0.2f}) {
    auto surface = wavy_surface("torus,resolution=80", kAxis, 25);
    flip_half(surface.waves, 2);
    AnimatorOptions options;
    options.slack = slack;
    const Surface whole{surface.mesh, surface.neighborhood, surface.normals};
    StripeAnimator animator(whole, options);
    PatternFrames drawn(whole);
    std::vector<PatternVertex> vertices(surface.mesh.vertex_count());
    const auto next = [&] {
      const FrameResult frame = animator.frame(input_of(surface));
      drawn.fill(input_of(surface), frame, vertices);
      drawn.corners(input_of(surface), frame);
    };
    next();
    const std::size_t before = allocations;
    for (int n = 0; n < 5; ++n) {
      zoom(surface);
      for (Vec3& p : surface.waves.positions) p *= 1.01f;
      next();
    }
    EXPECT_EQ(allocations, before) << slack;
  }
}

TEST(StripeAnimator, RefusesBadInputAndOptions) {
  const auto surface = wavy_surface("plane,resolution=5", kAxis, 5);
  StripeAnimator animator(surface.neighborhood);
  FrameInput input = input_of(surface);
  input.frequencies = input.frequencies.first(3);
  EXPECT_THROW(animator.frame(input), Error);
  EXPECT_THROW(StripeAnimator(surface.neighborhood, with_lambda(-1)), Error);
  EXPECT_THROW(StripeAnimator(surface.neighborhood, with_lambda(2e36f)), Error);
  AnimatorOptions options;
  options.phase_shift = PhaseShiftKind::common_source;
  EXPECT_THROW(StripeAnimator(surface.neighborhood, options), Error);
  options = {};
  options.edge_weights.assign(surface.neighborhood->directed_edge_count(), 1);
  EXPECT_NO_THROW(StripeAnimator(surface.neighborhood, options));
  options.edge_weights[3] = std::nanf("");
  EXPECT_THROW(StripeAnimator(surface.neighborhood, options), Error);
}

std::vector<Complex> copy_of(std::span<const Complex> z) { return {z.begin(), z.end()}; }

TEST(StripeAnimator, GivenPhasesCountAlsoForInputOfTheLastFrame) {
  auto surface = wavy_surface("torus,resolution=80", kAxis, 25);
  StripeAnimator animator(surface.neighborhood, with_lambda(1e4f));
  std::vector<Complex> turned = copy_of(animator.frame(input_of(surface)).z);
  for (Complex& z : turned) z *= std::polar(1.0f, 0.7f);
  animator.set_last_phases(turned);
  const FrameResult frame = animator.frame(input_of(surface));
  EXPECT_FALSE(frame.unchanged);
  for (std::size_t i = 0; i < turned.size(); ++i) EXPECT_LT(std::abs(frame.z[i] - turned[i]), 0.01);
  EXPECT_TRUE(animator.frame(input_of(surface)).unchanged);
}

TEST(StripeAnimator, VerticesWithoutAGivenPhaseAreFree) {
  for (const FrameSolver solver : {FrameSolver::multilevel, FrameSolver::relaxation}) {
    auto surface = wavy_surface("torus,resolution=80", kAxis, 25);
    AnimatorOptions options;
    options.solver = solver;
    options.iterations = 30;
    std::vector<Complex> half =
        copy_of(StripeAnimator(surface.neighborhood).frame(input_of(surface)).z);
    for (std::size_t i = 0; i < half.size(); i += 2) half[i] = 0;
    StripeAnimator animator(surface.neighborhood, options);
    animator.set_last_phases(half);
    const FrameResult frame = animator.frame(input_of(surface));
    for (const Complex& z : frame.z) EXPECT_NEAR(std::abs(z), 1, 1e-4);
    EXPECT_LT(energy(surface.graph(), frame.z), 0.02);
    EXPECT_LT(frame.phase_step, 0.2);
  }
}

TEST(StripeAnimator, RefusedPhasesAndFramesLeaveAllAsItWas) {
  const auto surface = wavy_surface("torus,resolution=80", kAxis, 25);
  auto next = surface;
  zoom(next);
  AnimatorOptions options = with_lambda(0.2f);
  options.cycles = 2;
  StripeAnimator expected(surface.neighborhood, options), tried(surface.neighborhood, options);
  const auto first = copy_of(expected.frame(input_of(surface)).z);
  expected.set_last_phases(first);
  const auto phases = copy_of(expected.frame(input_of(next)).z);

  tried.set_last_phases(std::vector<Complex>(first.size(), Complex(0)));
  EXPECT_THROW(tried.frame(input_of(surface), Reports(0).progress()), Cancelled);
  tried.restart();
  tried.frame(input_of(surface));
  tried.set_last_phases(first);
  std::vector<Complex> bad = first;
  bad[3] = 2;
  EXPECT_THROW(tried.set_last_phases(bad), Error);
  bad.pop_back();
  EXPECT_THROW(tried.set_last_phases(bad), Error);
  bad[3] = std::nanf("");
  EXPECT_THROW(tried.set_last_phases(bad), Error);
  FrameInput short_input = input_of(next);
  short_input.frequencies = short_input.frequencies.first(3);
  EXPECT_THROW(tried.frame(short_input), Error);
  EXPECT_THROW(tried.frame(input_of(next), Reports(0).progress()), Cancelled);
  EXPECT_EQ(copy_of(tried.frame(input_of(next)).z), phases);
}

}  // namespace
}  // namespace brindle
