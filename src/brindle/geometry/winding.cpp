#include "brindle/geometry/winding.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/standard.h"
#include "brindle/geometry/normals_around.h"

namespace brindle {
namespace {

struct WoundNeighbor {
  Index triangle;
  bool against;  ///< of opposite winding: both traverse the edge in the same direction
};

/// The only triangle along an edge from `a` to `b` besides `t`, which traverses it in this order.
std::optional<WoundNeighbor> neighbor_along(const Mesh& mesh, const VertexTriangles& around,
                                            Index t, Index a, Index b) {
  std::optional<WoundNeighbor> found;
  for (const Index other : around.of(a)) {
    if (other == t) continue;
    const Triangle& triangle = mesh.triangles[other];
    const int c = corner_of(triangle, a);
    const bool leaves = triangle[(c + 1) % 3] == b;
    if (!leaves && triangle[(c + 2) % 3] != b) continue;
    if (found) return std::nullopt;
    found = WoundNeighbor{other, leaves};
  }
  return found;
}

/// Walks components and marks triangles against their first one.
class WindingWalk {
 public:
  WindingWalk(const Mesh& mesh, const VertexTriangles& around,
              std::span<const CreaseNeighbors> links)
      : mesh_(mesh), around_(around), turned_(mesh.triangle_count(), kUnseen) {
    const auto add_all = [&](const auto& add) {
      for (const CreaseNeighbors& link : links) {
        add(link.first, {link.second, link.against});
        add(link.second, {link.first, link.against});
      }
    };
    if (!links.empty()) links_ = compressed_rows<WoundNeighbor>(turned_.size(), add_all);
  }

  std::vector<std::uint8_t> turned() {
    for (Index start = 0; start < turned_.size(); ++start) {
      if (turned_[start] == kUnseen) turn_component(start);
    }
    const bool any = ranges::find(turned_, std::uint8_t{1}) != turned_.end();
    return any ? std::move(turned_) : std::vector<std::uint8_t>();
  }

 private:
  static constexpr std::uint8_t kUnseen = 2;

  void turn_component(Index start) {
    component_.assign(1, start);
    turned_[start] = 0;
    orientable_ = closed_ = true;
    for (std::size_t next = 0; next < component_.size(); ++next) visit_neighbors(component_[next]);
    std::size_t against = 0;
    for (const Index t : component_) against += turned_[t];
    if (!orientable_ || against == 0) return stay();
    const double volume = closed_ ? six_volumes() : 0;
    const bool reversed = volume != 0 ? volume < 0 : 2 * against > component_.size();
    for (const Index t : component_) turned_[t] ^= reversed ? 1 : 0;
  }

  void stay() {
    for (const Index t : component_) turned_[t] = 0;
  }

  /// Six times the volume within the component after turning; positive if it is wound outwards.
  double six_volumes() const {
    const Vec3& origin = mesh_.positions[mesh_.triangles[component_[0]][0]];
    double sum = 0;
    for (const Index t : component_) {
      std::array<Eigen::Vector3d, 3> p;
      for (std::size_t c = 0; c < 3; ++c) {
        p[c] = (mesh_.positions[mesh_.triangles[t][c]] - origin).cast<double>();
      }
      sum += (turned_[t] != 0 ? -1 : 1) * p[0].dot(p[1].cross(p[2]));
    }
    return sum;
  }

  void visit_neighbors(Index t) {
    const Triangle& triangle = mesh_.triangles[t];
    for (int m = 0; m < 3; ++m) {
      const Index a = triangle[m], b = triangle[(m + 1) % 3];
      if (a == b) continue;
      const auto found = neighbor_along(mesh_, around_, t, a, b);
      if (found) reach(t, *found);
      closed_ = closed_ && found;
    }
    if (links_.entries.empty()) return;
    for (const WoundNeighbor& neighbor : links_.of(t)) reach(t, neighbor);
  }

  void reach(Index from, const WoundNeighbor& to) {
    const std::uint8_t turned = turned_[from] ^ (to.against ? 1 : 0);
    if (turned_[to.triangle] == kUnseen) {
      turned_[to.triangle] = turned;
      component_.push_back(to.triangle);
    } else if (turned_[to.triangle] != turned) {
      orientable_ = false;
    }
  }

  const Mesh& mesh_;
  const VertexTriangles& around_;
  CompressedRows<WoundNeighbor> links_;
  std::vector<std::uint8_t> turned_;
  std::vector<Index> component_;
  bool orientable_ = true, closed_ = true;
};

}  // namespace

std::vector<CreaseNeighbors> triangles_over_creases(const Mesh& mesh, const VertexTriangles& around,
                                                    const Creases& creases) {
  std::vector<CreaseNeighbors> links;
  for (const auto& [first, second] : creases.edges) {
    const auto a = neighbor_along(mesh, around, kNoTriangle, first[0], first[1]);
    const auto b = neighbor_along(mesh, around, kNoTriangle, second[0], second[1]);
    if (!a || !b || a->triangle == b->triangle) continue;
    links.push_back({a->triangle, b->triangle, a->against == b->against});
  }
  return links;
}

std::vector<std::uint8_t> triangles_to_turn(const Mesh& mesh, const VertexTriangles& around,
                                            std::span<const CreaseNeighbors> links) {
  return WindingWalk(mesh, around, links).turned();
}

}  // namespace brindle
