/// Compressed rows: the entries of all rows in one list.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brindle/base/parallel.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// The entries of row i are `entries[offsets[i]] .. entries[offsets[i + 1] - 1]`.
template <class Entry>
struct CompressedRows {
  std::vector<Index> offsets{0};  ///< rows + 1 entries
  std::vector<Entry> entries;

  std::size_t size() const { return offsets.size() - 1; }

  std::span<const Entry> of(std::size_t row) const {
    return std::span(entries).subspan(offsets[row], offsets[row + 1] - offsets[row]);
  }
  std::span<Entry> of(std::size_t row) {
    return std::span(entries).subspan(offsets[row], offsets[row + 1] - offsets[row]);
  }
};

/// Builds rows. `add_all(progress, add)` calls `add(row, entry)` for all entries, in order within a
/// row. It is called twice, to count and to fill, and must add the same both times.
template <class Entry, class AddAll>
CompressedRows<Entry> compressed_rows(std::size_t count, const Progress& progress,
                                      const AddAll& add_all) {
  CompressedRows<Entry> rows;
  // Counts one place to the right, so that filling moves each offset to its final value.
  std::vector<Index>& offsets = rows.offsets;
  offsets.assign(count + 2, 0);
  add_all(progress.part(0, 0.4), [&](std::size_t row, const Entry&) { ++offsets[row + 2]; });
  for (std::size_t i = 2; i < offsets.size(); ++i) offsets[i] += offsets[i - 1];
  ticking_resize(rows.entries, offsets.back(), progress);
  add_all(progress.part(0.4, 1),
          [&](std::size_t row, const Entry& entry) { rows.entries[offsets[row + 1]++] = entry; });
  offsets.pop_back();
  return rows;
}

/// The same for `add_all(add)`.
template <class Entry, class AddAll>
CompressedRows<Entry> compressed_rows(std::size_t count, const AddAll& add_all) {
  return compressed_rows<Entry>(count, {}, [&](const Progress&, const auto& add) { add_all(add); });
}

// ---- Concatenated lists -------------------------------------------------------------------------

/// Reserves memory for a list of all parts.
template <class Part>
void reserve_for_lists(std::vector<Index>& all, const std::vector<Part>& parts,
                       std::vector<Index> Part::*list) {
  std::size_t size = all.size();
  for (const Part& part : parts) size += (part.*list).size();
  all.reserve(size);
}

inline void append_list(std::vector<Index>& all, const std::vector<Index>& part) {
  all.insert(all.end(), part.begin(), part.end());
}

/// Appends offsets, the first of which is 0, shifted to continue `all`.
inline void append_offsets(std::vector<Index>& all, const std::vector<Index>& part) {
  const Index first = all.back();
  for (std::size_t n = 1; n < part.size(); ++n) all.push_back(first + part[n]);
}

}  // namespace brindle
