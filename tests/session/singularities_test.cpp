#include "session/singularities.h"

#include <gtest/gtest.h>

#include "brindle/smooth_field.h"
#include "session/live_pattern.h"

namespace brindle::tool {
namespace {

struct Solved {
  std::shared_ptr<const LiveState> state;
  std::vector<FieldSingularity> singularities;

  const Surface& surface() const { return *state->job->surface; }
  std::span<const Vec3> directions() const { return state->job->result.stripes().waves.directions; }
};

Solved solved(const std::string& mesh, const std::vector<FieldStroke>& strokes = {}) {
  SessionDocument document;
  document.mesh = mesh;
  document.strokes = strokes;
  LivePattern pattern;
  pattern.update(document, Follow::afresh);
  Solved result{pattern.state(), {}};
  const StripePattern& stripes = result.state->job->result.stripes();
  result.singularities =
      field_singularities(result.surface(), stripes.corners, stripes.waves.directions);
  return result;
}

int total(const std::vector<FieldSingularity>& singularities) {
  int sum = 0;
  for (const FieldSingularity& singularity : singularities) sum += singularity.sign;
  return sum;
}

std::size_t near(const Solved& field, const Vec3& place, float radius) {
  return static_cast<std::size_t>(std::ranges::count_if(
      field.singularities,
      [&](const auto& singularity) { return (singularity.position - place).norm() < radius; }));
}

std::size_t triangle_at(const Surface& surface, const Vec3& place) {
  std::size_t nearest = 0;
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    Vec3 middle = Vec3::Zero();
    for (const Index v : surface.mesh.triangles[t]) middle += surface.mesh.positions[v] / 3;
    if (!((middle - place).norm() < least)) continue;
    least = (middle - place).norm();
    nearest = t;
  }
  return nearest;
}

TEST(Singularities, SumUpToTwiceTheEulerCharacteristic) {
  EXPECT_EQ(total(solved("shape:sphere,resolution=40").singularities), 4);
  EXPECT_EQ(total(solved("shape:torus,resolution=40").singularities), 0);
  for (const FieldSingularity& singularity : solved("shape:sphere").singularities) {
    EXPECT_EQ(std::abs(singularity.sign), 1);
    EXPECT_GT(singularity.normal.dot(singularity.position), 0);
  }
}

// Along the sphere, by different angles and in all directions.
TEST(Singularities, AreMovedByStrokes) {
  const Solved before = solved("shape:sphere,resolution=60");
  ASSERT_EQ(before.singularities.size(), 4u);
  const float reach = 0.15f;
  for (const FieldSingularity& moved : before.singularities) {
    for (const float degrees : {15.0f, 35.0f, 60.0f}) {
      const Vec3 axis = moved.position.unitOrthogonal();
      const Vec3 to = Eigen::AngleAxisf(degrees * 3.14159265f / 180, axis) * moved.position;
      if (near(before, to, 4 * reach) > (degrees < 20 ? 1 : 0)) continue;  // another one
      const Solved after =
          solved("shape:sphere,resolution=60",
                 strokes_that_move(moved, triangle_at(before.surface(), to), before.surface(),
                                   before.directions(), reach, 4));
      EXPECT_EQ(near(after, to, reach), 1u) << degrees;
      EXPECT_EQ(near(after, moved.position, reach), 0u) << degrees;
      EXPECT_EQ(total(after.singularities), 4);
      EXPECT_EQ(after.singularities.size(), 4u);
    }
  }
}

TEST(Singularities, OfOppositeSignsAreGoneWhenTheyMeet) {
  const Solved before = solved("shape:vessels");
  const float diagonal = bounding_box(before.surface().mesh).diagonal();
  struct Pair {
    const FieldSingularity *one, *other;
    float distance;
  };
  std::vector<Pair> pairs;
  for (const FieldSingularity& one : before.singularities) {
    for (const FieldSingularity& other : before.singularities) {
      if (one.sign != 1 || other.sign != -1 || one.normal.dot(other.normal) < 0) continue;
      pairs.push_back({&one, &other, (one.position - other.position).norm()});
    }
  }
  ASSERT_GE(pairs.size(), 5u);
  std::ranges::sort(pairs, {}, &Pair::distance);
  for (std::size_t i = 0; i < 5; ++i) {
    const Solved after =
        solved("shape:vessels",
               strokes_that_move(*pairs[i].one, pairs[i].other->triangle, before.surface(),
                                 before.directions(), 0.02 * diagonal, 4));
    EXPECT_EQ(after.singularities.size(), before.singularities.size() - 2);
  }
}

// What held one where it was is left behind when it is led on, so that it goes there, too.
TEST(Singularities, AreLedOnFromWhereTheyAre) {
  const std::string mesh = "shape:sphere,resolution=60";
  const Solved before = solved(mesh);
  const FieldSingularity& moved = before.singularities.front();
  const float reach = 0.15f;
  const Vec3 axis = moved.position.unitOrthogonal();
  std::vector<FieldStroke> held;
  Solved now = before;
  for (const float degrees : {20.0f, 40.0f, 55.0f}) {
    const Vec3 to = Eigen::AngleAxisf(degrees * 3.14159265f / 180, axis) * moved.position;
    const DroppedSingularity dropped{triangle_at(now.surface(), to), moved.sign, false, 4};
    const Arrival was = arrival_of(dropped, now.surface(), now.singularities, 0.5 * reach);
    EXPECT_FALSE(was.there);
    ASSERT_NE(was.nearest, nullptr);
    EXPECT_NE(arrival_words(dropped, was, 2).find("from where you dropped it"), std::string::npos);
    held = with_steering(std::move(held), strokes_that_move(*was.nearest, dropped.to, now.surface(),
                                                            now.directions(), reach, 4));
    now = solved(mesh, held);
    const Arrival arrival = arrival_of(dropped, now.surface(), now.singularities, 0.5 * reach);
    EXPECT_TRUE(arrival.there) << degrees << ": " << arrival.distance;
    EXPECT_EQ(arrival.others, 0) << degrees;
    EXPECT_EQ(arrival_words(dropped, arrival, 2), "the singularity is where you dropped it");
  }
  const std::size_t ends = held.size();
  held = with_steering(std::move(held), held);
  EXPECT_EQ(held.size(), ends) << "the same again takes the place of itself";
}

// Of two signs, one each, far from a place, at it and beyond it.
TEST(Singularities, WhatBecameOfThemIsSaid) {
  const Solved field = solved("shape:sphere,resolution=40");
  const FieldSingularity& one = field.singularities.front();
  std::vector<FieldSingularity> after = {one};
  const auto words = [&](DroppedSingularity dropped) {
    return arrival_words(dropped, arrival_of(dropped, field.surface(), after, 0.1), 2);
  };
  const auto says = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_EQ(words({one.triangle, one.sign, false, 1}), "the singularity is where you dropped it");
  EXPECT_TRUE(says(words({one.triangle, one.sign, false, 3}), "elsewhere 2 went"));
  EXPECT_TRUE(says(words({one.triangle, one.sign, true, 1}), "have not met"));
  EXPECT_TRUE(says(words({one.triangle, -one.sign, true, 3}), "have not met"));
  EXPECT_TRUE(says(words({one.triangle, -one.sign, false, 3}), "is gone"));
  const std::size_t far = triangle_at(field.surface(), -one.position);
  EXPECT_TRUE(says(words({far, one.sign, false, 1}), "from where you dropped it"));
  EXPECT_EQ(words({far, one.sign, true, 3}), "both singularities are gone");
}

TEST(Singularities, CannotBeMovedToAnotherPart) {
  const Solved field = solved("shape:pieces");
  ASSERT_FALSE(field.singularities.empty());
  const Mesh& mesh = field.surface().mesh;
  const Vec3 from = field.singularities.front().position;
  std::size_t farthest = 0;
  float most = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const float distance = (mesh.positions[mesh.triangles[t][0]] - from).norm();
    if (distance <= most) continue;
    most = distance;
    farthest = t;
  }
  EXPECT_TRUE(strokes_that_move(field.singularities.front(), farthest, field.surface(),
                                field.directions(), 0.1, 4)
                  .empty());
}

}  // namespace
}  // namespace brindle::tool
