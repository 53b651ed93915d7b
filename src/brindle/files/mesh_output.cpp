#include <algorithm>
#include <array>
#include <string>

#include "brindle/base/file_names.h"
#include "brindle/base/input_file.h"
#include "brindle/base/output_file.h"
#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/gltf/gltf_file.h"
#include "brindle/files/mesh_formats.h"
#include "brindle/files/vtk/vtp_file.h"
#include "brindle/files/written_arrays.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

/// The arrays in the form of the file. Throws if the file cannot hold one.
DataArrays checked_arrays(const fs::path& path, const Mesh& mesh,
                          std::span<const DataArray> point_arrays,
                          std::span<const DataArray> cell_arrays) {
  const std::string kind = lower_extension(path);
  constexpr std::array kKinds = {".obj", ".ply", ".vtp", ".gltf", ".glb", ".stl", ".3mf"};
  if (ranges::find(kKinds, kind) == kKinds.end()) {
    throw Error("cannot write '" + shown(path.string()) + "': the extension '" +
                shown(path.extension().string()) +
                "' is unknown; brindle writes .obj, .ply, .vtp, .gltf, .glb, .stl and .3mf");
  }
  check_rows(path, point_arrays, mesh.vertex_count(), "vertex");
  check_rows(path, cell_arrays, mesh.triangle_count(), "triangle");
  FittedArrays fitted = fitted_arrays(
      path, {{point_arrays.begin(), point_arrays.end()}, {cell_arrays.begin(), cell_arrays.end()}});
  if (!fitted.left_out.empty()) refuse_array(path, fitted.left_out.front());
  return std::move(fitted.arrays);
}

/// `path` with another extension.
fs::path beside(const fs::path& path, const char* ending) {
  return path.parent_path() / (path.stem().string() + ending);
}

fs::path picture_path(const fs::path& path) { return beside(path, "_texture.png"); }
fs::path materials_path(const fs::path& path) { return beside(path, ".mtl"); }

bool holds_picture(const std::string& kind) { return kind == ".gltf" || kind == ".glb"; }

void write_whole(const fs::path& path, const std::string& content) {
  write_file(path, [&](OutputStream& out) { out << content; });
}

/// File names of a mesh's texture; all empty if it has none.
struct TextureNames {
  std::string picture;    ///< image file beside the mesh
  std::string materials;  ///< material file beside an OBJ file
  std::string png;        ///< the image's content
};

void write_as(OutputStream& out, const std::string& kind, const Mesh& mesh,
              const DataArrays& arrays, const TextureNames& texture) {
  if (kind == ".obj") {
    write_obj(out, mesh, arrays.points, texture.materials);
  } else if (kind == ".ply") {
    write_ply(out, mesh, arrays, texture.picture);
  } else if (kind == ".vtp") {
    write_vtp(out, {.points = mesh.positions,
                    .triangles = mesh.triangles,
                    .point_arrays = arrays.points,
                    .cell_arrays = arrays.cells,
                    .origin = mesh.origin});
  } else if (kind == ".stl") {
    write_stl(out, mesh);
  } else if (kind == ".3mf") {
    write_3mf(out, mesh);
  } else {
    write_gltf(out, mesh, arrays.points, kind == ".glb" ? GltfKind::binary : GltfKind::text,
               texture.png);
  }
}

}  // namespace

void write_mesh(const fs::path& path, const Mesh& mesh, std::span<const DataArray> point_arrays,
                std::span<const DataArray> cell_arrays, const Progress& progress) {
  const DataArrays arrays = checked_arrays(path, mesh, point_arrays, cell_arrays);
  write_file(
      path, [&](OutputStream& out) { write_as(out, lower_extension(path), mesh, arrays, {}); },
      progress);
}

void write_textured_mesh(const fs::path& path, const Mesh& mesh,
                         std::span<const DataArray> point_arrays, const std::string& png,
                         std::span<const DataArray> cell_arrays, const Progress& progress) {
  const DataArrays arrays = checked_arrays(path, mesh, point_arrays, cell_arrays);
  if (std::none_of(arrays.points.begin(), arrays.points.end(), is_uv)) {
    throw Error("cannot write '" + shown(path.string()) +
                "': a textured mesh needs the array 'uv'");
  }
  static_cast<void>(textured_mesh_files(path));  // checks their names
  const fs::path picture = picture_path(path);
  const fs::path materials = materials_path(path);
  const std::string kind = lower_extension(path);
  if (!holds_picture(kind)) write_whole(picture, png);
  if (kind == ".obj") write_whole(materials, material_library(picture.filename().string()));
  const TextureNames names{picture.filename().string(), materials.filename().string(), png};
  write_file(
      path, [&](OutputStream& out) { write_as(out, kind, mesh, arrays, names); }, progress);
}

std::vector<fs::path> textured_mesh_files(const fs::path& path) {
  const std::string kind = lower_extension(path);
  std::vector<fs::path> files;
  if (!holds_picture(kind)) files.push_back(picture_path(path));
  if (kind == ".obj") files.push_back(materials_path(path));
  for (const fs::path& named : files) check_name_in_text(named);
  files.push_back(path);
  return files;
}

}  // namespace brindle
