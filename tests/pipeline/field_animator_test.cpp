#include "brindle/pipeline/field_animator.h"

#include <cmath>

#include <gtest/gtest.h>

#include "brindle/base/error.h"
#include "brindle/waves/direction_graph.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::wavy_surface;
using testing_support::WavySurface;

const WavySurface& torus() {
  static const WavySurface surface = wavy_surface("torus,resolution=48", Vec3(0, 1, 0), 5);
  return surface;
}

float mean_turn(const DirectionField& a, const DirectionField& b) {
  float sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += (a[v] - b[v]).norm();
  return sum / static_cast<float>(a.size());
}

std::vector<FieldAnchor> anchors_along(const WavySurface& surface, float weight) {
  std::vector<FieldAnchor> anchors;
  for (Index v = 0; v < surface.normals.size(); v += 7) {
    anchors.push_back({v, surface.waves.directions[v], weight});
  }
  return anchors;
}

TEST(FieldAnimator, DirectionsAreUnitAndTangentForEverySymmetry) {
  for (const int symmetry : {1, 2, 4}) {
    FieldAnimator animator(torus().neighborhood, torus().normals, {.symmetry = symmetry});
    for (const float weight : {0.0f, 1.0f}) {
      const DirectionField& field = animator.frame(anchors_along(torus(), weight));
      for (std::size_t v = 0; v < field.size(); ++v) {
        EXPECT_NEAR(field[v].norm(), 1, 1e-5);
        EXPECT_NEAR(field[v].dot(torus().normals[v]), 0, 1e-5);
      }
    }
  }
}

TEST(FieldAnimator, StrongAnchorsAreObeyedUpToSign) {
  FieldAnimator animator(torus().neighborhood, torus().normals);
  animator.frame({});
  const auto anchors = anchors_along(torus(), 100);
  const DirectionField& field = animator.frame(anchors);
  for (const FieldAnchor& anchor : anchors) {
    if (anchor.direction.isZero(0)) continue;
    EXPECT_GT(std::abs(field[anchor.vertex].dot(anchor.direction)), 0.99f);
  }
}

TEST(FieldAnimator, TheSameAnchorsLeaveTheFieldAsItIs) {
  FieldAnimator animator(torus().neighborhood, torus().normals);
  const auto anchors = anchors_along(torus(), 1);
  const DirectionField first = animator.frame(anchors);
  EXPECT_EQ(animator.frame(anchors), first);
}

TEST(FieldAnimator, LambdaHoldsTheFieldBack) {
  const auto turn = [](float lambda) {
    FieldAnimator animator(torus().neighborhood, torus().normals, {.lambda = lambda});
    const DirectionField first = animator.frame({});
    return mean_turn(first, animator.frame(anchors_along(torus(), 0.2f)));
  };
  EXPECT_LT(turn(10), 0.5f * turn(0.01f));
  EXPECT_GT(turn(0.01f), 0.01f);
}

TEST(FieldAnimator, RefusesOptionsOutOfRange) {
  const auto make = [](const FieldAnimatorOptions& options) {
    FieldAnimator(torus().neighborhood, torus().normals, options);
  };
  EXPECT_THROW(make({.symmetry = 0}), Error);
  EXPECT_THROW(make({.lambda = -1}), Error);
  EXPECT_THROW(make({.lambda = NAN}), Error);
  EXPECT_THROW(make({.sweeps = -1}), Error);
  EXPECT_THROW(FieldAnimator(torus().neighborhood, {}), Error);
}

}  // namespace
}  // namespace brindle
