#include <algorithm>
#include <limits>
#include <utility>

#include "brindle/base/graph.h"
#include "brindle/base/standard.h"
#include "brindle/geometry/topology.h"
#include "brindle/surface.h"

namespace brindle {
namespace {

constexpr Index kNowhere = std::numeric_limits<Index>::max();

class LoopFinder {
 public:
  LoopFinder(const Mesh& mesh, const Adjacency& neighborhood)
      : mesh_(mesh),
        neighborhood_(neighborhood),
        edges_(mesh_edges(mesh_, neighborhood_)),
        component_(mesh_.vertex_count(), kNowhere),
        ways_(mesh_.vertex_count()) {}

  std::vector<SurfaceLoop> find() {
    find_components();
    find_boundaries();
    find_tree();
    find_handles();
    return std::move(loops_);
  }

 private:
  void find_components() {
    std::size_t count = 0;
    for (Index start = 0; start < component_.size(); ++start) {
      if (component_[start] != kNowhere || neighborhood_.of(start).empty()) continue;
      std::vector<Index> queue = {start};
      component_[start] = static_cast<Index>(count);
      for (std::size_t next = 0; next < queue.size(); ++next) {
        for (const Index neighbor : neighborhood_.of(queue[next])) {
          if (component_[neighbor] != kNowhere) continue;
          component_[neighbor] = static_cast<Index>(count);
          queue.push_back(neighbor);
        }
      }
      ++count;
    }
    manifold_.assign(count, true);
    for (Index e = 0; e < edges_.count(); ++e) {
      if (edges_.triangle_count(e) > 2) manifold_[component_[edges_.vertices[e][0]]] = false;
    }
  }

  bool is_usable(Index edge) const { return manifold_[component_[edges_.vertices[edge][0]]]; }

  /// The other edge of the triangle at `vertex`, an end of `edge`.
  Index edge_beside(Index triangle, Index edge, Index vertex) const {
    for (const Index other : edges_.of_triangle[triangle]) {
      const auto& ends = edges_.vertices[other];
      if (other != edge && (ends[0] == vertex || ends[1] == vertex)) return other;
    }
    return kNowhere;
  }

  Index other_end(Index edge, Index vertex) const {
    const auto& ends = edges_.vertices[edge];
    return ends[0] == vertex ? ends[1] : ends[0];
  }

  void find_boundaries() {
    boundary_of_.assign(edges_.count(), kNowhere);
    std::vector<Index> firsts;
    for (Index e = 0; e < edges_.count(); ++e) {
      if (edges_.triangle_count(e) == 1 && is_usable(e)) firsts.push_back(e);
    }
    ranges::sort(firsts.begin(), firsts.end(),
                 [&](Index a, Index b) { return edges_.vertices[a] < edges_.vertices[b]; });
    for (const Index first : firsts) {
      if (boundary_of_[first] == kNowhere) follow_boundary(first);
    }
    boundary_count_ = loops_.size();
  }

  void follow_boundary(Index first) {
    const auto number = static_cast<Index>(loops_.size());
    SurfaceLoop loop;
    loop.boundary = true;
    loop.name = "boundary-" + std::to_string(number + 1);
    Index edge = first;
    Index at = starts_at(first);
    while (boundary_of_[edge] == kNowhere) {
      boundary_of_[edge] = number;
      loop.vertices.push_back(at);
      at = other_end(edge, at);
      // Rotates around the vertex to the next boundary edge.
      Index triangle = edges_.triangles(edge)[0];
      for (edge = edge_beside(triangle, edge, at); edges_.triangle_count(edge) == 2;) {
        const auto sides = edges_.triangles(edge);
        triangle = sides[0] == triangle ? sides[1] : sides[0];
        edge = edge_beside(triangle, edge, at);
      }
    }
    add(std::move(loop));
  }

  /// The end at which a boundary edge starts in its triangle's winding.
  Index starts_at(Index edge) const {
    const Index t = edges_.triangles(edge)[0];
    for (int m = 0; m < 3; ++m) {
      if (edges_.of_triangle[t][m] == edge) return mesh_.triangles[t][m];
    }
    return kNowhere;
  }

  double edge_length(Index a, Index b) const {
    return static_cast<double>((mesh_.positions[a] - mesh_.positions[b]).norm());
  }

  void add(SurfaceLoop loop) {
    loop.component = component_[loop.vertices[0]];
    for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
      const Index a = loop.vertices[i], b = loop.vertices[(i + 1) % loop.vertices.size()];
      const double length = edge_length(a, b);
      loop.length += length;
      loop.center += length / 2 * (mesh_.positions[a] + mesh_.positions[b]).cast<double>();
    }
    if (loop.length > 0) loop.center /= loop.length;
    loops_.push_back(std::move(loop));
  }

  /// Shortest-path trees along edges from the first vertex of each component.
  void find_tree() {
    parent_.assign(mesh_.vertex_count(), kNowhere);
    std::vector<bool> begun(manifold_.size());
    for (Index v = 0; v < component_.size(); ++v) {
      if (component_[v] == kNowhere || begun[component_[v]]) continue;
      begun[component_[v]] = true;
      ways_.offer(v, 0);
    }
    while (const auto reached = ways_.next()) {
      const auto [distance, v] = *reached;
      for (const Index neighbor : neighborhood_.of(v)) {
        if (ways_.offer(neighbor, distance + edge_length(v, neighbor))) parent_[neighbor] = v;
      }
    }
  }

  /// Edges outside the tree and outside a spanning tree of triangles and filled boundaries. The
  /// latter takes the edges of the longest loops first.
  void find_handles() {
    struct LoopEdge {
      double length;
      Index edge;
    };
    std::vector<LoopEdge> candidates;
    for (Index e = 0; e < edges_.count(); ++e) {
      const auto [a, b] = edges_.vertices[e];
      if (!is_usable(e) || edges_.triangle_count(e) == 0) continue;
      if (parent_[a] == b || parent_[b] == a) continue;
      candidates.push_back({ways_.distance(a) + ways_.distance(b) + edge_length(a, b), e});
    }
    ranges::sort(candidates.begin(), candidates.end(), [](const LoopEdge& x, const LoopEdge& y) {
      return std::pair(-x.length, x.edge) < std::pair(-y.length, y.edge);
    });
    const auto triangles = static_cast<Index>(mesh_.triangle_count());
    MergedSets sets(triangles + boundary_count_);
    std::vector<Index> left;
    for (const auto& [length, e] : candidates) {
      const auto sides = edges_.triangles(e);
      const Index other = sides[1] == kNoTriangle ? triangles + boundary_of_[e] : sides[1];
      if (!sets.merge(sides[0], other)) left.push_back(e);
    }
    std::reverse(left.begin(), left.end());
    for (const Index e : left) add_handle(e);
  }

  std::vector<Index> way_to_root(Index v) const {
    std::vector<Index> way = {v};
    while (parent_[way.back()] != kNowhere) way.push_back(parent_[way.back()]);
    return way;
  }

  void add_handle(Index edge) {
    const auto [a, b] = edges_.vertices[edge];
    std::vector<Index> there = way_to_root(a), back = way_to_root(b);
    Index meeting = there.back();
    while (!there.empty() && !back.empty() && there.back() == back.back()) {
      meeting = there.back();
      there.pop_back();
      back.pop_back();
    }
    SurfaceLoop loop;
    loop.name = "loop-" + std::to_string(loops_.size() - boundary_count_ + 1);
    // The loop's own edge closes it, from its last vertex to its first.
    loop.vertices = std::move(back);
    loop.vertices.push_back(meeting);
    loop.vertices.insert(loop.vertices.end(), there.rbegin(), there.rend());
    add(std::move(loop));
  }

  const Mesh& mesh_;
  const Adjacency& neighborhood_;
  MeshEdges edges_;
  std::vector<Index> component_;
  std::vector<bool> manifold_;
  std::vector<Index> boundary_of_;
  std::size_t boundary_count_ = 0;
  ShortestWays<double> ways_;
  std::vector<Index> parent_;
  std::vector<SurfaceLoop> loops_;
};

}  // namespace

std::vector<SurfaceLoop> surface_loops(const Surface& surface) {
  if (surface.mesh.triangles.empty()) return {};
  return LoopFinder(surface.mesh, *surface.neighborhood).find();
}

}  // namespace brindle
