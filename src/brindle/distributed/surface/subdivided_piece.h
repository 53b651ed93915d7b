/// Subdivision of distributed surfaces.
#pragma once

#include "brindle/communicator.h"
#include "brindle/data_arrays.h"
#include "brindle/distributed_surface.h"

namespace brindle {

/// The result of `subdivide` on the whole surface: every rank has the triangles of its own ones.
/// Midpoints get the whole's numbers if vertices are numbered from 0 without gaps; otherwise,
/// numbers after the largest. Throws Error on all ranks, as `subdivide` does.
SurfacePiece subdivided_piece(Communicator& ranks, SurfacePiece piece, int times);

/// The same with the partition's arrays, as `subdivide` of mesh_data.h.
SurfacePiece subdivided_piece(Communicator& ranks, SurfacePiece piece, DataArrays& arrays,
                              int times);

}  // namespace brindle
