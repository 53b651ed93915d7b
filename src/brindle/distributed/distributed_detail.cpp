#include <cstdint>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "brindle/distributed/part_of_whole.h"
#include "brindle/distributed/rank_surface.h"
#include "brindle/distributed_surface.h"
#include "brindle/error.h"
#include "brindle/measured_field.h"

namespace brindle {
namespace {

constexpr Index kNone = ~Index{0};

/// The whole surface on rank 0, and what belongs to its vertices and triangles.
class WholeOnFirst {
 public:
  /// Collective.
  explicit WholeOnFirst(const RankSurface& surface) : surface_(surface), ranks_(*surface.ranks) {
    std::vector<Index> all(surface.mesh.triangle_count());
    std::iota(all.begin(), all.end(), Index{0});
    const std::vector<SentTriangle> own = sent_triangles(surface, all);
    auto sent = joined<SentTriangle>(ranks_.gather(std::as_bytes(std::span(own))));
    const std::vector<std::uint64_t> ids = own_ids(surface);
    const auto of_ranks = ranks_.gather(std::as_bytes(std::span(ids)));
    ranks_.together([&] {
      if (!is_first()) return;
      for (const SentTriangle& triangle : sent) numbers_.push_back(triangle.number);
      part_ = part_of(std::move(sent), surface.mesh.origin, joined<std::uint64_t>(of_ranks));
      for (const std::vector<std::byte>& of_rank : of_ranks) {
        std::vector<Index>& places = places_.emplace_back();
        for (const std::uint64_t id : joined<std::uint64_t>({of_rank})) {
          places.push_back(place_of(id));
        }
      }
    });
    places_.resize(static_cast<std::size_t>(ranks_.size()));
  }

  bool is_first() const { return ranks_.rank() == 0; }
  const Surface& surface() const { return part_.surface; }

  /// Collective. What owners have at vertices of their pieces, on rank 0.
  template <class T>
  std::vector<T> of_vertices(std::span<const T> of_piece) {
    std::vector<T> own(surface_.graph.own);
    for (std::size_t p = 0; p < of_piece.size(); ++p) {
      const Index v = surface_.vertex_of_piece[p];
      if (v < own.size()) own[v] = of_piece[p];
    }
    const auto of_ranks = ranks_.gather(std::as_bytes(std::span(own)));
    std::vector<T> whole(part_.ids.size());
    for (std::size_t r = 0; r < of_ranks.size(); ++r) {
      const std::vector<T> rows = joined<T>({of_ranks[r]});
      for (std::size_t i = 0; i < rows.size(); ++i) {
        if (places_[r][i] != kNone) whole[places_[r][i]] = rows[i];
      }
    }
    return whole;
  }

  /// Collective. The same at triangles.
  template <class T>
  std::vector<T> of_triangles(std::span<const T> of_piece) {
    std::vector<T> own;
    for (const Index t : surface_.triangle_of_piece) own.push_back(of_piece[t]);
    const auto rows = joined<T>(ranks_.gather(std::as_bytes(std::span(own))));
    std::vector<Index> order(rows.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::stable_sort(order, {}, [&](Index t) { return numbers_[t]; });
    std::vector<T> whole;
    for (const Index t : order) whole.push_back(rows[t]);
    return whole;
  }

  /// Collective. What rank 0 has, at the vertices of the piece; nothing where no triangle is.
  template <class T>
  std::vector<T> to_pieces(const std::vector<T>& whole) {
    std::vector<std::vector<T>> to(static_cast<std::size_t>(ranks_.size()));
    for (std::size_t r = 0; r < to.size(); ++r) {
      for (const Index place : places_[r]) to[r].push_back(place == kNone ? T{} : whole[place]);
    }
    std::vector<T> by_vertex = std::move(ranks_.swap_lists(to)[0]);
    by_vertex.resize(surface_.vertex_count());
    surface_.exchange_all(std::span(by_vertex));
    return surface_.to_piece(std::span<const T>(by_vertex));
  }

 private:
  Index place_of(std::uint64_t id) const {
    const auto place = std::ranges::lower_bound(part_.ids, id);
    const bool is_there = place != part_.ids.end() && *place == id;
    return is_there ? static_cast<Index>(place - part_.ids.begin()) : kNone;
  }

  const RankSurface& surface_;
  Communicator& ranks_;
  // All of rank 0 alone.
  PartOfWhole part_;
  std::vector<std::uint64_t> numbers_;      ///< of triangles, rank by rank
  std::vector<std::vector<Index>> places_;  ///< in the part, of every rank's own vertices
};

std::vector<SentVector> sent(std::span<const Vec3> vectors) {
  std::vector<SentVector> result;
  for (const Vec3& vector : vectors) result.push_back(floats_of(vector));
  return result;
}

DirectionField received(const std::vector<SentVector>& vectors) {
  DirectionField result;
  for (const SentVector& vector : vectors) result.push_back(vector_of(vector));
  return result;
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

/// Collective. A field of pieces as rank 0 has it.
MeasuredField whole_field(Communicator& ranks, WholeOnFirst& whole, const MeasuredField& piece) {
  MeasuredField field;
  field.of_triangles = ranks.any(piece.of_triangles);
  const auto gathered = [&]<class T>(const std::vector<T>& rows) {
    const std::span<const T> all(rows);
    return field.of_triangles ? whole.of_triangles(all) : whole.of_vertices(all);
  };
  field.directions = received(gathered(sent(piece.directions)));
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
  result.field.directions = received(whole.to_pieces(sent(found.directions)));
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
  for (std::size_t p = 0; p < frequencies.size(); ++p) {
    // What no triangle uses is as it was.
    if (surface.vertex_of_piece[p] < surface.graph.own &&
        surface.graph.adjacency->of(surface.vertex_of_piece[p]).empty()) {
      result.frequencies[p] = frequencies[p];
    }
  }
  result.filled = ranks.greatest(found.filled);
  result.changed_median = ranks.greatest(found.changed_median);
  return result;
}

}  // namespace brindle
