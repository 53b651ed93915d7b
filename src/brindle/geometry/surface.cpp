#include "brindle/surface.h"

#include <algorithm>
#include <string>
#include <utility>

#include "brindle/error.h"
#include "brindle/geometry/edge_lengths.h"
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

Surface make_surface(Mesh mesh, const Progress& progress) {
  JobStages stages(progress, {{"corners", 3}, {"neighborhood", 5}, {"normals", 4}});
  const Progress corners = stages.begin("corners");
  check_mesh(mesh);
  corners.report(0.2);
  const VertexTriangles around = vertex_triangles(mesh);
  Surface surface;
  surface.neighborhood = std::make_shared<const Adjacency>(
      vertex_neighborhood(mesh, around, stages.begin("neighborhood")));
  check_edge_lengths(edge_lengths(mesh.positions, *surface.neighborhood));
  surface.normals = vertex_normals(mesh, around, stages.begin("normals"));
  stages.finish();
  surface.mesh = std::move(mesh);
  return surface;
}

}  // namespace brindle
