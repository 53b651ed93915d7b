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
