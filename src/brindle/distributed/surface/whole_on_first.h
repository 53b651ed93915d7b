/// The whole surface on rank 0, for what no part of it tells.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "brindle/direction_field.h"
#include "brindle/distributed/surface/part_of_whole.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/types.h"

namespace brindle {

/// It has the order of one process, and its bits, where triangles have numbers. Rank 0 needs room
/// for all of it.
class WholeOnFirst {
 public:
  /// Collective; the surface must outlive this.
  explicit WholeOnFirst(const RankSurface& surface);

  bool is_first() const { return ranks_.rank() == 0; }
  const Surface& surface() const { return part_.surface; }

  /// Collective. What owners have at vertices of their pieces, on rank 0.
  template <class T>
  std::vector<T> of_vertices(std::span<const T> of_piece) const {
    std::vector<T> own(surface_.graph.own);
    for (std::size_t p = 0; p < of_piece.size(); ++p) {
      const Index v = surface_.vertex_of_piece[p];
      if (v < own.size()) own[v] = of_piece[p];
    }
    const auto of_ranks = ranks_.gather(std::as_bytes(std::span(own)));
    std::vector<T> whole(part_.ids.size());
    for (std::size_t r = 0; r < of_ranks.size(); ++r) {
      const std::vector<T> rows = joined<T>({of_ranks[r]});
      for (std::size_t i = 0; i < rows.size(); ++i) whole[places_[r][i]] = rows[i];
    }
    return whole;
  }

  /// Collective. The same at triangles.
  template <class T>
  std::vector<T> of_triangles(std::span<const T> of_piece) const {
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

  /// Collective. What rank 0 has, at the vertices of the piece.
  template <class T>
  std::vector<T> to_pieces(const std::vector<T>& whole) const {
    return surface_.to_piece(std::span<const T>(to_vertices(whole)));
  }

  /// Collective. The same at all vertices of the rank's surface.
  template <class T>
  std::vector<T> to_vertices(const std::vector<T>& whole) const {
    std::vector<std::vector<T>> to(static_cast<std::size_t>(ranks_.size()));
    for (std::size_t r = 0; r < to.size(); ++r) {
      for (const Index place : places_[r]) to[r].push_back(whole[place]);
    }
    std::vector<T> by_vertex = std::move(ranks_.swap_lists(to)[0]);
    by_vertex.resize(surface_.vertex_count());
    surface_.exchange_all(std::span(by_vertex));
    return by_vertex;
  }

 private:
  const RankSurface& surface_;
  Communicator& ranks_;
  // All of rank 0 alone.
  PartOfWhole part_;
  std::vector<std::uint64_t> numbers_;      ///< of triangles, rank by rank
  std::vector<std::vector<Index>> places_;  ///< in the part, of every rank's own vertices
};

/// Vectors as they are sent, and back.
std::vector<SentVector> sent_vectors(std::span<const Vec3> vectors);
DirectionField received_vectors(const std::vector<SentVector>& vectors);

}  // namespace brindle
