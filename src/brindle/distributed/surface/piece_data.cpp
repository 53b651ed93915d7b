#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <unordered_map>
#include <vector>

#include "brindle/base/array_numbers.h"
#include "brindle/base/array_rows.h"
#include "brindle/communicator.h"
#include "brindle/distributed/surface/gathered_surface.h"
#include "brindle/distributed/surface/shared_vertices.h"
#include "brindle/distributed_surface.h"
#include "brindle/error.h"
#include "brindle/geometry/crease_edges.h"
#include "brindle/mesh_data.h"

namespace brindle {
namespace {

/// Transfers rows of triangles to vertices; owners receive all triangles of theirs.
class CellMeans {
 public:
  CellMeans(Communicator& ranks, const SurfacePiece& piece, const DataArray& cells)
      : ranks_(ranks),
        around_(piece),
        vertices_(piece.vertex_ids.size()),
        columns_(static_cast<std::size_t>(cells.components)),
        rows_(doubles_of(cells.view())) {
    const std::vector<std::uint8_t> used(vertices_, 1);
    owner_ = find_owners(ranks, piece.vertex_ids, used);
    for (Index v = 0; v < vertices_; ++v) vertex_of_[piece.vertex_ids[v]] = v;
    around_.triangle_ids.resize(piece.mesh.triangle_count());  // 0 for unnumbered triangles
  }

  DataArray means(const std::string& name) {
    hear();
    const DataArray own = own_means(name);
    DataArray all = everywhere(own, own.view());
    // Collective, even if this rank has no axes.
    if (may_be_axes(own)) set_axes(all, everywhere(own, own.axes()).bytes);
    return all;
  }

 private:
  void hear() {
    std::vector<std::vector<double>> rows;
    for (const std::vector<Index>& triangles : hear_of_triangles(ranks_, around_, owner_)) {
      std::vector<double>& sent = rows.emplace_back();
      for (const Index t : triangles) {
        const auto row = std::span(rows_).subspan(t * columns_, columns_);
        sent.insert(sent.end(), row.begin(), row.end());
      }
    }
    for (const auto& list : ranks_.swap_lists(rows)) {
      rows_.insert(rows_.end(), list.begin(), list.end());
    }
  }

  /// Valid at own vertices, all of whose triangles are known.
  DataArray own_means(const std::string& name) const {
    std::vector<Index> order(around_.mesh.triangle_count());
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::stable_sort(order, {}, [&](Index t) { return around_.triangle_ids[t]; });
    Mesh mesh{around_.mesh.positions, {}, {}};
    for (const Index t : order) mesh.triangles.push_back(around_.mesh.triangles[t]);
    const DataArray rows = make_data_array(name, static_cast<int>(columns_), rows_);
    return cells_to_points(mesh, rows_of(rows, order));
  }

  DataArray everywhere(const DataArray& own, const ArrayView& rows) const {
    std::vector<double> numbers = doubles_of(rows);
    numbers.resize(vertices_ * columns_);
    ask(numbers);
    return make_data_array(own.name, own.components, numbers);
  }

  /// Replaces the numbers at foreign vertices by their owners'.
  void ask(std::vector<double>& numbers) const {
    std::vector<std::vector<std::uint64_t>> asked(static_cast<std::size_t>(ranks_.size()));
    std::vector<std::vector<Index>> vertices(asked.size());
    for (Index v = 0; v < vertices_; ++v) {
      if (owner_[v] == ranks_.rank()) continue;
      asked[static_cast<std::size_t>(owner_[v])].push_back(around_.vertex_ids[v]);
      vertices[static_cast<std::size_t>(owner_[v])].push_back(v);
    }
    std::vector<std::vector<double>> answers;
    for (const auto& list : ranks_.swap_lists(asked)) {
      std::vector<double>& answer = answers.emplace_back();
      for (const std::uint64_t id : list) {
        const auto row = std::span(numbers).subspan(vertex_of_.at(id) * columns_, columns_);
        answer.insert(answer.end(), row.begin(), row.end());
      }
    }
    const auto sent = ranks_.swap_lists(answers);
    for (std::size_t r = 0; r < sent.size(); ++r) {
      for (std::size_t i = 0; i < vertices[r].size(); ++i) {
        std::copy_n(&sent[r][i * columns_], columns_, &numbers[vertices[r][i] * columns_]);
      }
    }
  }

  Communicator& ranks_;
  SurfacePiece around_;   ///< the partition, then received triangles
  std::size_t vertices_;  ///< of the partition
  std::size_t columns_;
  std::vector<double> rows_;
  std::vector<int> owner_;
  std::unordered_map<std::uint64_t, Index> vertex_of_;
};

/// Of partitions without ghosts.
DataArray means_over_ranks(Communicator& ranks, const SurfacePiece& piece, const DataArray& cells) {
  if (ranks.size() == 1) return cells_to_points(piece.mesh, cells);
  return CellMeans(ranks, piece, cells).means(cells.name);
}

}  // namespace

DataArray cells_to_points(Communicator& ranks, const SurfacePiece& piece, const DataArray& cells) {
  ranks.throw_on_all([&] { check_rows_per_triangle(cells, piece.mesh.triangle_count()); });
  if (piece.ghost_triangles.empty()) return means_over_ranks(ranks, piece, cells);
  std::vector<Index> own(piece.mesh.triangle_count());
  std::iota(own.begin(), own.end(), Index{0});
  std::erase_if(own, [&](Index t) { return piece.ghost_triangles[t] != 0; });
  SurfacePiece part{{piece.mesh.positions, {}, piece.mesh.origin}, piece.vertex_ids, {}};
  for (const Index t : own) {
    part.mesh.triangles.push_back(piece.mesh.triangles[t]);
    if (!piece.triangle_ids.empty()) part.triangle_ids.push_back(piece.triangle_ids[t]);
  }
  return means_over_ranks(ranks, part, rows_of(cells, own));
}

namespace {

/// A corner of a partition that is moved to a copy of its vertex.
struct MovedCorner {
  Index triangle;
  Index corner;
  std::uint64_t copy;  ///< its number
};

/// The number of the first copy.
std::uint64_t first_copy(std::uint64_t last_number) {
  constexpr std::uint64_t kMost = ~std::uint64_t{std::numeric_limits<Index>::max()};
  if (last_number < kMost) return last_number + 1;
  throw Error("a vertex has the number " + std::to_string(last_number) +
              "; to split a surface at creases its numbers must be below 2^64 - 2^32 (an angle of "
              "180 degrees leaves creases out)");
}

/// On rank 0, for all ranks: the corners that differ in the split mesh, sorted by copies.
std::vector<std::vector<MovedCorner>> moved_corners(const GatheredSurface& whole, const Mesh& split,
                                                    std::span<const TriangleOfPiece> triangles,
                                                    std::size_t ranks) {
  std::vector<std::vector<MovedCorner>> moved(ranks);
  const Mesh& mesh = whole.surface().mesh;
  const std::uint64_t first = first_copy(whole.ids().back());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (Index c = 0; c < 3; ++c) {
      const Index vertex = split.triangles[t][c];
      if (vertex < mesh.vertex_count()) continue;
      moved[static_cast<std::size_t>(triangles[t].rank)].push_back(
          {triangles[t].triangle, c, first + (vertex - mesh.vertex_count())});
    }
  }
  for (auto& corners : moved) std::ranges::stable_sort(corners, {}, &MovedCorner::copy);
  return moved;
}

/// Returns the vertices that added ones copy.
std::vector<Index> move_corners(const std::vector<MovedCorner>& moved, SurfacePiece& piece) {
  std::vector<Index> copied;
  const std::size_t own = piece.vertex_ids.size();
  for (const auto& [triangle, c, copy] : moved) {
    Index& corner = piece.mesh.triangles[triangle][c];
    // Corners are sorted by copies.
    if (copied.empty() || piece.vertex_ids.back() != copy) {
      copied.push_back(corner);
      piece.vertex_ids.push_back(copy);
      piece.mesh.positions.push_back(Vec3(piece.mesh.positions[corner]));
    }
    corner = static_cast<Index>(own + copied.size() - 1);
  }
  return copied;
}

}  // namespace

std::optional<std::vector<Index>> split_at_creases(const DistributedSurface& surface,
                                                   SurfacePiece& piece, float angle_deg) {
  const RankSurface& own = surface.rank_surface();
  Communicator& ranks = *own.ranks;
  bool may_split = false;
  ranks.throw_on_all([&] { may_split = may_have_creases(triangles_around_own(own), angle_deg); });
  if (!ranks.any(may_split)) return std::nullopt;
  const GatheredSurface whole(own);
  const std::vector<TriangleOfPiece> triangles = whole.triangles_of_pieces();
  const auto size = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<MovedCorner>> moved(size);
  ranks.throw_on_all([&] {
    if (!whole.is_first()) return;
    Mesh split = whole.surface().mesh;
    piece.creases = split_at_creases(split, angle_deg);
    if (!piece.creases.empty()) moved = moved_corners(whole, split, triangles, size);
  });
  if (!ranks.any(!piece.creases.empty())) return std::nullopt;
  return move_corners(ranks.swap_lists(moved)[0], piece);
}

}  // namespace brindle
