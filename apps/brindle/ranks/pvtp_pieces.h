/// Partitioned surfaces, of which every rank reads its own pieces.
#pragma once

#include <string>
#include <vector>

#include "brindle/communicator.h"
#include "cli/job_listener.h"
#include "input/used_files.h"
#include "ranks/mesh_pieces.h"

namespace brindle::tool {

/// Whether the mesh is a .pvtp.
bool is_pvtp(const std::string& mesh);

/// Collective. The .pvtp and its pieces as inputs. Throws Error on all ranks if it cannot be read.
std::vector<UsedFile> files_of_pvtp(Communicator& ranks, const std::string& path);

/// Collective. Distributes the pieces of a .pvtp to ranks in contiguous runs. Vertices with one
/// global id are joined; without ids, those at exactly the same position. Ghost triangles, which
/// other pieces have, and ghost arrays are left out. All arrays of the .pvtp may be requested.
/// Throws Error on all ranks, with one message, for files that cannot be read, pieces that do not
/// fit together, or missing arrays.
ReadPiece read_pvtp_pieces(Communicator& ranks, const std::string& path, const WantedArrays& wanted,
                           JobListener& listener);

}  // namespace brindle::tool
