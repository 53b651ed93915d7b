#include "brindle/pipeline/fields/feature_anchors.h"

#include <cmath>
#include <vector>

#include "brindle/base/elementary.h"
#include "brindle/geometry/measures.h"
#include "brindle/geometry/topology.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {
namespace {

/// At every vertex the mean of its features as lines (N = 2): a crease that the triangles follow in
/// zigzag keeps its direction, and where creases meet across each other they cancel.
std::vector<Complex> feature_lines(const Mesh& mesh, const Adjacency& neighborhood,
                                   std::span<const Vec3> normals, float angle_deg) {
  const MeshEdges edges = mesh_edges(mesh, neighborhood);
  std::vector<Complex> lines(mesh.vertex_count());
  std::vector<float> lengths(mesh.vertex_count());
  for (const auto& [a, b] : feature_edges(mesh, edges, angle_deg)) {
    const Vec3 edge = mesh.positions[b] - mesh.positions[a];
    for (const Index i : {a, b}) {
      const Vec3& normal = normals[i];
      lines[i] += edge.norm() * representation(tangent_direction(edge, normal), normal, 2);
      lengths[i] += edge.norm();
    }
  }
  for (Index i = 0; i < lines.size(); ++i) {
    if (lengths[i] > 0) lines[i] /= lengths[i];
  }
  return lines;
}

}  // namespace

void add_feature_anchors(PhaseGraph& graph, const Mesh& mesh, const Adjacency& neighborhood,
                         std::span<const Vec3> normals, const SmoothFieldOptions& options) {
  const int half_symmetry = options.symmetry / 2;
  const auto turns = static_cast<float>(half_symmetry);
  const std::vector<Complex> lines =
      feature_lines(mesh, neighborhood, normals, options.feature_angle_deg);
  for (Index i = 0; i < graph.node_count(); ++i) {
    const auto degree = static_cast<float>(graph.adjacency->of(i).size());
    graph.anchor[i] += elementary::polar(options.feature_anchor * degree * std::abs(lines[i]),
                                         turns * elementary::arg(lines[i]));
  }
}

}  // namespace brindle
