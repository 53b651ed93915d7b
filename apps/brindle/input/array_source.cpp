#include "input/array_source.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/mesh_data.h"
#include "input/preparation.h"

namespace brindle::tool {
namespace {

/// Prefixes each line with the name of the file.
std::string lines_about(const std::string& file, const std::string& text) {
  std::string lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    lines += shown(file) + ": " + text.substr(begin, end - begin);
    begin = end;
  }
  return lines;
}

}  // namespace

/// The mesh of another file, with its arrays.
struct OtherMesh {
  std::string file;
  Mesh mesh;
  DataArrays arrays;
  std::string notes;
  NearbyRows rows;  // one per vertex of the surface
};

namespace {

OtherMesh read_other(const std::string& file) {
  OtherMesh other;
  other.file = file;
  SurfaceFile surface(file);
  if (!surface.has_faces()) {
    LoadedPoints loaded = surface.points();
    other.notes = describe(loaded);
    for (const Index i : loaded.cloud.used) {
      other.mesh.positions.push_back(loaded.cloud.positions[i]);
    }
    other.mesh.origin = loaded.cloud.origin;
    other.arrays.points = rows_of(loaded.arrays, loaded.cloud.used);
  } else {
    LoadedMesh loaded = surface.mesh();
    other.notes = describe(loaded);
    other.mesh = std::move(loaded.mesh);
    other.arrays = std::move(loaded.arrays);
  }
  other.notes = lines_about(file, other.notes);
  return other;
}

}  // namespace

ArraySource::ArraySource(const Surface& surface, const DataArrays& arrays, std::string file,
                         const ArrayOptions& options)
    : surface_(surface), own_(arrays), file_(std::move(file)) {
  if (options.mesh.empty()) return;
  other_ = std::make_unique<OtherMesh>(read_other(options.mesh));
  const Length limit = options.max_distance.value_or(kDefaultMaxDistance);
  const float distance = limit.on(bounding_box(surface.mesh).diagonal());
  other_->rows = nearby_rows(other_->mesh, surface.mesh, static_cast<double>(distance));
}

ArraySource::~ArraySource() = default;

ArraySource::PerVertex ArraySource::array(const std::string& name) const {
  const DataArrays& arrays = other_ ? other_->arrays : own_;
  const auto [array, of_cells] = choice_of(arrays, name, other_ ? other_->file : file_);
  const std::size_t nonfinite = nonfinite_rows(*array);
  if (other_) {
    return {of_cells ? carried_from_cells(*array, other_->rows)
                     : carried_from_points(*array, other_->rows),
            nonfinite};
  }
  if (of_cells) return {cells_to_points(surface_.mesh, *array), nonfinite, *array};
  return {*array, nonfinite};
}

std::optional<std::size_t> ArraySource::drop_too_far(DirectionField& directions) const {
  if (!other_) return std::nullopt;
  std::size_t count = 0;
  for (Index v = 0; v < directions.size(); ++v) {
    if (is_near(v)) continue;
    directions[v] = Vec3::Zero();
    count += surface_.neighborhood->of(v).empty() ? 0 : 1;
  }
  return count;
}

bool ArraySource::is_near(Index vertex) const { return !other_ || other_->rows.found[vertex] != 0; }

std::string ArraySource::notes() const { return other_ ? other_->notes : ""; }

}  // namespace brindle::tool
