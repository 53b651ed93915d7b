#include "brindle/smooth_field.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/curvature.h"
#include "brindle/error.h"
#include "brindle/geometry/feature_edges.h"
#include "brindle/pipeline/curvature_anchors.h"
#include "brindle/pipeline/field_anchors.h"
#include "brindle/solver.h"
#include "brindle/waves/direction_graph.h"
#include "brindle/waves/orientation.h"

namespace brindle {
namespace {

void add_curvature(PhaseGraph& graph, const Surface& surface, const SmoothFieldOptions& options) {
  const auto curvatures =
      principal_curvatures(surface.mesh.positions, surface.normals, *surface.neighborhood);
  std::vector<float> sorted = curvature_differences(curvatures);
  const auto tenth = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 9 / 10);
  std::nth_element(sorted.begin(), tenth, sorted.end());
  add_curvature_anchors(graph, surface.normals, curvatures, *tenth, options);
}

/// At every vertex the mean of its features as lines (N = 2): a crease that the triangles follow in
/// zigzag keeps its direction, and where creases meet across each other they cancel.
std::vector<Complex> feature_lines(const Surface& surface, float angle_deg) {
  const Mesh& mesh = surface.mesh;
  const MeshEdges edges = mesh_edges(mesh, *surface.neighborhood);
  std::vector<Complex> lines(mesh.vertex_count());
  std::vector<float> lengths(mesh.vertex_count());
  for (const auto& [a, b] : feature_edges(mesh, edges, angle_deg)) {
    const Vec3 edge = mesh.positions[b] - mesh.positions[a];
    for (const Index i : {a, b}) {
      const Vec3& normal = surface.normals[i];
      lines[i] += edge.norm() * representation(tangent_direction(edge, normal), normal, 2);
      lengths[i] += edge.norm();
    }
  }
  for (Index i = 0; i < lines.size(); ++i) {
    if (lengths[i] > 0) lines[i] /= lengths[i];
  }
  return lines;
}

void add_anchors(PhaseGraph& graph, const Surface& surface, std::span<const FieldAnchor> anchors,
                 int symmetry) {
  for (const FieldAnchor& anchor : anchors) check_field_anchor(anchor, graph.node_count());
  for (const FieldAnchor& anchor : anchors) {
    graph.anchor[anchor.vertex] +=
        pull_of(anchor, *graph.adjacency, surface.normals[anchor.vertex], symmetry);
  }
}

void add_feature_anchors(PhaseGraph& graph, const Surface& surface,
                         const SmoothFieldOptions& options) {
  if (options.feature_radius > 0) {
    const std::vector<FieldStroke> strokes = feature_strokes(
        surface, options.feature_angle_deg, options.feature_radius, options.feature_anchor);
    return add_anchors(graph, surface, stroke_anchors(surface, strokes), options.symmetry);
  }
  const int half_symmetry = options.symmetry / 2;
  const auto turns = static_cast<float>(half_symmetry);
  const std::vector<Complex> lines = feature_lines(surface, options.feature_angle_deg);
  for (Index i = 0; i < graph.node_count(); ++i) {
    const auto degree = static_cast<float>(graph.adjacency->of(i).size());
    graph.anchor[i] += std::polar(options.feature_anchor * degree * std::abs(lines[i]),
                                  turns * std::arg(lines[i]));
  }
}

}  // namespace

void check(const SmoothFieldOptions& options) {
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw Error(std::string("smooth field: ") + message);
  };
  const auto strength = [](float anchor) { return std::isfinite(anchor) && anchor >= 0; };
  require(options.symmetry >= 1, "the symmetry N must be 1 or above");
  require(strength(options.curvature_anchor) && strength(options.feature_anchor),
          "anchors must be finite numbers of 0 or above");
  require(std::isfinite(options.feature_angle_deg), "the feature angle must be finite");
  require(strength(options.feature_radius), "the feature radius must be finite and 0 or above");
  require(options.feature_anchor == 0 || options.symmetry % 2 == 0,
          "edges have no sign; feature anchors need an even symmetry");
}

DirectionField smooth_direction_field(const Surface& surface, const SmoothFieldOptions& options) {
  check(options);
  check_positions(surface.mesh.positions);
  if (surface.mesh.vertex_count() == 0) return {};
  PhaseGraph graph = build_direction_graph(surface.neighborhood, surface.normals, options.symmetry);
  if (options.curvature_anchor > 0 || options.feature_anchor > 0 || !options.anchors.empty()) {
    graph.anchor.resize(graph.node_count());
  }
  if (options.curvature_anchor > 0) add_curvature(graph, surface, options);
  if (options.feature_anchor > 0) add_feature_anchors(graph, surface, options);
  add_anchors(graph, surface, options.anchors, options.symmetry);
  SolverOptions solver;
  solver.sweeps = options.sweeps;
  solver.cycles = options.cycles;
  const PhaseSolution solution = solve_phases(graph, solver);
  DirectionField field = directions_of(solution.z, surface.normals, options.symmetry);
  orient_alike(*surface.neighborhood, field);
  return field;
}

}  // namespace brindle
