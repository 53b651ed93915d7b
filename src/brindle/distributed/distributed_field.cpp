#include "brindle/distributed/distributed_field.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "brindle/curvature.h"
#include "brindle/distributed/levels/gathered_graph.h"
#include "brindle/distributed/levels/seeded_start.h"
#include "brindle/distributed/surface/piece_curvatures.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/distributed/surface/selection.h"
#include "brindle/distributed_surface.h"
#include "brindle/error.h"
#include "brindle/geometry/neighborhood.h"
#include "brindle/orientation.h"
#include "brindle/phases/multilevel.h"
#include "brindle/pipeline/fields/curvature_anchors.h"
#include "brindle/pipeline/fields/feature_anchors.h"
#include "brindle/pipeline/fields/field_anchors.h"
#include "brindle/pipeline/fields/known_directions.h"
#include "brindle/solver.h"
#include "brindle/waves/direction_graph.h"
#include "brindle/waves/least_curl.h"

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

/// Gives ghosts and the rest the directions of their owners.
DirectionField to_piece(const RankSurface& surface, DirectionField directions) {
  directions.resize(surface.vertex_count());
  surface.exchange_all(std::span(directions));
  return surface.to_piece(std::span<const Vec3>(directions));
}

/// The same of directions that are signed first.
DirectionField of_piece(const RankSurface& surface, DirectionField directions,
                        HierarchyBounds bounds = {}) {
  if (surface.ranks->size() > 1 && surface.vertices < bounds.planned_below()) {
    orient_as_one(surface, directions);
  } else {
    orient_alike(*surface.graph.adjacency, directions);
  }
  return to_piece(surface, std::move(directions));
}

/// From the coarsest level down. A field that is drawn to the last one has one start, and one that
/// cannot be turned to the least curl.
LowestPhases solved(const RankSurface& surface, const PhaseGraph& graph,
                    const SmoothFieldOptions& options, HierarchyBounds bounds, Starts starts) {
  DistributedHierarchy hierarchy(*surface.ranks, surface.graph, own_ids(surface), bounds);
  load_couplings(graph, hierarchy.finest().layout(), hierarchy.finest().couplings);
  hierarchy.coarsen();
  LowestPhases phases;
  if (surface.vertices >= bounds.planned_below()) {
    phases = seeded_start(*surface.ranks, surface.graph, graph, own_ids(surface), starts,
                          options.sweeps, options.cycles);
    hierarchy.start_from(phases.z, options.sweeps);
  } else if (starts == Starts::several) {
    phases.is_lower = hierarchy.descend_from_several(options.sweeps);
  } else {
    hierarchy.descend(options.sweeps);
  }
  hierarchy.run_cycles(options.sweeps, options.cycles, {});
  phases.z = to_nodes(hierarchy.finest().layout(), hierarchy.finest().z);
  return phases;
}

/// As those of one process: where another start has found them, or that more than halves their
/// curl, they turn as a whole until it is least.
void turn_to_least_curl(const RankSurface& surface, const PhaseGraph& graph, int symmetry,
                        bool is_lower, DirectionField& directions) {
  if (surface.ranks->any(!turns_freely(graph, symmetry))) return;
  directions.resize(surface.vertex_count());
  surface.exchange_all(std::span(directions));
  const CurlSums sums = surface.ranks->sum(curl_sums(surface.mesh, directions, surface.normals));
  turn_to_least_curl(sums, is_lower, surface.normals, directions);
  directions.resize(surface.graph.node_count());
}

/// Descents start from the coarsest level, not from the last field: they are drawn to it more.
constexpr float kPullOfDescents = 3;

/// The last field at the graph's nodes, as their owners have it.
KnownDirections last_of_nodes(const RankSurface& surface, const KnownDirections& last) {
  KnownDirections known{DirectionField(surface.vertex_count(), Vec3::Zero()),
                        std::vector<float>(surface.vertex_count()), kPullOfDescents * last.weight};
  for (std::size_t v = 0; v < last.directions.size(); ++v) {
    const Index vertex = surface.vertex_of_piece[v];
    known.directions[vertex] = last.directions[v];
    known.confidence[vertex] = last.confidence.empty() ? 1 : last.confidence[v];
  }
  surface.exchange_all(std::span(known.directions));
  surface.exchange_all(std::span(known.confidence));
  known.directions.resize(surface.graph.node_count());
  known.confidence.resize(surface.graph.node_count());
  return known;
}

/// Whether there is a last field, on all ranks.
bool follows(const RankSurface& surface, const SmoothFieldOptions& options) {
  const bool any = surface.ranks->any(!options.last.directions.empty());
  surface.ranks->together([&] {
    const std::size_t vertices = surface.vertex_of_piece.size();
    check_known(options.last, vertices, "the last field");
    if (any && vertices > 0 && options.last.directions.empty()) {
      throw Error("smooth field: the last field must be there on all ranks or on none");
    }
  });
  return any;
}

DirectionField following_field(const RankSurface& surface, PhaseGraph& graph,
                               std::vector<float> of_curvature, const SmoothFieldOptions& options,
                               HierarchyBounds bounds) {
  Communicator& ranks = *surface.ranks;
  const auto normals = std::span(surface.normals).first(surface.graph.node_count());
  const KnownDirections known = last_of_nodes(surface, options.last);
  ScreenedOptions screened;
  screened.own = surface.graph.own;
  screened.exchange = [&](std::span<Complex> values) {
    exchange(ranks, surface.graph.halo, values);
  };
  screened.total = [&](double here) { return ranks.sum(here); };
  LastValues last = last_values(known, normals, options.symmetry);
  last.noisy = std::move(of_curvature);
  follow_last(
      graph, last, surface.vertices,
      [&] { return solved(surface, graph, options, bounds, Starts::one).z; }, screened);
  const std::vector<Complex> u = solved(surface, graph, options, bounds, Starts::one).z;
  DirectionField field = directions_of(u, normals, options.symmetry);
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Vec3 before = tangent_direction(known.directions[i], normals[i]);
    if (!before.isZero(0)) field[i] = direction_near(before, u[i], normals[i], options.symmetry);
  }
  return to_piece(surface, std::move(field));
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
  ranks.together([&] {
    check_smoothing(options);
    if (options.normal_radius > 0) {
      throw Error("smooth field: normals are averaged by one process alone; take a radius of 0");
    }
  });
  if (surface.vertices == 0) return {};
  const auto normals = std::span(surface.normals).first(surface.graph.node_count());
  PhaseGraph graph = build_direction_graph(surface.graph.adjacency, normals, options.symmetry);
  if (options.curvature_anchor > 0) add_curvature(surface, options, graph);
  std::vector<float> of_curvature = anchor_strengths(graph);
  if (options.feature_anchor > 0) add_features(distributed, options, graph);
  add_anchors(surface, options.anchors, options.symmetry, graph);
  if (follows(surface, options)) {
    return following_field(surface, graph, std::move(of_curvature), options, bounds);
  }
  const bool is_one = ranks.any(starts_of_field(graph, true) == Starts::one);
  const Starts starts = is_one ? Starts::one : Starts::several;
  const LowestPhases phases = solved(surface, graph, options, bounds, starts);
  DirectionField field = directions_of(phases.z, normals, options.symmetry);
  turn_to_least_curl(surface, graph, options.symmetry, phases.is_lower, field);
  return of_piece(surface, std::move(field), bounds);
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
