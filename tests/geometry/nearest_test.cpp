#include "brindle/nearest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "test_meshes.h"
#include "test_numbers.h"

namespace brindle {
namespace {

using testing_support::kInfinity;

using Eigen::Vector3d;

Vector3d corner(const Mesh& mesh, Index triangle, std::size_t m) {
  return mesh.positions[mesh.triangles[triangle][m]].cast<double>();
}

Vector3d place(const Mesh& mesh, const PointOnMesh& found) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t m = 0; m < 3; ++m) sum += found.barycentric[m] * corner(mesh, found.triangle, m);
  return sum;
}

/// The distance to a triangle, found as the minimum of a convex function of two shares by ternary
/// search: nothing that the class computes with.
double distance_by_search(const Mesh& mesh, Index triangle, const Vector3d& point) {
  const Vector3d a = corner(mesh, triangle, 0), b = corner(mesh, triangle, 1),
                 c = corner(mesh, triangle, 2);
  const auto minimum = [](double upper, const auto& f) {
    double low = 0, high = upper;
    for (int step = 0; step < 60; ++step) {
      const double first = low + (high - low) / 3, second = high - (high - low) / 3;
      (f(first) < f(second) ? high : low) = f(first) < f(second) ? second : first;
    }
    return f((low + high) / 2);
  };
  return minimum(1, [&](double s) {
    return minimum(1 - s, [&](double t) { return (a + s * (b - a) + t * (c - a) - point).norm(); });
  });
}

std::vector<Vector3d> points_around(const Mesh& mesh, int count) {
  std::mt19937 random(3);
  const BoundingBox box = bounding_box(mesh);
  std::uniform_real_distribution<double> share(-0.5, 1.5);
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const Vector3d size = (box.upper - box.lower).cast<double>();
    points.push_back(box.lower.cast<double>() +
                     Vector3d(share(random), share(random), share(random)).cwiseProduct(size));
  }
  return points;
}

/// The nearest of all triangles, each asked by itself.
std::optional<PointOnMesh> nearest_by_force(const Mesh& mesh, const Vector3d& point) {
  std::optional<PointOnMesh> best;
  Mesh alone = mesh;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    alone.triangles = {mesh.triangles[t]};
    auto found = NearestOnMesh(alone).nearest(point);
    if (!best || found->distance < best->distance) {
      best = found;
      best->triangle = t;
    }
  }
  return best;
}

void expect_on_triangle(const Mesh& mesh, const PointOnMesh& found, const Vector3d& point) {
  for (const double weight : found.barycentric) EXPECT_GE(weight, 0);
  EXPECT_NEAR(found.barycentric[0] + found.barycentric[1] + found.barycentric[2], 1, 1e-15);
  const double scale = bounding_box(mesh).diagonal();
  EXPECT_LE((place(mesh, found) - found.position).norm(), 1e-12 * scale);
  EXPECT_NEAR((found.position - point).norm(), found.distance, 1e-12 * scale);
}

TEST(NearestOnMesh, OneTriangleIsAsSearched) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> at(-1, 1);
  for (int round = 0; round < 40; ++round) {
    Mesh mesh{{}, {{0, 1, 2}}};
    for (int v = 0; v < 3; ++v) mesh.positions.emplace_back(at(random), at(random), at(random));
    const NearestOnMesh nearest(mesh);
    for (const Vector3d& point : points_around(mesh, 10)) {
      const auto found = nearest.nearest(point);
      ASSERT_TRUE(found);
      expect_on_triangle(mesh, *found, point);
      EXPECT_NEAR(found->distance, distance_by_search(mesh, 0, point), 1e-9);
    }
  }
}

TEST(NearestOnMesh, FindsWhatAskingEveryTriangleFinds) {
  for (const auto& [name, mesh] : every_shape()) {
    SCOPED_TRACE(name);
    Mesh part = mesh;  // asking every triangle takes long
    part.triangles.resize(std::min<std::size_t>(part.triangles.size(), 2000));
    drop_unreferenced_vertices(part);
    const NearestOnMesh nearest(part);
    for (const Vector3d& point : points_around(part, 5)) {
      const auto found = nearest.nearest(point), expected = nearest_by_force(part, point);
      ASSERT_TRUE(found && expected);
      EXPECT_EQ(found->distance, expected->distance);
      EXPECT_EQ(found->triangle, expected->triangle);
      EXPECT_EQ(found->barycentric, expected->barycentric);
      expect_on_triangle(part, *found, point);
    }
  }
}

TEST(NearestOnMesh, AVertexIsItsOwnPlace) {
  const Mesh mesh = make_shape("molecule,resolution=20");
  const NearestOnMesh nearest(mesh);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const auto found = nearest.nearest(mesh.positions[v].cast<double>());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->distance, 0);
    const auto largest = std::ranges::max_element(found->barycentric) - found->barycentric.begin();
    EXPECT_EQ(mesh.triangles[found->triangle][static_cast<std::size_t>(largest)], v);
    EXPECT_EQ(found->barycentric[static_cast<std::size_t>(largest)], 1);
  }
}

TEST(NearestOnMesh, TiesGoToTheSmallestNumber) {
  // A fan around vertex 0, above which all triangles are equally near, each of them twice.
  Mesh fan{{{0, 0, 0}}, {}};
  for (int k = 0; k < 24; ++k) {
    const float angle = static_cast<float>(k) * 0.2617994f;
    fan.positions.emplace_back(std::cos(angle), std::sin(angle), -1.0f);
  }
  for (int copy = 0; copy < 2; ++copy) {
    for (Index k = 0; k < 24; ++k) fan.triangles.push_back({0, 1 + k, 1 + (k + 1) % 24});
  }
  for (std::size_t turn = 0; turn < fan.triangles.size(); ++turn) {
    std::ranges::rotate(fan.triangles, fan.triangles.begin() + 1);
    const auto above = NearestOnMesh(fan).nearest({0, 0, 2});
    ASSERT_TRUE(above);
    EXPECT_EQ(above->triangle, 0u);
    EXPECT_EQ(above->distance, 2);
  }
  const auto beside = NearestOnMesh(fan).nearest({3, 0.01, -2});
  ASSERT_TRUE(beside);
  EXPECT_LT(beside->triangle, 24u) << "not the copy";
}

TEST(NearestOnMesh, PlacesOfASharedEdgeTieToTheBit) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> at(-1, 1);
  for (int round = 0; round < 200; ++round) {
    // A roof, seen from above its ridge.
    Mesh roof{{{at(random), 0, 0}, {at(random) + 3, 0, at(random)}, {1, 2, -3}, {1, -2, -3}},
              {{0, 1, 2}, {1, 0, 3}}};
    if (round % 2 == 1) std::swap(roof.triangles[0], roof.triangles[1]);
    const auto found = NearestOnMesh(roof).nearest({1.3, 0.05 * at(random), 4});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->triangle, 0u);
  }
}

TEST(NearestOnMesh, TrianglesWithoutAreaHaveTheirEdges) {
  const Mesh line{{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {{0, 1, 2}}};
  const auto on_line = NearestOnMesh(line).nearest({2, 1, 0});
  ASSERT_TRUE(on_line);
  EXPECT_EQ(on_line->distance, 1);
  EXPECT_LT((place(line, *on_line) - Vector3d(2, 0, 0)).norm(), 1e-15);
  const Mesh dot{{{1, 1, 1}, {1, 1, 1}}, {{0, 0, 0}, {0, 1, 0}}};
  const auto on_dot = NearestOnMesh(dot).nearest({1, 1, 3});
  ASSERT_TRUE(on_dot);
  EXPECT_EQ(on_dot->distance, 2);
  EXPECT_EQ(on_dot->triangle, 0u);
  expect_on_triangle(dot, *on_dot, {1, 1, 3});
}

TEST(NearestOnMesh, ManyTrianglesAtOnePlaceAreNoProblem) {
  Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, std::vector<Triangle>(3000, {0, 1, 2})};
  const auto found = NearestOnMesh(mesh).nearest({0.2, 0.2, 1});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->triangle, 0u);
}

TEST(NearestOnMesh, FarPointsFindTheirPlace) {
  const Mesh mesh = make_shape("torus");
  const auto found = NearestOnMesh(mesh).nearest({1e9, 0, 0});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->position.x(), static_cast<double>(bounding_box(mesh).upper.x()), 1e-3);
  EXPECT_NEAR(found->distance, 1e9, 10);
}

TEST(NearestOnMesh, FindsNothingBeyondTheMaximum) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const NearestOnMesh nearest(mesh);
  EXPECT_TRUE(nearest.nearest({0.2, 0.2, 0.7}, 0.7));
  EXPECT_FALSE(nearest.nearest({0.2, 0.2, 0.7}, 0.6999));
  EXPECT_TRUE(nearest.nearest({0, 0, 0}, 0));
  EXPECT_FALSE(nearest.nearest({0, 0, 0}, -1));
  EXPECT_FALSE(nearest.nearest({0, 0, 0}, std::nan("")));
}

TEST(NearestOnMesh, NothingIsNearestToNothing) {
  const Mesh empty;
  EXPECT_FALSE(NearestOnMesh(empty).nearest({0, 0, 0}));
  const Mesh points{{{0, 0, 0}}, {}};
  EXPECT_FALSE(NearestOnMesh(points).nearest({0, 0, 0}));
  const Mesh mesh = make_shape("torus,resolution=8");
  const NearestOnMesh nearest(mesh);
  EXPECT_FALSE(nearest.nearest({std::nan(""), 0, 0}));
  EXPECT_FALSE(nearest.nearest({0, kInfinity, 0}));
  EXPECT_FALSE(nearest.nearest({0, 1e160, 0}));
}

TEST(NearestOnMesh, RefusesWhatIsNoMesh) {
  const Mesh no_vertex{{{0, 0, 0}}, {{0, 1, 2}}};
  EXPECT_THROW(NearestOnMesh{no_vertex}, Error);
  const Mesh not_finite{{{0, 0, 0}, {std::nanf(""), 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_THROW(NearestOnMesh{not_finite}, Error);
  EXPECT_THROW(NearestVertex{not_finite}, Error);
}

TEST(NearestVertex, IsTheNearestOfAll) {
  const Mesh mesh = make_shape("trefoil,resolution=40");
  const NearestVertex nearest(mesh);
  for (const Vector3d& point : points_around(mesh, 50)) {
    const auto found = nearest.nearest(point);
    ASSERT_TRUE(found);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const double distance = (mesh.positions[v].cast<double>() - point).norm();
      EXPECT_TRUE(distance > found->distance ||
                  (distance == found->distance && v >= found->vertex));
    }
  }
}

TEST(NearestVertex, KnowsTiesLimitsAndEmptyMeshes) {
  const Mesh twins{{{1, 0, 0}, {1, 0, 0}, {-1, 0, 0}}, {}};
  const NearestVertex nearest(twins);
  EXPECT_EQ(nearest.nearest({2, 0, 0})->vertex, 0u);
  EXPECT_EQ(nearest.nearest({0, 0, 0})->vertex, 0u);
  EXPECT_FALSE(nearest.nearest({3, 0, 0}, 1.99));
  EXPECT_EQ(nearest.nearest({3, 0, 0}, 2)->distance, 2);
  EXPECT_FALSE(nearest.nearest({std::nan(""), 0, 0}));
  const Mesh empty;
  EXPECT_FALSE(NearestVertex(empty).nearest({0, 0, 0}));
}

}  // namespace
}  // namespace brindle
