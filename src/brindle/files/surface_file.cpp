#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brindle/base/file_names.h"
#include "brindle/base/input_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/gltf/gltf_file.h"
#include "brindle/files/mesh_formats.h"
#include "brindle/files/vtk/vtk_file.h"
#include "brindle/files/vtk/vtk_surface.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

template <class Read>
auto with_memory(const fs::path& path, const char* what, const Read& read) {
  try {
    return read();
  } catch (const std::bad_alloc&) {
    throw Error(shown(path.string()) + ": there is not enough memory for " + what);
  }
}

constexpr const char* kReadable =
    "it reads .vtp, .vtu, .vtk, .ply, .obj, .stl, .off, .gltf and .glb";

/// Lets triangles use one of the vertices at one place, and removes the others from meshes that
/// have no numbers.
void join(bool renumbers, LoadedMesh& loaded) {
  std::vector<Index> first = first_at_each_place(loaded.mesh.positions);
  loaded.repair.vertices_joined = join_vertices(loaded.mesh, first);
  if (loaded.repair.vertices_joined == 0) return;
  if (renumbers) {
    const std::vector<Index> number = drop_unreferenced_vertices(loaded.mesh);
    for (Index& v : first) v = number[v];
    loaded.renumbered = true;
  }
  loaded.vertex_of_row = std::move(first);
}

/// Drops unusable triangles and their rows.
void repair(LoadedMesh& loaded) {
  const std::size_t joined = loaded.repair.vertices_joined, count = loaded.mesh.triangle_count();
  std::vector<Index> kept;
  loaded.repair = repair_mesh(loaded.mesh, kept);
  loaded.repair.vertices_joined = joined;
  if (kept.size() < count) loaded.arrays.cells = rows_of(loaded.arrays.cells, kept);
}

void check_usable(const std::string& name, const LoadedMesh& loaded, const std::string& why_empty) {
  if (!loaded.mesh.triangles.empty()) return;
  if (!why_empty.empty()) throw Error(name + ": " + why_empty);
  const MeshRepair& repair = loaded.repair;
  std::string why = "has no triangles";
  if (repair.triangles_not_finite > 0) {
    why =
        "has no usable triangle: the corners of all have coordinates that are no numbers or beyond "
        "1e18, for which larger units are needed";
  } else if (repair.triangles_degenerate > 0) {
    why = "has no usable triangle: none has an area";
  }
  throw Error(name + ": " + why + "; export the mesh again, as a surface with faces");
}

RawMesh read_raw_mesh(const fs::path& path, const Progress& progress) {
  const std::string kind = lower_extension(path);
  if (kind == ".obj") return read_obj(path, progress);
  if (kind == ".ply") return read_ply(path, progress);
  if (kind == ".off") return read_off(path, progress);
  if (kind == ".stl") return read_stl(path, progress);
  if (kind == ".gltf" || kind == ".glb") return read_gltf(path, progress);
  if (is_vtk_format(path)) return read_vtk(path, progress);
  const InputFile readable(path);
  if (kind == ".pvtp") {
    readable.fail_whole(
        "names the pieces of a surface, which 'mpirun -n 1 brindle' reads; or save it in "
        "ParaView as .vtp");
  }
  readable.fail_whole("brindle cannot tell the format by the extension '" +
                      shown(path.extension().string()) + "'; " + kReadable);
}

bool has_no_numbers(const fs::path& path) { return lower_extension(path) == ".stl"; }

LoadedMesh mesh_of(const std::string& name, bool renumbers, RawMesh raw) {
  LoadedMesh loaded;
  loaded.mesh = std::move(raw.mesh);
  loaded.arrays = std::move(raw.arrays);
  loaded.left_out = raw.taken + raw.left_out;
  join(renumbers, loaded);
  repair(loaded);
  check_usable(name, loaded, raw.why_empty);
  return loaded;
}

/// The array that the file declares as normals, or one named so.
const DataArray* normals_of(const RawMesh& raw) {
  for (const std::string& name : {raw.normals, std::string("Normals"), std::string("normal")}) {
    const DataArray* array = find_array(raw.arrays.points, name);
    if (array != nullptr && array->components == 3) return array;
  }
  return nullptr;
}

LoadedPoints points_of(RawMesh raw) {
  const DataArray* normals = normals_of(raw);
  LoadedPoints loaded = make_point_cloud(
      std::move(raw.mesh.positions),
      normals != nullptr ? vectors_of(normals->view(), "normals") : std::vector<Vec3>());
  loaded.cloud.origin = raw.mesh.origin;
  loaded.arrays = std::move(raw.arrays.points);
  loaded.left_out = std::move(raw.left_out);
  return loaded;
}

LoadedPoints read_raw_points(const fs::path& path) {
  const std::string kind = lower_extension(path);
  if (kind == ".csv") return read_csv_points(path);
  if (kind == ".ply") return read_ply_points(path);
  if (kind == ".obj") return read_obj_points(path);
  Mesh mesh = read_vertices(path);
  LoadedPoints loaded = make_point_cloud(std::move(mesh.positions));
  loaded.cloud.origin = mesh.origin;
  return loaded;
}

}  // namespace

struct SurfaceFile::Content {
  fs::path path;
  std::optional<FileElements> elements;
  std::optional<RawMesh> raw;  ///< of files that are read to find out whether they have faces

  RawMesh take(const Progress& progress) {
    if (!raw) return read_raw_mesh(path, progress);
    return *std::exchange(raw, std::nullopt);
  }

  FileElements find_elements(const Progress& progress) {
    const std::string kind = lower_extension(path);
    if (kind == ".csv") return {};
    if (kind == ".ply") return ply_elements(path);
    if (kind != ".obj" && !is_vtk_format(path)) return {true, false};
    raw = read_raw_mesh(path, progress);
    return raw->elements;
  }
};

SurfaceFile::SurfaceFile(fs::path path) : content_(std::make_unique<Content>()) {
  content_->path = std::move(path);
}
SurfaceFile::~SurfaceFile() = default;
SurfaceFile::SurfaceFile(SurfaceFile&&) noexcept = default;
SurfaceFile& SurfaceFile::operator=(SurfaceFile&&) noexcept = default;

const fs::path& SurfaceFile::path() const { return content_->path; }

bool SurfaceFile::has_faces(const Progress& progress) {
  if (content_->elements) return content_->elements->faces;
  try {
    content_->elements = content_->find_elements(progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception&) {
    content_->elements = FileElements{true, false};  // `mesh` reports the reason
  }
  return content_->elements->faces;
}

bool SurfaceFile::is_point_cloud(const Progress& progress) {
  if (has_faces(progress)) return false;
  if (!content_->elements->lines) return true;
  throw Error(shown(path().string()) +
              ": holds lines and no faces, and lines are no surface; export a mesh, or read "
              "it as points if they are all over a surface");
}

LoadedMesh SurfaceFile::mesh(const Progress& progress) {
  const std::string stage = "loading " + shown(path().string());
  JobStages stages(progress, {{stage, 1}});
  const Progress loading = stages.begin(stage);
  LoadedMesh loaded = with_memory(path(), "this mesh", [&] {
    return mesh_of(shown(path().string()), has_no_numbers(path()), content_->take(loading));
  });
  stages.finish();
  return loaded;
}

LoadedPoints SurfaceFile::points(const Progress& progress) {
  LoadedPoints loaded = with_memory(path(), "these points", [&] {
    if (is_vtk_format(path())) return points_of(content_->take(progress));
    content_->raw.reset();
    return read_raw_points(path());
  });
  if (!loaded.cloud.used.empty()) return loaded;
  throw Error(shown(path().string()) + ": has no point with finite coordinates; export it again");
}

Mesh read_vertices(const fs::path& path) {
  return with_memory(path, "this mesh", [&] {
    LoadedMesh loaded;
    loaded.mesh = read_raw_mesh(path, {}).mesh;
    join(has_no_numbers(path), loaded);
    return std::move(loaded.mesh);
  });
}

LoadedMesh read_mesh(const fs::path& path, const Progress& progress) {
  return SurfaceFile(path).mesh(progress);
}

LoadedMesh mesh_of_cells(CellArrays cells, const std::string& name) {
  check_columns(cells.points.view(), 3, "points");
  if (cells.types.size() != cells.ends.rows()) {
    throw Error(name + ": has " + std::to_string(cells.types.size()) + " types for " +
                std::to_string(cells.ends.rows()) + " cells");
  }
  std::vector<VtkPiece> pieces(1);
  pieces[0] = {std::move(cells.points), {}, std::move(cells.arrays), {}};
  pieces[0].cells.push_back(
      {std::move(cells.corners), std::move(cells.ends), std::move(cells.types), 0});
  return mesh_of(name, false, vtk_surface(name, std::move(pieces)));
}

LoadedPoints read_points(const fs::path& path) { return SurfaceFile(path).points(); }

bool is_point_file(const fs::path& path) { return !SurfaceFile(path).has_faces(); }

}  // namespace brindle
