#include "piece_rows.h"

#include <cstdint>
#include <cstring>
#include <unordered_map>
#include <utility>

#include "array_source.h"
#include "brindle/array_field.h"
#include "brindle/distributed/piece_data.h"
#include "brindle/error.h"
#include "first_rank.h"
#include "rank_arrays.h"

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
  return rows_of_numbers(ranks, of_whole, read.piece.vertex_ids, file);
}

ArrayAtVertices piece_array(Communicator& ranks, const DistributedSurface& surface,
                            const ReadPiece& read, const std::string& name) {
  ArrayChoice choice;
  ranks.together([&] { choice = choice_of(read.arrays, name, read.file); });
  const DataArray& array = *choice.array;
  if (!choice.of_cells) {
    return {array, ranks.sum(nonfinite_rows(own_rows(surface, array)))};
  }
  return {cells_to_points(ranks, read.piece, array), ranks.sum(nonfinite_rows(array))};
}

void copy_from_partners(Communicator& ranks, const DistributedSurface& surface,
                        const ReadPiece& read, std::vector<DataArray>& arrays) {
  const auto size = static_cast<std::size_t>(ranks.size());
  // Vertices of rank 0 that no triangle uses, and for which vertices others stand.
  std::vector<Index> joined;
  std::vector<std::vector<std::uint64_t>> asked(size);
  for (Index v = 0; v < read.piece.vertex_ids.size() && !read.partners.empty(); ++v) {
    const std::uint64_t id = read.piece.vertex_ids[v];
    if (id >= read.partners.size() || read.partners[id] == id) continue;
    joined.push_back(v);
    asked[0].push_back(read.partners[id]);
  }
  if (!ranks.any(!joined.empty())) return;
  for (auto& list : asked) list = asked[0];
  const std::vector<std::uint64_t> partners = ranks.swap_lists(asked)[0];
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
  const auto told = ranks.swap_lists(places);
  for (DataArray& array : arrays) {
    std::vector<std::vector<std::byte>> parts(size);
    parts[0] = rows_of(array, rows).bytes;
    const auto bytes = ranks.swap_lists(parts);
    const std::size_t row_size = size_of(array.type) * static_cast<std::size_t>(array.components);
    for (std::size_t r = 0; r < size && !joined.empty(); ++r) {
      for (std::size_t i = 0; i < told[r].size(); ++i) {
        std::memcpy(&array.bytes[joined[told[r][i]] * row_size], &bytes[r][i * row_size], row_size);
      }
    }
  }
}

DataArray own_rows(const DistributedSurface& surface, const DataArray& array) {
  std::vector<Index> own;
  for (Index v = 0; v < surface.is_own().size(); ++v) {
    if (surface.is_own()[v] != 0) own.push_back(v);
  }
  return rows_of(array, own);
}

}  // namespace brindle::tool
