// Objects that were moved from say so.
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "brindle/cross_animator.h"
#include "brindle/error.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/spacing_tolerance.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"
#include "brindle/texture_animator.h"

namespace brindle {
namespace {

template <class Use>
void expect_moved_from(const Use& use) {
  try {
    use();
    ADD_FAILURE() << "an object was used that was moved from";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("moved from"), std::string::npos) << error.what();
  }
}

struct MovedFrom : testing::Test {
  Surface surface = make_surface(make_shape("sphere,resolution=6"));
  DirectionField directions = projected_direction_field(Vec3(0, 0, 1), surface.normals);
  FrequencyField frequencies = constant_frequency_field(3, surface.mesh.vertex_count());
  FrameInput input{surface.mesh.positions, directions, frequencies};

  /// Moving on leaves `animator` empty; what was moved, and what is assigned to it, works.
  template <class Animator, class Frame>
  void check_animator(Animator animator, const Frame& frame) {
    Animator other = std::move(animator);
    expect_moved_from([&] { frame(animator); });  // NOLINT(bugprone-use-after-move)
    EXPECT_NO_THROW(frame(other));
    animator = std::move(other);
    EXPECT_NO_THROW(frame(animator));
  }
};

TEST_F(MovedFrom, AnimatorsSaySo) {
  check_animator(StripeAnimator(surface), [&](StripeAnimator& a) { a.frame(input); });
  check_animator(TextureAnimator(surface), [&](TextureAnimator& a) { a.frame({input}); });
  check_animator(CrossAnimator(surface), [&](CrossAnimator& a) { a.frame({input}); });
  check_animator(SmoothFieldAnimator(surface), [](SmoothFieldAnimator& a) { a.frame({}); });
}

TEST_F(MovedFrom, EveryCallOfStripeAnimatorSaysSo) {
  StripeAnimator animator(surface);
  const StripeAnimator other = std::move(animator);
  // NOLINTBEGIN(bugprone-use-after-move)
  expect_moved_from([&] { static_cast<void>(animator.energy()); });
  expect_moved_from([&] { static_cast<void>(animator.sibling()); });
  expect_moved_from([&] { animator.restart(); });
  expect_moved_from([&] { animator.set_last_phases({}); });
  expect_moved_from([&] { animator.set_slack(0.1f); });
  expect_moved_from([&] { static_cast<void>(animator.topology_milliseconds()); });
  // NOLINTEND(bugprone-use-after-move)
}

TEST_F(MovedFrom, ASurfaceHasNoNeighboursLeft) {
  const Surface taken = std::move(surface);
  // NOLINTBEGIN(bugprone-use-after-move)
  EXPECT_THROW(StripeAnimator{surface}, Error);
  EXPECT_THROW(stripe_pattern(surface, DirectionField(), FrequencyField()), Error);
  // NOLINTEND(bugprone-use-after-move)
}

}  // namespace
}  // namespace brindle
