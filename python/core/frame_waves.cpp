#include "frame_waves.h"

#include <algorithm>
#include <cmath>

#include "brindle/array_field.h"
#include "brindle/error.h"
#include "brindle/recipe/refusals.h"
#include "words.h"

namespace brindle::python {
namespace {

constexpr float kUnitSquare = 1e-5f;
constexpr float kTangentSine = 1e-3f;

bool is_unit(const Vec3& vector) { return std::abs(vector.squaredNorm() - 1) <= kUnitSquare; }

bool is_direction(const Vec3& vector, const Vec3& normal) {
  return vector.isZero(0) || (is_unit(vector) && std::abs(vector.dot(normal)) <= kTangentSine);
}

bool is_nan(float number) { return std::isnan(number); }

}  // namespace

Vec3 direction_of(const Vec3& vector, const Vec3& normal) {
  if (is_direction(vector, normal) && !normal.isZero(0)) return vector;
  return tangent_direction(vector, normal);
}

DirectionsIn::DirectionsIn(py::handle given, const Mesh& mesh, std::span<const Vec3> normals,
                           const std::function<std::span<const Vec3>()>& otherwise)
    : given_(given, mesh, "directions") {
  const std::span<const Vec3> rows = given_.rows();
  const bool units_stay = normals.empty();
  for (std::size_t v = 0; v < rows.size(); ++v) {
    if (units_stay && (is_unit(rows[v]) || rows[v].isZero(0))) continue;
    Vec3 direction = Vec3::Zero();
    if (rows[v].allFinite()) {
      if (normals.empty()) normals = otherwise();
      direction = direction_of(rows[v], normals[v]);
    }
    if (direction == rows[v]) continue;
    if (own_.empty()) own_.assign(rows.begin(), rows.end());
    nonfinite_ += rows[v].allFinite() ? 0 : 1;
    own_[v] = direction;
  }
}

FrequenciesIn::FrequenciesIn(py::handle given, const Mesh& mesh, const std::string& what,
                             std::span<const Vec3> directions) {
  const Table table = table_of(given, what);
  is_number_ = table.is_number;
  if (is_number_) {
    own_ = constant_frequency_field(numbers_of(table.view, what).front(), mesh.vertex_count());
    return;
  }
  check_rows(table.array, mesh, what);
  if (table.view.columns() == 1) {
    given_ = RowsIn<float>(table.array, mesh, what);
    const auto is_frequency = [](float f) { return f > 0 && std::isfinite(f); };
    if (std::ranges::all_of(given_.rows(), is_frequency)) return;
  }
  own_ = frequencies_of(data_array_of(what, table.array), directions);
}

bool FrequenciesIn::have_gaps() const { return std::ranges::any_of(rows(), is_nan); }

std::span<const Vec3> MovingNormals::operator()(std::span<const Vec3> positions) {
  const Mesh& mesh = surface_.mesh;
  if (mesh.triangles.empty() || std::ranges::equal(positions, mesh.positions)) {
    return surface_.normals;
  }
  if (!frames_) frames_.emplace(surface_);
  return frames_->normals(positions);
}

RowsIn<Vec3> rows_if_given(py::handle given, const Mesh& mesh, const std::string& what) {
  return given.is_none() ? RowsIn<Vec3>() : RowsIn<Vec3>(given, mesh, what);
}

FrameIn::FrameIn(const Surface& surface, const NormalsAt& normals_at, MovedNormals moved,
                 py::handle directions, py::handle frequencies, py::handle positions,
                 py::handle normals)
    : positions_(rows_if_given(positions, surface.mesh, "positions")),
      normals_(rows_if_given(normals, surface.mesh, "normals")),
      input_(places(surface, normals_at, moved)),
      directions_(directions, surface.mesh, input_.normals,
                  [&] { return normals_at(input_.positions); }),
      frequencies_(frequencies, surface.mesh, "frequencies", directions_.rows()) {
  input_.directions = directions_.rows();
  input_.frequencies = frequencies_.rows();
  if (frequencies_.have_gaps()) drop_gaps();
}

// Rows that are given take the place of the surface's.
FrameInput FrameIn::places(const Surface& surface, const NormalsAt& normals_at,
                           MovedNormals moved) const {
  FrameInput input;
  input.positions = positions_.rows().empty() ? surface.mesh.positions : positions_.rows();
  if (!normals_.rows().empty()) {
    input.normals = normals_.rows();
  } else if (std::ranges::equal(input.positions, surface.mesh.positions)) {
    input.normals = surface.normals;
  } else if (moved == MovedNormals::computed) {
    input.normals = normals_at(input.positions);
  }
  return input;
}

void FrameIn::drop_gaps() {
  if (std::ranges::all_of(input_.frequencies, is_nan)) {
    throw Error("frequencies: all are nan; give stripes per unit length where there is a wave");
  }
  own_directions_.assign(input_.directions.begin(), input_.directions.end());
  own_frequencies_.assign(input_.frequencies.begin(), input_.frequencies.end());
  drop_waves_without_frequency(own_directions_, own_frequencies_);
  input_.directions = own_directions_;
  input_.frequencies = own_frequencies_;
}

}  // namespace brindle::python
