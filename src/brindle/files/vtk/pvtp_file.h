/// VTK's partitioned surfaces: a .pvtp that lists one .vtp per piece.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "brindle/data_arrays.h"

namespace brindle {

/// An array that all pieces have.
struct PieceArray {
  std::string name;
  int components = 1;
};

struct PieceList {
  std::vector<std::filesystem::path> pieces;  ///< one at least
  std::vector<PieceArray> points, cells;
  std::string global_ids;  ///< name of the array of global ids per point, or empty
};

/// Reads the .pvtp alone. Throws Error with the file and the remedy if it cannot be read, is no
/// XML, is no partitioned PolyData or lists no piece.
PieceList read_pvtp(const std::filesystem::path& path);

/// Throws Error with the piece and the array unless `arrays` are those of the list.
void check_piece_arrays(const std::filesystem::path& piece, const PieceList& list,
                        const DataArrays& arrays);

}  // namespace brindle
