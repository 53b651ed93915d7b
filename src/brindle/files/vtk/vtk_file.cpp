#include "brindle/files/vtk/vtk_file.h"

#include "brindle/base/file_names.h"
#include "brindle/files/vtk/vtk_legacy_file.h"
#include "brindle/files/vtk/vtk_xml_file.h"

namespace brindle {

bool is_vtk_format(const std::filesystem::path& path) {
  const std::string kind = lower_extension(path);
  return kind == ".vtp" || kind == ".vtu" || kind == ".vtk";
}

RawMesh read_vtk(const std::filesystem::path& path, const Progress& progress) {
  return lower_extension(path) == ".vtk" ? read_vtk_legacy(path, progress)
                                         : read_vtk_xml(path, progress);
}

}  // namespace brindle
