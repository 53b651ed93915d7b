/// A surface in pieces, of which every rank reads its own.
#pragma once

#include <string>
#include <vector>

#include "brindle/communicator.h"
#include "cli/job_listener.h"
#include "input/used_files.h"
#include "mesh_pieces.h"

namespace brindle::tool {

/// Whether a mesh is named that comes in pieces.
bool is_pvtp(const std::string& mesh);

/// Collective. The .pvtp and its pieces, which no output may overwrite. Throws Error on all ranks
/// if it cannot be read.
std::vector<UsedFile> files_of_pvtp(Communicator& ranks, const std::string& path);

/// Collective. Deals the pieces of a .pvtp to ranks in contiguous runs. Vertices of one global id
/// are one vertex; without such ids those at exactly the same place are. Ghost triangles are left
/// out, since other pieces have them, and so are arrays that mark ghosts. All arrays that the .pvtp
/// announces may be asked for. Throws Error on all ranks, with one message, for a file that cannot
/// be read, for pieces that do not fit together, and for those that lack one of the arrays.
ReadPiece read_pvtp_pieces(Communicator& ranks, const std::string& path, const WantedArrays& wanted,
                           JobListener& listener);

}  // namespace brindle::tool
