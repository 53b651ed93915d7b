#include "brindle/distributed/distributed_field.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "brindle/curvature.h"
#include "brindle/distributed/gathered_graph.h"
#include "brindle/distributed/piece_curvatures.h"
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

/// Signs own directions like their neighbours, as one process does.
void orient_as_one(const RankSurface& surface, DirectionField& directions) {
  Communicator& ranks = *surface.ranks;
  const GatheredGraph graph =
      gather_graph(ranks, surface.graph, numbers_by_id(ranks, own_ids(surface)));
  const std::span<const Vec3> own = std::span(directions).first(surface.graph.own);
  const auto gathered = joined<std::array<float, 3>>(ranks.gather(std::as_bytes(own)));
  std::vector<std::vector<std::uint8_t>> turned(static_cast<std::size_t>(ranks.size()));
  ranks.together([&] {
    if (ranks.rank() != 0) return;
    DirectionField whole(gathered.size());
    const auto before = [&](Index node) { return Vec3(gathered[node].data()); };
    for (Index node = 0; node < gathered.size(); ++node) {
      whole[graph.number_of[node]] = before(node);
    }
    orient_alike(graph.adjacency(), whole);
    for (std::size_t r = 0; r < turned.size(); ++r) {
      for (Index node = graph.first_node[r]; node < graph.first_node[r + 1]; ++node) {
        turned[r].push_back(whole[graph.number_of[node]].dot(before(node)) < 0 ? 1 : 0);
      }
    }
  });
  const std::vector<std::uint8_t> own_turned = ranks.swap_lists(turned)[0];
  for (std::size_t v = 0; v < own_turned.size(); ++v) {
    if (own_turned[v]) directions[v] = -directions[v];
  }
}

/// Signs directions, gives ghosts and the rest those of their owners.
DirectionField of_piece(const RankSurface& surface, DirectionField directions,
                        HierarchyBounds bounds = {}) {
  if (surface.ranks->size() > 1 && surface.vertices < bounds.plan_below) {
    orient_as_one(surface, directions);
  } else {
    orient_alike(*surface.graph.adjacency, directions);
  }
  directions.resize(surface.vertex_count());
  surface.exchange_all(std::span(directions));
  return surface.to_piece(std::span<const Vec3>(directions));
}

}  // namespace

DirectionField smooth_direction_field(const DistributedSurface& surface,
                                      const SmoothFieldOptions& options) {
  return smooth_direction_field(surface, options, HierarchyBounds());
}

DirectionField smooth_direction_field(const DistributedSurface& distributed,
                                      const SmoothFieldOptions& options, HierarchyBounds bounds) {
  const RankSurface& surface = distributed.rank_surface();
  Communicator& ranks = *surface.ranks;
  ranks.together([&] { check(options); });
  if (surface.vertices == 0) return {};
  const auto normals = std::span(surface.normals).first(surface.graph.node_count());
  PhaseGraph graph = build_direction_graph(surface.graph.adjacency, normals, options.symmetry);
  if (options.curvature_anchor > 0) add_curvature(surface, options, graph);
  if (options.feature_anchor > 0) add_features(distributed, options, graph);
  add_anchors(surface, options.anchors, options.symmetry, graph);
  DistributedHierarchy hierarchy(ranks, surface.graph, own_ids(surface), bounds);
  load_couplings(graph, hierarchy.finest().layout(), hierarchy.finest().couplings);
  hierarchy.coarsen();
  hierarchy.descend(options.sweeps);
  hierarchy.run_cycles(options.sweeps, options.cycles, {});
  const std::vector<Complex> z = to_nodes(hierarchy.finest().layout(), hierarchy.finest().z);
  return of_piece(surface, directions_of(z, normals, options.symmetry), bounds);
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
