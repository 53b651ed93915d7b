/// A mesh in pieces as VTK has it: a .pvtp that names a .vtp a rank.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "brindle/base/output_file.h"
#include "brindle/communicator.h"
#include "brindle/data_arrays.h"
#include "brindle/mesh.h"
#include "input/used_files.h"

namespace brindle::tool {

/// The ranks' files of `pvtp`: FILE_0.vtp and on, beside it.
std::filesystem::path piece_path(const std::filesystem::path& pvtp, int rank);

/// The .pvtp and all its pieces, as outputs; also those of an older .pvtp of this name, of a run
/// with more ranks, which go when the new one is written.
std::vector<UsedFile> files_of_pieces(const std::string& pvtp, int ranks);

/// Throws Error on all ranks, as `write_pieces` would, if the place of a file is no good.
void check_pieces(Communicator& ranks, const std::filesystem::path& pvtp);

/// All ranks write their pieces into files without names (output_file.h); once all have, pieces get
/// theirs, and rank 0 writes the .pvtp last. Where one rank fails, all throw, and what stood there
/// stays, but for pieces if it is giving names that fails; a rank that is killed leaves nothing
/// behind. All ranks have arrays of the same names and types.
void write_pieces(Communicator& ranks, const std::filesystem::path& pvtp, const Mesh& mesh,
                  const DataArrays& arrays);

/// Writes a piece, a .vtp, into a stream; the path is for messages.
using PieceWriter = std::function<void(OutputStream&, const std::filesystem::path&)>;

/// The same for any pieces with points about `origin`; `arrays`, which may have no rows, have the
/// names and types of theirs.
void write_pieces(Communicator& ranks, const std::filesystem::path& pvtp,
                  const Eigen::Vector3d& origin, const DataArrays& arrays,
                  const PieceWriter& write);

}  // namespace brindle::tool
