#include "surface_cache.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include <Eigen/Core>
#include <brindle/distributed_surface.h>
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
#include "vtk_data.h"

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

/// The bounding box of all ranks' points.
struct CommonBox {
  Eigen::Vector3d origin;  ///< of all positions, as `make_mesh` would choose it
  double diagonal = 0;
};

/// Collective.
CommonBox common_box(vtkPolyData& data, const Ranks& ranks) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::array<double, 6> box = {kFar, kFar, kFar, -kFar, -kFar, -kFar};
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
    double p[3];
    data.GetPoint(i, p);
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
  if (!std::ranges::all_of(box, [](double x) { return std::isfinite(x); })) {
    return {Eigen::Vector3d::Zero(), 0};  // empty, or rejected later
  }
  const std::vector<Index> no_triangles;
  return {make_mesh({box.data(), 2, 3}, {no_triangles, 3}).origin,
          (Eigen::Vector3d(&box[3]) - Eigen::Vector3d(&box[0])).norm()};
}

/// Collective. Identifies points that are one vertex.
PointNumbers point_numbers(vtkPolyData& data, const CommonBox& box, const Ranks& ranks) {
  std::vector<Vec3> positions;
  std::vector<std::int64_t> ids;
  ranks.throw_on_all([&] {
    positions = positions_about(box.origin, data);
    ids = ids_of(data);
  });
  return global_numbers(ranks, {positions, ids}, box.diagonal);
}

/// Sorts own triangles first: the repair keeps the first of repeated triangles. A single rank has
/// no use for ghosts, which are removed. Returns the old numbers.
std::vector<Index> put_ghosts_last(Mesh& mesh, std::span<const std::uint8_t> ghosts, bool alone) {
  std::vector<Index> order(mesh.triangle_count());
  std::iota(order.begin(), order.end(), Index{0});
  if (ghosts.empty()) return order;
  const auto own = std::ranges::stable_partition(order, [&](Index t) { return ghosts[t] == 0; });
  if (alone) order.erase(own.begin(), own.end());
  std::vector<Triangle> triangles;
  for (const Index t : order) triangles.push_back(mesh.triangles[t]);
  mesh.triangles = std::move(triangles);
  return order;
}

/// A single rank orders vertices by id, as several ranks do, so that the pattern is the same.
void order_vertices(std::span<const std::uint64_t> numbers, Mesh& mesh, InputSurface& made) {
  const auto key = [&](Index p) { return std::pair(numbers[p], p); };
  if (std::ranges::is_sorted(made.point_of_vertex, {}, key)) return;
  std::vector<Index> order(numbers.size()), place(numbers.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::sort(order, {}, key);
  std::vector<Vec3> positions;
  std::vector<Index> points;
  for (Index v = 0; v < order.size(); ++v) {
    place[order[v]] = v;
    positions.push_back(mesh.positions[order[v]]);
    points.push_back(made.point_of_vertex[order[v]]);
  }
  mesh.positions = std::move(positions);
  made.point_of_vertex = std::move(points);
  for (Triangle& triangle : mesh.triangles) {
    for (Index& v : triangle) v = place[v];
  }
  for (Index& v : made.vertex_of_point) v = place[v];
  made.joined = true;
}

/// Replaced vertices get the number of their replacement.
void keep_ids(const PointNumbers& numbers, InputSurface& made) {
  if (!numbers.by_id) return;
  std::vector<std::uint64_t> ids;
  for (const Index p : made.point_of_vertex) ids.push_back(numbers.of_points[made.source_of(p)]);
  made.ids = std::make_shared<const std::vector<std::uint64_t>>(std::move(ids));
}

/// Points for the vertices added by creases: copies of all points at such corners, in the order of
/// the vertices, which have the numbers of their points if none are joined.
void add_copied_points(const Mesh& mesh, const Creases& creases, InputSurface& made) {
  const auto first_copy = static_cast<Index>(mesh.vertex_count() - creases.copied.size());
  const auto for_copied_corners = [&](const auto& body) {
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Index vertex = mesh.triangles[t][k];
        if (vertex >= first_copy) body(vertex, made.points_of_triangle[t][k]);
      }
    }
  };
  std::map<std::pair<Index, Index>, Index> copies;  // of a vertex and its source point
  for_copied_corners([&](Index vertex, Index point) { copies[{vertex, point}] = 0; });
  for (auto& [of, copy] : copies) {
    const auto [vertex, point] = of;
    copy = static_cast<Index>(made.vertex_of_point.size());
    made.vertex_of_point.push_back(vertex);
    made.copied_points.push_back(point);
    if (made.point_of_vertex.size() == vertex) made.point_of_vertex.push_back(copy);
  }
  for_copied_corners([&](Index vertex, Index& point) { point = copies.at({vertex, point}); });
}

/// The points' vertices, and the mesh reduced to valid triangles.
InputSurface usable_triangles(const RawMesh& raw, Mesh& mesh, const PointNumbers& numbers,
                              bool alone) {
  InputSurface made;
  made.ids_refused = numbers.ids_refused;
  made.vertex_of_point = made.point_of_vertex = first_points(numbers.of_points);
  made.joined = join_vertices(mesh, made.vertex_of_point) > 0;
  if (alone && numbers.by_id) order_vertices(numbers.of_points, mesh, made);
  const std::vector<Index> order = put_ghosts_last(mesh, raw.ghosts, alone);
  repair_mesh(mesh, made.cell_of_triangle);
  for (Index& cell : made.cell_of_triangle) {
    cell = order[cell];
    made.points_of_triangle.push_back(raw.mesh.triangles[cell]);
  }
  return made;
}

/// Removes triangles that other ranks also have.
void drop_repeated(std::span<const std::uint8_t> repeated, InputSurface& made) {
  if (std::ranges::count(repeated, 1) == 0) return;
  Mesh mesh = made.surface->mesh;
  std::size_t left = 0;
  for (std::size_t t = 0; t < repeated.size(); ++t) {
    if (repeated[t] != 0) continue;
    mesh.triangles[left] = mesh.triangles[t];
    made.points_of_triangle[left] = made.points_of_triangle[t];
    made.cell_of_triangle[left++] = made.cell_of_triangle[t];
  }
  mesh.triangles.resize(left);
  made.points_of_triangle.resize(left);
  made.cell_of_triangle.resize(left);
  made.surface = std::make_shared<const Surface>(make_surface(std::move(mesh)));
}

std::vector<std::uint8_t> ghosts_among(const InputSurface& made, const RawMesh& raw) {
  std::vector<std::uint8_t> ghosts;
  for (const Index cell : made.cell_of_triangle) {
    ghosts.push_back(raw.ghosts.empty() ? 0 : raw.ghosts[cell]);
  }
  return ghosts;
}

/// Collective. Splits a partition at creases of the whole.
void split_over_ranks(const Ranks& ranks, float crease_angle, SurfacePiece& piece,
                      InputSurface& made) {
  std::optional<std::vector<Index>> copied;
  {
    const DistributedSurface whole(piece, ranks.communicator());
    copied = split_at_creases(whole, piece, crease_angle);
  }
  if (!copied) return;
  ranks.throw_on_all([&] {
    Creases creases{std::move(*copied), {}};
    add_copied_points(piece.mesh, creases, made);
    made.surface = std::make_shared<const Surface>(make_surface(piece.mesh, std::move(creases)));
  });
}

/// Collective. Makes one surface of all ranks' parts.
void join_ranks(InputSurface& made, const RawMesh& raw, const PointNumbers& numbers,
                const Ranks& ranks, float crease_angle) {
  const std::vector<std::uint64_t> of_vertices =
      vertex_numbers(ranks, numbers.of_points, made.vertex_of_point);
  const std::vector<std::uint8_t> repeated = repeated_triangles(
      {made.surface->mesh, of_vertices, ghosts_among(made, raw)}, ranks.communicator());
  ranks.throw_on_all([&] { drop_repeated(repeated, made); });
  std::vector<std::uint8_t> ghosts = ghosts_among(made, raw);
  if (!ranks.any(std::ranges::count(ghosts, 0) > 0)) {
    throw Error("the input's surface has no triangle with an area");
  }
  SurfacePiece piece{made.surface->mesh, of_vertices, std::move(ghosts)};
  split_over_ranks(ranks, crease_angle, piece, made);
  made.piece = std::make_shared<const RankPiece>(ranks, piece);
  Surface surface = *made.surface;
  const std::span<const Vec3> normals = made.piece->surface().normals();
  surface.normals.assign(normals.begin(), normals.end());
  made.surface = std::make_shared<const Surface>(std::move(surface));
}

/// The data, with an empty list of points if they have none.
vtkSmartPointer<vtkPolyData> with_points(vtkSmartPointer<vtkPolyData> data) {
  if (data->GetPoints() != nullptr) return data;
  auto empty = vtkSmartPointer<vtkPolyData>::New();
  empty->SetPoints(vtkSmartPointer<vtkPoints>::New());
  return empty;
}

/// The data, with copied points appended if there are any.
vtkSmartPointer<vtkPolyData> with_copies(vtkSmartPointer<vtkPolyData> data,
                                         std::span<const Index> copied) {
  if (copied.empty()) return data;
  std::vector<Index> points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  std::iota(points.begin(), points.end(), Index{0});
  points.insert(points.end(), copied.begin(), copied.end());
  const std::vector<RowBlend> rows = whole_rows(points);
  auto more = vtkSmartPointer<vtkPolyData>::New();
  more->SetPoints(blended_points(*data, rows));
  more->SetPolys(data->GetPolys());
  carry(*data->GetPointData(), rows, *more->GetPointData());
  more->GetCellData()->PassData(data->GetCellData());
  more->GetFieldData()->PassData(data->GetFieldData());
  return more;
}

}  // namespace

const Creases& KnownCreases::split(Mesh& mesh, float angle) {
  if (angle_ == angle && whole_ == mesh.triangles) {
    mesh.triangles = split_;
    add_rows_of_copies(creases_, mesh.positions);
    return creases_;
  }
  std::vector<Triangle> whole = mesh.triangles;
  creases_ = split_at_creases(mesh, angle);
  angle_ = angle;
  whole_ = std::move(whole);
  split_ = mesh.triangles;
  return creases_;
}

DataArray InputSurface::array_of_vertices(const std::string& name) const {
  if (piece) return rows_of_piece(name, true);
  DataArray rows = data_array_of(found_array(*triangles, name, true));
  return joined ? rows_of(rows, point_of_vertex) : std::move(rows);
}

DataArray InputSurface::array_of_triangles(const std::string& name) const {
  if (piece) return rows_of_piece(name, false);
  return rows_of(data_array_of(found_array(*triangles, name, false)), cell_of_triangle);
}

DataArray InputSurface::cells_to_points(const DataArray& rows) const {
  return piece ? piece->cells_to_points(surface->mesh, rows)
               : brindle::cells_to_points(surface->mesh, rows);
}

void InputSurface::carry_to_places(std::span<const TrianglePoint> places,
                                   vtkDataSetAttributes& points) const {
  std::vector<RowBlend> of_points, of_cells;
  for (const TrianglePoint& place : places) {
    of_points.push_back({points_of_triangle[place.triangle], place.barycentric});
    of_cells.push_back(whole_row(cell_of_triangle[place.triangle]));
  }
  carry(*triangles->GetPointData(), of_points, points);
  carry(*triangles->GetCellData(), of_cells, points);
}

/// One row per vertex or triangle. Ranks without rows may lack the array.
DataArray InputSurface::rows_of_piece(const std::string& name, bool of_points) const {
  const Ranks& ranks = piece->ranks();
  const bool any_rows = of_points ? surface->mesh.vertex_count() > 0 : !cell_of_triangle.empty();
  DataArray rows;
  ranks.throw_on_all([&] {
    if (!any_rows) return;
    rows = data_array_of(found_array(*triangles, name, of_points));
    rows = rows_of(rows, of_points ? point_of_vertex : cell_of_triangle);
  });
  const std::vector<int> columns = ranks.all(any_rows ? rows.components : 0);
  const int most = std::ranges::max(columns);
  for (const int count : columns) {
    if (count == 0 || count == most) continue;
    throw Error("array '" + name + "' has " + std::to_string(most) +
                " numbers in a row on one rank, and " + std::to_string(count) + " on another");
  }
  if (!any_rows) rows = make_data_array(name, std::max(most, 1), std::vector<double>{});
  return rows;
}

const InputSurface* SurfaceCache::surface_of(vtkDataObject* input, vtkAlgorithm* owner,
                                             const Ranks& ranks, float crease_angle) {
  const bool grid = is_grid(input);
  vtkSmartPointer<vtkPolyData> triangles;
  ranks.throw_on_all([&] {
    vtkSmartPointer<vtkDataObject> marked = input;
    if (grid) marked = with_solids_marked(input);
    triangles = polygons_of(with_ghosts_of_all(marked), owner);
  });
  const CommonBox box = common_box(*triangles, ranks);
  if (ranks.every(grid || triangles->GetNumberOfCells() == 0)) {
    triangles = without_walls(triangles, point_numbers(*triangles, box, ranks).of_points, ranks);
  }
  ranks.throw_on_all([&] { triangles = with_points(triangles_of(triangles, box.origin)); });
  if (!ranks.any(triangles->GetNumberOfPoints() > 0)) return nullptr;
  if (!ranks.any(triangles->GetNumberOfPolys() > 0)) {
    throw Error("the input has points, but no surface: stripes need polygons");
  }
  bool renewed = false;
  try {
    ranks.throw_on_all([&] { renewed = this->read(*triangles); });
  } catch (...) {
    current_ = {};  // other ranks' state is unknown, so discard this one
    throw;
  }
  if (ranks.any(renewed || crease_angle_ != crease_angle)) derive(*triangles, ranks, crease_angle);
  current_.triangles =
      with_copies(triangles, current_.copied_points);  // with the arrays of this input
  return &current_;
}

/// Stores the numbers if they have changed, and returns whether they have.
bool SurfaceCache::read(vtkPolyData& triangles) {
  Stamp stamp{triangles.GetPoints()->GetData(), triangles.GetPolys(),
              std::max(triangles.GetPoints()->GetMTime(), triangles.GetPolys()->GetMTime())};
  for (vtkObject* more : {static_cast<vtkObject*>(triangles.GetCellGhostArray()),
                          static_cast<vtkObject*>(triangles.GetPointData()->GetGlobalIds())}) {
    if (more != nullptr) stamp.time = std::max(stamp.time, more->GetMTime());
  }
  if (current_.surface && stamp == stamp_) return false;
  RawMesh raw = raw_mesh(triangles);
  stamp_ = stamp;
  if (current_.surface && same(raw, raw_)) return false;
  raw_ = std::move(raw);
  return true;
}

void SurfaceCache::derive(vtkPolyData& triangles, const Ranks& ranks, float crease_angle) {
  current_ = {};
  const CommonBox box = common_box(triangles, ranks);
  const PointNumbers numbers = point_numbers(triangles, box, ranks);
  InputSurface made;
  ranks.throw_on_all([&] {
    Mesh mesh = raw_.mesh;
    if (!ranks.alone()) {
      mesh.origin = box.origin;
      mesh.positions = positions_about(box.origin, triangles);
    }
    made = usable_triangles(raw_, mesh, numbers, ranks.alone());
    if (ranks.alone() && mesh.triangles.empty()) {
      throw Error("the input's surface has no triangle with an area");
    }
    Creases creases;
    if (ranks.alone()) creases = creases_.split(mesh, crease_angle);
    add_copied_points(mesh, creases, made);
    made.surface =
        std::make_shared<const Surface>(make_surface(std::move(mesh), std::move(creases)));
  });
  if (!ranks.alone()) join_ranks(made, raw_, numbers, ranks, crease_angle);
  keep_ids(numbers, made);
  current_ = std::move(made);
  crease_angle_ = crease_angle;
  ++surfaces_made_;
}

}  // namespace brindle::paraview
