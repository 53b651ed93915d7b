/// Arrays whose rows go to the ranks that need them.
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

/// Collective. What the lowest rank has that has any, on all ranks.
DataArrays agreed_heads(Communicator& ranks, const DataArrays& heads);

/// Collective. Of rank 0's arrays the rows that this rank is to have; on rank 0 there is a list of
/// rows for each rank.
std::vector<DataArray> scattered_rows(Communicator& ranks, std::span<const DataArray> arrays,
                                      const std::vector<std::vector<Index>>& rows);

/// Collective. Of rank 0's arrays, which have a row for each vertex of the whole, those of the
/// vertices of these numbers. Throws Error on all ranks for a number that there is no row for;
/// `file` is where rows come from.
std::vector<DataArray> rows_of_numbers(Communicator& ranks, std::span<const DataArray> arrays,
                                       const std::vector<std::uint64_t>& ids,
                                       const std::string& file);

}  // namespace brindle::tool
