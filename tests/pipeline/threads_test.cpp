/// What several threads may do at the same time: what threads.h promises.
#include "brindle/threads.h"

#include <cmath>
#include <functional>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/frequency_field.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"
#include "brindle/surface.h"

namespace brindle {
namespace {

using Phases = std::vector<Complex>;

/// What each job returns when all run at the same time, each on a thread of its own.
std::vector<Phases> together(const std::vector<std::function<Phases()>>& jobs) {
  std::vector<Phases> results(jobs.size());
  std::vector<std::thread> threads;
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    threads.emplace_back([&, j] { results[j] = jobs[j](); });
  }
  for (std::thread& thread : threads) thread.join();
  return results;
}

std::vector<Phases> one_by_one(const std::vector<std::function<Phases()>>& jobs) {
  std::vector<Phases> results;
  for (const auto& job : jobs) results.push_back(job());
  return results;
}

Phases pattern_on(const Surface& surface, float frequency) {
  const std::size_t vertices = surface.mesh.vertex_count();
  return stripe_pattern(surface, {surface.mesh.positions, smooth_direction_field(surface),
                                  constant_frequency_field(frequency, vertices)})
      .solution.z;
}

/// The phases of the last of a few frames whose field turns.
Phases frames_on(const Surface& surface, float frequency) {
  StripeAnimator animator(surface.neighborhood);
  const std::vector<float> frequencies(surface.mesh.vertex_count(), frequency);
  Phases last;
  for (int number = 0; number < 6; ++number) {
    const float angle = 0.05f * static_cast<float>(number);
    const auto z = animator
                       .frame({surface.mesh.positions,
                               projected_direction_field({std::cos(angle), std::sin(angle), 0.3f},
                                                         surface.normals),
                               frequencies})
                       .z;
    last.assign(z.begin(), z.end());
  }
  return last;
}

TEST(Threads, SolvePatternsOnSurfacesOfTheirOwn) {
  const Surface torus = make_surface(make_shape("torus,resolution=120"));
  const Surface trefoil = make_surface(make_shape("trefoil,resolution=24"));
  const std::vector<std::function<Phases()>> jobs = {[&] { return pattern_on(torus, 10); },
                                                     [&] { return pattern_on(trefoil, 14); }};
  EXPECT_EQ(together(jobs), one_by_one(jobs));
}

TEST(Threads, SolvePatternsOnOneSurface) {
  const Surface torus = make_surface(make_shape("torus,resolution=120"));
  const std::vector<std::function<Phases()>> jobs = {[&] { return pattern_on(torus, 10); },
                                                     [&] { return pattern_on(torus, 17); },
                                                     [&] { return pattern_on(torus, 23); }};
  EXPECT_EQ(together(jobs), one_by_one(jobs));
}

TEST(Threads, RunAnimatorsSideBySide) {
  const Surface torus = make_surface(make_shape("torus,resolution=120"));
  const Surface sphere = make_surface(make_shape("sphere,resolution=30"));
  const std::vector<std::function<Phases()>> jobs = {[&] { return frames_on(torus, 10); },
                                                     [&] { return frames_on(torus, 20); },
                                                     [&] { return frames_on(sphere, 9); }};
  EXPECT_EQ(together(jobs), one_by_one(jobs));
}

TEST(Threads, MayBeLimitedWhileOthersWork) {
  const Surface torus = make_surface(make_shape("torus,resolution=120"));
  const std::vector<std::function<Phases()>> jobs = {[&] { return pattern_on(torus, 10); },
                                                     [&] {
                                                       const ThreadLimit one(1);
                                                       return pattern_on(torus, 17);
                                                     }};
  EXPECT_EQ(together(jobs), one_by_one(jobs));
}

}  // namespace
}  // namespace brindle
