#include "scenes/brush_stroke.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "brindle/base/graph.h"
#include "brindle/direction_field.h"

namespace brindle {
namespace {

/// The shortest paths along edges from some vertices.
struct PathsFrom {
  std::vector<float> distance;   ///< to the nearest source; infinite beyond the limit
  std::vector<Index> before;     ///< the previous vertex; sources have themselves
  std::vector<Index> source_of;  ///< index of the nearest source
  Index farthest = 0;            ///< the last vertex reached
};

PathsFrom paths_from(std::span<const Index> sources, const Surface& surface, float limit) {
  const std::size_t count = surface.mesh.vertex_count();
  PathsFrom paths{{}, std::vector<Index>(count), std::vector<Index>(count)};
  ShortestWays<float> ways(count);
  for (Index s = 0; s < sources.size(); ++s) {
    ways.offer(sources[s], 0);
    paths.before[sources[s]] = sources[s];
    paths.source_of[sources[s]] = s;
  }
  while (const auto nearest = ways.next()) {
    const auto [distance, v] = *nearest;
    paths.farthest = v;
    for (const Index w : surface.neighborhood->of(v)) {
      const float there = distance + (surface.mesh.positions[w] - surface.mesh.positions[v]).norm();
      if (there > limit || !ways.offer(w, there)) continue;
      paths.before[w] = v;
      paths.source_of[w] = paths.source_of[v];
    }
  }
  for (Index v = 0; v < count; ++v) paths.distance.push_back(ways.distance(v));
  return paths;
}

/// The used vertex with the smallest coordinate along the longest side of the bounding box.
Index outermost_vertex(const Surface& surface) {
  const BoundingBox box = bounding_box(surface.mesh);
  Eigen::Index axis = 0;
  (box.upper - box.lower).maxCoeff(&axis);
  Index outermost = surface.mesh.triangles.front()[0];
  for (const Triangle& triangle : surface.mesh.triangles) {
    for (const Index v : triangle) {
      if (surface.mesh.positions[v][axis] < surface.mesh.positions[outermost][axis]) outermost = v;
    }
  }
  return outermost;
}

std::vector<Index> longest_path(const Surface& surface) {
  const Index begin = outermost_vertex(surface);
  const PathsFrom paths = paths_from({&begin, 1}, surface, std::numeric_limits<float>::infinity());
  std::vector<Index> path{paths.farthest};
  while (path.back() != begin) path.push_back(paths.before[path.back()]);
  std::ranges::reverse(path);
  return path;
}

/// Smooths zigzag edge paths by averages over about one brush radius.
std::vector<Vec3> smoothed(std::vector<Vec3> points, float length, float radius) {
  const auto count = static_cast<float>(points.size());
  const float window = length > 0 ? radius / length * count : 0;  // points per radius
  const auto rounds =
      static_cast<int>(window * window / 2);  // their width grows as the square root
  std::vector<Vec3> last;
  for (int round = 0; round < std::min(rounds, 1000); ++round) {
    last = points;
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
      points[k] = 0.25f * last[k - 1] + 0.5f * last[k] + 0.25f * last[k + 1];
    }
  }
  return points;
}

std::vector<float> arcs_of(std::span<const Vec3> points) {
  std::vector<float> arc(points.size(), 0);
  for (std::size_t k = 1; k < points.size(); ++k) {
    arc[k] = arc[k - 1] + (points[k] - points[k - 1]).norm();
  }
  return arc;
}

void add_anchors(BrushStroke& stroke, const Surface& surface, std::span<const Index> path,
                 float weight) {
  const PathsFrom ways = paths_from(path, surface, stroke.radius);
  for (Index v = 0; v < surface.mesh.vertex_count(); ++v) {
    if (std::isinf(ways.distance[v])) continue;
    const std::size_t k = ways.source_of[v];
    const Vec3 along =
        stroke.path[std::min(k + 1, path.size() - 1)] - stroke.path[k > 0 ? k - 1 : 0];
    const float share = ways.distance[v] / stroke.radius;
    const Vec3 across = tangent_direction(surface.normals[v].cross(along), surface.normals[v]);
    stroke.anchor.push_back({v, across, weight * (1 - share * share) * (1 - share * share)});
    stroke.anchor_arc.push_back(stroke.path_arc[k]);
  }
}

}  // namespace

BrushStroke make_brush_stroke(const Surface& surface, float radius, float weight) {
  BrushStroke stroke;
  stroke.radius = radius;
  if (surface.mesh.triangles.empty()) return stroke;
  const std::vector<Index> path = longest_path(surface);
  for (const Index v : path) stroke.path.push_back(surface.mesh.positions[v]);
  stroke.path = smoothed(std::move(stroke.path), arcs_of(stroke.path).back(), radius);
  stroke.path_arc = arcs_of(stroke.path);
  stroke.length = stroke.path_arc.back();
  add_anchors(stroke, surface, path, weight);
  return stroke;
}

void anchors_up_to(const BrushStroke& stroke, float arc, std::vector<FieldAnchor>& anchors) {
  anchors.clear();
  for (std::size_t k = 0; k < stroke.anchor.size(); ++k) {
    const float behind = std::clamp((arc - stroke.anchor_arc[k]) / stroke.radius, 0.0f, 1.0f);
    if (behind <= 0) continue;
    anchors.push_back(stroke.anchor[k]);
    anchors.back().weight *= behind;
  }
}

Vec3 brush_tip(const BrushStroke& stroke, float arc) {
  const auto after = std::ranges::upper_bound(stroke.path_arc, arc);
  const auto k = static_cast<std::size_t>(after - stroke.path_arc.begin());
  if (k == 0) return stroke.path.front();
  if (k == stroke.path.size()) return stroke.path.back();
  const float share =
      (arc - stroke.path_arc[k - 1]) / (stroke.path_arc[k] - stroke.path_arc[k - 1]);
  return stroke.path[k - 1] + share * (stroke.path[k] - stroke.path[k - 1]);
}

}  // namespace brindle
