#include <algorithm>
#include <string>

#include "brindle/base/file_names.h"
#include "brindle/base/input_file.h"
#include "brindle/base/output_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/gltf/gltf_reader.h"
#include "brindle/files/gltf/gltf_writer.h"
#include "brindle/files/ply_file.h"
#include "brindle/files/stl_file.h"
#include "brindle/files/surface_file.h"
#include "brindle/files/text/obj_file.h"
#include "brindle/files/text/off_file.h"
#include "brindle/files/vtk/vtk_file.h"
#include "brindle/files/vtk/vtp_file.h"
#include "brindle/files/written_arrays.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReadable =
    "it reads .vtp, .vtu, .vtk, .ply, .obj, .stl, .off, .gltf and .glb";

/// Lets triangles use one of the vertices at one place, and removes the others where they have no
/// numbers.
void join(const fs::path& path, LoadedMesh& loaded) {
  std::vector<Index> first = first_at_each_place(loaded.mesh.positions);
  loaded.repair.vertices_joined = join_vertices(loaded.mesh, first);
  if (loaded.repair.vertices_joined == 0) return;
  if (lower_extension(path) == ".stl") {
    const std::vector<Index> number = drop_unreferenced_vertices(loaded.mesh);
    for (Index& v : first) v = number[v];
    loaded.renumbered = true;
  }
  loaded.vertex_of_row = std::move(first);
}

/// Drops triangles that cannot be used, with their rows.
void repair(LoadedMesh& loaded) {
  const std::size_t joined = loaded.repair.vertices_joined, count = loaded.mesh.triangle_count();
  std::vector<Index> kept;
  loaded.repair = repair_mesh(loaded.mesh, kept);
  loaded.repair.vertices_joined = joined;
  if (kept.size() < count) loaded.arrays.cells = rows_of(loaded.arrays.cells, kept);
}

void check_usable(const fs::path& path, const LoadedMesh& loaded, const std::string& why_empty) {
  if (!loaded.mesh.triangles.empty()) return;
  if (!why_empty.empty()) throw Error(shown(path.string()) + ": " + why_empty);
  const MeshRepair& repair = loaded.repair;
  std::string why = "has no triangles";
  if (repair.triangles_not_finite > 0) {
    why =
        "has no usable triangle: the corners of all have coordinates that are no numbers or beyond "
        "1e18, for which larger units are needed";
  } else if (repair.triangles_degenerate > 0) {
    why = "has no usable triangle: none has an area";
  }
  throw Error(shown(path.string()) + ": " + why +
              "; export the mesh again, as a surface with faces");
}

/// The arrays as the file holds them, if it holds them all.
DataArrays checked_arrays(const fs::path& path, const Mesh& mesh,
                          std::span<const DataArray> point_arrays,
                          std::span<const DataArray> cell_arrays) {
  const std::string kind = lower_extension(path);
  if (kind != ".obj" && kind != ".ply" && kind != ".vtp" && kind != ".gltf" && kind != ".glb") {
    throw Error("cannot write '" + shown(path.string()) + "': the extension '" +
                shown(path.extension().string()) +
                "' is unknown; brindle writes .obj, .ply, .vtp, .gltf and .glb");
  }
  check_rows(path, point_arrays, mesh.vertex_count(), "vertex");
  check_rows(path, cell_arrays, mesh.triangle_count(), "triangle");
  FittedArrays fitted = fitted_arrays(
      path, {{point_arrays.begin(), point_arrays.end()}, {cell_arrays.begin(), cell_arrays.end()}});
  if (!fitted.left_out.empty()) refuse_array(path, fitted.left_out.front());
  return std::move(fitted.arrays);
}

/// `path` with another ending.
fs::path beside(const fs::path& path, const char* ending) {
  return path.parent_path() / (path.stem().string() + ending);
}

fs::path picture_path(const fs::path& path) { return beside(path, "_texture.png"); }
fs::path materials_path(const fs::path& path) { return beside(path, ".mtl"); }

bool holds_picture(const std::string& kind) { return kind == ".gltf" || kind == ".glb"; }

void write_whole(const fs::path& path, const std::string& content) {
  write_file(path, [&](OutputStream& out) { out << content; });
}

/// What a mesh file says of its texture; all empty if it has none.
struct TextureNames {
  std::string picture;    ///< file beside the mesh
  std::string materials;  ///< file beside an OBJ file
  std::string png;        ///< the picture itself
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
  } else {
    write_gltf(out, mesh, arrays.points, kind == ".glb" ? GltfKind::binary : GltfKind::text,
               texture.png);
  }
}

}  // namespace

RawMesh read_raw_mesh(const fs::path& path, const Progress& progress) {
  const std::string kind = lower_extension(path);
  if (kind == ".obj") return {read_obj(path, progress)};
  if (kind == ".ply") return read_ply(path, progress);
  if (kind == ".off") return {read_off(path, progress)};
  if (kind == ".stl") return {read_stl(path, progress)};
  if (kind == ".gltf" || kind == ".glb") return read_gltf(path, progress);
  if (is_vtk_format(path)) return read_vtk(path, progress);
  const InputFile readable(path);
  if (kind == ".pvtp") {
    readable.fail_whole(
        "names the pieces of a surface, which 'mpirun -n 1 brindle-mpi' reads; or save it in "
        "ParaView as .vtp");
  }
  readable.fail_whole("brindle cannot tell the format by the extension '" +
                      shown(path.extension().string()) + "'; " + kReadable);
}

LoadedMesh mesh_of(const fs::path& path, RawMesh raw) {
  LoadedMesh loaded;
  loaded.mesh = std::move(raw.mesh);
  loaded.arrays = std::move(raw.arrays);
  loaded.left_out = raw.taken + raw.left_out;
  join(path, loaded);
  repair(loaded);
  check_usable(path, loaded, raw.why_empty);
  return loaded;
}

Mesh read_vertices(const fs::path& path) {
  try {
    LoadedMesh loaded;
    loaded.mesh = read_raw_mesh(path, {}).mesh;
    join(path, loaded);
    return std::move(loaded.mesh);
  } catch (const std::bad_alloc&) {
    throw Error(shown(path.string()) + ": there is not enough memory for this mesh");
  }
}

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
  static_cast<void>(textured_mesh_files(path));  // their names are checked
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
