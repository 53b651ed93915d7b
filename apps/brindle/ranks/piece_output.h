/// VTK's partitioned meshes: a .pvtp that lists one .vtp per rank.
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

/// The file of a rank: FILE_0.vtp and so on, beside `pvtp`.
std::filesystem::path piece_path(const std::filesystem::path& pvtp, int rank);

/// The .pvtp and all its pieces as outputs, including pieces of an older .pvtp with more ranks,
/// which are removed when the new one is written.
std::vector<UsedFile> files_of_pieces(const std::filesystem::path& pvtp, int ranks);

/// Throws Error on all ranks, as `write_pieces` would, if a file cannot be written.
void check_pieces(Communicator& ranks, const std::filesystem::path& pvtp);

/// Each rank writes its piece to an unnamed file (output_file.h). Once all are complete, they are
/// named, and rank 0 writes the .pvtp last. If a rank fails, all throw and existing files stay,
/// except for pieces if the naming itself fails; a killed rank leaves no files. All ranks have
/// arrays of the same names and types.
void write_pieces(Communicator& ranks, const std::filesystem::path& pvtp, const Mesh& mesh,
                  const DataArrays& arrays);

/// Writes a .vtp piece to a stream; the path is for messages.
using PieceWriter = std::function<void(OutputStream&, const std::filesystem::path&)>;

/// The same for any pieces with points relative to `origin`; `arrays`, whose rows are ignored, have
/// the names and types of theirs.
void write_pieces(Communicator& ranks, const std::filesystem::path& pvtp,
                  const Eigen::Vector3d& origin, const DataArrays& arrays,
                  const PieceWriter& write);

}  // namespace brindle::tool
