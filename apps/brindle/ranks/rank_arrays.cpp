#include "ranks/rank_arrays.h"

#include <cstddef>
#include <cstring>
#include <utility>

#include "brindle/error.h"

namespace brindle::tool {
namespace {

/// The header of a sent array; its name and rows follow.
struct Head {
  std::uint64_t name_length = 0;
  std::int32_t components = 1;
  NumberType type = NumberType::float32;
  std::uint8_t of_cells = 0;
};

template <class Thing>
void put(std::vector<std::byte>& bytes, std::span<const Thing> things) {
  const auto raw = std::as_bytes(things);
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

void put_heads(std::vector<std::byte>& bytes, std::span<const DataArray> arrays, bool of_cells) {
  for (const DataArray& array : arrays) {
    const Head head{array.name.size(), array.components, array.type,
                    static_cast<std::uint8_t>(of_cells ? 1 : 0)};
    put(bytes, std::span(&head, 1));
    put(bytes, std::span<const char>(array.name));
  }
}

std::vector<std::byte> packed(const DataArrays& heads) {
  std::vector<std::byte> bytes;
  put_heads(bytes, heads.points, false);
  put_heads(bytes, heads.cells, true);
  return bytes;
}

DataArrays unpacked(std::span<const std::byte> bytes) {
  DataArrays heads;
  while (!bytes.empty()) {
    Head head;
    std::memcpy(&head, bytes.data(), sizeof(Head));
    bytes = bytes.subspan(sizeof(Head));
    const auto* name = reinterpret_cast<const char*>(bytes.data());
    (head.of_cells != 0 ? heads.cells : heads.points)
        .push_back({std::string(name, head.name_length), head.type, head.components, {}});
    bytes = bytes.subspan(head.name_length);
  }
  return heads;
}

}  // namespace

std::vector<DataArray> heads_of(std::span<const DataArray> arrays) {
  std::vector<DataArray> heads;
  for (const DataArray& array : arrays) {
    heads.push_back({array.name, array.type, array.components, {}});
  }
  return heads;
}

DataArrays agreed_heads(Communicator& ranks, const DataArrays& heads) {
  std::vector<std::byte> first;
  for (const auto& bytes : ranks.gather(packed(heads))) {
    if (first.empty()) first = bytes;
  }
  return unpacked(ranks.of_first(first));
}

std::vector<DataArray> scattered_rows(Communicator& ranks, std::span<const DataArray> arrays,
                                      const std::vector<std::vector<Index>>& rows) {
  const auto size = static_cast<std::size_t>(ranks.size());
  DataArrays heads;
  if (ranks.rank() == 0) heads.points = heads_of(arrays);
  std::vector<DataArray> result = unpacked(ranks.of_first(packed(heads))).points;
  for (std::size_t a = 0; a < result.size(); ++a) {
    std::vector<std::vector<std::byte>> parts(size);
    ranks.throw_on_all([&] {
      if (ranks.rank() != 0) return;
      for (std::size_t r = 0; r < size; ++r) parts[r] = rows_of(arrays[a], rows[r]).bytes;
    });
    result[a].bytes = ranks.swap_lists(parts)[0];
  }
  return result;
}

std::vector<DataArray> rows_of_numbers(Communicator& ranks, std::span<const DataArray> arrays,
                                       const std::vector<std::uint64_t>& ids,
                                       const std::string& file) {
  std::vector<std::vector<std::uint64_t>> asked(static_cast<std::size_t>(ranks.size()));
  asked[0] = ids;
  std::vector<std::vector<Index>> rows;
  for (const auto& list : ranks.swap_lists(asked)) rows.emplace_back(list.begin(), list.end());
  const std::size_t there = ranks.all(arrays.empty() ? 0 : arrays[0].rows())[0];
  ranks.throw_on_all([&] {
    for (const std::uint64_t id : ids) {
      if (id < there) continue;
      throw Error("'" + file + "' has " + std::to_string(there) +
                  " rows, but a vertex of the pieces has the number " + std::to_string(id) +
                  "; number them from 0 on, without gaps");
    }
  });
  return scattered_rows(ranks, arrays, rows);
}

}  // namespace brindle::tool
