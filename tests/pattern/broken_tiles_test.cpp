#include "brindle/broken_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/base/elementary.h"
#include "brindle/error.h"
#include "brindle/geometry/topology.h"
#include "brindle/texture_animator.h"
#include "brindle/texture_pattern.h"
#include "brindle/threads.h"
#include "textures.h"

namespace brindle {
namespace {

using testing_support::singular_field;
using testing_support::texture_along;
using testing_support::waves_of;

constexpr double kClearance = 0.05;

TileMotifs motifs_of(float half_u, float half_v, std::uint8_t symmetries) {
  TileMotifs motifs;
  motifs.extents.fill({Eigen::Vector2f(-half_u, -half_v), Eigen::Vector2f(half_u, half_v)});
  motifs.symmetries = symmetries;
  return motifs;
}

const TileMotifs kDots = motifs_of(0.29f, 0.29f, 0xff);
const TileMotifs kArrows = motifs_of(0.42f, 0.21f, 0x03);

/// A mesh with waves of its triangles' corners.
struct Textured {
  Mesh mesh;
  TextureWaves waves;
};

/// The square from 0 to `side` with n by n squares of two triangles. Coordinates are x and y, and
/// where `branch` says so U grows by one more on the way round it.
Textured plane(int n, float side, const Eigen::Vector2f& offset,
               const std::optional<Eigen::Vector2f>& branch = std::nullopt) {
  Textured plane;
  std::vector<Complex> z_u, z_v;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const Vec3 p =
          Vec3(static_cast<float>(i), static_cast<float>(j), 0) * side / static_cast<float>(n);
      plane.mesh.positions.push_back(p);
      float u = p.x() + offset.x();
      if (branch) u += std::atan2(p.y() - branch->y(), p.x() - branch->x()) / kTwoPi;
      z_u.push_back(std::polar(1.0f, kTwoPi * (u - 0.25f)));
      z_v.push_back(std::polar(1.0f, kTwoPi * (p.y() + offset.y() - 0.25f)));
    }
  }
  const auto id = [n](int i, int j) { return static_cast<Index>(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      plane.mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      plane.mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  const std::size_t count = plane.mesh.positions.size();
  const WaveSet u{plane.mesh.positions, DirectionField(count, Vec3::UnitX()),
                  constant_frequency_field(1, count)};
  const WaveSet v{plane.mesh.positions, DirectionField(count, Vec3::UnitY()),
                  constant_frequency_field(1, count)};
  plane.waves = texture_waves(plane.mesh.triangles, u, z_u, v, z_v);
  return plane;
}

Eigen::Vector2f coordinates_at(const Textured& on, std::size_t t, const Vec3& barycentric) {
  const TextureFragment f = texture_fragment(on.waves.u[t], on.waves.v[t], barycentric);
  return {texture_coordinate(f.u.z), texture_coordinate(f.v.z)};
}

/// Some points of every triangle.
const std::vector<Vec3>& weights() {
  static const std::vector<Vec3> all = {{0.34f, 0.33f, 0.33f}, {0.8f, 0.11f, 0.09f},
                                        {0.1f, 0.79f, 0.11f},  {0.12f, 0.1f, 0.78f},
                                        {0.48f, 0.04f, 0.48f}, {0.03f, 0.49f, 0.48f}};
  return all;
}

/// What `broken` says of all those points.
std::vector<bool> answers(const Textured& on, const BrokenTiles& broken) {
  std::vector<bool> result;
  for (std::size_t t = 0; t < on.mesh.triangle_count(); ++t) {
    for (const Vec3& b : weights()) {
      result.push_back(broken.is_broken(t, b, coordinates_at(on, t, b)));
    }
  }
  return result;
}

BrokenTiles find(const Textured& on, const TileMotifs& motifs) {
  return broken_tiles(on.mesh.triangles, on.waves, motifs);
}

TEST(BrokenTiles, OfAPlaneAreThoseThatReachItsBorder) {
  const Textured square = plane(29, 5, {0.31f, 0.83f});
  const BrokenTiles broken = find(square, kDots);
  int whole = 0, cut = 0;
  for (std::size_t t = 0; t < square.mesh.triangle_count(); ++t) {
    for (const Vec3& b : weights()) {
      Vec3 at = Vec3::Zero();
      for (int m = 0; m < 3; ++m) at += b[m] * square.mesh.positions[square.mesh.triangles[t][m]];
      const float middle_x = std::floor(at.x() + 0.31f) + 0.5f - 0.31f;
      const float middle_y = std::floor(at.y() + 0.83f) + 0.5f - 0.83f;
      if (std::max(std::abs(at.x() - middle_x), std::abs(at.y() - middle_y)) > 0.29f) continue;
      const auto reaches = [](float middle) { return middle < 0.34f || middle > 5 - 0.34f; };
      const bool expected = reaches(middle_x) || reaches(middle_y);
      ASSERT_EQ(broken.is_broken(t, b, coordinates_at(square, t, b)), expected)
          << at.x() << ' ' << at.y();
      ++(expected ? cut : whole);
    }
  }
  EXPECT_GT(whole, 1000);
  EXPECT_GT(cut, 300);
}

TEST(BrokenTiles, WithoutBorderSeamAndBranchThereAreNone) {
  // Sides that are opposite are one: a torus.
  constexpr Index kSide = 20;
  Textured torus = plane(kSide, 4, {0.3f, 0.1f});
  for (Triangle& triangle : torus.mesh.triangles) {
    for (Index& v : triangle) {
      const Index i = v % (kSide + 1) % kSide, j = v / (kSide + 1) % kSide;
      v = j * (kSide + 1) + i;
    }
  }
  EXPECT_TRUE(find(torus, kDots).words.empty());
  EXPECT_TRUE(find(torus, motifs_of(0.5f, 0.5f, 1)).words.empty());
}

// ---- An oracle: all pieces of motifs in triangles, and which of them are one.

using Point = Eigen::Vector2d;
using Polygon = std::vector<Point>;

Polygon clipped(Polygon polygon, int axis, double bound, double sign) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = sign * (a[axis] - bound), at_b = sign * (b[axis] - bound);
    if (at_a <= 0) result.push_back(a);
    if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) {
      result.push_back(a + at_a / (at_a - at_b) * (b - a));
    }
  }
  return result;
}

Polygon within(Polygon polygon, const Point& middle, const Point& half) {
  for (int axis = 0; axis < 2; ++axis) {
    polygon = clipped(polygon, axis, middle[axis] + half[axis], 1);
    polygon = clipped(polygon, axis, middle[axis] - half[axis], -1);
  }
  return polygon;
}

double area_within(const std::array<Point, 3>& triangle, const Point& middle, const Point& half) {
  const Polygon polygon = within(Polygon(triangle.begin(), triangle.end()), middle, half);
  double area = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Point a = polygon[i] - polygon[0], b = polygon[i + 1] - polygon[0];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  return std::abs(area);
}

Point turned(Point p, unsigned turn) {
  if (turn & kSwapsUV) std::swap(p.x(), p.y());
  if (turn & kTurnsU) p.x() = -p.x();
  if (turn & kTurnsV) p.y() = -p.y();
  return p;
}

/// Of one motif a tile, symmetric about its middle.
class Oracle {
 public:
  Oracle(const Textured& on, const TileMotifs& motifs)
      : on_(on), motifs_(motifs), half_(motifs.extents[0].max().cast<double>()) {
    const auto u = corner_phases(on.waves.u, PhaseShiftKind::aligned);
    const auto v = corner_phases(on.waves.v, PhaseShiftKind::aligned);
    for (std::size_t t = 0; t < u.size(); ++t) {
      closed_.push_back(u[t].kind == TriangleKind::regular && v[t].kind == TriangleKind::regular);
      std::array<Point, 3> places;
      for (int m = 0; m < 3; ++m) {
        places[m] =
            Point(u[t].phase[m], v[t].phase[m]) / (2 * std::numbers::pi) + Point(0.25, 0.25);
      }
      places_.push_back(places);
      if (closed_[t]) add_pieces(t);
    }
    set_.resize(areas_.size());
    std::iota(set_.begin(), set_.end(), 0U);
    for (const SharedEdge& edge : shared_edges(on.mesh.triangles)) join(edge);
    for (std::size_t i = 0; i < set_.size(); ++i) {
      area_[root(i)] += areas_[i];
      clear_area_[root(i)] += clear_areas_[i];
    }
  }

  /// Calls `visit(share, clear share, triangle, middle)` for every piece: how much of its motif,
  /// and of what has to be clear around it, there is in all triangles.
  template <class Visit>
  void for_each_piece(const Visit& visit) {
    for (const auto& [piece, i] : pieces_) {
      const auto& [t, u, v] = piece;
      const Point clear = clear_half();
      visit(area_[root(i)] / (4 * half_.x() * half_.y()),
            clear_area_[root(i)] / (4 * clear.x() * clear.y()), t, Point(0.5 + u, 0.5 + v),
            areas_[i]);
    }
  }

  const std::array<Point, 3>& places(std::size_t t) const { return places_[t]; }

 private:
  Point clear_half() const {
    const auto clear = [](double half) {
      return std::max(half + 0.03, std::min(half + kClearance, 0.5));
    };
    return {clear(half_.x()), clear(half_.y())};
  }

  void add_pieces(std::size_t t) {
    const auto& p = places_[t];
    const Point reach = half_.array() + kClearance;
    const auto range = [&](int axis) {
      const auto [least, most] = std::minmax({p[0][axis], p[1][axis], p[2][axis]});
      return std::pair(static_cast<int>(std::floor(least - 1)), static_cast<int>(std::ceil(most)));
    };
    const auto [u0, u1] = range(0);
    const auto [v0, v1] = range(1);
    for (int i = u0; i <= u1; ++i) {
      for (int j = v0; j <= v1; ++j) {
        const Point middle(i + 0.5, j + 0.5);
        if (area_within(p, middle, reach) < 1e-12) continue;
        pieces_[{t, i, j}] = areas_.size();
        areas_.push_back(area_within(p, middle, half_));
        clear_areas_.push_back(area_within(p, middle, clear_half()));
      }
    }
  }

  const Point& place(Index corner) const { return places_[corner / 3][corner % 3]; }

  void join(const SharedEdge& edge) {
    const std::size_t a = edge.from[0] / 3, b = edge.from[1] / 3;
    if (!closed_[a] || !closed_[b]) return;
    for (unsigned turn = 0; turn < 8; ++turn) {
      // All meshes here are wound alike and run along their waves: nothing is mirrored.
      if (turn != 0 && turn != (kTurnsU | kTurnsV)) continue;
      if ((motifs_.symmetries >> turn & 1) == 0) continue;
      const Point away = place(edge.from[1]) - turned(place(edge.from[0]), turn);
      const Point away_to = place(edge.to[1]) - turned(place(edge.to[0]), turn);
      const Point whole(std::round(away.x()), std::round(away.y()));
      if ((away - whole).cwiseAbs().maxCoeff() > 1e-4) continue;
      if ((away_to - whole).cwiseAbs().maxCoeff() > 1e-4) continue;
      join(edge, turn, whole);
      return;
    }
  }

  void join(const SharedEdge& edge, unsigned turn, const Point& whole) {
    const std::size_t a = edge.from[0] / 3, b = edge.from[1] / 3;
    const Polygon segment = {place(edge.from[0]), place(edge.to[0])};
    const Point reach = half_.array() + kClearance;
    constexpr int kFirst = std::numeric_limits<int>::min();
    for (auto at = pieces_.lower_bound({a, kFirst, kFirst});
         at != pieces_.end() && std::get<0>(at->first) == a; ++at) {
      const auto& [t, u, v] = at->first;
      if (within(segment, Point(u + 0.5, v + 0.5), reach).empty()) continue;
      const Point there = turned(Point(u + 0.5, v + 0.5), turn) + whole;
      const auto found = pieces_.find(
          {b, static_cast<int>(std::floor(there.x())), static_cast<int>(std::floor(there.y()))});
      if (found != pieces_.end()) set_[root(at->second)] = root(found->second);
    }
  }

  std::size_t root(std::size_t i) const {
    while (set_[i] != i) i = set_[i];
    return i;
  }

  const Textured& on_;
  const TileMotifs& motifs_;
  Point half_;
  std::vector<bool> closed_;
  std::vector<std::array<Point, 3>> places_;
  std::map<std::tuple<std::size_t, int, int>, std::size_t> pieces_;
  std::vector<double> areas_, clear_areas_;
  std::vector<std::size_t> set_;
  std::map<std::size_t, double> area_, clear_area_;
};

std::optional<Vec3> barycentric_at(const std::array<Point, 3>& p, const Point& at) {
  const auto area = [](const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); };
  const double whole = area(p[1] - p[0], p[2] - p[0]);
  const double b = area(at - p[0], p[2] - p[0]) / whole;
  const double c = area(p[1] - p[0], at - p[0]) / whole;
  if (!(b > 1e-3 && c > 1e-3 && 1 - b - c > 1e-3)) return std::nullopt;
  return Vec3(static_cast<float>(1 - b - c), static_cast<float>(b), static_cast<float>(c));
}

/// What is kept is whole, and nothing is left out without a reason. Returns how many pieces of
/// motifs were kept and left out.
std::array<int, 2> check_with_oracle(const Textured& on, const TileMotifs& motifs) {
  const BrokenTiles broken = find(on, motifs);
  Oracle oracle(on, motifs);
  std::array<int, 2> seen{};
  oracle.for_each_piece(
      [&](double share, double clear_share, std::size_t t, const Point& middle, double area) {
        if (area < 1e-4) return;
        // A point of the piece: the middle, or what of the triangle's middle is nearest to it.
        const auto& p = oracle.places(t);
        const Point centre = (p[0] + p[1] + p[2]) / 3;
        const Point half = motifs.extents[0].max().cast<double>();
        const Point at = centre.cwiseMax(middle - 0.98 * half).cwiseMin(middle + 0.98 * half);
        const auto b = barycentric_at(p, at);
        if (!b) return;
        const bool is = broken.is_broken(t, *b, at.cast<float>());
        ++seen[is];
        if (is) {
          // Round a branch there is nearly all of it twice.
          EXPECT_GT(std::abs(clear_share - 1), 1e-7) << t << ' ' << middle.transpose();
        } else {
          EXPECT_NEAR(share, 1, 1e-3) << t << ' ' << middle.transpose();
        }
      });
  return seen;
}

TEST(BrokenTiles, AtABranchOfAPlaneAreThoseThatItTouches) {
  const Eigen::Vector2f branch(3.137f, 2.912f);
  const Textured torn = plane(41, 6, {0.31f, 0.83f}, branch);
  const Textured whole = plane(41, 6, {0.31f, 0.83f});
  const auto branches = corner_phases(torn.waves.u, PhaseShiftKind::aligned);
  EXPECT_EQ(std::ranges::count(branches, TriangleKind::branch, &CornerPhases::kind), 1);
  for (const TileMotifs& motifs : {kDots, kArrows}) {
    const auto [kept, left_out] = check_with_oracle(torn, motifs);
    check_with_oracle(whole, motifs);
    EXPECT_GT(kept, 1000);
    EXPECT_GT(left_out, 100);
  }
  // The branch is a motif's, or is between motifs; no other is touched.
  const BrokenTiles broken = find(torn, kDots), of_whole = find(whole, kDots);
  int touched = 0;
  for (std::size_t t = 0; t < torn.mesh.triangle_count(); ++t) {
    const Vec3& p = torn.mesh.positions[torn.mesh.triangles[t][0]];
    const float away = (p.head<2>() - branch).norm();
    const bool inner = (p.head<2>().array() > 1.2f).all() && (p.head<2>().array() < 4.8f).all();
    touched += inner && broken.touches(t);
    if (inner) {
      EXPECT_FALSE(of_whole.touches(t)) << p.transpose();
    }
    if (inner && away > 1.6f) {
      EXPECT_FALSE(broken.touches(t)) << p.transpose();
    }
    if (branches[t].kind == TriangleKind::branch) {
      EXPECT_EQ(broken.words[t], 1U);
    }
  }
  EXPECT_GT(touched, 20);
}

TEST(BrokenTiles, OfTexturesOnSurfacesAreThoseThatAreNotWhole) {
  for (const char* shape :
       {"torus,resolution=50", "sphere,resolution=20", "trefoil,resolution=30"}) {
    SCOPED_TRACE(shape);
    const Surface surface = make_surface(make_shape(shape));
    const TexturePattern pattern = texture_along(surface, Vec3(0.3f, 0.9f, 0.2f), 12);
    const Textured textured{surface.mesh, pattern.waves};
    for (const TileMotifs& motifs : {kDots, kArrows}) {
      const auto [kept, left_out] = check_with_oracle(textured, motifs);
      EXPECT_GT(kept, 1000);
      EXPECT_GT(left_out, 20);
    }
  }
}

TEST(BrokenTiles, ASeamBreaksWhatHasNoSymmetry) {
  const Surface square = make_surface(plane(40, 2, {0, 0}).mesh);
  Mesh centred = square.mesh;
  for (Vec3& p : centred.positions) p -= Vec3(1, 1, 0);
  const Surface surface = make_surface(centred);
  const TexturePattern pattern =
      texture_pattern(surface, waves_of(surface, singular_field(surface.mesh, 0.5f), 16));
  ASSERT_GT(pattern.seams.turned, 10U);
  const Textured textured{surface.mesh, pattern.waves};
  const auto count = [&](const TileMotifs& motifs) {
    const std::vector<bool> all = answers(textured, find(textured, motifs));
    return std::ranges::count(all, true);
  };
  const TileMotifs as_large = motifs_of(0.29f, 0.29f, 0x03);
  EXPECT_GT(count(as_large), count(kDots));
  // Shifted tiles do not fit beyond a seam, but for half tiles.
  TileMotifs shifted = kDots;
  shifted.shift = {0.3f, 0};
  TileMotifs by_halves = kDots;
  by_halves.shift = {0.5f, 0.5f};
  EXPECT_GT(count(shifted), count(by_halves));
}

Textured sphere_texture() {
  const Surface surface = make_surface(make_shape("sphere,resolution=24"));
  return {surface.mesh, texture_along(surface, Vec3(0.3f, 0.9f, 0.2f), 14).waves};
}

TEST(BrokenTiles, DoNotDependOnWhichWayTrianglesRun) {
  const Textured sphere = sphere_texture();
  Textured flipped_some = sphere;
  std::mt19937 random(7);
  for (std::size_t t = 0; t < sphere.mesh.triangle_count(); ++t) {
    if (random() % 2 == 0) continue;
    for (CornerWave& corner : flipped_some.waves.u[t]) corner = flipped(corner);
    for (CornerWave& corner : flipped_some.waves.v[t]) corner = flipped(corner);
  }
  const std::vector<bool> expected = answers(sphere, find(sphere, kDots));
  EXPECT_EQ(answers(flipped_some, find(flipped_some, kDots)), expected);
  EXPECT_GT(std::ranges::count(expected, true), 100);
  EXPECT_GT(std::ranges::count(expected, false), 1000);
}

TEST(BrokenTiles, DoNotDependOnTheOrderOfTrianglesAndCorners) {
  const Textured sphere = sphere_texture();
  for (const TileMotifs& motifs : {kDots, kArrows}) {
    const BrokenTiles expected = find(sphere, motifs);
    std::vector<std::size_t> order(sphere.mesh.triangle_count());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::shuffle(order, std::mt19937(3));
    Textured other{sphere.mesh, sphere.waves};
    for (std::size_t i = 0; i < order.size(); ++i) {
      const std::size_t t = order[i];
      for (int m = 0; m < 3; ++m) {
        const int from = (m + static_cast<int>(i)) % 3;
        other.mesh.triangles[i][m] = sphere.mesh.triangles[t][from];
        other.waves.u[i][m] = sphere.waves.u[t][from];
        other.waves.v[i][m] = sphere.waves.v[t][from];
      }
    }
    const BrokenTiles found = find(other, motifs);
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (const Vec3& b : weights()) {
        Vec3 turned_weights;
        for (int m = 0; m < 3; ++m) turned_weights[(m + static_cast<int>(i)) % 3] = b[m];
        const auto uv = coordinates_at(sphere, order[i], turned_weights);
        ASSERT_EQ(found.is_broken(i, b, uv), expected.is_broken(order[i], turned_weights, uv));
      }
    }
  }
}

TEST(BrokenTiles, AreTheSameForAnyNumberOfThreads) {
  const Textured sphere = sphere_texture();
  const ThreadLimit one(1);
  const BrokenTiles expected = find(sphere, kArrows);
  const ThreadLimit four(4);
  EXPECT_EQ(find(sphere, kArrows).words, expected.words);
}

TEST(BrokenTiles, SignsInCornersAreMotifsOfTheirOwn) {
  const Textured square = plane(40, 4, {0.25f, 0.25f});
  TileMotifs signs = motifs_of(0.1f, 0.1f, 0xff);
  signs.layout = TileLayout::middle_and_corner;
  const BrokenTiles broken = find(square, signs);
  // At x = 0.25 and y = 0.25 are middles of whole motifs; at x = -0.25 there would be corners.
  for (std::size_t t = 0; t < square.mesh.triangle_count(); ++t) {
    Vec3 at = Vec3::Zero();
    for (const Index v : square.mesh.triangles[t]) at += square.mesh.positions[v] / 3;
    const Eigen::Vector2f uv = coordinates_at(square, t, Vec3::Constant(1 / 3.0f));
    const auto near = [&](float x, float y) {
      return std::max(std::abs(at.x() - x), std::abs(at.y() - y)) < 0.09f;
    };
    if (near(0.25f, 0.25f) || near(0.75f, 0.75f) || near(2.25f, 1.25f) || near(3.75f, 2.75f)) {
      EXPECT_FALSE(broken.is_broken(t, Vec3::Constant(1 / 3.0f), uv)) << at.transpose();
    }
  }
}

TEST(BrokenTiles, OfBricksAreSplitWhereJointsEnd) {
  TileMotifs bricks = motifs_of(0.5f, 0.25f, 0x0f);
  bricks.layout = TileLayout::courses;
  bricks.split = true;
  EXPECT_TRUE(find(plane(20, 4, {0.3f, 0.1f}), bricks).words.empty());
  const Eigen::Vector2f branch(2.03f, 1.96f);
  const Textured torn = plane(40, 4, {0.3f, 0.1f}, branch);
  const BrokenTiles broken = find(torn, bricks);
  // All round the branch, as far as its course reaches: V + 0.1 is 2.06, in that of 2.
  int split = 0, course = 0;
  for (std::size_t t = 0; t < torn.mesh.triangle_count(); ++t) {
    Vec3 at = Vec3::Zero();
    for (const Index v : torn.mesh.triangles[t]) at += torn.mesh.positions[v] / 3;
    const bool is = broken.is_broken(t, Vec3::Constant(1 / 3.0f),
                                     coordinates_at(torn, t, Vec3::Constant(1 / 3.0f)));
    split += is;
    const bool in_course = std::abs(at.y() + 0.1f - 2) < 0.25f;
    course += in_course;
    const float away = std::abs(at.x() - branch.x());
    if (is && broken.words[t] != 1) {
      EXPECT_TRUE(in_course && away < 1.1f) << at.transpose();
    }
    if (in_course && away < 0.2f) {
      EXPECT_TRUE(is) << at.transpose();
    }
  }
  EXPECT_GT(split, 20);
  EXPECT_LT(split, course / 2);
}

TEST(BrokenTiles, AnimatorsFindThoseOfTheirTextures) {
  const Surface surface = make_surface(make_shape("torus,resolution=60"));
  const WaveSet waves =
      waves_of(surface, projected_direction_field(Vec3(0.3f, 0.9f, 0.2f), surface.normals), 14);
  TextureAnimatorOptions options;
  options.whole_tiles = kArrows;
  TextureAnimator animator(surface, options);
  for (int i = 0; i < 3; ++i) {
    const auto turned_directions =
        rotated(waves.directions, surface.normals, 0.05f * static_cast<float>(i));
    const TextureFrameResult frame =
        animator.frame({{waves.positions, turned_directions, waves.frequencies, {}}, {}, {}});
    ASSERT_NE(frame.broken, nullptr);
    const Textured textured{surface.mesh, frame.pattern.waves};
    EXPECT_EQ(answers(textured, *frame.broken), answers(textured, find(textured, kArrows)));
  }
  EXPECT_EQ(TextureAnimator(surface)
                .frame({{waves.positions, waves.directions, waves.frequencies, {}}, {}, {}})
                .broken,
            nullptr);
}

TEST(BrokenTiles, RefuseWhatDoesNotFit) {
  const Textured square = plane(4, 4, {0, 0});
  EXPECT_THROW(broken_tiles(square.mesh.triangles, TextureWaves(), kDots), Error);
  EXPECT_THROW(find(square, motifs_of(0.6f, 0.2f, 1)), Error);
  TileMotifs shifted = kDots;
  shifted.shift.x() = std::nanf("");
  EXPECT_THROW(find(square, shifted), Error);
}

TEST(BrokenTiles, FramesLookAfterTheMotifsThatAreAskedForLast) {
  const Surface surface = make_surface(make_shape("torus,resolution=60"));
  const WaveSet waves =
      waves_of(surface, projected_direction_field(Vec3(0.3f, 0.9f, 0.2f), surface.normals), 14);
  const TextureFrameInput input{{waves.positions, waves.directions, waves.frequencies, {}}, {}, {}};
  TextureAnimator animator(surface);
  EXPECT_EQ(animator.frame(input).broken, nullptr);
  TileMotifs shifted = kArrows;
  shifted.shift = {0.3f, 0.1f};
  for (const TileMotifs& motifs : {kArrows, shifted}) {
    animator.set_whole_tiles(motifs);
    const TextureFrameResult frame = animator.frame(input);
    ASSERT_NE(frame.broken, nullptr);
    EXPECT_FALSE(frame.broken->words.empty());
    const Textured textured{surface.mesh, frame.pattern.waves};
    EXPECT_EQ(answers(textured, *frame.broken), answers(textured, find(textured, motifs)));
  }
  TileMotifs too_large = kArrows;
  too_large.extents[0].max().x() = 0.6f;
  EXPECT_THROW(animator.set_whole_tiles(too_large), Error);
  EXPECT_NE(animator.frame(input).broken, nullptr);
  animator.set_whole_tiles(std::nullopt);
  EXPECT_EQ(animator.frame(input).broken, nullptr);
}

}  // namespace
}  // namespace brindle
