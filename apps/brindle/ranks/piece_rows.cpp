#include "ranks/piece_rows.h"

#include <cstdint>
#include <cstring>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "brindle/error.h"
#include "ranks/rank_arrays.h"
#include "ranks/request.h"

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

}  // namespace brindle::tool
