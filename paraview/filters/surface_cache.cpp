#include "surface_cache.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <brindle/error.h>
#include <brindle/mesh_data.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include "global_numbers.h"
#include "rank_walls.h"
#include "vtk_arrays.h"

namespace brindle::paraview {
namespace {

vtkDataArray& found_array(vtkPolyData& triangles, const std::string& name, bool of_points) {
  vtkDataSetAttributes* attributes =
      of_points ? static_cast<vtkDataSetAttributes*>(triangles.GetPointData())
                : triangles.GetCellData();
  vtkDataArray* found = attributes->GetArray(name.c_str());
  if (found == nullptr) {
    throw Error("the surface has no array '" + name + "' of numbers per " +
                (of_points ? "point" : "cell"));
  }
  return *found;
}

/// Collective: where positions of all ranks are relative to, as `make_mesh` chooses it for all.
Eigen::Vector3d common_origin(vtkPolyData& triangles, const Ranks& ranks) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::array<double, 6> box = {kFar, kFar, kFar, -kFar, -kFar, -kFar};
  for (vtkIdType i = 0; i < triangles.GetNumberOfPoints(); ++i) {
    double p[3];
    triangles.GetPoint(i, p);
    for (std::size_t k = 0; k < 3; ++k) {
      box[k] = std::min(box[k], p[k]);
      box[k + 3] = std::max(box[k + 3], p[k]);
    }
  }
  for (const auto& other : ranks.all(box)) {
    for (std::size_t k = 0; k < 3; ++k) {
      box[k] = std::min(box[k], other[k]);
      box[k + 3] = std::max(box[k + 3], other[k + 3]);
    }
  }
  const std::vector<Index> no_triangles;
  return make_mesh({box.data(), 2, 3}, {no_triangles, 3}).origin;
}

void place_about(const Eigen::Vector3d& origin, vtkPolyData& triangles, Mesh& mesh) {
  mesh.origin = origin;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    Eigen::Vector3d p;
    triangles.GetPoint(static_cast<vtkIdType>(v), p.data());
    mesh.positions[v] = (p - origin).cast<float>();
  }
}

/// Own triangles first: of triangles that stand twice, a repair keeps the first. Returns the number
/// that each had.
std::vector<Index> put_ghosts_last(Mesh& mesh, std::span<const std::uint8_t> ghosts) {
  std::vector<Index> order(mesh.triangle_count());
  std::iota(order.begin(), order.end(), Index{0});
  if (ghosts.empty()) return order;
  std::ranges::stable_partition(order, [&](Index t) { return ghosts[t] == 0; });
  std::vector<Triangle> triangles;
  for (const Index t : order) triangles.push_back(mesh.triangles[t]);
  mesh.triangles = std::move(triangles);
  return order;
}

/// The points' vertices, the triangles that can be used, and the surface of this process's own.
InputSurface local_surface(const RawMesh& raw, Mesh mesh) {
  InputSurface made;
  made.vertex_of_point = first_at_each_place(mesh.positions);
  made.joined = join_vertices(mesh, made.vertex_of_point) > 0;
  const std::vector<Index> order = put_ghosts_last(mesh, raw.ghosts);
  repair_mesh(mesh, made.cell_of_triangle);
  for (Index& cell : made.cell_of_triangle) {
    cell = order[cell];
    made.points_of_triangle.push_back(raw.mesh.triangles[cell]);
  }
  made.surface = std::make_shared<const Surface>(make_surface(std::move(mesh)));
  return made;
}

/// Collective: one of the surfaces of all ranks.
void join_ranks(InputSurface& made, const RawMesh& raw, const Ranks& ranks) {
  std::vector<std::uint8_t> ghosts;
  for (const Index cell : made.cell_of_triangle) {
    ghosts.push_back(raw.ghosts.empty() ? 0 : raw.ghosts[cell]);
  }
  if (!ranks.any(std::ranges::count(ghosts, 0) > 0)) {
    throw Error("the input's surface has no triangle with an area");
  }
  Surface surface = *made.surface;
  const float diagonal = std::ranges::max(ranks.all(bounding_box(surface.mesh).diagonal()));
  std::vector<std::uint64_t> numbers = global_numbers(
      ranks, {surface.mesh.positions, made.vertex_of_point, raw.ids}, double{diagonal});
  made.piece =
      std::make_shared<const RankPiece>(ranks, surface.mesh, std::move(numbers), std::move(ghosts));
  const std::span<const Vec3> normals = made.piece->surface().normals();
  surface.normals.assign(normals.begin(), normals.end());
  made.surface = std::make_shared<const Surface>(std::move(surface));
}

/// Itself, or, if it has no points, one that has a list of none.
vtkSmartPointer<vtkPolyData> with_points(vtkSmartPointer<vtkPolyData> data) {
  if (data->GetPoints() != nullptr) return data;
  auto empty = vtkSmartPointer<vtkPolyData>::New();
  empty->SetPoints(vtkSmartPointer<vtkPoints>::New());
  return empty;
}

}  // namespace

DataArray InputSurface::array(const std::string& name, bool of_points) const {
  if (piece) return rows_of_piece(name, of_points);
  DataArray rows = data_array_of(found_array(*triangles, name, of_points));
  if (!of_points) return cells_to_points(surface->mesh, rows_of(rows, cell_of_triangle));
  return joined ? rows_of(rows, vertex_of_point) : std::move(rows);
}

/// As `array`. Ranks without rows need not have the array.
DataArray InputSurface::rows_of_piece(const std::string& name, bool of_points) const {
  const Ranks& ranks = piece->ranks();
  const bool any_rows = of_points ? surface->mesh.vertex_count() > 0 : !cell_of_triangle.empty();
  DataArray rows;
  ranks.together([&] {
    if (!any_rows) return;
    rows = data_array_of(found_array(*triangles, name, of_points));
    rows = rows_of(rows, of_points ? vertex_of_point : cell_of_triangle);
  });
  const std::vector<int> columns = ranks.all(any_rows ? rows.components : 0);
  const int most = std::ranges::max(columns);
  for (const int count : columns) {
    if (count == 0 || count == most) continue;
    throw Error("array '" + name + "' has " + std::to_string(most) +
                " numbers in a row on one rank, and " + std::to_string(count) + " on another");
  }
  if (!any_rows) rows = make_data_array(name, std::max(most, 1), std::vector<double>{});
  if (of_points) return rows;
  const auto each = static_cast<std::size_t>(rows.components);
  return make_data_array(name, rows.components,
                         piece->cells_to_points(surface->mesh, doubles_of(rows), each));
}

const InputSurface* SurfaceCache::surface_of(vtkDataObject* input, vtkAlgorithm* owner,
                                             const Ranks& ranks) {
  vtkSmartPointer<vtkPolyData> triangles;
  ranks.together([&] {
    triangles =
        ranks.alone() ? polygons_of(input, owner) : polygons_of(with_ghosts_of_all(input), owner);
  });
  const bool grid = is_grid(input) || triangles->GetNumberOfCells() == 0;
  if (!ranks.alone() && ranks.every(grid)) triangles = without_walls(triangles, ranks);
  ranks.together([&] { triangles = with_points(triangles_of(triangles, owner)); });
  if (!ranks.any(triangles->GetNumberOfPoints() > 0)) return nullptr;
  if (!ranks.any(triangles->GetNumberOfPolys() > 0)) {
    throw Error("the input has points, but no surface: stripes need polygons");
  }
  bool renewed = false;
  try {
    ranks.together([&] { renewed = this->read(*triangles, ranks); });
  } catch (...) {
    current_ = {};  // what other ranks have read belongs to no surface
    throw;
  }
  if (ranks.any(renewed)) derive(*triangles, ranks);
  current_.triangles = triangles;  // with this input's arrays
  return &current_;
}

/// Takes the numbers over if they are other ones than before, and returns whether they are.
bool SurfaceCache::read(vtkPolyData& triangles, const Ranks& ranks) {
  Stamp stamp{triangles.GetPoints()->GetData(), triangles.GetPolys(),
              std::max(triangles.GetPoints()->GetMTime(), triangles.GetPolys()->GetMTime())};
  for (vtkObject* more : {static_cast<vtkObject*>(triangles.GetCellGhostArray()),
                          static_cast<vtkObject*>(triangles.GetPointData()->GetGlobalIds())}) {
    if (more != nullptr) stamp.time = std::max(stamp.time, more->GetMTime());
  }
  if (current_.surface && stamp == stamp_) return false;
  RawMesh raw = ranks.alone() ? RawMesh{raw_mesh(triangles), {}, {}} : raw_piece(triangles);
  stamp_ = stamp;
  if (current_.surface && same(raw, raw_)) return false;
  raw_ = std::move(raw);
  return true;
}

void SurfaceCache::derive(vtkPolyData& triangles, const Ranks& ranks) {
  current_ = {};
  InputSurface made;
  if (ranks.alone()) {
    made = local_surface(raw_, raw_.mesh);
    if (made.surface->mesh.triangles.empty()) {
      throw Error("the input's surface has no triangle with an area");
    }
  } else {
    const Eigen::Vector3d origin = common_origin(triangles, ranks);
    ranks.together([&] {
      Mesh mesh = raw_.mesh;
      place_about(origin, triangles, mesh);
      made = local_surface(raw_, std::move(mesh));
    });
    join_ranks(made, raw_, ranks);
  }
  current_ = std::move(made);
  ++surfaces_made_;
}

}  // namespace brindle::paraview
