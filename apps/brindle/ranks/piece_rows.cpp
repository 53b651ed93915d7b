#include "ranks/piece_rows.h"

#include <cstdint>
#include <cstring>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "brindle/array_field.h"
#include "brindle/distributed/surface/piece_data.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/error.h"
#include "input/array_source.h"
#include "ranks/first_rank.h"
#include "ranks/rank_arrays.h"

namespace brindle::tool {

std::vector<DataArray> piece_rows(Communicator& ranks, const ReadPiece& read,
                                  const std::string& option, const std::string& file,
                                  const std::function<std::vector<DataArray>()>& rows) {
  if (!read.numbered) {
    throw Error(option + ": the pieces have no global ids, so rows of '" + file +
                "' belong to none of their vertices; in ParaView, apply the filter Generate Global "
                "Ids, or give the pieces an array");
  }
  std::vector<DataArray> of_whole;
  on_first_rank(ranks, [&] { of_whole = rows(); });
  return rows_of_numbers(ranks, of_whole, read.row_ids, file);
}

PieceArrays::PieceArrays(Communicator& ranks, const DistributedSurface& surface,
                         const ReadPiece& read, const ArrayOptions& options)
    : ranks_(ranks), surface_(surface), read_(read) {
  if (options.mesh.empty()) return;
  piece_.mesh = {read.piece.mesh.positions, {}, read.piece.mesh.origin};
  ArrayOptions of_whole = options;
  if (of_whole.max_distance) {
    const float distance = of_whole.max_distance->on(static_cast<float>(surface.diagonal()));
    of_whole.max_distance = Length{distance, false};
  } else {
    of_whole.max_distance =
        Length{kDefaultMaxDistance.on(static_cast<float>(surface.diagonal())), false};
  }
  ranks.throw_on_all(
      [&] { other_ = std::make_unique<ArraySource>(piece_, read.arrays, read.file, of_whole); });
}

ArrayAtVertices PieceArrays::array(const std::string& name) const {
  ArrayAtVertices result;
  if (other_) {
    ranks_.throw_on_all([&] {
      auto [array, rows_nonfinite, of_cells] = other_->array(name);
      result.array = std::move(array);
      result.rows_nonfinite = rows_nonfinite;
    });
    return result;
  }
  ArrayChoice choice;
  ranks_.throw_on_all([&] { choice = choice_of(read_.arrays, name, read_.file); });
  const DataArray& array = *choice.array;
  if (!choice.of_cells) {
    return {array, ranks_.sum(nonfinite_rows(own_rows(surface_, array))), std::nullopt};
  }
  return {cells_to_points(ranks_, read_.piece, array), ranks_.sum(nonfinite_rows(array)), array};
}

std::optional<std::size_t> PieceArrays::drop_too_far(DirectionField& directions) const {
  if (!other_) return std::nullopt;
  const std::vector<std::uint8_t> counted = used_own(surface_);
  std::size_t count = 0;
  for (Index v = 0; v < directions.size(); ++v) {
    if (other_->is_near(v)) continue;
    directions[v] = Vec3::Zero();
    count += counted[v];
  }
  return ranks_.sum(count);
}

std::string PieceArrays::notes() const { return other_ ? other_->notes() : ""; }

std::vector<std::uint8_t> used_own(const DistributedSurface& surface) {
  const RankSurface& own = surface.rank_surface();
  std::vector<std::uint8_t> used;
  for (const Index v : own.vertex_of_piece) {
    used.push_back(v < own.graph.own && !own.graph.adjacency->of(v).empty() ? 1 : 0);
  }
  return used;
}

void copy_from_partners(Communicator& ranks, const DistributedSurface& surface,
                        const ReadPiece& read, std::vector<DataArray>& arrays) {
  const auto size = static_cast<std::size_t>(ranks.size());
  // Vertices of rank 0 without triangles that were joined with others.
  std::vector<Index> joined;
  std::vector<std::uint64_t> asked;
  for (Index v = 0; v < read.piece.vertex_ids.size() && !read.partners.empty(); ++v) {
    const std::uint64_t id = read.piece.vertex_ids[v];
    if (id >= read.partners.size() || read.partners[id] == id) continue;
    joined.push_back(v);
    asked.push_back(read.partners[id]);
  }
  if (!ranks.any(!joined.empty())) return;
  const std::vector<std::uint64_t> partners = ranks.of_first(asked);
  std::unordered_map<std::uint64_t, Index> own;
  for (Index v = 0; v < surface.is_own().size(); ++v) {
    if (surface.is_own()[v] != 0) own[read.piece.vertex_ids[v]] = v;
  }
  std::vector<std::vector<std::uint64_t>> places(size);
  std::vector<Index> rows;
  for (std::size_t i = 0; i < partners.size(); ++i) {
    const auto found = own.find(partners[i]);
    if (found == own.end()) continue;
    places[0].push_back(i);
    rows.push_back(found->second);
  }
  const auto received = ranks.swap_lists(places);
  for (DataArray& array : arrays) {
    std::vector<std::vector<std::byte>> parts(size);
    parts[0] = rows_of(array, rows).bytes;
    const auto bytes = ranks.swap_lists(parts);
    const std::size_t row_size = size_of(array.type) * static_cast<std::size_t>(array.components);
    for (std::size_t r = 0; r < size && !joined.empty(); ++r) {
      for (std::size_t i = 0; i < received[r].size(); ++i) {
        std::memcpy(&array.bytes[joined[received[r][i]] * row_size], &bytes[r][i * row_size],
                    row_size);
      }
    }
  }
}

std::vector<float> flags_of_all(Communicator& ranks, const ReadPiece& read,
                                std::vector<float> flags) {
  if (ranks.size() == 1) return flags;
  const std::vector<std::uint64_t>& ids = read.piece.vertex_ids;
  const auto size = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<std::uint64_t>> flagged(size), asked(size);
  for (std::size_t v = 0; v < ids.size(); ++v) {
    asked[ids[v] % size].push_back(ids[v]);
    if (flags[v] != 0) flagged[ids[v] % size].push_back(ids[v]);
  }
  std::unordered_set<std::uint64_t> known;
  for (const auto& list : ranks.swap_lists(flagged)) known.insert(list.begin(), list.end());
  std::vector<std::vector<std::uint8_t>> answers(size);
  const auto questions = ranks.swap_lists(asked);
  for (std::size_t r = 0; r < size; ++r) {
    for (const std::uint64_t id : questions[r]) answers[r].push_back(known.contains(id) ? 1 : 0);
  }
  const auto answered = ranks.swap_lists(answers);
  std::vector<std::size_t> next(size);
  for (std::size_t v = 0; v < ids.size(); ++v) {
    const std::size_t knows = ids[v] % size;
    flags[v] = answered[knows][next[knows]++];
  }
  return flags;
}

DataArray own_rows(const DistributedSurface& surface, const DataArray& array) {
  std::vector<Index> own;
  for (Index v = 0; v < surface.is_own().size(); ++v) {
    if (surface.is_own()[v] != 0) own.push_back(v);
  }
  return rows_of(array, own);
}

}  // namespace brindle::tool
