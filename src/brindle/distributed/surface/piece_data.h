/// Arrays that belong to a surface in pieces.
#pragma once

#include "brindle/communicator.h"
#include "brindle/data_arrays.h"
#include "brindle/distributed_surface.h"

namespace brindle {

/// Collective. What `cells_to_points` makes of the whole's triangles, at the vertices of the piece:
/// the means are over the triangles of all ranks, and their bits are those of the whole where
/// triangles have numbers. All ranks have arrays of as many components. The piece has no ghosts.
/// Throws Error on all ranks unless there is a row per triangle.
DataArray cells_to_points(Communicator& ranks, const SurfacePiece& piece, const DataArray& cells);

}  // namespace brindle
