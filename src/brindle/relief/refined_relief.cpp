#include "brindle/relief/refined_relief.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <Eigen/Dense>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/topology.h"
#include "brindle/pattern/motif_centre.h"

namespace brindle {
namespace {

using Corners = std::array<Vec3, 3>;  // barycentric coordinates

constexpr std::size_t kMostReliefTriangles = 30'000'000;
constexpr float kLongestMitre = 3;
constexpr float kNearestToEnd = 0.3f;  // share of an edge: shorter pieces make slivers
constexpr float kUnsplit = -1;
constexpr float kOutline = 0.5f;

Eigen::Vector2f uv_at(const ReliefBase& base, Index t, const Vec3& place) {
  const auto& uv = base.uv[t];
  return place[0] * uv[0] + place[1] * uv[1] + place[2] * uv[2];
}

Vec3 mixed(const Corners& corners, const Vec3& place) {
  return place[0] * corners[0] + place[1] * corners[1] + place[2] * corners[2];
}

/// Heights on the base.
class BaseHeights {
 public:
  BaseHeights(const ReliefBase& base, const ReliefTexture& texture)
      : base_(base), texture_(texture) {}

  float at(Index t, const Vec3& place) const {
    if (base_.textured[t] == 0) return 0;
    const Eigen::Vector2f uv = uv_at(base_, t, place);
    const float height = std::clamp(texture_.height(uv.x(), uv.y()), 0.0f, 1.0f);
    const BrokenTiles* broken = texture_.broken;
    if (broken == nullptr || !broken->touches(base_.original[t])) return height;
    const Vec3 there = mixed(base_.in_original[t], place);
    if (!broken->is_broken(base_.original[t], there, uv)) return height;
    if (!broken->split) return 0;
    // A joint splits a broken brick along its middle.
    const Eigen::Vector2f own = uv - broken->shift;
    const float beside = std::abs(own.x() - place_of(motif_at(broken->layout, own)).x());
    return std::min(height, std::clamp((beside - kHalfJoint) / kFlank, 0.0f, 1.0f));
  }

  Vec3 normal(Index t, const Vec3& place) const {
    return mixed(base_.normals[t], place).normalized();
  }

  /// The distance between two places, in details of the texture.
  float details(Index t, const Vec3& from, const Vec3& to) const {
    if (base_.textured[t] == 0) return 0;
    return (uv_at(base_, t, to) - uv_at(base_, t, from)).norm() / texture_.detail;
  }

 private:
  const ReliefBase& base_;
  const ReliefTexture& texture_;
};

/// The shortest vector that has the product 1 with all of some unit normals, in the sense of least
/// squares: faces displaced by their normals meet there.
Vec3 mitre(const std::vector<Vec3>& normals) {
  Vec3 sum = Vec3::Zero();
  Eigen::Matrix3d products = 1e-4 * Eigen::Matrix3d::Identity();
  bool differ = false;
  for (const Vec3& n : normals) {
    sum += n;
    products += (n * n.transpose()).cast<double>();
    differ = differ || n.dot(normals.front()) < 0.9999f;
  }
  if (!differ) return normals.front();
  const Vec3 way = products.ldlt().solve(sum.cast<double>()).cast<float>();
  const float length = way.norm();
  return length > kLongestMitre ? Vec3(way * (kLongestMitre / length)) : way;
}

/// Splits edges of a mesh of half-edges. An edge keeps its number; half-edge m of triangle t runs
/// from corner m to the next.
class Refinement {
 public:
  Refinement(const ReliefBase& base, const ReliefTexture& texture, const RefinementLimits& limits)
      : base_(base),
        heights_(base, texture),
        limits_(limits),
        has_plain_(ranges::find(base.textured, std::uint8_t{0}) != base.textured.end()) {
    add_base();
  }

  RefinedRelief run(const Progress& progress) {
    std::vector<Index> edges(edges_.size()), triangles(relief_.triangles.size());
    for (Index e = 0; e < edges.size(); ++e) edges[e] = e;
    for (Index t = 0; t < triangles.size(); ++t) triangles[t] = t;
    fresh_ = {std::move(edges), std::move(triangles)};
    for (int round = 1; !fresh_.edges.empty() || !fresh_.triangles.empty(); ++round) {
      progress.report(1 - 1 / (1 + 0.2 * round));
      if (!split_long_edges(progress)) split_in_triangles(progress);
    }
    if (limits_.outline) split_at_outline(progress);
    return std::move(relief_);
  }

 private:
  using Edge = std::array<Index, 2>;  // its half-edges; kNoTriangle: none
  struct Fresh {
    std::vector<Index> edges, triangles;
  };

  void add_base() {
    const Mesh& mesh = base_.mesh;
    relief_.positions = mesh.positions;
    relief_.triangles = mesh.triangles;
    relief_.base.resize(mesh.triangle_count());
    for (Index t = 0; t < relief_.base.size(); ++t) relief_.base[t] = t;
    places_.assign(mesh.triangle_count(), {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()});
    add_edges(twins_of(mesh.triangles));
    const VertexTriangles around = vertex_triangles(mesh);
    relief_.heights.assign(mesh.vertex_count(), 0);
    relief_.directions.assign(mesh.vertex_count(), Vec3::Zero());
    parallel_for(mesh.vertex_count(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) measure_vertex(static_cast<Index>(v), around);
    });
  }

  void add_edges(const std::vector<Index>& twins) {
    edge_of_.resize(relief_.triangles.size());
    for (Index h = 0; h < twins.size(); ++h) {
      if (twins[h] != kNoTwin && twins[h] < h) continue;
      edge_of_[h / 3][h % 3] = static_cast<Index>(edges_.size());
      if (twins[h] != kNoTwin) edge_of_[twins[h] / 3][twins[h] % 3] = edge_of_[h / 3][h % 3];
      edges_.push_back({h, twins[h] == kNoTwin ? kNoTriangle : twins[h]});
    }
  }

  void measure_vertex(Index v, const VertexTriangles& around) {
    std::vector<Vec3> normals;
    float height = 1;
    for (const Index t : around.of(v)) {
      for (int m = 0; m < 3; ++m) {
        if (base_.mesh.triangles[t][m] != v) continue;
        const Vec3& normal = base_.normals[t][m];
        if (ranges::none_of(normals, [&](const Vec3& n) { return n.dot(normal) > 0.9999f; }))
          normals.push_back(normal);
        height = std::min(height, heights_.at(t, places_[t][m]));
      }
    }
    if (normals.empty()) return;
    relief_.heights[v] = height;
    relief_.directions[v] = mitre(normals);
  }

  /// The place on an edge at `share` of the way along its first half-edge, seen from side k.
  Vec3 place_on(const Edge& edge, int k, float share) const {
    const Corners& corners = places_[edge[k] / 3];
    const float s = k == 0 ? share : 1 - share;
    const Index m = edge[k] % 3;
    return (1 - s) * corners[m] + s * corners[(m + 1) % 3];
  }
  Index base_beside(const Edge& edge, int k) const { return relief_.base[edge[k] / 3]; }
  /// The sides with different triangles of the base.
  int sides(const Edge& edge) const {
    return edge[1] != kNoTriangle && base_beside(edge, 0) != base_beside(edge, 1) ? 2 : 1;
  }
  std::array<Index, 2> ends(const Edge& edge) const {
    return {vertex_at(relief_.triangles, edge[0]),
            vertex_at(relief_.triangles, next_in_triangle(edge[0]))};
  }

  /// The height on an edge. At a step, as on a seam, it is the lower one.
  float height_on(const Edge& edge, float share) const {
    float height = 1;
    for (int k = 0; k < sides(edge); ++k) {
      height = std::min(height, heights_.at(base_beside(edge, k), place_on(edge, k, share)));
    }
    return height;
  }

  float length_of(const Edge& edge) const {
    const auto [a, b] = ends(edge);
    return (relief_.positions[a] - relief_.positions[b]).norm();
  }

  /// Whether a triangle is no wider than the shortest edges, so that a step in it is no error.
  bool is_thin(Index t) const {
    const Triangle& v = relief_.triangles[t];
    const std::vector<Vec3>& p = relief_.positions;
    float longest = 0;
    for (const Index e : edge_of_[t]) longest = std::max(longest, length_of(edges_[e]));
    return (p[v[1]] - p[v[0]]).cross(p[v[2]] - p[v[0]]).norm() <= limits_.shortest * longest;
  }

  /// Triangles beside those that stay whole may be long and thin, and steps in them without end.
  bool is_short(const Edge& edge) const {
    if (length_of(edge) <= limits_.shortest) return true;
    if (!has_plain_) return false;
    return is_thin(edge[0] / 3) && (edge[1] == kNoTriangle || is_thin(edge[1] / 3));
  }

  /// Where to split an edge; kUnsplit: nowhere.
  float split_of(const Edge& edge) const {
    float details = 0;
    for (int k = 0; k < sides(edge); ++k) {
      details = std::max(details, heights_.details(base_beside(edge, k), place_on(edge, k, 0),
                                                   place_on(edge, k, 1)));
    }
    if (details == 0 || is_short(edge)) return kUnsplit;
    const auto [a, b] = ends(edge);
    const float from = relief_.heights[a], to = relief_.heights[b];
    const auto error = [&](float s) {
      return std::abs(height_on(edge, s) - (1 - s) * from - s * to);
    };
    const int steps = std::clamp(static_cast<int>(std::ceil(details)), 3, 256);
    float place = 0, largest = 0;
    for (int i = 1; i < steps; ++i) {
      const float s = static_cast<float>(i) / static_cast<float>(steps);
      const float here = error(s);
      if (here > largest) std::tie(place, largest) = std::pair(s, here);
    }
    if (largest <= limits_.error) return kUnsplit;
    // The error has its maximum at a kink between the neighbouring samples.
    const float step = 1 / static_cast<float>(steps);
    float begin = place - step, end = place + step;
    for (int i = 0; i < 8; ++i) {
      const float one = begin + 0.4f * (end - begin), two = begin + 0.6f * (end - begin);
      (error(one) < error(two) ? begin : end) = error(one) < error(two) ? one : two;
    }
    return std::clamp(0.5f * (begin + end), kNearestToEnd, 1 - kNearestToEnd);
  }

  /// Whether the height in a triangle is not linear, far from its edges too.
  bool bends_inside(Index t) const {
    const Index base = relief_.base[t];
    const Corners& c = places_[t];
    float details = 0;
    for (int m = 0; m < 3; ++m) {
      details = std::max(details, heights_.details(base, c[m], c[(m + 1) % 3]));
    }
    if (details == 0 || (has_plain_ && is_thin(t)) ||
        length_to_split(longest_edge(t)) <= limits_.shortest) {
      return false;
    }
    const Triangle& v = relief_.triangles[t];
    const int steps = std::clamp(static_cast<int>(std::ceil(details)), 3, 32);
    for (int i = 1; i < steps; ++i) {
      for (int j = 1; i + j < steps; ++j) {
        const Vec3 w =
            Vec3(static_cast<float>(i), static_cast<float>(j), static_cast<float>(steps - i - j)) /
            static_cast<float>(steps);
        const float linear = w[0] * relief_.heights[v[0]] + w[1] * relief_.heights[v[1]] +
                             w[2] * relief_.heights[v[2]];
        if (std::abs(heights_.at(base, mixed(c, w)) - linear) > limits_.error) return true;
      }
    }
    return false;
  }

  /// The length of an edge; 0 at triangles without texture, which stay whole.
  float length_to_split(Index e) const {
    for (const Index h : edges_[e]) {
      if (h != kNoTriangle && base_.textured[relief_.base[h / 3]] == 0) return 0;
    }
    return length_of(edges_[e]);
  }

  Index longest_edge(Index t) const {
    Index longest = edge_of_[t][0];
    for (const Index e : edge_of_[t]) {
      if (length_to_split(e) > length_to_split(longest)) longest = e;
    }
    return longest;
  }

  /// Splits the fresh edges that need it. Returns whether there were any.
  bool split_long_edges(const Progress& progress) {
    const std::vector<Index> edges = std::exchange(fresh_.edges, {});
    std::vector<float> splits(edges.size(), kUnsplit), lengths(edges.size());
    parallel_for(
        edges.size(),
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            splits[i] = split_of(edges_[edges[i]]);
            lengths[i] = length_of(edges_[edges[i]]);
          }
        },
        64);
    const std::size_t before = edges_.size();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (i % kReportSlice == 0) progress.tick();
      // An edge that was split for another one is fresh again.
      if (splits[i] == kUnsplit || length_of(edges_[edges[i]]) != lengths[i]) continue;
      split_longer_ones(edges[i]);
      split(edges[i], splits[i]);
    }
    return edges_.size() > before;
  }

  /// Splits the longest edges of the triangles beside an edge first, which avoids slivers (Rivara
  /// 1984).
  void split_longer_ones(Index e) {
    constexpr float kLonger = 1.2f;
    for (int k = 0; k < 2; ++k) {
      while (edges_[e][k] != kNoTriangle) {
        const Index longest = longest_edge(edges_[e][k] / 3);
        if (!(length_to_split(longest) > kLonger * length_of(edges_[e]))) break;
        split_longer_ones(longest);
        const float share = split_of(edges_[longest]);
        split(longest, share == kUnsplit ? 0.5f : share);
      }
    }
  }

  void split_in_triangles(const Progress& progress) {
    std::vector<Index> triangles = std::exchange(fresh_.triangles, {});
    ranges::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    std::vector<std::uint8_t> bend(triangles.size());
    parallel_for(
        triangles.size(),
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) bend[i] = bends_inside(triangles[i]) ? 1 : 0;
        },
        64);
    progress.tick();
    std::vector<Index> longest;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (bend[i] == 0) continue;
      longest.push_back(longest_edge(triangles[i]));
    }
    ranges::sort(longest.begin(), longest.end());
    longest.erase(std::unique(longest.begin(), longest.end()), longest.end());
    for (const Index e : longest) split(e, 0.5f);
  }

  /// Splits edges at height 1/2, or moves the outline to an end nearby.
  void split_at_outline(const Progress& progress) {
    std::vector<float> places(edges_.size(), kUnsplit);
    for (Index e = 0; e < places.size(); ++e) {
      if (e % kReportSlice == 0) progress.tick();
      const auto [a, b] = ends(edges_[e]);
      const float from = relief_.heights[a] - kOutline, to = relief_.heights[b] - kOutline;
      if (!(from * to < 0)) continue;
      const float place = from / (from - to);
      constexpr float kSnapped = 0.1f;
      if (place < kSnapped) {
        relief_.heights[a] = kOutline;
      } else if (place > 1 - kSnapped) {
        relief_.heights[b] = kOutline;
      } else {
        places[e] = place;
      }
    }
    for (Index e = 0; e < places.size(); ++e) {
      const auto [a, b] = ends(edges_[e]);
      const float product = (relief_.heights[a] - kOutline) * (relief_.heights[b] - kOutline);
      if (places[e] == kUnsplit || !(product < 0)) continue;
      relief_.heights[split(e, places[e])] = kOutline;
    }
  }

  /// Returns the new vertex.
  Index split(Index e, float share) {
    const Edge edge = edges_[e];
    const auto [a, b] = ends(edge);
    const auto vertex = static_cast<Index>(relief_.positions.size());
    const double s = share;
    relief_.positions.push_back(
        ((1 - s) * relief_.positions[a].cast<double>() + s * relief_.positions[b].cast<double>())
            .cast<float>());
    relief_.heights.push_back(height_on(edge, share));
    std::vector<Vec3> normals;
    for (int k = 0; k < sides(edge); ++k) {
      normals.push_back(heights_.normal(base_beside(edge, k), place_on(edge, k, share)));
    }
    relief_.directions.push_back(mitre(normals));
    const std::array<Vec3, 2> places = {
        place_on(edge, 0, share), edge[1] == kNoTriangle ? Vec3::Zero() : place_on(edge, 1, share)};
    const auto rest = static_cast<Index>(edges_.size());
    edges_.push_back({kNoTriangle, kNoTriangle});
    fresh_.edges.insert(fresh_.edges.end(), {e, rest});
    for (int k = 0; k < 2; ++k) {
      if (edge[k] == kNoTriangle) continue;
      // `e` keeps the first end of the edge, `rest` the second.
      split_triangle(edge[k], vertex, places[k], k == 0 ? e : rest, k == 0 ? rest : e, k);
    }
    if (relief_.triangles.size() > kMostReliefTriangles) {
      throw Error(
          "the relief needs more than 30 million triangles; raise the tolerance or the spacing");
    }
    return vertex;
  }

  /// Splits the triangle of half-edge `h` at a vertex on it. `first` and `second` are the edges
  /// before and after the vertex; the half-edges are their side `k`.
  void split_triangle(Index h, Index vertex, const Vec3& place, Index first, Index second, int k) {
    const Index t = h / 3, m = h % 3, next = (m + 1) % 3, last = (m + 2) % 3;
    const auto added = static_cast<Index>(relief_.triangles.size());
    const auto across = static_cast<Index>(edges_.size());
    relief_.triangles.push_back(relief_.triangles[t]);
    relief_.base.push_back(relief_.base[t]);
    places_.push_back(places_[t]);
    edge_of_.push_back(edge_of_[t]);
    relief_.triangles[t][next] = relief_.triangles[added][m] = vertex;
    places_[t][next] = places_[added][m] = place;
    ranges::replace(edges_[edge_of_[t][next]], 3 * t + next, 3 * added + next);
    edges_.push_back({3 * t + next, 3 * added + last});
    edge_of_[t][m] = first;
    edge_of_[t][next] = edge_of_[added][last] = across;
    edge_of_[added][m] = second;
    edges_[first][k] = 3 * t + m;
    edges_[second][k] = 3 * added + m;
    fresh_.edges.push_back(across);
    fresh_.triangles.insert(fresh_.triangles.end(), {t, added});
  }

  const ReliefBase& base_;
  BaseHeights heights_;
  RefinementLimits limits_;
  bool has_plain_;  // triangles without texture, which stay whole
  RefinedRelief relief_;
  std::vector<Corners> places_;                // of the corners in the base's triangle
  std::vector<std::array<Index, 3>> edge_of_;  // of half-edges
  std::vector<Edge> edges_;
  Fresh fresh_;
};

}  // namespace

RefinedRelief refined_relief(const ReliefBase& base, const ReliefTexture& texture,
                             const RefinementLimits& limits, const Progress& progress) {
  return Refinement(base, texture, limits).run(progress);
}

}  // namespace brindle
