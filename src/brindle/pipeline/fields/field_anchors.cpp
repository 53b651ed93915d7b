#include "brindle/pipeline/fields/field_anchors.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "brindle/base/elementary.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "brindle/geometry/topology.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {
namespace {

/// Mean feature direction of every vertex as a line (N = 2). A crease that zigzags along edges
/// keeps its direction; orthogonal creases cancel.
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

void check_field_anchor(const FieldAnchor& anchor, std::size_t vertices) {
  const bool finite = anchor.direction.allFinite() && std::isfinite(anchor.weight);
  if (anchor.vertex < vertices && finite) return;
  throw Error("smooth field: anchor at vertex " + std::to_string(anchor.vertex) +
              (finite ? ", but the surface has " + std::to_string(vertices)
                      : " has a direction or weight that is not finite; correct or leave it out"));
}

Complex pull_of(const FieldAnchor& anchor, const Adjacency& neighborhood, const Vec3& normal,
                int symmetry) {
  const Vec3 tangent = anchor.direction - anchor.direction.dot(normal) * normal;
  const auto degree = static_cast<float>(neighborhood.of(anchor.vertex).size());
  return anchor.weight * degree * representation(tangent, normal, symmetry);
}

std::vector<float> curvature_differences(std::span<const PrincipalCurvature> curvatures) {
  std::vector<float> difference(curvatures.size());
  for (std::size_t i = 0; i < difference.size(); ++i) {
    difference[i] = std::abs(curvatures[i].maximum - curvatures[i].minimum);
  }
  return difference;
}

void add_curvature_anchors(PhaseGraph& graph, std::span<const Vec3> normals,
                           std::span<const PrincipalCurvature> curvatures, float scale,
                           const SmoothFieldOptions& options) {
  const DirectionField directions =
      curvature_direction_field(curvatures, options.curvature_direction);
  const std::vector<float> difference = curvature_differences(curvatures);
  const float factor = scale > 0 ? 1 / scale : 0;
  for (Index i = 0; i < curvatures.size(); ++i) {
    const float trust = std::min(1.0f, difference[i] * factor);
    const auto degree = static_cast<float>(graph.adjacency->of(i).size());
    graph.anchor[i] += options.curvature_anchor * trust * degree *
                       representation(directions[i], normals[i], options.symmetry);
  }
}

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
