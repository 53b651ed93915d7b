/// The pieces of a mesh that ranks read, make, or get from rank 0.
#pragma once

#include <cstddef>

#include "brindle/distributed/communicator.h"
#include "brindle/distributed_surface.h"
#include "job_listener.h"
#include "surface_options.h"

namespace brindle::tool {

struct ReadPiece {
  SurfacePiece piece;  ///< vertex numbers are those of the whole mesh
  std::size_t vertices_joined = 0;
};

/// Collective. Ranks read the pieces of a .pvtp and make their parts of shapes that can be made in
/// parts (`make_shape_part`). Any other mesh rank 0 reads or makes, cuts along a Hilbert curve and
/// sends. Pieces are then subdivided. Throws on all ranks CLI::ValidationError for a shape that is
/// not spelt right, and Error for a file that cannot be read or has no triangles.
ReadPiece read_piece(Communicator& ranks, const SurfaceOptions& options, JobListener& listener);

}  // namespace brindle::tool
