/// Arrays of distributed surfaces.
#pragma once

#include "brindle/communicator.h"
#include "brindle/data_arrays.h"
#include "brindle/distributed_surface.h"

namespace brindle {

/// Collective. The result of `cells_to_points` on the whole surface, at the partition's vertices:
/// means over the triangles of all ranks, with the bits of the whole if triangles are numbered. All
/// ranks have the same number of components. The partition has no ghosts. Throws Error on all ranks
/// unless there is a row per triangle.
DataArray cells_to_points(Communicator& ranks, const SurfacePiece& piece, const DataArray& cells);

}  // namespace brindle
