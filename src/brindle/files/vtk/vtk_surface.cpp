#include "brindle/files/vtk/vtk_surface.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <type_traits>
#include <utility>

#include "brindle/base/array_numbers.h"
#include "brindle/base/file_names.h"
#include "brindle/error.h"
#include "brindle/files/vtk/vtk_file.h"

namespace brindle {
namespace {

constexpr std::uint64_t kMostRows = 0xfffffffe;

enum class CellKind {
  nothing,
  point,
  line,
  polygon,
  pixel,
  strip,
  curved,
  half_curved,
  volume,
  unknown
};

bool is_among(std::uint8_t type, std::initializer_list<std::uint8_t> types) {
  return std::find(types.begin(), types.end(), type) != types.end();
}

/// The kinds of cells by VTK type (vtkCellType.h).
CellKind kind_of(std::uint8_t type) {
  if (type == 0) return CellKind::nothing;
  if (is_among(type, {1, kVtkPolyVertex})) return CellKind::point;
  if (is_among(type, {3, kVtkPolyLine, 21, 35, 68, 75})) return CellKind::line;
  if (is_among(type, {5, kVtkPolygon, 9})) return CellKind::polygon;
  if (type == kVtkTriangleStrip) return CellKind::strip;
  if (type == 8) return CellKind::pixel;
  if (is_among(type, {22, 23, 28, 34, 36})) return CellKind::curved;
  if (type == 30) return CellKind::half_curved;
  const bool volume = (type >= 10 && type <= 16) || (type >= 24 && type <= 33) || type == 37 ||
                      type == 41 || type == 42 || (type >= 64 && type <= 67) ||
                      (type >= 71 && type <= 74) || (type >= 78 && type <= 81);
  return volume ? CellKind::volume : CellKind::unknown;
}

/// Corners of a quadratic or biquadratic cell; a quadratic polygon has half as many corners as
/// points.
std::size_t sides_of(std::uint8_t type, std::size_t points) {
  if (is_among(type, {22, 34})) return 3;
  return is_among(type, {23, 28}) ? 4 : points / 2;
}

/// An integer converted to another type; the maximum for values out of range and for floating-point
/// numbers.
template <class Number, class Stored>
Number as(Stored value) {
  if constexpr (std::is_integral_v<Stored>) {
    if (std::in_range<Number>(value)) return static_cast<Number>(value);
  }
  return std::numeric_limits<Number>::max();
}

template <class Number>
std::vector<Number> as_numbers(const DataArray& array) {
  std::vector<Number> result;
  result.reserve(array.rows() * static_cast<std::size_t>(array.components));
  for_each_number(array.view(), [&](std::size_t, std::size_t, auto value) {
    result.push_back(as<Number>(value));
  });
  return result;
}

/// Reads the number at a place of an array as an Index.
using IndexReader = Index (*)(const std::byte* numbers, std::size_t place);

IndexReader index_reader(NumberType type) {
  IndexReader reader = nullptr;
  with_number_type(type, [&]<class Stored>(Stored) {
    reader = [](const std::byte* numbers, std::size_t place) {
      Stored value;
      std::memcpy(&value, numbers + place * sizeof value, sizeof value);
      return as<Index>(value);
    };
  });
  return reader;
}

}  // namespace

bool is_vtk_format(const std::filesystem::path& path) {
  const std::string kind = lower_extension(path);
  return kind == ".vtp" || kind == ".vtu" || kind == ".vtk";
}

RawMesh read_vtk(const std::filesystem::path& path, const Progress& progress) {
  return lower_extension(path) == ".vtk" ? read_vtk_legacy(path, progress)
                                         : read_vtk_xml(path, progress);
}

std::uint64_t vtk_points_of_cells(const DataArray& ends) {
  if (ends.rows() == 0) return 0;
  return as_numbers<std::uint64_t>(rows_of(ends, std::array{static_cast<Index>(ends.rows() - 1)}))
      .back();
}

std::vector<std::uint8_t> vtk_cell_types(const DataArray& types) {
  return as_numbers<std::uint8_t>(types);
}

void VtkSurface::add(VtkPiece piece) {
  const std::uint64_t points = piece.points.rows();
  std::uint64_t cells = cell_;
  for (const VtkCells& c : piece.cells) cells += c.ends.rows();
  if (builder_.vertex_count() + points > kMostRows || cells > kMostRows) {
    fail("has more points or cells than brindle can number; split it into parts");
  }
  const bool has_cells = cells > cell_;
  const auto first_point = static_cast<Index>(builder_.vertex_count());
  add_points(piece.points);
  for (const VtkCells& c : piece.cells) add_cells(c, first_point);
  if (points > 0) point_arrays_.add(std::move(piece.arrays.points));
  if (has_cells) cell_arrays_.add(std::move(piece.arrays.cells));
  if (normals_.empty()) normals_ = std::move(piece.normals);
}

void VtkSurface::add_points(const DataArray& points) {
  builder_.reserve_vertices(points.rows());
  with_number_type(points.type, [&]<class Number>(Number) {
    for (std::size_t row = 0; row < points.rows(); ++row) {
      std::array<Number, 3> place{};
      std::memcpy(place.data(), &points.bytes[row * sizeof place], sizeof place);
      builder_.add_vertex({static_cast<double>(place[0]), static_cast<double>(place[1]),
                           static_cast<double>(place[2])});
    }
  });
}

void VtkSurface::add_cells(const VtkCells& cells, Index first_point) {
  const std::size_t points = cells.points.rows();
  const Index existing = static_cast<Index>(builder_.vertex_count()) - first_point;
  const IndexReader read = index_reader(cells.points.type);
  builder_.reserve_polygons(cells.ends.rows(), points);
  std::uint64_t begin = 0;
  for_each_number(cells.ends.view(), [&](std::size_t cell, std::size_t, auto stored) {
    const auto end = as<std::uint64_t>(stored);
    if (end < begin || end > points) {
      fail("has cells whose offsets do not rise within their " + std::to_string(points) +
           " points; the file is damaged, export it again");
    }
    cell_points_.clear();
    for (; begin < end; ++begin) {
      const Index point = read(cells.points.bytes.data(), static_cast<std::size_t>(begin));
      if (point >= existing) fail_point(existing);
      cell_points_.push_back(point + first_point);
    }
    add_cell(cells.types.empty() ? cells.type : cells.types[cell], cell_points_);
    ++cell_;
  });
}

void VtkSurface::fail(const std::string& what) const { throw Error(name_ + ": " + what); }

void VtkSurface::fail_point(Index existing) const {
  fail("has cells over points that do not exist: there are " + std::to_string(existing) +
       "; the file is damaged, export it again");
}

void VtkSurface::add_cell(std::uint8_t stored_type, std::span<const Index> points) {
  const std::uint8_t type = vtk_plain_type(stored_type, points.size());
  const CellKind kind = kind_of(type);
  if (kind >= CellKind::polygon && kind <= CellKind::half_curved) ++surfaces_;
  switch (kind) {
    case CellKind::nothing:
      break;
    case CellKind::point:
      ++points_;
      break;
    case CellKind::line:
      ++lines_;
      break;
    case CellKind::polygon:
      builder_.add_polygon(points, cell_);
      break;
    case CellKind::pixel:
      check_size(points, 4);
      builder_.add_polygon(std::array{points[0], points[1], points[3], points[2]}, cell_);
      break;
    case CellKind::strip:
      builder_.add_strip(points, cell_);
      break;
    case CellKind::curved:
      add_curved(points, sides_of(type, points.size()));
      break;
    case CellKind::half_curved:  // two of its four sides have a mid-edge point
      check_size(points, 6);
      builder_.add_polygon(
          std::array{points[0], points[4], points[1], points[2], points[5], points[3]}, cell_);
      break;
    case CellKind::volume:
      add_volume(type, points);
      break;
    case CellKind::unknown:
      ++unknown_;
      break;
  }
}

void VtkSurface::add_curved(std::span<const Index> points, std::size_t sides) {
  check_size(points, 2 * sides);
  corners_.clear();
  for (std::size_t s = 0; s < sides; ++s) {
    corners_.push_back(points[s]);
    corners_.push_back(points[sides + s]);
  }
  builder_.add_polygon(corners_, cell_);
}

void VtkSurface::add_volume(std::uint8_t type, std::span<const Index> points) {
  const std::size_t least = VtkVolumes::points_of(type);
  if (least == 0) {
    ++unread_volumes_;
  } else {
    check_size(points, least);
    volumes_.add(type, points, cell_);
  }
}

void VtkSurface::check_size(std::span<const Index> points, std::size_t least) const {
  if (points.size() >= least) return;
  fail("has a cell of " + std::to_string(points.size()) + " points, number " +
       std::to_string(cell_) + ", whose type asks for " + std::to_string(least) +
       "; the file is damaged, export it again");
}

std::string VtkSurface::left_out() const {
  std::string text;
  const auto line = [&](std::size_t count, const std::string& what) {
    if (count > 0) text += std::to_string(count) + what;
  };
  line(points_ + lines_, " cells that are points or lines: left out\n");
  line(unread_volumes_ + volumes_.count(),
       " volume cells: left out; ParaView's filter Extract Surface gives their faces\n");
  line(unknown_,
       " cells of types that brindle does not read: left out; ParaView's filter "
       "Tessellate makes triangles of curved ones\n");
  return text;
}

std::string VtkSurface::take_boundary() {
  // Without the faces of unread cells, those of their neighbours would seem to be on the boundary.
  if (surfaces_ > 0 || unread_volumes_ > 0 || volumes_.count() == 0) return "";
  std::size_t faces = 0;
  volumes_.for_each_boundary_face(builder_.positions(),
                                  [&](std::span<const Index> corners, Index cell) {
                                    builder_.add_polygon(corners, cell);
                                    ++faces;
                                  });
  if (faces == 0) return "";
  std::string text = std::to_string(volumes_.count()) + " volume cells: the " +
                     std::to_string(faces) + " faces of their boundary are taken\n";
  volumes_ = {};
  return text;
}

std::string VtkSurface::why_empty() const {
  const std::size_t volumes = unread_volumes_ + volumes_.count();
  if (volumes > 0 && unread_volumes_ == 0) {
    return "holds " + std::to_string(volumes) +
           " volume cells that have no boundary, because each face belongs to two; export it "
           "again, "
           "with each cell once";
  }
  if (volumes > 0) {
    return "holds " + std::to_string(volumes) + " volume cells and no surface, " +
           std::to_string(unread_volumes_) +
           " of them of types whose faces brindle does not know; in ParaView, apply the filter "
           "Extract Surface and save its result as .vtp";
  }
  if (unknown_ == 0) return "";
  return "holds no cells that brindle reads; in ParaView, apply the filter Tessellate and save its "
         "result as .vtp or .vtu";
}

RawMesh VtkSurface::take(std::vector<Eigen::Vector3d>* exact) {
  const bool has_faces = surfaces_ + unread_volumes_ + volumes_.count() + unknown_ > 0;
  const std::string boundary = take_boundary();
  std::string text = left_out();
  DataArrays arrays{point_arrays_.take("points", text), cell_arrays_.take("cells", text)};
  RawMesh raw = builder_.take(std::move(arrays), exact);
  raw.left_out = std::move(text);
  raw.taken += boundary;
  raw.normals = std::move(normals_);
  raw.elements = {has_faces, lines_ > 0};
  // The mesh repair explains surface cells without triangles.
  if (surfaces_ == 0) raw.why_empty = why_empty();
  return raw;
}

}  // namespace brindle
