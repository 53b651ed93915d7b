#include "brindle/mesh_data.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "brindle/base/array_numbers.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/nearest.h"

namespace brindle {
namespace {

constexpr std::size_t kSearchGrain = 256;  // a search takes longer than what others do per vertex

/// Calls `take(v, point)` for all vertices of `to`, in coordinates of `from`.
template <class Take>
void for_each_vertex_near(const Mesh& from, const Mesh& to, const Progress& progress,
                          const Take& take) {
  const Eigen::Vector3d shift = to.origin - from.origin;
  parallel_for(
      to.vertex_count(), progress,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
          take(v, Eigen::Vector3d(to.positions[v].cast<double>() + shift));
        }
      },
      kSearchGrain);
}

/// `rows` has a row per point that was found.
DataArray spread(const DataArray& rows, const NearbyRows& nearby) {
  const std::vector<double> numbers = doubles_of(rows.view());
  const auto columns = static_cast<std::size_t>(rows.components);
  std::vector<double> all(nearby.found.size() * columns, std::numeric_limits<double>::quiet_NaN());
  auto next = numbers.begin();
  for (std::size_t v = 0; v < nearby.found.size(); ++v) {
    if (nearby.found[v] == 0) continue;
    std::copy_n(next, columns, &all[v * columns]);
    next += rows.components;
  }
  return make_data_array(rows.name, rows.components, all);
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

NearbyRows nearby_rows(const Mesh& from, const Mesh& to, double max_distance,
                       const Progress& progress) {
  if (from.positions.empty()) throw Error("a mesh without vertices has nothing to carry over");
  JobStages stages(progress, {{"nearest places", 1}, {"look up", 1}});
  const Progress building = stages.begin("nearest places");
  NearbyRows rows;
  rows.vertices.resize(to.vertex_count(), {{0, 0, 0}, {1, 0, 0}});
  rows.found.resize(to.vertex_count(), 0);
  if (from.triangles.empty()) {
    const NearestVertex nearest(from, building);
    for_each_vertex_near(
        from, to, stages.begin("look up"), [&](std::size_t v, const Eigen::Vector3d& point) {
          const std::optional<VertexNearby> found = nearest.nearest(point, max_distance);
          if (!found) return;
          rows.vertices[v] = {{found->vertex, found->vertex, found->vertex}, {1, 0, 0}};
          rows.found[v] = 1;
        });
    stages.finish();
    return rows;
  }
  rows.triangles.resize(to.vertex_count(), 0);
  const NearestOnMesh nearest(from, building);
  for_each_vertex_near(
      from, to, stages.begin("look up"), [&](std::size_t v, const Eigen::Vector3d& point) {
        const std::optional<PointOnMesh> found = nearest.nearest(point, max_distance);
        if (!found) return;
        rows.vertices[v] = {from.triangles[found->triangle], found->barycentric};
        rows.triangles[v] = found->triangle;
        rows.found[v] = 1;
      });
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
