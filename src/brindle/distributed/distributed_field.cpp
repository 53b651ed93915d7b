#include <limits>
#include <string>
#include <vector>

#include "brindle/curvature.h"
#include "brindle/distributed/piece_curvatures.h"
#include "brindle/distributed/rank_hierarchy.h"
#include "brindle/distributed/rank_surface.h"
#include "brindle/distributed/selection.h"
#include "brindle/distributed_surface.h"
#include "brindle/error.h"
#include "brindle/geometry/neighborhood.h"
#include "brindle/phases/multilevel.h"
#include "brindle/pipeline/curvature_anchors.h"
#include "brindle/pipeline/feature_anchors.h"
#include "brindle/pipeline/field_anchors.h"
#include "brindle/waves/direction_graph.h"
#include "brindle/waves/orientation.h"

namespace brindle {
namespace {

/// Where fields are gathered: as stripes are by default.
constexpr std::size_t kGatherFieldsBelow = 16384;

/// Of own vertices; ghosts' entries mean nothing.
std::vector<PrincipalCurvature> own_curvatures(const RankSurface& surface) {
  const std::size_t nodes = surface.graph.node_count();
  return principal_curvatures(std::span(surface.mesh.positions).first(nodes),
                              std::span(surface.normals).first(nodes), *surface.graph.adjacency);
}

void add_curvature(const RankSurface& surface, const SmoothFieldOptions& options,
                   PhaseGraph& graph) {
  auto curvatures = own_curvatures(surface);
  curvatures.resize(surface.graph.own);
  const std::vector<float> difference = curvature_differences(curvatures);
  const float scale = kth_smallest(*surface.ranks, difference, surface.vertices * 9 / 10);
  graph.anchor.resize(graph.node_count());
  add_curvature_anchors(graph, surface.normals, curvatures, scale, options);
}

/// Those of own vertices.
void add_anchors(const RankSurface& surface, std::span<const FieldAnchor> anchors, int symmetry,
                 PhaseGraph& graph) {
  surface.ranks->together([&] {
    for (const FieldAnchor& anchor : anchors) {
      check_field_anchor(anchor, surface.vertex_of_piece.size());
    }
  });
  if (!surface.ranks->any(!anchors.empty())) return;
  graph.anchor.resize(graph.node_count());
  for (FieldAnchor anchor : anchors) {
    anchor.vertex = surface.vertex_of_piece[anchor.vertex];
    if (anchor.vertex >= surface.graph.own) continue;
    graph.anchor[anchor.vertex] +=
        pull_of(anchor, *graph.adjacency, surface.normals[anchor.vertex], symmetry);
  }
}

/// At own vertices, all of whose triangles are here.
void add_features(const DistributedSurface& distributed, const SmoothFieldOptions& options,
                  PhaseGraph& graph) {
  const RankSurface& surface = distributed.rank_surface();
  if (options.feature_radius > 0) {
    const std::vector<FieldStroke> strokes = feature_strokes(
        distributed, options.feature_angle_deg, options.feature_radius, options.feature_anchor);
    return add_anchors(surface, stroke_anchors(distributed, strokes), options.symmetry, graph);
  }
  const Mesh mesh = triangles_around_own(surface);
  graph.anchor.resize(graph.node_count());
  add_feature_anchors(graph, mesh, vertex_neighborhood(mesh), surface.normals, options);
}

/// Signs own directions like their neighbours, gives ghosts and the rest those of their owners.
DirectionField of_piece(const RankSurface& surface, DirectionField directions) {
  orient_alike(*surface.graph.adjacency, directions);
  directions.resize(surface.vertex_count());
  surface.exchange_all(std::span(directions));
  return surface.to_piece(std::span<const Vec3>(directions));
}

}  // namespace

DirectionField smooth_direction_field(const DistributedSurface& distributed,
                                      const SmoothFieldOptions& options) {
  const RankSurface& surface = distributed.rank_surface();
  Communicator& ranks = *surface.ranks;
  ranks.together([&] { check(options); });
  if (surface.vertices == 0) return {};
  const auto normals = std::span(surface.normals).first(surface.graph.node_count());
  PhaseGraph graph = build_direction_graph(surface.graph.adjacency, normals, options.symmetry);
  if (options.curvature_anchor > 0) add_curvature(surface, options, graph);
  if (options.feature_anchor > 0) add_features(distributed, options, graph);
  add_anchors(surface, options.anchors, options.symmetry, graph);
  RankHierarchy hierarchy(ranks, surface.graph, kGatherFieldsBelow);
  load_couplings(graph, hierarchy.finest().layout(), hierarchy.finest().couplings);
  hierarchy.coarsen();
  hierarchy.descend(options.sweeps);
  hierarchy.run_cycles(options.sweeps, options.cycles, {});
  const std::vector<Complex> z = to_nodes(hierarchy.finest().layout(), hierarchy.finest().z);
  return of_piece(surface, directions_of(z, normals, options.symmetry));
}

std::vector<float> greatest_curvatures(const DistributedSurface& distributed) {
  const RankSurface& surface = distributed.rank_surface();
  std::vector<float> values;
  for (const PrincipalCurvature& c : own_curvatures(surface)) {
    const bool none = c.maximum_direction.isZero(0);
    values.push_back(none ? std::numeric_limits<float>::quiet_NaN() : c.maximum);
  }
  values.resize(surface.vertex_count());
  surface.exchange_all(std::span(values));
  return surface.to_piece(std::span<const float>(values));
}

DirectionField curvature_direction_field(const DistributedSurface& distributed,
                                         CurvatureDirection direction) {
  const RankSurface& surface = distributed.rank_surface();
  return of_piece(surface, curvature_direction_field(own_curvatures(surface), direction));
}

}  // namespace brindle
