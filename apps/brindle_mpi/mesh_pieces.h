/// The pieces of a mesh that ranks read, make, or get from rank 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/data_arrays.h"
#include "brindle/distributed_surface.h"
#include "cli/job_listener.h"
#include "input/surface_options.h"

namespace brindle::tool {

struct ReadPiece {
  std::string file;    ///< or shape, as messages call it
  SurfacePiece piece;  ///< numbers are those of the whole mesh
  /// Whether vertices have the numbers that the mesh's file or the shape gives them; a .pvtp
  /// without ids gives none.
  bool numbered = true;
  /// Per vertex the number that the mesh's file or the shape gives it, -1 for those that are added;
  /// none if it gives none.
  std::vector<std::int64_t> original_ids = {};
  std::size_t vertices_joined = 0;
  int subdivided = 0;                ///< times
  std::vector<Index> vertex_of_row;  ///< on rank 0, as LoadedMesh has it; none if subdivided
  std::vector<Index> partners;       ///< on rank 0, as Preparation has it
  DataArrays arrays = {};            ///< those asked for: a row per vertex, and per triangle
};

/// Arrays of the mesh's file that are asked for.
struct WantedArrays {
  std::vector<std::string> names;  ///< NAME, points/NAME or cells/NAME: they must be there
  bool all = false;                ///< and all others, but those that mark ghosts
};

/// Collective. Ranks read the pieces of a .pvtp and make their parts of shapes that can be made in
/// parts (`make_shape_part`). Any other mesh rank 0 reads or makes, cuts along a Hilbert curve and
/// sends. Pieces are then subdivided. Throws on all ranks CLI::ValidationError for a shape that is
/// not spelt right, and Error for a file that cannot be read, has no triangles, or lacks one of the
/// arrays asked for.
ReadPiece read_piece(Communicator& ranks, const SurfaceOptions& options, const WantedArrays& wanted,
                     JobListener& listener);

}  // namespace brindle::tool
