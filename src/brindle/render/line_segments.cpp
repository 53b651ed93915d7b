#include "brindle/render/line_segments.h"

#include <map>
#include <optional>
#include <utility>

namespace brindle {
namespace {

Vec3 point_in(const Mesh& mesh, const Triangle& t, const CornerWeights& weights) {
  Vec3 point = Vec3::Zero();
  for (int m = 0; m < 3; ++m) point += static_cast<float>(weights[m]) * mesh.positions[t[m]];
  return point;
}

Vec3 normal_in(std::span<const Vec3> normals, const Triangle& t, const CornerWeights& weights) {
  Vec3 normal = Vec3::Zero();
  for (int m = 0; m < 3; ++m) normal += static_cast<float>(weights[m]) * normals[t[m]];
  return normal.normalized();
}

/// Joins segments at nodes of degree two into lines.
class SegmentJoiner {
 public:
  SegmentJoiner(const Mesh& mesh, std::span<const Vec3> normals,
                std::span<const LineSegment> segments)
      : mesh_(mesh), normals_(normals), segments_(segments), used_(segments_.size()) {
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      for (const Index node : segments_[s].nodes) at_node_[node].push_back(s);
    }
  }

  Polylines joined() {
    // First from ends and forks, then the remaining closed lines.
    for (const auto& [node, around] : at_node_) {
      if (around.size() != 2) add_lines(node);
    }
    for (const auto& [node, around] : at_node_) add_lines(node);
    lines_.origin = mesh_.origin;
    return std::move(lines_);
  }

 private:
  std::optional<std::size_t> next_at(Index node) const {
    for (const std::size_t s : at_node_.at(node)) {
      if (!used_[s]) return s;
    }
    return std::nullopt;
  }

  void add_lines(Index start) {
    while (next_at(start)) {
      Index node = start;
      std::size_t last = 0;
      CornerWeights arrival{};
      while (const std::optional<std::size_t> s = next_at(node)) {
        const LineSegment& segment = segments_[*s];
        const int from = segment.nodes[0] == node ? 0 : 1;
        add_point(segment.triangle, segment.barycentric[from], segment.barycentric[1 - from]);
        used_[*s] = true;
        last = *s;
        arrival = segment.barycentric[1 - from];
        node = segment.nodes[1 - from];
        if (node == start || at_node_.at(node).size() != 2) break;
      }
      const bool closed = node == start;
      if (!closed) add_point(segments_[last].triangle, arrival, arrival);
      lines_.end_line(closed);
    }
  }

  void add_point(Index triangle, const CornerWeights& place, const CornerWeights& arrival) {
    const Triangle& t = mesh_.triangles[triangle];
    lines_.add(point_in(mesh_, t, place), normal_in(normals_, t, place), {triangle, place},
               arrival);
  }

  const Mesh& mesh_;
  std::span<const Vec3> normals_;
  std::span<const LineSegment> segments_;
  std::vector<bool> used_;
  std::map<Index, std::vector<std::size_t>> at_node_;
  Polylines lines_;
};

}  // namespace

CornerWeights zero_between(int a, int b, double value_a, double value_b) {
  const double share = value_a / (value_a - value_b);
  CornerWeights weights{};
  weights[a] = 1 - share;
  weights[b] = share;
  return weights;
}

Polylines joined_lines(const Mesh& mesh, std::span<const Vec3> normals,
                       std::span<const LineSegment> segments) {
  return SegmentJoiner(mesh, normals, segments).joined();
}

}  // namespace brindle
