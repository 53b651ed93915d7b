#include "brindle/smooth_field.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/curvature.h"
#include "brindle/error.h"
#include "brindle/pipeline/curvature_anchors.h"
#include "brindle/pipeline/feature_anchors.h"
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
  add_feature_anchors(graph, surface.mesh, *surface.neighborhood, surface.normals, options);
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
