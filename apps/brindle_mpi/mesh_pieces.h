/// The pieces of a mesh that ranks read, make, or get from rank 0.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/distributed/communicator.h"
#include "brindle/distributed_surface.h"
#include "job_listener.h"
#include "surface_options.h"

namespace brindle::tool {

struct ReadPiece {
  SurfacePiece piece;  ///< vertex numbers are those of the whole mesh
  std::size_t vertices_joined = 0;
  std::vector<Index> vertex_of_row;    ///< on rank 0, as LoadedMesh has it; none if subdivided
  std::vector<DataArray> arrays = {};  ///< those asked for: float64, a row per vertex
};

/// An array's numbers as float64, under another name.
DataArray as_doubles(const DataArray& array, const std::string& name);

/// Collective. Ranks read the pieces of a .pvtp and make their parts of shapes that can be made in
/// parts (`make_shape_part`). Any other mesh rank 0 reads or makes, cuts along a Hilbert curve and
/// sends. Pieces are then subdivided. Throws on all ranks CLI::ValidationError for a shape that is
/// not spelt right, and Error for a file that cannot be read, has no triangles, or lacks one of the
/// arrays of points asked for.
ReadPiece read_piece(Communicator& ranks, const SurfaceOptions& options,
                     const std::vector<std::string>& arrays, JobListener& listener);

}  // namespace brindle::tool
