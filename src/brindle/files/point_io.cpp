#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brindle/base/file_extension.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/csv_file.h"
#include "brindle/files/obj_file.h"
#include "brindle/files/ply_file.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

LoadedPoints read_csv_points(const fs::path& path) {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Vec3> normals;
  const CsvKind kind{"points", "x,y,z or x,y,z,nx,ny,nz"};
  read_csv(path, kind, [&](std::size_t line, std::span<const double> row) {
    if (row.size() != 3 && row.size() != 6) {
      throw Error(at_line(path, line) + std::to_string(row.size()) +
                  " columns; a row must have 3 (x,y,z) or 6 (x,y,z,nx,ny,nz)");
    }
    if (!positions.empty() && (row.size() == 6) == normals.empty()) {
      throw Error(at_line(path, line) + std::to_string(row.size()) +
                  " columns where the rows before have another number; give all the same");
    }
    positions.emplace_back(row[0], row[1], row[2]);
    if (row.size() == 6) {
      normals.push_back(Eigen::Vector3d(row[3], row[4], row[5]).cast<float>());
    }
  });
  return make_placed_point_cloud(positions, std::move(normals));
}

LoadedPoints read_any(const fs::path& path) {
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

bool is_point_file(const fs::path& path) {
  const std::string kind = lower_extension(path);
  if (kind == ".csv") return true;
  try {
    if (kind == ".ply") return !ply_has_faces(path);
    if (kind == ".obj") return !obj_has_faces(path);
  } catch (const Error&) {
  }
  return false;
}

LoadedPoints read_points(const fs::path& path) {
  try {
    LoadedPoints loaded = read_any(path);
    if (loaded.cloud.used.empty()) {
      throw Error(path.string() + ": has no point with finite coordinates; export it again");
    }
    return loaded;
  } catch (const std::bad_alloc&) {
    throw Error(path.string() + ": there is not enough memory for these points");
  }
}

}  // namespace brindle
