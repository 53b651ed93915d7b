/// Subdivision of a surface that no rank has whole.
#pragma once

#include "brindle/communicator.h"
#include "brindle/data_arrays.h"
#include "brindle/distributed_surface.h"

namespace brindle {

/// What `subdivide` makes of the whole, piece by piece: every rank has the triangles of its own. If
/// vertices are numbered from 0 on without gaps, midpoints have the numbers that they have there;
/// they follow the greatest number in any case. Throws Error on all ranks, as `subdivide` does.
SurfacePiece subdivided_piece(Communicator& ranks, SurfacePiece piece, int times);

/// The same with arrays of the piece, which become what `subdivide` of mesh_data.h makes of those
/// of the whole.
SurfacePiece subdivided_piece(Communicator& ranks, SurfacePiece piece, DataArrays& arrays,
                              int times);

}  // namespace brindle
