/// Partitions of a mesh that ranks read, make or receive from rank 0.
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
  std::string file;    ///< or shape, for messages
  SurfacePiece piece;  ///< with global numbers
  /// Whether vertices have the numbers of the mesh's file or shape; false for a .pvtp without ids.
  bool numbered = true;
  /// Per vertex, its number in the mesh's file or shape, -1 for added vertices; empty without
  /// numbers.
  std::vector<std::int64_t> original_ids = {};
  std::vector<std::uint64_t> row_ids = {};  ///< per vertex, its row in files for the whole
  std::size_t vertices_joined = 0;
  int subdivided = 0;                ///< number of subdivisions
  std::vector<Index> vertex_of_row;  ///< on rank 0, as in LoadedMesh; empty if subdivided
  std::vector<Index> partners;       ///< on rank 0, as in Preparation
  DataArrays arrays = {};            ///< requested arrays, per vertex and per triangle
};

/// Requested arrays of the mesh's file.
struct WantedArrays {
  std::vector<std::string> names;  ///< NAME, points/NAME or cells/NAME; must exist
  bool all = false;                ///< also all others, except for ghost markers
};

/// Collective. Ranks read the pieces of a .pvtp, or make their partitions of a shape
/// (`make_shape_part`). Rank 0 reads or makes any other mesh, partitions it along a Hilbert curve
/// and sends the partitions, which are then subdivided. Throws on all ranks: CLI::ValidationError
/// for a misspelt shape, Error for a file that cannot be read, has no triangles or lacks a
/// requested array.
ReadPiece read_piece(Communicator& ranks, const SurfaceOptions& options, const WantedArrays& wanted,
                     JobListener& listener);

/// Collective. The surface, with its partitions split at creases.
DistributedSurface make_piece_surface(ReadPiece& read, const SurfaceOptions& options);

}  // namespace brindle::tool
