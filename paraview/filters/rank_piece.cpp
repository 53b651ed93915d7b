#include "rank_piece.h"

namespace brindle::paraview {
namespace {

using Lists = std::vector<std::vector<std::uint64_t>>;

/// How often each number of all lists occurs in them.
Lists counts_of(const Lists& lists) {
  std::unordered_map<std::uint64_t, std::uint64_t> counts;
  for (const auto& list : lists) {
    for (const std::uint64_t number : list) ++counts[number];
  }
  Lists answers = lists;
  for (auto& list : answers) {
    for (std::uint64_t& number : list) number = counts.at(number);
  }
  return answers;
}

}  // namespace

RankPiece::RankPiece(const Ranks& ranks, const SurfacePiece& piece)
    : ranks_(ranks),
      vertex_ids_(piece.vertex_ids),
      ghosts_(piece.ghost_triangles),
      surface_(piece, ranks.communicator()) {
  const std::vector<std::uint64_t> counts = answers_to(
      ranks, vertex_ids_,
      [&](const std::uint64_t& id) {
        return ranks.rank_of({&id, 1});
      },
      counts_of);
  for (Index v = 0; v < counts.size(); ++v) {
    if (counts[v] > 1) shared_.push_back(v);
    sources_.push_back({ranks.rank(), v});
  }
  from_owners(std::span(sources_));
}

bool RankPiece::is_shared_like(const RankPiece& other) const {
  return sources_ == other.sources_ && ghosts_ == other.ghosts_;
}

DataArray RankPiece::cells_to_points(const Mesh& mesh, const DataArray& rows) const {
  return brindle::cells_to_points(ranks_.messages(), {mesh, vertex_ids_, ghosts_}, rows);
}

}  // namespace brindle::paraview
