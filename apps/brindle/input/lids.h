/// Faces of a closed solid that paths leave out: its bottom and its top.
#pragma once

#include <optional>
#include <string>

#include "brindle/files.h"

namespace brindle::tool {

struct Lids {
  std::optional<float> degrees;  ///< from level, instead of a file
  std::string file;              ///< .csv: a number per triangle of the mesh's file; lids have 1
  Vec3 up = Vec3::UnitZ();
};

/// "30" or "lids.csv". Throws CLI::ValidationError for other text.
Lids parse_lids(const std::string& option, const std::string& text);

/// Removes the triangles of lids. Throws Error if the file does not fit, and unless some triangles
/// are lids and some are not.
void leave_out(const Lids& lids, LoadedMesh& loaded);

}  // namespace brindle::tool
