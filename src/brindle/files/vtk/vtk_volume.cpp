#include "brindle/files/vtk/vtk_volume.h"

#include <algorithm>
#include <array>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/standard.h"

namespace brindle {
namespace {

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

}  // namespace

std::uint8_t vtk_plain_type(std::uint8_t type, std::size_t points) {
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

std::size_t VtkVolumes::points_of(std::uint8_t type) {
  const Solid* solid = solid_of(type);
  return solid == nullptr ? 0 : solid->points;
}

void VtkVolumes::add(std::uint8_t type, std::span<const Index> points, Index cell) {
  types_.push_back(type);
  cells_.push_back(cell);
  const auto end = points.begin() + static_cast<std::ptrdiff_t>(points_of(type));
  points_.insert(points_.end(), points.begin(), end);
}

template <class Use>
void VtkVolumes::for_each_face(const Use& use) const {
  std::size_t begin = 0;
  for (std::size_t c = 0; c < types_.size(); ++c) {
    const Solid& solid = *solid_of(types_[c]);
    const auto points = std::span(points_).subspan(begin, solid.points);
    for (const Corners& face : solid.faces) use(c, solid, face, points);
    begin += solid.points;
  }
}

std::vector<char> VtkVolumes::on_boundary() const {
  struct Face {
    FaceKey key;
    std::size_t number;
  };
  std::vector<Face> faces;
  std::vector<Index> corners;
  for_each_face([&](std::size_t, const Solid&, const Corners& face, std::span<const Index> points) {
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

void VtkVolumes::for_each_boundary_face(
    std::span<const Eigen::Vector3d> positions,
    const std::function<void(std::span<const Index> corners, Index cell)>& use) const {
  const std::vector<char> boundary = on_boundary();
  std::vector<Index> polygon;
  std::size_t number = 0;
  for_each_face([&](std::size_t c, const Solid& solid, const Corners& face,
                    std::span<const Index> points) {
    if (!boundary[number++]) return;
    polygon.clear();
    add_points_of_edges(solid, face, points, polygon);
    const Eigen::Vector3d centre = centre_of(positions, points.first(solid.corners));
    if (faces_inwards(positions, polygon, centre)) ranges::reverse(polygon);
    // Polygons are triangulated from their second point on, which cuts off corners: diagonals
    // between corners would flatten a curved face.
    const bool begins_at_corner =
        ranges::find(points.first(solid.corners), polygon[0]) != points.first(solid.corners).end();
    if (polygon.size() > face.size() && begins_at_corner) {
      std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
    }
    use(polygon, cells_[c]);
  });
}

}  // namespace brindle
