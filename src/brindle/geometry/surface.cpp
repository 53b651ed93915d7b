#include "brindle/surface.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>

#include "brindle/base/graph.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/geometry/crease_edges.h"
#include "brindle/geometry/measures.h"
#include "brindle/geometry/normals_around.h"
#include "brindle/geometry/topology.h"

namespace brindle {
namespace {

void check_triangles(const Mesh& mesh) {
  const auto in_range = [&](const Triangle& triangle) {
    return std::all_of(triangle.begin(), triangle.end(),
                       [&](Index vertex) { return vertex < mesh.vertex_count(); });
  };
  const auto bad = std::find_if_not(mesh.triangles.begin(), mesh.triangles.end(), in_range);
  if (bad == mesh.triangles.end()) return;
  throw Error("surface: triangle " + std::to_string(bad - mesh.triangles.begin()) + " joins " +
              std::to_string((*bad)[0]) + ", " + std::to_string((*bad)[1]) + " and " +
              std::to_string((*bad)[2]) + ", but there are " + std::to_string(mesh.vertex_count()) +
              " vertices, numbered from 0; correct or drop it, as repair_mesh does");
}

/// Number of boundary edges that coincide with another one.
std::size_t coinciding_boundary_edges(const Surface& surface) {
  // Ignores copies at creases.
  const std::vector<Index> first =
      first_at_each_place(std::span(surface.mesh.positions).first(surface.own_vertex_count()));
  bool any = false;
  for (Index v = 0; v < first.size(); ++v) {
    any = any || (first[v] != v && !surface.neighborhood->of(v).empty());
  }
  if (!any) return 0;
  const MeshEdges edges = joined_edges(surface);
  std::vector<std::array<Index, 2>> places;
  for (Index e = 0; e < edges.count(); ++e) {
    if (edges.triangle_count(e) != 1) continue;
    std::array<Index, 2> place{first[edges.vertices[e][0]], first[edges.vertices[e][1]]};
    if (place[0] > place[1]) std::swap(place[0], place[1]);
    if (place[0] != place[1]) places.push_back(place);
  }
  ranges::sort(places.begin(), places.end());
  std::size_t count = 0;
  for (auto begin = places.begin(); begin != places.end();) {
    const auto end = std::find_if(begin, places.end(), [&](const auto& p) { return p != *begin; });
    if (end - begin > 1) count += static_cast<std::size_t>(end - begin);
    begin = end;
  }
  return count;
}

}  // namespace

void check_positions(std::span<const Vec3> positions) {
  const auto bad = std::find_if_not(positions.begin(), positions.end(),
                                    [](const Vec3& position) { return position.allFinite(); });
  if (bad == positions.end()) return;
  throw Error("surface: the position of vertex " + std::to_string(bad - positions.begin()) +
              " is not finite; correct it, or move it as repair_mesh does");
}

void check_mesh(const Mesh& mesh) {
  check_positions(mesh.positions);
  check_triangles(mesh);
}

namespace {

/// Normals, and the triangles that they turn.
void add_normals(Surface& surface, const Mesh& mesh, const VertexTriangles& around,
                 const Creases& creases, const Progress& progress) {
  std::vector<TriangleAngles> angles;
  const auto fill = [&](const Progress& part) {
    return fill_vertex_normals(mesh, around, surface.turned, angles, surface.normals, part);
  };
  const std::vector<CreaseNeighbors> links = triangles_over_creases(mesh, around, creases);
  const bool against = fill(progress);
  if (!against && ranges::none_of(links, &CreaseNeighbors::against)) return;
  surface.turned = triangles_to_turn(mesh, around, links);
  if (!surface.turned.empty()) fill({});
}

}  // namespace

std::vector<std::array<Index, 2>> links_over_creases(const Creases& creases) {
  std::vector<std::array<Index, 2>> links;
  for (const CreaseEdge& edge : creases.edges) {
    for (int end = 0; end < 2; ++end) {
      const Index a = edge.first[end], b = edge.second[end];
      if (a != b) links.insert(links.end(), {{a, b}, {b, a}});
    }
  }
  ranges::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

std::shared_ptr<const Adjacency> neighbors_over_creases(const Surface& surface) {
  const Adjacency& neighborhood = *surface.neighborhood;
  const std::vector<std::array<Index, 2>> links = links_over_creases(surface.creases);
  if (links.empty()) return surface.neighborhood;
  auto joined = std::make_shared<Adjacency>();
  joined->offsets.reserve(neighborhood.offsets.size());
  joined->neighbors.reserve(neighborhood.neighbors.size() + links.size());
  auto next = links.begin();
  for (Index v = 0; v < neighborhood.node_count(); ++v) {
    const std::span<const Index> row = neighborhood.of(v);
    joined->neighbors.insert(joined->neighbors.end(), row.begin(), row.end());
    const auto first = next;
    for (; next != links.end() && (*next)[0] == v; ++next) joined->neighbors.push_back((*next)[1]);
    if (next != first) {
      ranges::sort(joined->neighbors.begin() + joined->offsets.back(), joined->neighbors.end());
    }
    joined->offsets.push_back(static_cast<Index>(joined->neighbors.size()));
  }
  return joined;
}

MeshEdges joined_edges(const Surface& surface, const Progress& progress) {
  if (surface.creases.empty()) return mesh_edges(surface.mesh, *surface.neighborhood, progress);
  const Mesh joined = joined_mesh(surface.mesh, surface.creases);
  return mesh_edges(joined, vertex_neighborhood(joined), progress);
}

Surface make_surface(Mesh mesh, const Progress& progress) {
  return make_surface(std::move(mesh), Creases(), progress);
}

Surface make_surface(Mesh mesh, Creases creases, const Progress& progress) {
  JobStages stages(progress, {{"corners", 3}, {"neighborhood", 5}, {"normals", 4}});
  const Progress corners = stages.begin("corners");
  check_mesh(mesh);
  corners.report(0.2);
  const VertexTriangles around = vertex_triangles(mesh);
  Surface surface;
  surface.neighborhood = std::make_shared<const Adjacency>(
      vertex_neighborhood(mesh, around, stages.begin("neighborhood")));
  check_edge_lengths(edge_lengths(mesh.positions, *surface.neighborhood));
  add_normals(surface, mesh, around, creases, stages.begin("normals"));
  stages.finish();
  surface.mesh = std::move(mesh);
  surface.creases = std::move(creases);
  return surface;
}

std::vector<std::string> surface_warnings(const Surface& surface, const std::string& join) {
  const std::size_t count = coinciding_boundary_edges(surface);
  if (count == 0) return {};
  return {std::to_string(count) +
          " boundary edges stand exactly where others do, and the surface is cut there, so that "
          "stripes end; vertices at one place are not joined: " +
          join};
}

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
