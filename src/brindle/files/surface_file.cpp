#include "brindle/files/surface_file.h"

#include <new>
#include <optional>
#include <string>
#include <utility>

#include "brindle/base/file_names.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files/ply_file.h"
#include "brindle/files/text/obj_file.h"
#include "brindle/files/vtk/vtk_file.h"

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

}  // namespace

struct SurfaceFile::Content {
  fs::path path;
  std::optional<bool> has_faces;
  std::optional<RawMesh> raw;  ///< of a file that had to be read to know whether it has faces

  RawMesh take(const Progress& progress) {
    if (!raw) return read_raw_mesh(path, progress);
    return *std::exchange(raw, std::nullopt);
  }

  bool find_faces(const Progress& progress) {
    const std::string kind = lower_extension(path);
    if (kind == ".csv") return false;
    if (kind == ".ply") return ply_has_faces(path);
    if (kind == ".obj") return obj_has_faces(path);
    if (!is_vtk_format(path)) return true;
    raw = read_vtk(path, progress);
    return raw->has_faces;
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
  if (content_->has_faces) return *content_->has_faces;
  try {
    content_->has_faces = content_->find_faces(progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception&) {
    content_->has_faces = true;  // `mesh` will say why
  }
  return *content_->has_faces;
}

LoadedMesh SurfaceFile::mesh(const Progress& progress) {
  const std::string stage = "loading " + shown(path().string());
  JobStages stages(progress, {{stage, 1}});
  const Progress loading = stages.begin(stage);
  LoadedMesh loaded = with_memory(
      path(), "this mesh", [&] { return mesh_of(path(), content_->take(loading.part(0, 0.9))); });
  stages.finish();
  return loaded;
}

LoadedPoints SurfaceFile::points(const Progress& progress) {
  LoadedPoints loaded = with_memory(path(), "these points", [&] {
    return is_vtk_format(path()) ? points_of(content_->take(progress)) : read_raw_points(path());
  });
  if (!loaded.cloud.used.empty()) return loaded;
  throw Error(shown(path().string()) + ": has no point with finite coordinates; export it again");
}

LoadedMesh read_mesh(const fs::path& path, const Progress& progress) {
  return SurfaceFile(path).mesh(progress);
}

LoadedPoints read_points(const fs::path& path) { return SurfaceFile(path).points(); }

bool is_point_file(const fs::path& path) { return !SurfaceFile(path).has_faces(); }

}  // namespace brindle
