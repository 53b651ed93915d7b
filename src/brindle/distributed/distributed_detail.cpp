#include <string>
#include <utility>
#include <vector>

#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/distributed/surface/whole_on_first.h"
#include "brindle/distributed_surface.h"
#include "brindle/error.h"
#include "brindle/measured_field.h"

namespace brindle {
namespace {

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

/// Collective. A field of pieces as rank 0 has it.
MeasuredField whole_field(Communicator& ranks, WholeOnFirst& whole, const MeasuredField& piece) {
  MeasuredField field;
  field.of_triangles = ranks.any(piece.of_triangles);
  const auto gathered = [&]<class T>(const std::vector<T>& rows) {
    const std::span<const T> all(rows);
    return field.of_triangles ? whole.of_triangles(all) : whole.of_vertices(all);
  };
  field.directions = received_vectors(gathered(sent_vectors(piece.directions)));
  if (ranks.any(!piece.confidence.empty())) {
    std::vector<float> confidence = piece.confidence;
    confidence.resize(piece.directions.size(), 1);  // of a rank that has no vertex at all
    field.confidence = gathered(confidence);
  }
  return field;
}

}  // namespace

DistributedDetail detailed_field(const DistributedSurface& distributed,
                                 const MeasuredField& measured, std::span<const float> frequencies,
                                 const FieldDetailOptions& options, const MeasuredField& last,
                                 const Progress& progress) {
  const RankSurface& surface = distributed.rank_surface();
  Communicator& ranks = *surface.ranks;
  const bool has_last = ranks.any(!last.directions.empty());
  ranks.together([&] {
    check_piece(surface, measured, "the data");
    if (has_last) check_piece(surface, last, "the last field");
    if (frequencies.size() != surface.piece_ids.size()) {
      throw Error("measured field: there must be a frequency for every vertex of the piece");
    }
  });
  WholeOnFirst whole(surface);
  const MeasuredField data = whole_field(ranks, whole, measured);
  const std::vector<float> all_frequencies = whole.of_vertices(frequencies);
  const MeasuredField before = has_last ? whole_field(ranks, whole, last) : MeasuredField{};
  DetailedField found;
  std::vector<FieldDetailFigures> figures;
  ranks.together([&] {
    if (!whole.is_first()) return;
    FieldDetail detail(whole.surface(), options, progress.part(0, 0.3));
    found = detail.frame(data, all_frequencies, before, progress.part(0.3, 1));
    figures.push_back(detail.figures());
  });
  DistributedDetail result;
  result.field.directions = received_vectors(whole.to_pieces(sent_vectors(found.directions)));
  result.field.agreement = whole.to_pieces(found.agreement);
  result.figures = ranks.of_first(figures)[0];
  return result;
}

DetailedFrequencies detailed_frequencies(const DistributedSurface& distributed,
                                         std::span<const float> frequencies,
                                         const FrequencyDetailOptions& options,
                                         const Progress& progress) {
  const RankSurface& surface = distributed.rank_surface();
  Communicator& ranks = *surface.ranks;
  ranks.together([&] {
    if (frequencies.size() == surface.piece_ids.size()) return;
    throw Error("measured frequencies: there must be one for every vertex of the piece");
  });
  WholeOnFirst whole(surface);
  const std::vector<float> data = whole.of_vertices(frequencies);
  DetailedFrequencies found;
  ranks.together([&] {
    if (whole.is_first()) found = detailed_frequencies(whole.surface(), data, options, progress);
  });
  DetailedFrequencies result;
  result.frequencies = whole.to_pieces(found.frequencies);
  result.filled = ranks.greatest(found.filled);
  result.changed_median = ranks.greatest(found.changed_median);
  return result;
}

}  // namespace brindle
