/// Rows of files that stand for vertices, at the vertices of pieces.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/distributed/communicator.h"
#include "brindle/distributed_surface.h"
#include "mesh_pieces.h"

namespace brindle::tool {

/// Collective. Rank 0 reads a file whose rows stand for the vertices of the whole: `rows` returns
/// arrays of a row for each. Returns those of the piece's vertices. Throws on all ranks what `rows`
/// throws, Error for a piece whose vertices have no numbers that a file could mean, or numbers
/// beyond the rows. `option` names the file.
std::vector<DataArray> piece_rows(Communicator& ranks, const ReadPiece& read,
                                  const std::string& option, const std::string& file,
                                  const std::function<std::vector<DataArray>()>& rows);

/// An array at the vertices of a piece.
struct ArrayAtVertices {
  DataArray array;                 ///< a row per vertex of the piece
  std::size_t rows_nonfinite = 0;  ///< of all ranks, as the array was read
};

/// Collective. The array NAME, points/NAME or cells/NAME of the mesh's file, that of cells moved to
/// the vertices. Throws Error on all ranks if there is no such array.
ArrayAtVertices piece_array(Communicator& ranks, const DistributedSurface& surface,
                            const ReadPiece& read, const std::string& name);

/// Collective. As `copy_from_partners` of files.h, where the partners on rank 0 may be others'.
void copy_from_partners(Communicator& ranks, const DistributedSurface& surface,
                        const ReadPiece& read, std::vector<DataArray>& arrays);

/// Rows of the vertices that this rank owns.
DataArray own_rows(const DistributedSurface& surface, const DataArray& array);

}  // namespace brindle::tool
