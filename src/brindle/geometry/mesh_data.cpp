#include "brindle/mesh_data.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/array_numbers.h"
#include "brindle/base/array_rows.h"
#include "brindle/base/parallel.h"
#include "brindle/geometry/subdivide.h"
#include "brindle/geometry/topology.h"

namespace brindle {
namespace {

/// The area of every triangle whose row counts, and zero for the others. In double precision: the
/// square of a small length is no float.
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

/// Replaces `mean`, a row of NaN, unless no cell counts.
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
  // Relative to the first row, so that rows that are all alike have exactly themselves as mean.
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

/// Where the vertices and the triangles of a mesh that was subdivided once come from.
struct Parents {
  std::vector<RowBlend> of_vertices;
  std::vector<Index> of_triangles;
};

Parents parents_of(const Mesh& coarse, const Mesh& fine) {
  Parents parents;
  parents.of_vertices.resize(fine.vertex_count());
  for (Index v = 0; v < coarse.vertex_count(); ++v) {
    parents.of_vertices[v] = {{v, v, v}, {1, 0, 0}};
  }
  for (std::size_t t = 0; t < coarse.triangle_count(); ++t) {
    const Triangle& inner = fine.triangles[4 * t + 3];  // its corners: the midpoints ab, bc, ca
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(coarse.triangles[t][i], coarse.triangles[t][(i + 1) % 3]);
      parents.of_vertices[inner[i]] = {{a, b, b}, {0.5, 0.5, 0}};
    }
  }
  parents.of_triangles.resize(fine.triangle_count());
  for (std::size_t t = 0; t < fine.triangle_count(); ++t) {
    parents.of_triangles[t] = static_cast<Index>(t / 4);
  }
  return parents;
}

}  // namespace

DataArray cells_to_points(const Mesh& mesh, const DataArray& cells) {
  check_rows_per_triangle(cells, mesh.triangle_count());
  const std::vector<double> numbers = doubles_of(cells.view());
  const auto columns = static_cast<std::size_t>(cells.components);
  const std::vector<double> weights = weights_of_cells(mesh, numbers, columns);
  const VertexTriangles around = vertex_triangles(mesh);
  std::vector<double> means(mesh.vertex_count() * columns,
                            std::numeric_limits<double>::quiet_NaN());
  parallel_for(mesh.vertex_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      mean_of_cells(around.of(v), weights, numbers, std::span(means).subspan(v * columns, columns));
    }
  });
  return make_data_array(cells.name, cells.components, means);
}

void subdivide(Mesh& mesh, DataArrays& arrays, int times, const Progress& progress) {
  subdivide(mesh, arrays, times, Midpoints::straight, progress);
}

void subdivide(Mesh& mesh, DataArrays& arrays, int times, Midpoints midpoints,
               const Progress& progress) {
  check_subdivisions(mesh.triangle_count(), times);
  for (const DataArray& array : arrays.points) {
    check_rows_per_vertex(array, mesh.vertex_count());
  }
  for (const DataArray& array : arrays.cells) {
    check_rows_per_triangle(array, mesh.triangle_count());
  }
  if (arrays == DataArrays{}) {
    mesh = progress.is_heard() ? subdivide(mesh, times, midpoints, progress)
                               : subdivide(std::move(mesh), times, midpoints);
    return;
  }
  if (times == 0 || mesh.triangles.empty()) return;
  const std::vector<JobStage> rounds = subdivision_rounds(times);
  JobStages stages(progress, rounds);
  Mesh result = mesh;
  DataArrays data = arrays;
  for (const JobStage& round : rounds) {
    const Progress stage = stages.begin(round.name);
    Mesh finer = subdivide(result, 1, midpoints, stage.part(0, 0.5));
    stage.report(0.5);
    const Parents parents = parents_of(result, finer);
    data = {blended(data.points, parents.of_vertices), rows_of(data.cells, parents.of_triangles)};
    result = std::move(finer);
  }
  stages.finish();
  mesh = std::move(result);
  arrays = std::move(data);
}

}  // namespace brindle
