/// The whole surface on rank 0, for computations that are not distributed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "brindle/distributed/parts_on_first.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/surface.h"

namespace brindle {

/// A triangle by its rank and its number in that rank's partition.
struct TriangleOfPiece {
  int rank;
  Index triangle;
};

/// Vertices and numbered triangles are in global order, so that results have the bits of one
/// process. Rank 0 needs memory for the whole surface. All functions but accessors are collective.
class GatheredSurface {
 public:
  /// The surface must outlive this.
  explicit GatheredSurface(const RankSurface& surface);

  const RankSurface& piece() const { return piece_; }
  bool is_first() const { return piece_.ranks->rank() == 0; }

  /// What `make` returns for the whole on rank 0, a default elsewhere. Throws on all ranks.
  template <class Make>
  auto on_first(const Make& make) const {
    decltype(make(surface_)) made{};
    piece_.ranks->throw_on_all([&] {
      if (is_first()) made = make(surface_);
    });
    return made;
  }

  /// On rank 0; empty elsewhere.
  const Surface& surface() const { return surface_; }
  /// The global numbers of its vertices, ascending.
  std::span<const std::uint64_t> ids() const { return ids_; }
  /// The row of an own vertex among those of all ranks and, on rank 0, the vertex of a row.
  Index row_of(Index own) const { return vertices_.first(piece_.ranks->rank()) + own; }
  Index vertex_of_row(Index row) const { return vertex_of_row_[row]; }

  /// On rank 0, the owners' rows of vertices of partitions; empty elsewhere.
  template <class T>
  std::vector<T> of_vertices(std::span<const T> of_piece) const {
    std::vector<T> own(piece_.graph.own), whole;
    piece_.copy_to_own(of_piece, std::span(own));
    of_own(std::span<const T>(own), whole);
    return whole;
  }
  template <class T>
  std::vector<T> of_vertices(const std::vector<T>& of_piece) const {
    return of_vertices(std::span<const T>(of_piece));
  }

  /// The same for rows of own vertices.
  template <class T>
  void of_own(std::span<const T> own, std::vector<T>& whole) const {
    std::vector<T> rows;
    vertices_.gather(own, rows);
    whole.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) whole[vertex_of_row_[i]] = rows[i];
  }

  /// The same for rows of the partitions' triangles.
  template <class T>
  std::vector<T> of_triangles(std::span<const T> of_piece) const {
    std::vector<T> own, rows, whole;
    for (const Index t : piece_.triangle_of_piece) own.push_back(of_piece[t]);
    triangles_.gather(std::span<const T>(own), rows);
    for (std::size_t t = 0; t < rows.size(); ++t) whole.push_back(rows[row_of_triangle_[t]]);
    return whole;
  }

  /// On rank 0: its triangles by rank and number in the partition.
  std::vector<TriangleOfPiece> triangles_of_pieces() const;

  /// Rank 0's rows at the partition's vertices.
  template <class T>
  std::vector<T> to_piece(std::span<const T> whole) const {
    std::vector<T> by_vertex(piece_.vertex_count());
    to_own(whole, std::span(by_vertex).first(piece_.graph.own));
    piece_.exchange_all(std::span(by_vertex));
    return piece_.to_piece(std::span<const T>(by_vertex));
  }
  template <class T>
  std::vector<T> to_piece(const std::vector<T>& whole) const {
    return to_piece(std::span<const T>(whole));
  }

  /// Rank 0's rows at own vertices.
  template <class T>
  void to_own(std::span<const T> whole, std::span<T> own) const {
    std::vector<T> rows(vertex_of_row_.size());
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = whole[vertex_of_row_[i]];
    vertices_.scatter(std::span<const T>(rows), own);
  }

 private:
  /// The number of a triangle and of its corners.
  struct SentTriangle {
    std::uint64_t number;  ///< 0 for unnumbered triangles
    std::array<std::uint64_t, 3> ids;
  };
  void put_together(const std::vector<std::uint64_t>& ids, const std::vector<Vec3>& positions,
                    const std::vector<SentTriangle>& triangles);

  const RankSurface& piece_;
  PartsOnFirst vertices_, triangles_;
  // On rank 0 only. Rows of all ranks, rank by rank.
  Surface surface_;
  std::vector<std::uint64_t> ids_;
  std::vector<Index> vertex_of_row_;
  std::vector<Index> row_of_triangle_;
};

}  // namespace brindle
