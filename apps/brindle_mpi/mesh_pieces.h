/// A mesh that rank 0 reads and the others get pieces of.
#pragma once

#include <cstddef>
#include <vector>

#include "brindle/distributed/communicator.h"
#include "brindle/distributed_surface.h"
#include "job_listener.h"
#include "surface_options.h"

namespace brindle::tool {

struct ReadPiece {
  SurfacePiece piece;  ///< vertex numbers are those of the whole mesh
  std::size_t vertices_joined = 0;
  std::vector<Index> vertex_of_row;  ///< on rank 0, as LoadedMesh has it; none if subdivided
};

/// Rank 0 reads or makes the mesh, cuts it along a Hilbert curve and sends the pieces. Throws on
/// all ranks CLI::ValidationError for a shape that is not spelt right, and Error for a file that
/// cannot be read or has no triangles.
ReadPiece read_piece(Communicator& ranks, const SurfaceOptions& options, JobListener& listener);

}  // namespace brindle::tool
