#include <cmath>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "progress_reports.h"

namespace brindle {
namespace {

TEST(SmoothFieldAnimator, FollowsItsAnchors) {
  const Surface plane = make_surface(make_shape("plane,resolution=40"));
  SmoothFieldAnimator animator(plane);
  for (const float angle : {0.3f, 0.5f, 0.7f}) {
    const Vec3 wanted(std::cos(angle), std::sin(angle), 0);
    const std::vector<FieldAnchor> anchors{{100, wanted, 20}, {900, wanted, 20}};
    std::span<const Vec3> field;
    // Drawn towards the last frame too, it takes some tens of frames.
    for (int n = 0; n < 80; ++n) {
      const std::vector<FieldAnchor> wobbling{{100, wanted, 20.0f + static_cast<float>(n % 2)},
                                              anchors[1]};
      field = animator.frame(wobbling);
    }
    for (const Vec3& d : field) EXPECT_GT(std::abs(d.dot(wanted)), 0.97f);
  }
}

TEST(SmoothFieldAnimator, ChangesLittleFromFrameToFrame) {
  const Surface sphere = make_surface(make_shape("sphere,resolution=24"));
  SmoothFieldAnimator animator(sphere);
  std::vector<FieldAnchor> anchors;
  std::vector<Vec3> last;
  for (Index n = 0; n < 10; ++n) {
    anchors.push_back({50 + n, Vec3(0.2f, 1, 0), 1});
    const auto field = animator.frame(anchors);
    double change = 0;
    for (std::size_t i = 0; i < last.size(); ++i) {
      change += std::acos(std::min(1.0f, std::abs(field[i].dot(last[i]))));
    }
    EXPECT_LE(change, 0.1 * static_cast<double>(last.size()));
    last.assign(field.begin(), field.end());
  }
}

TEST(SmoothFieldAnimator, KeepsSignsAndUnchangedFields) {
  const Surface torus = make_surface(make_shape("torus,resolution=60"));
  SmoothFieldAnimator animator(torus);
  const std::vector<FieldAnchor> anchors{{10, Vec3(0, 0, 1), 1}};
  const auto first = animator.frame(anchors);
  const std::vector<Vec3> kept(first.begin(), first.end());
  EXPECT_TRUE(std::ranges::equal(animator.frame(anchors), kept));
  const std::vector<FieldAnchor> moved{{11, Vec3(0, 0, 1), 1}};
  const auto next = animator.frame(moved);
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_GE(next[i].dot(kept[i]), 0);
}

TEST(SmoothFieldAnimator, RefusedAnchorsLeaveTheLastFrame) {
  const Surface sphere = make_surface(make_shape("sphere,resolution=12"));
  SmoothFieldAnimator animator(sphere), undisturbed(sphere);
  const std::vector<FieldAnchor> first{{10, Vec3(0, 0, 1), 5}}, second{{90, Vec3(1, 0, 0), 5}};
  const float nan = std::nanf("");
  const auto refuse_all = [&] {
    for (const FieldAnchor& bad :
         {FieldAnchor{100000, Vec3(1, 0, 0), 1}, FieldAnchor{3, Vec3(nan, 0, 0), 1},
          FieldAnchor{3, Vec3(1, 0, 0), nan}, FieldAnchor{3, Vec3(1, 0, 0), INFINITY}}) {
      const std::vector<FieldAnchor> anchors{second[0], bad};
      EXPECT_THROW(animator.frame(anchors), Error);
    }
  };
  refuse_all();
  EXPECT_TRUE(std::ranges::equal(animator.frame(first), undisturbed.frame(first)));
  refuse_all();
  EXPECT_TRUE(std::ranges::equal(animator.frame(first), undisturbed.frame(first)));
  EXPECT_TRUE(std::ranges::equal(animator.frame(second), undisturbed.frame(second)));
}

TEST(SmoothFieldAnimator, CancelledFramesLeaveTheLastOne) {
  const Surface sphere = make_surface(make_shape("sphere,resolution=12"));
  const std::vector<FieldAnchor> first{{10, Vec3(0, 0, 1), 5}}, second{{90, Vec3(1, 0, 0), 5}};
  testing_support::Reports all, later;
  SmoothFieldAnimator counted(sphere);
  counted.frame(first, all.progress());
  counted.frame(second, later.progress());
  EXPECT_GE(later.count(), 1);
  EXPECT_GE(all.count(), later.count()) << "the first frame descends from several starts";
  for (const int k : testing_support::reports_to_cancel(all.count())) {
    SmoothFieldAnimator animator(sphere), undisturbed(sphere);
    testing_support::Reports reports(k), again(k);
    EXPECT_THROW(animator.frame(second, reports.progress()), Cancelled);
    EXPECT_TRUE(std::ranges::equal(animator.frame(first), undisturbed.frame(first)));
    if (k < later.count()) {
      EXPECT_THROW(animator.frame(second, again.progress()), Cancelled);
    }
    EXPECT_TRUE(std::ranges::equal(animator.frame(first), undisturbed.frame(first)));
    EXPECT_TRUE(std::ranges::equal(animator.frame(second), undisturbed.frame(second)));
  }
  testing_support::Reports none(0);
  EXPECT_THROW(SmoothFieldAnimator(sphere, {}, none.progress()), Cancelled);
}

}  // namespace
}  // namespace brindle
