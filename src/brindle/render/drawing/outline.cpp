/// Visible outlines of a surface.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "brindle/base/parallel.h"
#include "brindle/geometry/normals_around.h"
#include "brindle/geometry/topology.h"
#include "brindle/line_drawing.h"
#include "brindle/render/line_segments.h"

namespace brindle {
namespace {

/// A fan: triangles around a vertex between two creases. Numbered by its first triangle.
struct FanCorner {
  Index fan = 0;
  double facing = 0;  ///< positive if the front side is visible; never zero
};

/// A triangle around a vertex.
struct Around {
  Index triangle;
  int corner;
  std::array<Index, 2> others;  ///< the other two corners, in winding order
  float sign = 0;  ///< 0: in no fan yet; -1: wound against the first triangle of its fan
};

/// The sides of all corners that face a viewpoint.
class FacingCorners {
 public:
  FacingCorners(const Mesh& mesh, std::span<const Vec3> normals, const Vec3& eye,
                const Progress& progress)
      : mesh_(mesh), normals_(normals), eye_(eye), corners_(mesh.triangle_count()) {
    const VertexTriangles around = vertex_triangles(mesh, progress.part(0, 0.3));
    std::vector<Vec3> ignored;
    fill_vertex_normals(mesh, around, {}, angles_, ignored, progress.part(0.3, 0.6));
    parallel_for(mesh.vertex_count(), progress.part(0.6, 1),
                 [&](std::size_t begin, std::size_t end) {
                   std::vector<Around> triangles;
                   for (std::size_t v = begin; v < end; ++v) {
                     const auto vertex = static_cast<Index>(v);
                     collect(vertex, around.of(vertex), triangles);
                     add_fans(vertex, triangles);
                   }
                 });
  }

  const FanCorner& at(Index triangle, int corner) const { return corners_[triangle][corner]; }

 private:
  void collect(Index vertex, std::span<const Index> around, std::vector<Around>& triangles) const {
    triangles.clear();
    for (const Index t : around) {
      const Triangle& triangle = mesh_.triangles[t];
      const int c = corner_of(triangle, vertex);
      triangles.push_back({t, c, {triangle[(c + 1) % 3], triangle[(c + 2) % 3]}});
    }
  }

  /// 1 if the surface continues from a to b without a crease, -1 if their windings also differ,
  /// else 0.
  float goes_on(const std::vector<Around>& triangles, const Around& a, const Around& b) const {
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        if (a.others[i] != b.others[j]) continue;
        const auto has_it = [&](const Around& one) {
          return one.others[0] == a.others[i] || one.others[1] == a.others[i];
        };
        if (std::count_if(triangles.begin(), triangles.end(), has_it) != 2) continue;
        const float sign = i == j ? -1.0f : 1.0f;
        const Vec3& normal = angles_[a.triangle].normal;
        if (sign * normal.dot(angles_[b.triangle].normal) >= kCosineOfCrease) return sign;
      }
    }
    return 0;
  }

  void add_fans(Index vertex, std::vector<Around>& triangles) {
    std::vector<std::size_t> fan;
    for (std::size_t first = 0; first < triangles.size(); ++first) {
      if (triangles[first].sign != 0) continue;
      triangles[first].sign = 1;
      fan = {first};
      for (std::size_t i = 0; i < fan.size(); ++i) {
        for (std::size_t next = 0; next < triangles.size(); ++next) {
          if (triangles[next].sign != 0) continue;
          const Around& from = triangles[fan[i]];
          triangles[next].sign = from.sign * goes_on(triangles, from, triangles[next]);
          if (triangles[next].sign != 0) fan.push_back(next);
        }
      }
      const double facing = facing_of(vertex, triangles, fan);
      for (const std::size_t i : fan) {
        const Around& corner = triangles[i];
        corners_[corner.triangle][corner.corner] = {triangles[first].triangle,
                                                    static_cast<double>(corner.sign) * facing};
      }
    }
  }

  /// For the front side of the fan's first triangle.
  double facing_of(Index vertex, const std::vector<Around>& triangles,
                   const std::vector<std::size_t>& fan) const {
    Vec3 normal = Vec3::Zero();
    for (const std::size_t i : fan) {
      const TriangleAngles& angles = angles_[triangles[i].triangle];
      normal += triangles[i].sign * angles.angle[triangles[i].corner] * angles.normal;
    }
    const Vec3& given = normals_[vertex];
    if (fan.size() == triangles.size()) normal = normal.dot(given) < 0 ? Vec3(-given) : given;
    const double facing = static_cast<double>(normal.dot(eye_ - mesh_.positions[vertex]));
    return facing != 0 && std::isfinite(facing) ? facing
                                                : 1e-12;  // beside a vertex, not through it
  }

  const Mesh& mesh_;
  std::span<const Vec3> normals_;
  Vec3 eye_;
  std::vector<TriangleAngles> angles_;
  std::vector<std::array<FanCorner, 3>> corners_;
};

/// An edge of a triangle, by its end vertices.
struct Side {
  Index low, high;
  Index triangle;
  std::array<int, 2> corners;  ///< at both ends
};

std::vector<Side> sides_of(const Mesh& mesh, const Progress& progress) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangle_count());
  reported_for(mesh.triangle_count(), progress.part(0, 0.3), [&](std::size_t number) {
    const Triangle& t = mesh.triangles[number];
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      std::array<int, 2> corners = {a, b};
      if (t[b] < t[a]) corners = {b, a};
      sides.push_back({t[corners[0]], t[corners[1]], static_cast<Index>(number), corners});
    }
  });
  ticking_sort(sides.begin(), sides.end(), progress.part(0.3, 1), [](const Side& x, const Side& y) {
    return std::array{x.low, x.high, x.triangle} < std::array{y.low, y.high, y.triangle};
  });
  return sides;
}

/// Collects the segments of an outline.
class OutlineSegments {
 public:
  explicit OutlineSegments(const FacingCorners& facing) : facing_(facing) {}

  /// Adds the silhouette within a triangle.
  void add_turn(Index triangle, const Triangle& vertices) {
    LineSegment segment{{}, triangle, {}};
    int found = 0;
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      const double value_a = facing_.at(triangle, a).facing,
                   value_b = facing_.at(triangle, b).facing;
      if ((value_a > 0) == (value_b > 0)) continue;
      Side side{vertices[a], vertices[b], triangle, {a, b}};
      if (side.high < side.low) side = {side.high, side.low, triangle, {b, a}};
      segment.nodes[found] = zero_node(side);
      segment.barycentric[found++] = zero_between(a, b, value_a, value_b);
    }
    if (found == 2) segments_.push_back(segment);
  }

  void add_border(const Side& side) {
    add_part(side, {0, vertex_node(side.low)}, {1, vertex_node(side.high)});
  }

  /// Adds a crease edge if one of its triangles faces the viewer and the other does not. Smooth
  /// edges add nothing.
  void add_crease(const Side& first, const Side& second) {
    std::vector<Place> places = {{0, vertex_node(first.low)}};
    for (const Side* side : {&first, &second}) {
      const auto [low, high] = values(*side);
      if ((low > 0) != (high > 0)) places.push_back({low / (low - high), zero_node(*side)});
    }
    if (places.size() == 3 && places[2].share < places[1].share) std::swap(places[1], places[2]);
    places.push_back({1, vertex_node(first.high)});
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      const double middle = 0.5 * (places[i].share + places[i + 1].share);
      if (faces(first, middle) == faces(second, middle)) add_part(first, places[i], places[i + 1]);
    }
  }

  const std::vector<LineSegment>& segments() const { return segments_; }

 private:
  struct Place {
    double share;  ///< of the edge, from its lower vertex
    Index node;
  };

  /// At both ends, for the side of the surface from which the edge's triangle is wound from low to
  /// high.
  std::array<double, 2> values(const Side& side) const {
    const double sign = side.corners[1] == (side.corners[0] + 1) % 3 ? 1 : -1;
    return {sign * facing_.at(side.triangle, side.corners[0]).facing,
            sign * facing_.at(side.triangle, side.corners[1]).facing};
  }
  bool faces(const Side& side, double share) const {
    const auto [low, high] = values(side);
    return (1 - share) * low + share * high > 0;
  }

  void add_part(const Side& side, const Place& from, const Place& to) {
    if (from.node == to.node || !(from.share < to.share)) return;
    LineSegment segment{{from.node, to.node}, side.triangle, {}};
    for (int i = 0; i < 2; ++i) {
      const double share = i == 0 ? from.share : to.share;
      segment.barycentric[i][side.corners[0]] = 1 - share;
      segment.barycentric[i][side.corners[1]] = share;
    }
    segments_.push_back(segment);
  }

  Index vertex_node(Index vertex) { return node({vertex, vertex, 0, 0}); }
  /// One node for both triangles of an edge, unless it is a crease.
  Index zero_node(const Side& side) {
    return node({side.low, side.high, facing_.at(side.triangle, side.corners[0]).fan,
                 facing_.at(side.triangle, side.corners[1]).fan});
  }
  Index node(const std::array<Index, 4>& key) {
    return nodes_.try_emplace(key, static_cast<Index>(nodes_.size())).first->second;
  }

  const FacingCorners& facing_;
  std::map<std::array<Index, 4>, Index> nodes_;
  std::vector<LineSegment> segments_;
};

}  // namespace

Polylines outline(const Mesh& split, std::span<const Vec3> normals, const CameraView& view,
                  int width, int height, const Progress& heard) {
  Mesh mesh = split;
  join_vertices(mesh);
  JobStages stages(heard, {{"outline", 1}});
  const Progress progress = stages.begin("outline");
  const Camera camera = framed_camera(points_of_triangles(mesh), view, width, height);
  const FacingCorners facing(mesh, normals, viewpoint_of(camera), progress.part(0, 0.4));
  const std::vector<Side> sides = sides_of(mesh, progress.part(0.4, 0.7));
  OutlineSegments segments(facing);
  reported_for(mesh.triangle_count(), progress.part(0.7, 0.8),
               [&](std::size_t t) { segments.add_turn(static_cast<Index>(t), mesh.triangles[t]); });
  Reporter reporter(progress.part(0.8, 0.95), sides.size());
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
    const auto [low, high] = std::pair(sides[first].low, sides[first].high);
    while (end < sides.size() && sides[end].low == low && sides[end].high == high) ++end;
    reporter.done(end - first);
    if (end - first == 2) {
      segments.add_crease(sides[first], sides[first + 1]);
    } else {
      segments.add_border(sides[first]);
    }
  }
  Polylines lines = joined_lines(mesh, normals, segments.segments());
  stages.finish();
  return lines;
}

}  // namespace brindle
