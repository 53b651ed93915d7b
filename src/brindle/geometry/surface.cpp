#include "brindle/surface.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

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

}  // namespace brindle
