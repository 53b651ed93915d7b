/// File rows of vertices, distributed to partitions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/data_arrays.h"
#include "brindle/distributed_surface.h"
#include "ranks/mesh_pieces.h"

namespace brindle::tool {

/// Collective. Rank 0 reads a file with rows for the vertices of the whole mesh: `rows` returns
/// arrays with a row each. Returns those of the partition's vertices. Throws on all ranks what
/// `rows` throws, and Error for vertices without file numbers or with numbers beyond the rows.
/// `option` names the file.
std::vector<DataArray> piece_rows(Communicator& ranks, const ReadPiece& read,
                                  const std::string& option, const std::string& file,
                                  const std::function<std::vector<DataArray>()>& rows);

/// Collective. As `copy_from_partners` of array_rows.h; partners on rank 0 may belong to other
/// ranks.
void copy_from_partners(Communicator& ranks, const DistributedSurface& surface,
                        const ReadPiece& read, std::vector<DataArray>& arrays);

/// Collective. For each vertex of the partition, the largest flag, 0 or 1, of all ranks.
std::vector<float> flags_of_all(Communicator& ranks, const ReadPiece& read,
                                std::vector<float> flags);

}  // namespace brindle::tool
