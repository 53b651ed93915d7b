/// Sends rows of arrays to the ranks that need them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/data_arrays.h"

namespace brindle::tool {

/// Names, types and components, without rows.
std::vector<DataArray> heads_of(std::span<const DataArray> arrays);

/// Collective. The heads of the lowest rank that has any, on all ranks.
DataArrays agreed_heads(Communicator& ranks, const DataArrays& heads);

/// Collective. This rank's rows of rank 0's arrays; rank 0 has a list of rows for each rank.
std::vector<DataArray> scattered_rows(Communicator& ranks, std::span<const DataArray> arrays,
                                      const std::vector<std::vector<Index>>& rows);

/// Collective. The rows of the vertices with these numbers, from rank 0's arrays over the whole
/// mesh. Throws Error on all ranks for a number without a row; `file` is the source of the rows.
std::vector<DataArray> rows_of_numbers(Communicator& ranks, std::span<const DataArray> arrays,
                                       const std::vector<std::uint64_t>& ids,
                                       const std::string& file);

}  // namespace brindle::tool
