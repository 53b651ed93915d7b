#include "brindle/mesh_data.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/array_numbers.h"
#include "brindle/base/array_rows.h"
#include "brindle/base/axis_mean.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/nearest_place.h"
#include "brindle/geometry/topology.h"

namespace brindle {
namespace {

std::vector<double> rows_of_none(std::size_t numbers) {
  return std::vector<double>(numbers, std::numeric_limits<double>::quiet_NaN());
}

/// The area of every triangle with a finite row, zero for the others. In doubles: squares of small
/// lengths underflow in float.
std::vector<double> weights_of_cells(const Mesh& mesh, std::span<const double> numbers,
                                     std::size_t columns) {
  std::vector<double> weights(mesh.triangle_count());
  parallel_for(weights.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto row = numbers.subspan(t * columns, columns);
      if (!std::all_of(row.begin(), row.end(), [](double x) { return std::isfinite(x); })) continue;
      const auto corner = [&](std::size_t i) {
        return mesh.positions[mesh.triangles[t][i]].cast<double>();
      };
      const Eigen::Vector3d a = corner(0);
      weights[t] = (corner(1) - a).cross(corner(2) - a).norm() / 2;
    }
  });
  return weights;
}

/// Sets `mean`, initially NaN, if any cell has a weight.
void mean_of_cells(std::span<const Index> cells, std::span<const double> weights,
                   std::span<const double> numbers, std::span<double> mean) {
  const std::size_t columns = mean.size();
  double sum = 0;
  const double* first = nullptr;
  for (const Index cell : cells) {
    if (weights[cell] == 0) continue;
    sum += weights[cell];
    if (first == nullptr) first = &numbers[cell * columns];
  }
  if (first == nullptr) return;
  // Relative to the first row, so that the mean of identical rows is exact.
  for (std::size_t c = 0; c < columns; ++c) {
    double difference = 0;
    for (const Index cell : cells) {
      if (weights[cell] == 0) continue;
      const double share = weights[cell] / sum;
      difference += share * numbers[cell * columns + c] - share * first[c];
    }
    mean[c] = first[c] + difference;
  }
}

/// The same for axes.
void axis_of_cells(std::span<const Index> cells, std::span<const double> weights,
                   std::span<const double> numbers, std::span<double> mean) {
  mean_of_cells(cells, weights, numbers, mean);
  const std::size_t columns = mean.size();
  std::vector<WeightedAxis> axes;
  for (const Index cell : cells) {
    const double* row = &numbers[cell * columns];
    if (weights[cell] == 0) continue;
    axes.push_back({{row[0], row[1], columns > 2 ? row[2] : 0}, weights[cell]});
  }
  if (const auto axis = mean_of_turned(axes)) std::copy_n(axis->data(), columns, mean.data());
}

constexpr std::size_t kSearchGrain = 256;  // a search takes longer than other work per vertex

/// Expands `rows`, one per point found, to all points; NaN for the others.
DataArray spread(const DataArray& rows, const NearbyRows& nearby) {
  const auto at_all = [&](const ArrayView& view) {
    const std::vector<double> numbers = doubles_of(view);
    std::vector<double> all = rows_of_none(nearby.found.size() * view.columns());
    auto next = numbers.begin();
    for (std::size_t v = 0; v < nearby.found.size(); ++v) {
      if (nearby.found[v] == 0) continue;
      std::copy_n(next, view.columns(), &all[v * view.columns()]);
      next += rows.components;
    }
    return make_data_array(rows.name, rows.components, all);
  };
  DataArray result = at_all(rows.view());
  if (!rows.axis_bytes.empty()) set_axes(result, at_all(rows.axes()).bytes);
  return result;
}

template <class Row>
std::vector<Row> of_found(const std::vector<Row>& rows, const NearbyRows& nearby) {
  std::vector<Row> found;
  for (std::size_t v = 0; v < rows.size(); ++v) {
    if (nearby.found[v] != 0) found.push_back(rows[v]);
  }
  return found;
}

}  // namespace

DataArray cells_to_points(const Mesh& mesh, const DataArray& cells) {
  check_rows_per_triangle(cells, mesh.triangle_count());
  const std::vector<double> numbers = doubles_of(cells.view());
  const auto columns = static_cast<std::size_t>(cells.components);
  const std::vector<double> weights = weights_of_cells(mesh, numbers, columns);
  const VertexTriangles around = vertex_triangles(mesh);
  const auto at_vertices = [&](const auto& take_mean) {
    std::vector<double> means = rows_of_none(mesh.vertex_count() * columns);
    parallel_for(mesh.vertex_count(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) {
        const auto mean = std::span(means).subspan(v * columns, columns);
        take_mean(around.of(v), weights, numbers, mean);
      }
    });
    return make_data_array(cells.name, cells.components, means);
  };
  DataArray result = at_vertices(mean_of_cells);
  if (may_be_axes(cells)) set_axes(result, at_vertices(axis_of_cells).bytes);
  return result;
}

std::vector<DataArray> arrays_at(std::span<const TrianglePoint> places,
                                 std::span<const Triangle> triangles, const DataArrays& arrays) {
  std::vector<RowBlend> blends;
  std::vector<Index> rows;
  for (const TrianglePoint& place : places) {
    blends.push_back({triangles[place.triangle], place.barycentric});
    rows.push_back(place.triangle);
  }
  std::vector<DataArray> result = blended(arrays.points, blends);
  for (DataArray& array : rows_of(arrays.cells, rows)) result.push_back(std::move(array));
  return result;
}

NearbyRows nearby_rows(const Mesh& from, const Mesh& to, double max_distance,
                       const Progress& progress) {
  if (from.positions.empty()) throw Error("a mesh without vertices has nothing to carry over");
  JobStages stages(progress, {{"nearest places", 1}, {"look up", 1}});
  const NearestPlace places(from, stages.begin("nearest places"));
  NearbyRows rows;
  rows.vertices.resize(to.vertex_count(), {{0, 0, 0}, {1, 0, 0}});
  rows.found.resize(to.vertex_count(), 0);
  if (!from.triangles.empty()) rows.triangles.resize(to.vertex_count(), 0);
  const Eigen::Vector3d shift = to.origin - from.origin;
  parallel_for(
      to.vertex_count(), stages.begin("look up"),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
          const Eigen::Vector3d point = to.positions[v].cast<double>() + shift;
          const std::optional<NearbyPlace> found = places.nearest(point, max_distance);
          if (!found) continue;
          rows.vertices[v] = {found->corners, found->barycentric};
          if (found->triangle) rows.triangles[v] = *found->triangle;
          rows.found[v] = 1;
        }
      },
      kSearchGrain);
  stages.finish();
  return rows;
}

DataArray carried_from_points(const DataArray& points, const NearbyRows& rows) {
  return spread(blended(points, of_found(rows.vertices, rows)), rows);
}

DataArray carried_from_cells(const DataArray& cells, const NearbyRows& rows) {
  if (rows.triangles.empty() && !rows.found.empty()) {
    throw Error("array '" + cells.name + "' belongs to triangles, and there are none");
  }
  return spread(rows_of(cells, of_found(rows.triangles, rows)), rows);
}

}  // namespace brindle
