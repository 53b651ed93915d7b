#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/base/random.h"
#include "brindle/mesh.h"

namespace brindle {
namespace {

std::vector<Triangle> cut(const std::vector<Vec3>& corners) {
  std::vector<Index> numbers(corners.size());
  std::iota(numbers.begin(), numbers.end(), 0u);
  std::vector<Triangle> triangles;
  triangulate_polygon(corners, numbers, triangles);
  return triangles;
}

/// The z components of all triangles' areas, which must not cancel.
std::pair<float, float> signed_and_total_area(const std::vector<Vec3>& p) {
  float sum = 0, total = 0;
  for (const auto& [a, b, c] : cut(p)) {
    const float area = 0.5f * (p[b] - p[a]).cross(p[c] - p[a])[2];
    sum += area;
    total += std::abs(area);
  }
  return {sum, total};
}

TEST(Polygon, WithTooFewCornersIsNothing) { EXPECT_TRUE(cut({{0, 0, 0}, {1, 0, 0}}).empty()); }

TEST(Polygon, ConvexQuadrangleIsCutAlongItsShorterDiagonal) {
  EXPECT_EQ(cut({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 1, 0}}),
            (std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}}));
}

TEST(Polygon, ConcaveQuadrangleIsCutInside) {
  for (int shift = 0; shift < 4; ++shift) {
    std::vector<Vec3> arrow = {{0, 0, 0}, {2, -1, 0}, {0.5f, 0, 0}, {2, 1, 0}};
    std::rotate(arrow.begin(), arrow.begin() + shift, arrow.end());
    const auto [sum, total] = signed_and_total_area(arrow);
    EXPECT_FLOAT_EQ(std::abs(sum), total);
  }
}

TEST(Polygon, StarIsCutInside) {
  for (const float direction : {1.f, -1.f}) {
    std::vector<Vec3> star;
    for (int i = 0; i < 14; ++i) {
      const float r = i % 2 ? 0.3f : 1.0f, angle = direction * static_cast<float>(i) * 0.448799f;
      star.push_back({r * std::cos(angle), r * std::sin(angle), 0});
    }
    EXPECT_EQ(cut(star).size(), 12u);
    const auto [sum, total] = signed_and_total_area(star);
    EXPECT_NEAR(std::abs(sum), total, 1e-5f);
    EXPECT_GT(sum * direction, 0) << "triangles are wound as the polygon is";
  }
}

TEST(Polygon, BadCoordinatesEndInSomeTriangles) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(cut(std::vector<Vec3>(9, Vec3::Constant(nan))).size(), 7u);
  EXPECT_EQ(cut(std::vector<Vec3>(9, Vec3::Zero())).size(), 7u);
  EXPECT_EQ(cut(std::vector<Vec3>(5000, Vec3::Zero())).size(), 4998u);
}

/// Whether the triangles of a polygon in the plane z = 0 cover `area`, and nothing twice.
void expect_cut(const std::vector<Vec3>& positions, const std::vector<Index>& corners, double area,
                const char* what) {
  std::vector<Triangle> triangles;
  EXPECT_TRUE(triangulate_polygon(positions, corners, triangles)) << what;
  EXPECT_EQ(triangles.size(), corners.size() - 2) << what;
  double covered = 0;
  for (const auto& [a, b, c] : triangles) {
    const Eigen::Vector3d ab = (positions[b] - positions[a]).cast<double>();
    const Eigen::Vector3d ac = (positions[c] - positions[a]).cast<double>();
    covered += 0.5 * ab.cross(ac).norm();
  }
  EXPECT_NEAR(covered, area, 1e-5 * area) << what;
}

TEST(Polygon, WindowIsLeftOpenWhereABridgeLeadsToIt) {
  const std::vector<Vec3> positions = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},
                                       {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}};
  expect_cut(positions, {0, 1, 2, 3, 0, 4, 5, 6, 7, 4}, 12, "window");
  // The bridge's corners are vertices of their own.
  std::vector<Vec3> apart = positions;
  apart.push_back(positions[0]);
  apart.push_back(positions[4]);
  expect_cut(apart, {0, 1, 2, 3, 8, 4, 5, 6, 7, 9}, 12, "window with repeated vertices");
}

TEST(Polygon, RingOfManyCornersIsLeftOpen) {
  for (const std::size_t sides : {12u, 700u}) {
    std::vector<Vec3> positions;
    std::vector<Index> corners;
    for (const float radius : {2.f, 1.f}) {
      for (std::size_t i = 0; i <= sides; ++i) {
        const auto place =
            static_cast<Index>(radius == 2.f ? i % sides : sides + (sides - i) % sides);
        corners.push_back(place);
      }
      for (std::size_t i = 0; i < sides; ++i) {
        const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(sides);
        positions.push_back({radius * static_cast<float>(std::cos(angle)),
                             radius * static_cast<float>(std::sin(angle)), 0});
      }
    }
    const double angle = 2 * M_PI / static_cast<double>(sides);
    expect_cut(positions, corners, 1.5 * static_cast<double>(sides) * std::sin(angle), "ring");
  }
}

/// A polygon that touches itself: the border of triangles of a grid that are glued along a tree of
/// edges. All other edges between them are run along twice.
struct GluedPolygon {
  std::vector<Vec3> positions;
  std::vector<Index> corners;
  double area = 0;

  GluedPolygon(Index width, double jitter, std::uint64_t seed) {
    const auto random = [&] { return random_number(seed, drawn_++); };
    for (Index y = 0; y <= width; ++y) {
      for (Index x = 0; x <= width; ++x) {
        const double u = x + jitter * (random() - 0.5), v = y + jitter * (random() - 0.5);
        positions.push_back(Vec3(static_cast<float>(u), static_cast<float>(v), 0));
      }
    }
    for (Index y = 0; y < width; ++y) {
      for (Index x = 0; x < width; ++x) {
        const Index a = y * (width + 1) + x, b = a + 1, d = a + width + 1, c = d + 1;
        const bool other = random() < 0.5;
        triangles_.push_back(other ? Triangle{a, b, d} : Triangle{a, b, c});
        triangles_.push_back(other ? Triangle{b, c, d} : Triangle{a, c, d});
      }
    }
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) sides_[edge(t, k)] = {t, k};
    }
    glue(random);
    run_along_border();
  }

 private:
  using Edge = std::pair<Index, Index>;

  Edge edge(std::size_t t, std::size_t k) const {
    return {triangles_[t][k], triangles_[t][(k + 1) % 3]};
  }

  template <class Random>
  void glue(const Random& random) {
    const auto share =
        static_cast<std::size_t>((0.3 + 0.7 * random()) * static_cast<double>(triangles_.size()));
    std::set<std::size_t> taken;
    std::vector<Edge> open;
    const auto take = [&](std::size_t t) {
      taken.insert(t);
      for (std::size_t k = 0; k < 3; ++k) open.push_back(edge(t, k));
      const Vec3 ab = positions[triangles_[t][1]] - positions[triangles_[t][0]];
      const Vec3 ac = positions[triangles_[t][2]] - positions[triangles_[t][0]];
      area += 0.5 * static_cast<double>(ab.cross(ac)[2]);
    };
    take(static_cast<std::size_t>(random() * static_cast<double>(triangles_.size())));
    while (taken.size() < std::max<std::size_t>(3, share) && !open.empty()) {
      std::swap(open[static_cast<std::size_t>(random() * static_cast<double>(open.size()))],
                open.back());
      const auto [a, b] = open.back();
      open.pop_back();
      const auto other = sides_.find({b, a});
      if (other == sides_.end() || taken.contains(other->second.first)) continue;
      glued_.insert({a, b});
      glued_.insert({b, a});
      take(other->second.first);
    }
    for (const std::size_t t : taken) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (!glued_.contains(edge(t, k))) first_ = {t, k};
      }
    }
  }

  void run_along_border() {
    auto [t, k] = first_;
    do {
      corners.push_back(triangles_[t][k]);
      k = (k + 1) % 3;
      while (glued_.contains(edge(t, k))) {
        const auto [a, b] = edge(t, k);
        std::tie(t, k) = sides_.at({b, a});
        k = (k + 1) % 3;
      }
    } while (std::pair(t, k) != first_);
  }

  std::uint64_t drawn_ = 0;
  std::vector<Triangle> triangles_;
  std::map<Edge, std::pair<std::size_t, std::size_t>> sides_;  ///< triangle and its side
  std::set<Edge> glued_;
  std::pair<std::size_t, std::size_t> first_;
};

TEST(Polygon, ThatTouchesItselfIsCoveredOnce) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    for (const double jitter : {0.0, 0.4}) {
      GluedPolygon polygon(static_cast<Index>(2 + seed % 8), jitter, seed);
      expect_cut(polygon.positions, polygon.corners, polygon.area,
                 ("seed " + std::to_string(seed)).c_str());
      const Eigen::Quaternionf turn = Eigen::Quaternionf(0.3f, 0.5f, -0.2f, 0.7f).normalized();
      for (Vec3& position : polygon.positions) position = turn * position + Vec3(3, 1, 2);
      expect_cut(polygon.positions, polygon.corners, polygon.area,
                 ("turned, seed " + std::to_string(seed)).c_str());
    }
  }
  const GluedPolygon large(60, 0.4, 7);
  ASSERT_GT(large.corners.size(), 1000u);
  expect_cut(large.positions, large.corners, large.area, "large");
}

TEST(Polygon, LargeConcaveOneIsCutInside) {
  std::vector<Vec3> gear;
  const std::size_t corners = 5000;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / corners;
    const double radius = i % 4 < 2 ? 1 : 0.9;
    gear.push_back({static_cast<float>(radius * std::cos(angle)),
                    static_cast<float>(radius * std::sin(angle)), 0});
  }
  const auto [sum, total] = signed_and_total_area(gear);
  EXPECT_NEAR(sum, total, 1e-4f);
}

TEST(Polygon, SpikesAndContactsDoNoHarm) {
  // A spike outwards with a bend, one inwards, a corner on an edge, and one that is there twice.
  expect_cut({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {3, 2, 0}, {3, 3, 0}, {0, 2, 0}},
             {0, 1, 2, 3, 4, 3, 2, 5}, 4, "bent spike outwards");
  expect_cut({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}, {1, .5f, 0}, {0, 2, 0}},
             {0, 1, 2, 3, 4, 3, 2, 5}, 4, "bent spike inwards");
  expect_cut({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 4, 0}, {2, 0, 0}, {1, 4, 0}, {0, 4, 0}},
             {0, 1, 2, 3, 4, 5, 6}, 12, "corner on an edge");
  expect_cut({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {0, 1, 1, 2, 2, 3}, 4, "repeated");
  // The last corner comes back along the edge before.
  expect_cut({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 0}}, {0, 1, 2, 3}, 1, "quadrangle");
}

TEST(Polygon, ThatCrossesItselfIsTold) {
  std::vector<Triangle> triangles;
  const std::vector<Vec3> positions = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 2, 0}, {3, 3, 0}};
  EXPECT_FALSE(triangulate_polygon(positions, std::vector<Index>{0, 1, 2, 3}, triangles));
  EXPECT_EQ(triangles.size(), 2u);
  EXPECT_TRUE(triangulate_polygon(positions, std::vector<Index>{0, 1, 3, 2}, triangles));
  // Corners need not lie in a plane.
  EXPECT_TRUE(triangulate_polygon(std::vector<Vec3>{{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}},
                                  std::vector<Index>{0, 1, 2, 3}, triangles));
  CrossedPolygons crossed;
  EXPECT_EQ(describe(crossed), "");
  crossed.add(7);
  crossed.add(9);
  EXPECT_EQ(describe(crossed).find("2 polygons cross themselves"), 0u);
  EXPECT_NE(describe(crossed).find("number 7,"), std::string::npos);
}

}  // namespace
}  // namespace brindle
