/// One rank's partition of a distributed surface.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include <brindle/data_arrays.h>
#include <brindle/distributed_pattern.h>
#include <brindle/distributed_surface.h>
#include <brindle/mesh.h>
#include <brindle/stripe_pattern.h>

#include "ranks.h"

namespace brindle::paraview {

/// The constructor is collective, and functions that say so.
class RankPiece {
 public:
  RankPiece(const Ranks& ranks, const SurfacePiece& piece);

  const Ranks& ranks() const { return ranks_; }
  const DistributedSurface& surface() const { return surface_; }

  /// A pattern of this partition in the library's form; refers to both.
  PiecePattern part_of(const StripePattern& pattern) const {
    return {surface_, pattern.waves, pattern.solution.z, pattern.phase_shift};
  }

  /// Whether owners of vertices and ghost triangles are the same.
  bool is_shared_like(const RankPiece& other) const;

  /// Collective. The library's `cells_to_points`, over own triangles of all ranks.
  DataArray cells_to_points(const Mesh& mesh, const DataArray& rows) const;

  /// Collective. Sets vertices of other owners to the owners' values.
  template <class T>
  void from_owners(std::span<T> by_vertex) const {
    unite(by_vertex, [](T& united, const T& value, bool is_own) {
      if (is_own) united = value;
    });
  }

  /// Collective. Sets each vertex to the greatest of all ranks' values.
  template <class T>
  void greatest(std::span<T> by_vertex) const {
    unite(by_vertex, [](T& united, const T& value, bool) { united = std::max(united, value); });
  }

 private:
  /// A vertex on its owner.
  struct Source {
    int rank;
    Index vertex;
    bool operator==(const Source&) const = default;
  };

  /// Collective. `add(united, value, is_own)` adds one rank's value to those of lower ranks.
  template <class T, class Add>
  void unite(std::span<T> by_vertex, const Add& add) const {
    struct Row {
      std::uint64_t id;
      T value;
      bool is_own;
    };
    std::vector<Row> rows;
    for (const Index v : shared_) {
      rows.push_back({vertex_ids_[v], by_vertex[v], surface_.is_own()[v] != 0});
    }
    const auto united_values = [&](const std::vector<std::vector<Row>>& lists) {
      std::unordered_map<std::uint64_t, T> united;
      for (const auto& list : lists) {
        for (const Row& row : list)
          add(united.emplace(row.id, row.value).first->second, row.value, row.is_own);
      }
      std::vector<std::vector<T>> values;
      for (const auto& list : lists) {
        values.emplace_back();
        for (const Row& row : list) values.back().push_back(united.at(row.id));
      }
      return values;
    };
    const std::vector<T> values = answers_to(
        ranks_, rows,
        [&](const Row& row) {
          return ranks_.rank_of({&row.id, 1});
        },
        united_values);
    for (std::size_t i = 0; i < shared_.size(); ++i) by_vertex[shared_[i]] = values[i];
  }

  Ranks ranks_;
  std::vector<std::uint64_t> vertex_ids_;
  std::vector<std::uint8_t> ghosts_;
  DistributedSurface surface_;
  std::vector<Index> shared_;    ///< vertices that other ranks have, too
  std::vector<Source> sources_;  ///< per vertex
};

}  // namespace brindle::paraview
