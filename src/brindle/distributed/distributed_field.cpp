#include "brindle/distributed/distributed_field.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brindle/distributed/averaged_piece.h"
#include "brindle/distributed/distributed_strokes.h"
#include "brindle/distributed/levels/gathered_graph.h"
#include "brindle/distributed/levels/seeded_start.h"
#include "brindle/distributed/surface/piece_curvatures.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/distributed/surface/selection.h"
#include "brindle/distributed_surface.h"
#include "brindle/error.h"
#include "brindle/geometry/topology.h"
#include "brindle/normals.h"
#include "brindle/orientation.h"
#include "brindle/phases/multilevel.h"
#include "brindle/pipeline/fields/averaged_normals.h"
#include "brindle/pipeline/fields/field_anchors.h"
#include "brindle/pipeline/fields/followed_field.h"
#include "brindle/solver.h"
#include "brindle/waves/direction_graph.h"
#include "brindle/waves/least_curl.h"

namespace brindle {
namespace {

/// A piece as a field sees it: with the surface's normals, or averages of these, of all vertices.
struct SeenPiece {
  const DistributedSurface& distributed;
  std::span<const Vec3> normals;

  const RankSurface& surface() const { return distributed.rank_surface(); }
  std::span<const Vec3> of_nodes() const { return normals.first(surface().graph.node_count()); }
};

/// Of own vertices; ghosts' entries mean nothing.
std::vector<PrincipalCurvature> own_curvatures(const SeenPiece& seen) {
  const RankSurface& surface = seen.surface();
  return principal_curvatures(std::span(surface.mesh.positions).first(seen.of_nodes().size()),
                              seen.of_nodes(), *surface.graph.adjacency);
}

void add_curvature(const SeenPiece& seen, const SmoothFieldOptions& options, PhaseGraph& graph) {
  const RankSurface& surface = seen.surface();
  auto curvatures = own_curvatures(seen);
  curvatures.resize(surface.graph.own);
  const std::vector<float> difference = curvature_differences(curvatures);
  const float scale = kth_smallest(*surface.ranks, difference, surface.vertices * 9 / 10);
  graph.anchor.resize(graph.node_count());
  add_curvature_anchors(graph, seen.normals, curvatures, scale, options);
}

/// Those of own vertices.
void add_anchors(const SeenPiece& seen, std::span<const FieldAnchor> anchors, int symmetry,
                 PhaseGraph& graph) {
  const RankSurface& surface = seen.surface();
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
        pull_of(anchor, *graph.adjacency, seen.normals[anchor.vertex], symmetry);
  }
}

/// At own vertices, all of whose triangles are here.
void add_features(const SeenPiece& seen, const SmoothFieldOptions& options, PhaseGraph& graph) {
  if (options.feature_radius > 0) {
    const std::vector<FieldStroke> strokes =
        feature_strokes(seen.distributed, options.feature_angle_deg, options.feature_radius,
                        options.feature_anchor);
    const auto anchors = stroke_anchors(seen.distributed, strokes, seen.normals);
    return add_anchors(seen, anchors, options.symmetry, graph);
  }
  const Mesh mesh = triangles_around_own(seen.surface());
  graph.anchor.resize(graph.node_count());
  add_feature_anchors(graph, mesh, vertex_neighborhood(mesh), seen.normals, options);
}

/// Returns how strongly curvature attracts.
std::vector<float> add_all_anchors(const SeenPiece& seen, const SmoothFieldOptions& options,
                                   PhaseGraph& graph) {
  if (options.curvature_anchor > 0) add_curvature(seen, options, graph);
  std::vector<float> of_curvature = anchor_strengths(graph);
  if (options.feature_anchor > 0) add_features(seen, options, graph);
  add_anchors(seen, options.anchors, options.symmetry, graph);
  return of_curvature;
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

DistributedHierarchy hierarchy_of(const RankSurface& surface, const PhaseGraph& graph,
                                  HierarchyBounds bounds) {
  DistributedHierarchy hierarchy(*surface.ranks, surface.graph, own_ids(surface), bounds);
  load_couplings(graph, hierarchy.finest().layout(), hierarchy.finest().couplings);
  hierarchy.coarsen();
  return hierarchy;
}

/// From the coarsest level down. A field that is drawn to the last one has one start, and one that
/// cannot be turned to the least curl.
LowestPhases solved(const RankSurface& surface, const PhaseGraph& graph,
                    const SmoothFieldOptions& options, HierarchyBounds bounds, Starts starts) {
  DistributedHierarchy hierarchy = hierarchy_of(surface, graph, bounds);
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

/// From the field of other normals, or, where there is none, as above.
LowestPhases solved_from(const SeenPiece& seen, const PhaseGraph& graph,
                         std::optional<SeenField> from, const SmoothFieldOptions& options,
                         HierarchyBounds bounds) {
  const RankSurface& surface = seen.surface();
  if (!from) {
    const bool is_one = surface.ranks->any(starts_of_field(graph, true) == Starts::one);
    return solved(surface, graph, options, bounds, is_one ? Starts::one : Starts::several);
  }
  std::vector<Complex> start = values_at(*std::move(from), seen.of_nodes(), options.symmetry);
  std::ranges::replace(start, Complex(0), kPeak);
  DistributedHierarchy hierarchy = hierarchy_of(surface, graph, bounds);
  hierarchy.begin_with(start);
  hierarchy.run_cycles(options.sweeps, std::max(1, options.cycles), {});
  return {to_nodes(hierarchy.finest().layout(), hierarchy.finest().z)};
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

DirectionField following_field(const SeenPiece& seen, PhaseGraph& graph,
                               std::vector<float> of_curvature, const SmoothFieldOptions& options,
                               HierarchyBounds bounds) {
  const RankSurface& surface = seen.surface();
  const std::span<const Vec3> normals = seen.of_nodes();
  const KnownDirections known = last_of_nodes(surface, options.last);
  LastValues last = last_values(known, normals, options.symmetry);
  last.noisy = std::move(of_curvature);
  follow_last(
      graph, last, surface.vertices,
      [&] { return solved(surface, graph, options, bounds, Starts::one).z; },
      part_of_ranks(surface));
  const std::vector<Complex> u = solved(surface, graph, options, bounds, Starts::one).z;
  DirectionField field = directions_of(u, normals, options.symmetry);
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Vec3 before = tangent_direction(known.directions[i], normals[i]);
    if (!before.isZero(0)) field[i] = direction_near(before, u[i], normals[i], options.symmetry);
  }
  turn_to_normals(normals, surface.normals, field);
  return to_piece(surface, std::move(field));
}

/// As in one process: the field that the one of the first of `normals` begins with.
std::optional<SeenField> field_from_afar(const DistributedSurface& distributed,
                                         const std::vector<std::vector<Vec3>>& normals,
                                         const SmoothFieldOptions& options,
                                         HierarchyBounds bounds) {
  std::optional<SeenField> field;
  for (std::size_t i = normals.size(); i-- > 1;) {
    const SeenPiece seen{distributed, normals[i]};
    const std::span<const Vec3> of_nodes = seen.of_nodes();
    PhaseGraph graph =
        build_direction_graph(seen.surface().graph.adjacency, of_nodes, options.symmetry);
    add_all_anchors(seen, options, graph);
    const LowestPhases phases = solved_from(seen, graph, std::move(field), options, bounds);
    field = {{of_nodes.begin(), of_nodes.end()},
             directions_of(phases.z, of_nodes, options.symmetry)};
  }
  return field;
}

DirectionField field_of(const SeenPiece& seen, std::optional<SeenField> from,
                        const SmoothFieldOptions& options, HierarchyBounds bounds, bool goes_on) {
  const RankSurface& surface = seen.surface();
  const std::span<const Vec3> normals = seen.of_nodes();
  PhaseGraph graph = build_direction_graph(surface.graph.adjacency, normals, options.symmetry);
  std::vector<float> of_curvature = add_all_anchors(seen, options, graph);
  if (goes_on) return following_field(seen, graph, std::move(of_curvature), options, bounds);
  const LowestPhases phases = solved_from(seen, graph, std::move(from), options, bounds);
  DirectionField field = directions_of(phases.z, normals, options.symmetry);
  turn_to_normals(normals, surface.normals, field);
  turn_to_least_curl(surface, graph, options.symmetry, phases.is_lower, field);
  return of_piece(surface, std::move(field), bounds);
}

}  // namespace

DirectionField smooth_direction_field(const DistributedSurface& surface,
                                      const SmoothFieldOptions& options) {
  return smooth_direction_field(surface, options, HierarchyBounds());
}

DirectionField smooth_direction_field(const DistributedSurface& distributed,
                                      const SmoothFieldOptions& options, HierarchyBounds bounds) {
  const RankSurface& surface = distributed.rank_surface();
  surface.ranks->together([&] { check_smoothing(options); });
  if (surface.vertices == 0) return {};
  const bool goes_on = follows(surface, options);
  if (options.normal_radius == 0) {
    return field_of({distributed, surface.normals}, std::nullopt, options, bounds, goes_on);
  }
  const std::vector<float> radii = averaging_radii(options.normal_radius, goes_on);
  // Couplings that differ by rounding make other levels, and another field.
  const std::vector<std::vector<Vec3>> normals = surface.vertices < bounds.planned_below()
                                                     ? averaged_on_first(surface, radii)
                                                     : averaged_normals(surface, radii);
  std::optional<SeenField> from = field_from_afar(distributed, normals, options, bounds);
  return field_of({distributed, normals[0]}, std::move(from), options, bounds, goes_on);
}

std::vector<float> greatest_curvatures(const DistributedSurface& distributed) {
  const RankSurface& surface = distributed.rank_surface();
  std::vector<float> values;
  for (const PrincipalCurvature& c : own_curvatures({distributed, surface.normals})) {
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
  const auto curvatures = own_curvatures({distributed, surface.normals});
  return of_piece(surface, curvature_direction_field(curvatures, direction));
}

}  // namespace brindle
