/// Surfaces in pieces as VTK has them: a .pvtp that names a .vtp for each piece.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "brindle/data_arrays.h"

namespace brindle {

/// An array that every piece has.
struct PieceArray {
  std::string name;
  int components = 1;
};

struct PieceList {
  std::vector<std::filesystem::path> pieces;  ///< one at least
  std::vector<PieceArray> points, cells;
  std::string global_ids;  ///< name of the array of global ids per point, or empty
};

/// Reads the .pvtp alone. Throws Error, naming the file and the remedy, if it cannot be read, is no
/// XML, holds something else than a surface in pieces, or names no piece.
PieceList read_pvtp(const std::filesystem::path& path);

/// Throws Error, naming the piece and the array, unless `arrays` are all that the list announces.
void check_piece_arrays(const std::filesystem::path& piece, const PieceList& list,
                        const DataArrays& arrays);

}  // namespace brindle
