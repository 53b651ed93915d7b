// Fields that rank 0 computes on the whole surface, as one process does.
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

#include "brindle/direction_field.h"
#include "brindle/distributed/surface/gathered_surface.h"
#include "brindle/distributed_surface.h"
#include "brindle/distributed_waves.h"
#include "brindle/error.h"
#include "brindle/normals.h"
#include "brindle/pipeline/fields/field_anchors.h"

namespace brindle {
namespace {

/// The anchors of own vertices, on rank 0.
std::vector<FieldAnchor> anchors_of_whole(const GatheredSurface& whole,
                                          std::span<const FieldAnchor> of_piece) {
  const RankSurface& piece = whole.piece();
  std::vector<FieldAnchor> own, all;
  for (FieldAnchor anchor : of_piece) {
    anchor.vertex = piece.vertex_of_piece[anchor.vertex];
    if (anchor.vertex >= piece.graph.own) continue;
    anchor.vertex = whole.row_of(anchor.vertex);
    own.push_back(anchor);
  }
  PartsOnFirst(*piece.ranks, own.size()).gather(std::span<const FieldAnchor>(own), all);
  for (FieldAnchor& anchor : all) anchor.vertex = whole.vertex_of_row(anchor.vertex);
  return all;
}

/// Throws on all ranks for options that do not fit a partition.
void check_pieces(const RankSurface& surface, const SmoothFieldOptions& options) {
  const bool any = surface.ranks->any(!options.last.directions.empty());
  surface.ranks->throw_on_all([&] {
    const std::size_t vertices = surface.vertex_of_piece.size();
    for (const FieldAnchor& anchor : options.anchors) check_field_anchor(anchor, vertices);
    check_known(options.last, vertices, "the last field");
    if (any && vertices > 0 && options.last.directions.empty()) {
      throw Error("smooth field: the last field must be there on all ranks or on none");
    }
  });
}

/// The owners' last field, on rank 0.
KnownDirections last_of_whole(const GatheredSurface& whole, const KnownDirections& last) {
  Communicator& ranks = *whole.piece().ranks;
  KnownDirections all;
  all.weight = last.weight;
  if (!ranks.any(!last.directions.empty())) return all;
  all.directions = whole.of_vertices(last.directions);
  if (!ranks.any(!last.confidence.empty())) return all;
  std::vector<float> confidence = last.confidence;
  confidence.resize(last.directions.size(), 1);
  all.confidence = whole.of_vertices(confidence);
  return all;
}

/// Returns what `make` computes on rank 0 from the principal curvatures of the whole, at the
/// partition's vertices.
template <class Make>
auto of_curvatures(const RankSurface& surface, const Make& make) {
  const GatheredSurface whole(surface);
  return whole.to_piece(whole.on_first([&](const Surface& all) {
    return make(all, principal_curvatures(all.mesh.positions, all.normals, *all.neighborhood));
  }));
}

/// Rank 0's strokes on all ranks; they share one radius and strength.
std::vector<FieldStroke> of_first_rank(Communicator& ranks, const std::vector<FieldStroke>& strokes,
                                       double radius, double strength) {
  std::vector<std::uint64_t> counts;
  std::vector<Eigen::Vector3d> points;
  for (const FieldStroke& stroke : strokes) {
    counts.push_back(stroke.points.size());
    points.insert(points.end(), stroke.points.begin(), stroke.points.end());
  }
  points = ranks.of_first(points);
  std::vector<FieldStroke> of_all;
  auto next = points.begin();
  for (const std::uint64_t count : ranks.of_first(counts)) {
    const auto end = next + static_cast<std::ptrdiff_t>(count);
    of_all.push_back({{next, end}, radius, strength});
    next = end;
  }
  return of_all;
}

void check_piece(const RankSurface& surface, const MeasuredField& field, const std::string& what) {
  const std::size_t places =
      field.of_triangles ? surface.piece_triangles : surface.piece_ids.size();
  const auto require = [&](std::size_t entries) {
    if (entries == places) return;
    throw Error("measured field: " + what + " has " + std::to_string(entries) + " entries for " +
                std::to_string(places) + (field.of_triangles ? " triangles" : " vertices") +
                " of the piece");
  };
  require(field.directions.size());
  if (!field.confidence.empty()) require(field.confidence.size());
}

/// A measured field of all partitions, on rank 0.
MeasuredField measured_of_whole(const GatheredSurface& whole, const MeasuredField& piece) {
  Communicator& ranks = *whole.piece().ranks;
  MeasuredField field;
  field.of_triangles = ranks.any(piece.of_triangles);
  const auto gathered = [&]<class T>(const std::vector<T>& rows) {
    const std::span<const T> all(rows);
    return field.of_triangles ? whole.of_triangles(all) : whole.of_vertices(all);
  };
  field.directions = gathered(piece.directions);
  if (ranks.any(!piece.confidence.empty())) {
    std::vector<float> confidence = piece.confidence;
    confidence.resize(piece.directions.size(), 1);  // on ranks without vertices
    field.confidence = gathered(confidence);
  }
  return field;
}

}  // namespace

DirectionField smooth_direction_field(const DistributedSurface& distributed,
                                      const SmoothFieldOptions& options) {
  const RankSurface& surface = distributed.rank_surface();
  check_pieces(surface, options);
  if (surface.vertices == 0) return {};
  const GatheredSurface whole(surface);
  SmoothFieldOptions of_whole = options;
  of_whole.anchors = anchors_of_whole(whole, options.anchors);
  of_whole.last = last_of_whole(whole, options.last);
  return whole.to_piece(
      whole.on_first([&](const Surface& all) { return smooth_direction_field(all, of_whole); }));
}

DirectionField curvature_direction_field(const DistributedSurface& distributed,
                                         CurvatureDirection direction) {
  return of_curvatures(distributed.rank_surface(),
                       [&](const Surface& surface, std::span<const PrincipalCurvature> curvatures) {
                         DirectionField field = curvature_direction_field(curvatures, direction);
                         orient_alike(*surface.neighborhood, field);
                         return field;
                       });
}

std::vector<float> greatest_curvatures(const DistributedSurface& distributed) {
  return of_curvatures(
      distributed.rank_surface(),
      [](const Surface&, std::span<const PrincipalCurvature> curvatures) {
        std::vector<float> values;
        for (const PrincipalCurvature& c : curvatures) {
          const bool none = c.maximum_direction.isZero(0);
          values.push_back(none ? std::numeric_limits<float>::quiet_NaN() : c.maximum);
        }
        return values;
      });
}

std::vector<FieldStroke> feature_strokes(const DistributedSurface& distributed, float angle_deg,
                                         double radius, double strength) {
  const RankSurface& surface = distributed.rank_surface();
  const GatheredSurface whole(surface);
  const std::vector<FieldStroke> strokes = whole.on_first(
      [&](const Surface& all) { return feature_strokes(all, angle_deg, radius, strength); });
  return of_first_rank(*surface.ranks, strokes, radius, strength);
}

std::vector<FieldAnchor> stroke_anchors(const DistributedSurface& distributed,
                                        std::span<const FieldStroke> strokes) {
  struct AnchorOfWhole {
    std::uint64_t id;
    FieldAnchor anchor;
  };
  const RankSurface& surface = distributed.rank_surface();
  const GatheredSurface whole(surface);
  const auto found = whole.on_first([&](const Surface& all) {
    std::vector<AnchorOfWhole> anchors;
    for (const FieldAnchor& anchor : stroke_anchors(all, strokes)) {
      anchors.push_back({whole.ids()[anchor.vertex], anchor});
    }
    return anchors;
  });
  std::unordered_map<std::uint64_t, Index> vertex_of;
  for (Index p = 0; p < surface.piece_ids.size(); ++p) vertex_of[surface.piece_ids[p]] = p;
  std::vector<FieldAnchor> anchors;
  for (const auto& [id, anchor] : surface.ranks->of_first(found)) {
    const auto vertex = vertex_of.find(id);
    if (vertex == vertex_of.end()) continue;
    anchors.push_back({vertex->second, anchor.direction, anchor.weight});
  }
  return anchors;
}

std::pair<SmoothedField, FieldSmoothingMetrics> PieceSurface::smooth_field(
    const MeasuredField& measured, std::span<const float> places, const DirectionField& last_field,
    const FieldSmoothingOptions& options, const Progress& progress) const {
  const RankSurface& surface = surface_.rank_surface();
  const MeasuredField last{last_field, {}};
  Communicator& ranks = *surface.ranks;
  const bool has_last = ranks.any(!last.directions.empty());
  ranks.throw_on_all([&] {
    check_piece(surface, measured, "the data");
    if (has_last) check_piece(surface, last, "the last field");
    if (places.size() != surface.piece_ids.size()) {
      throw Error("measured field: there must be a frequency for every vertex of the piece");
    }
  });
  const GatheredSurface whole(surface);
  const MeasuredField data = measured_of_whole(whole, measured);
  const std::vector<float> all_frequencies = whole.of_vertices(places);
  const MeasuredField before = has_last ? measured_of_whole(whole, last) : MeasuredField{};
  SmoothedField found;
  std::vector<FieldSmoothingMetrics> metrics;
  ranks.on_first(progress, [&](const Progress& heard) {
    FieldSmoothing smoothing(whole.surface(), options, heard.part(0, 0.3));
    found = smoothing.frame(data, all_frequencies, before, heard.part(0.3, 1));
    metrics.push_back(smoothing.metrics());
  });
  return {{whole.to_piece(found.directions), whole.to_piece(found.coherence),
           whole.to_piece(found.filled)},
          ranks.of_first(metrics)[0]};
}

SmoothedFrequencies PieceSurface::smooth_frequencies(std::span<const float> frequencies,
                                                     const FrequencySmoothingOptions& options,
                                                     const Progress& progress) const {
  const RankSurface& surface = surface_.rank_surface();
  Communicator& ranks = *surface.ranks;
  ranks.throw_on_all([&] {
    if (frequencies.size() == surface.piece_ids.size()) return;
    throw Error("measured frequencies: there must be one for every vertex of the piece");
  });
  const GatheredSurface whole(surface);
  const std::vector<float> data = whole.of_vertices(frequencies);
  SmoothedFrequencies found;
  ranks.on_first(progress, [&](const Progress& heard) {
    found = smoothed_frequencies(whole.surface(), data, options, heard);
  });
  SmoothedFrequencies result;
  result.frequencies = whole.to_piece(found.frequencies);
  result.filled = ranks.greatest(found.filled);
  result.changed_median = ranks.greatest(found.changed_median);
  return result;
}

}  // namespace brindle
