#include "brindle/files/vtk/vtk_surface.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/array_numbers.h"
#include "brindle/base/file_names.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/files/read_arrays.h"
#include "brindle/files/vtk/vtk_file.h"
#include "brindle/types.h"

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

using Corners = std::vector<std::uint8_t>;
using Edge = std::array<std::uint8_t, 2>;

/// A solid by its faces and the edges that have mid-edge points, in the order of these points.
struct Solid {
  std::size_t points = 0;  ///< of a cell: the first ones, if it has more
  std::vector<Corners> faces;
  std::vector<Edge> edges;
  std::size_t corners = 0;
};

const std::vector<Corners> kTetraFaces = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}};
const std::vector<Corners> kHexaFaces = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
                                         {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};
const std::vector<Corners> kVoxelFaces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                          {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
const std::vector<Corners> kWedgeFaces = {
    {0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}};
const std::vector<Corners> kPyramidFaces = {
    {0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

const std::vector<Edge> kTetraEdges = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
const std::vector<Edge> kHexaEdges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                      {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
const std::vector<Edge> kTriangularEdges = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}};
const std::vector<Edge> kWedgeEdges = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5},
                                       {5, 3}, {0, 3}, {1, 4}, {2, 5}};
const std::vector<Edge> kPyramidEdges = {{0, 1}, {1, 2}, {2, 3}, {3, 0},
                                         {0, 4}, {1, 4}, {2, 4}, {3, 4}};

/// The faces of a prism over a polygon.
std::vector<Corners> prism_faces(std::uint8_t sides) {
  std::vector<Corners> faces(2);
  for (std::uint8_t i = 0; i < sides; ++i) {
    const auto next = static_cast<std::uint8_t>((i + 1) % sides);
    faces[0].insert(faces[0].begin(), i);
    faces[1].push_back(static_cast<std::uint8_t>(i + sides));
    faces.push_back(
        {i, next, static_cast<std::uint8_t>(next + sides), static_cast<std::uint8_t>(i + sides)});
  }
  return faces;
}

Solid solid(std::size_t corners, std::vector<Corners> faces, std::vector<Edge> edges = {}) {
  return {corners + edges.size(), std::move(faces), std::move(edges), corners};
}

/// The solid of a VTK type (vtkCellType.h, GetFaceArray and GetEdgeArray of the cells); null for
/// other types.
const Solid* solid_of(std::uint8_t type) {
  static const std::vector<std::pair<std::uint8_t, Solid>> kSolids = [] {
    std::vector<std::pair<std::uint8_t, Solid>> solids = {
        {10, solid(4, kTetraFaces)},
        {11, solid(8, kVoxelFaces)},
        {12, solid(8, kHexaFaces)},
        {13, solid(6, kWedgeFaces)},
        {14, solid(5, kPyramidFaces)},
        {15, solid(10, prism_faces(5))},
        {16, solid(12, prism_faces(6))},
        {24, solid(4, kTetraFaces, kTetraEdges)},
        {31, solid(6, kWedgeFaces, kTriangularEdges)}};
    for (const int number : {25, 29, 33}) {
      solids.emplace_back(static_cast<std::uint8_t>(number), solid(8, kHexaFaces, kHexaEdges));
    }
    for (const int number : {26, 32}) {
      solids.emplace_back(static_cast<std::uint8_t>(number), solid(6, kWedgeFaces, kWedgeEdges));
    }
    for (const int number : {27, 37}) {
      solids.emplace_back(static_cast<std::uint8_t>(number),
                          solid(5, kPyramidFaces, kPyramidEdges));
    }
    return solids;
  }();
  const auto found = ranges::find(kSolids, type, &std::pair<std::uint8_t, Solid>::first);
  return found == kSolids.end() ? nullptr : &found->second;
}

/// Identifies a face in two cells: its four smallest corner indices, each once. Repeated corners
/// make a quadrangle a triangle, as in hexahedra that represent wedges.
using FaceKey = std::array<Index, 4>;
constexpr Index kNoCorner = 0xffffffff;

FaceKey key_of(std::span<const Index> corners) {
  std::array<Index, 6> sorted{};
  ranges::copy(corners, sorted.begin());
  const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(corners.size());
  ranges::sort(sorted.begin(), end);
  const auto last = std::unique(sorted.begin(), end);
  FaceKey key;
  key.fill(kNoCorner);
  std::copy(sorted.begin(), std::min(last, sorted.begin() + 4), key.begin());
  return key;
}

/// The corners with the mid-edge points between them.
void add_points_of_edges(const Solid& solid, const Corners& face, std::span<const Index> points,
                         std::vector<Index>& polygon) {
  for (std::size_t i = 0; i < face.size(); ++i) {
    const std::uint8_t a = face[i], b = face[(i + 1) % face.size()];
    polygon.push_back(points[a]);
    for (std::size_t e = 0; e < solid.edges.size(); ++e) {
      const Edge& edge = solid.edges[e];
      if ((edge[0] == a && edge[1] == b) || (edge[0] == b && edge[1] == a)) {
        polygon.push_back(points[solid.corners + e]);
      }
    }
  }
}

Eigen::Vector3d centre_of(std::span<const Eigen::Vector3d> positions,
                          std::span<const Index> points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Index point : points) sum += positions[point];
  return sum / static_cast<double>(points.size());
}

/// Whether the face's corners are anticlockwise seen from inside the cell.
bool faces_inwards(std::span<const Eigen::Vector3d> positions, std::span<const Index> face,
                   const Eigen::Vector3d& centre_of_cell) {
  const Eigen::Vector3d centre = centre_of(positions, face);
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < face.size(); ++i) {
    normal += (positions[face[i]] - centre).cross(positions[face[(i + 1) % face.size()]] - centre);
  }
  return normal.dot(centre - centre_of_cell) < 0;
}

/// The linear or quadratic type of a Lagrange or Bezier cell with `points` points; other types are
/// returned unchanged. (Bezier cells of order 2 have points off their surface.)
std::uint8_t plain_type(std::uint8_t type, std::size_t points) {
  struct Plain {
    std::uint8_t type;
    std::size_t points;
    std::uint8_t plain;
  };
  constexpr std::array<Plain, 15> kPlain = {{{69, 3, 5},
                                             {69, 6, 22},
                                             {70, 4, 9},
                                             {70, 9, 28},
                                             {71, 4, 10},
                                             {71, 10, 24},
                                             {72, 8, 12},
                                             {73, 6, 13},
                                             {74, 5, 14},
                                             {76, 3, 5},
                                             {77, 4, 9},
                                             {78, 4, 10},
                                             {79, 8, 12},
                                             {80, 6, 13},
                                             {81, 5, 14}}};
  for (const Plain& plain : kPlain) {
    if (plain.type == type && plain.points == points) return plain.plain;
  }
  return type;
}

/// Volume cells with known faces: tetrahedra, voxels, hexahedra, wedges, pyramids, prisms and their
/// quadratic forms.
class VtkVolumes {
 public:
  /// The smallest number of points of a cell of this type; 0 if its faces are unknown.
  static std::size_t points_of(std::uint8_t type) {
    const Solid* solid = solid_of(type);
    return solid == nullptr ? 0 : solid->points;
  }

  /// A cell of a known type with at least `points_of` points; `cell` is its row.
  void add(std::uint8_t type, std::span<const Index> points, Index cell) {
    types_.push_back(type);
    cells_.push_back(cell);
    const auto end = points.begin() + static_cast<std::ptrdiff_t>(points_of(type));
    points_.insert(points_.end(), points.begin(), end);
  }

  std::size_t count() const { return types_.size(); }

  /// Calls `use` with the corners of every face that belongs to one cell only, and the cell's row,
  /// in cell order. Mid-edge points are between the corners. Faces are wound anticlockwise from
  /// outside, whatever the order of the cell's points.
  template <class Use>
  void for_each_boundary_face(std::span<const Eigen::Vector3d> positions, const Use& use) const {
    const std::vector<char> boundary = on_boundary();
    std::vector<Index> polygon;
    std::size_t number = 0;
    for_each_face(
        [&](std::size_t c, const Solid& solid, const Corners& face, std::span<const Index> points) {
          if (!boundary[number++]) return;
          polygon.clear();
          add_points_of_edges(solid, face, points, polygon);
          const Eigen::Vector3d centre = centre_of(positions, points.first(solid.corners));
          if (faces_inwards(positions, polygon, centre)) ranges::reverse(polygon);
          // Polygons are triangulated from their second point on, which cuts off corners: diagonals
          // between corners would flatten a curved face.
          const bool begins_at_corner = ranges::find(points.first(solid.corners), polygon[0]) !=
                                        points.first(solid.corners).end();
          if (polygon.size() > face.size() && begins_at_corner) {
            std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
          }
          use(polygon, cells_[c]);
        });
  }

 private:
  template <class Use>
  void for_each_face(const Use& use) const {
    std::size_t begin = 0;
    for (std::size_t c = 0; c < types_.size(); ++c) {
      const Solid& solid = *solid_of(types_[c]);
      const auto points = std::span(points_).subspan(begin, solid.points);
      for (const Corners& face : solid.faces) use(c, solid, face, points);
      begin += solid.points;
    }
  }

  std::vector<char> on_boundary() const {
    struct Face {
      FaceKey key;
      std::size_t number;
    };
    std::vector<Face> faces;
    std::vector<Index> corners;
    for_each_face(
        [&](std::size_t, const Solid&, const Corners& face, std::span<const Index> points) {
          corners.clear();
          for (const std::uint8_t corner : face) corners.push_back(points[corner]);
          faces.push_back({key_of(corners), faces.size()});
        });
    ranges::sort(faces, {}, [](const Face& face) { return face.key; });
    std::vector<char> result(faces.size(), 0);
    for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
      while (end < faces.size() && faces[end].key == faces[begin].key) ++end;
      const bool has_area = faces[begin].key[2] != kNoCorner;
      if (end - begin == 1 && has_area) result[faces[begin].number] = 1;
    }
    return result;
  }

  std::vector<std::uint8_t> types_;  ///< of each cell
  std::vector<Index> cells_;         ///< the row of each
  std::vector<Index> points_;        ///< of all cells, `points_of` each
};

/// Joins the surface cells of a file's pieces or, if it has volume cells only, their boundary.
class VtkSurface {
 public:
  explicit VtkSurface(std::string name) : name_(std::move(name)) {}

  void add(VtkPiece piece) {
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

  RawMesh take(std::vector<Eigen::Vector3d>* exact) {
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

 private:
  void add_points(const DataArray& points) {
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

  void add_cells(const VtkCells& cells, Index first_point) {
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

  [[noreturn]] void fail(const std::string& what) const { throw Error(name_ + ": " + what); }

  [[noreturn]] void fail_point(Index existing) const {
    fail("has cells over points that do not exist: there are " + std::to_string(existing) +
         "; the file is damaged, export it again");
  }

  void add_cell(std::uint8_t stored_type, std::span<const Index> points) {
    const std::uint8_t type = plain_type(stored_type, points.size());
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

  /// A cell with mid-edge points, which follow its corners.
  void add_curved(std::span<const Index> points, std::size_t sides) {
    check_size(points, 2 * sides);
    corners_.clear();
    for (std::size_t s = 0; s < sides; ++s) {
      corners_.push_back(points[s]);
      corners_.push_back(points[sides + s]);
    }
    builder_.add_polygon(corners_, cell_);
  }

  void add_volume(std::uint8_t type, std::span<const Index> points) {
    const std::size_t least = VtkVolumes::points_of(type);
    if (least == 0) {
      ++unread_volumes_;
    } else {
      check_size(points, least);
      volumes_.add(type, points, cell_);
    }
  }

  void check_size(std::span<const Index> points, std::size_t least) const {
    if (points.size() >= least) return;
    fail("has a cell of " + std::to_string(points.size()) + " points, number " +
         std::to_string(cell_) + ", whose type asks for " + std::to_string(least) +
         "; the file is damaged, export it again");
  }

  std::string left_out() const {
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

  /// Takes the boundary of the volumes as the surface, and returns a line about it; empty if there
  /// is none.
  std::string take_boundary() {
    // Without the faces of unread cells, those of their neighbours would seem to be on the
    // boundary.
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

  std::string why_empty() const {
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
    return "holds no cells that brindle reads; in ParaView, apply the filter Tessellate and save "
           "its "
           "result as .vtp or .vtu";
  }

  std::string name_;  ///< of the file, for errors
  MeshBuilder builder_;
  PiecewiseArrays point_arrays_, cell_arrays_;
  std::string normals_;
  std::vector<Index> cell_points_, corners_;  ///< of one cell; members to reuse their memory
  Index cell_ = 0;
  VtkVolumes volumes_;
  std::size_t surfaces_ = 0;  ///< cells
  std::size_t unread_volumes_ = 0, points_ = 0, lines_ = 0, unknown_ = 0;
};

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

RawMesh vtk_surface(const std::string& name, std::vector<VtkPiece> pieces,
                    std::vector<Eigen::Vector3d>* exact) {
  VtkSurface surface(name);
  for (VtkPiece& piece : pieces) surface.add(std::exchange(piece, {}));
  return surface.take(exact);
}

}  // namespace brindle
