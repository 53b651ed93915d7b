#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/files.h"
#include "vtk_surfaces.h"

namespace brindle {
namespace {

constexpr int kCubes = 2;          // along a side of the unit cube
constexpr int kSide = 4 * kCubes;  // points lie at quarters of a cube, so that every edge has one
using Place = std::array<int, 3>;  // in quarters
using Cell = std::vector<Place>;

Index number_of(const Place& p) {
  return static_cast<Index>((p[2] * (kSide + 1) + p[1]) * (kSide + 1) + p[0]);
}

Place between(const Place& a, const Place& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// The cell with points amid some of its edges.
Cell with_edges(Cell cell, const std::vector<std::array<std::size_t, 2>>& edges) {
  for (const auto& [a, b] : edges) cell.push_back(between(cell[a], cell[b]));
  return cell;
}

/// A kind of cell: how it fills a cube of four quarters a side.
struct Filling {
  const char* name;
  std::uint8_t type;
  std::vector<Cell> cells;
  bool curved = false;
};

std::vector<Filling> fillings() {
  const Cell hexa = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},
                     {0, 0, 4}, {4, 0, 4}, {4, 4, 4}, {0, 4, 4}};
  const Cell voxel = {hexa[0], hexa[1], hexa[3], hexa[2], hexa[4], hexa[5], hexa[7], hexa[6]};
  std::vector<Cell> tetras, wedges, pyramids, collapsed;
  for (const std::array<int, 3> axes :
       {std::array{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}) {
    Cell tetra = {{0, 0, 0}};  // a way from one corner to the opposite one
    for (const int axis : axes) {
      tetra.push_back(tetra.back());
      tetra.back()[axis] = 4;
    }
    tetras.push_back(tetra);
  }
  for (const std::array<std::size_t, 3>& base : {std::array<std::size_t, 3>{0, 2, 1}, {0, 3, 2}}) {
    Cell wedge;
    for (const std::size_t up : {0, 4}) {
      for (const std::size_t corner : base) wedge.push_back(hexa[corner + up]);
    }
    wedges.push_back(wedge);
    collapsed.push_back({wedge[0], wedge[1], wedge[2], wedge[2],  //
                         wedge[3], wedge[4], wedge[5], wedge[5]});
  }
  for (const std::array<std::size_t, 4>& base : {std::array<std::size_t, 4>{0, 1, 2, 3},
                                                 {4, 7, 6, 5},
                                                 {0, 4, 5, 1},
                                                 {1, 5, 6, 2},
                                                 {2, 6, 7, 3},
                                                 {3, 7, 4, 0}}) {
    pyramids.push_back({hexa[base[0]], hexa[base[1]], hexa[base[2]], hexa[base[3]], {2, 2, 2}});
  }
  const auto all_with_edges = [](std::vector<Cell> cells, const auto& edges) {
    for (Cell& cell : cells) cell = with_edges(cell, edges);
    return cells;
  };
  using Edges = std::vector<std::array<std::size_t, 2>>;
  const Edges of_tetra = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  const Edges of_hexa = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                         {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  const Edges of_wedge = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
  const Edges of_pyramid = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}};
  const std::vector<Cell> quadratic = all_with_edges({hexa}, of_hexa);
  std::vector<Cell> triquadratic = quadratic;
  for (const Place& centre :
       Cell{{0, 2, 2}, {4, 2, 2}, {2, 0, 2}, {2, 4, 2}, {2, 2, 0}, {2, 2, 4}, {2, 2, 2}}) {
    triquadratic[0].push_back(centre);
  }
  return {{"tetrahedra", 10, tetras},
          {"voxels", 11, {voxel}},
          {"hexahedra", 12, {hexa}},
          {"wedges", 13, wedges},
          {"pyramids", 14, pyramids},
          {"hexahedra that are wedges", 12, collapsed},
          {"Lagrange tetrahedra", 71, tetras},
          {"quadratic tetrahedra", 24, all_with_edges(tetras, of_tetra), true},
          {"quadratic hexahedra", 25, quadratic, true},
          {"quadratic wedges", 26, all_with_edges(wedges, of_wedge), true},
          {"quadratic pyramids", 27, all_with_edges(pyramids, of_pyramid), true},
          {"triquadratic hexahedra", 29, triquadratic, true}};
}

/// The cells of all cubes, and which points they have.
struct Volume {
  std::vector<float> places;
  Cells cells;
  std::vector<std::uint8_t> types;
  std::vector<std::vector<Index>> points;  ///< of each cell
  DataArrays arrays;
};

Volume volume_of(const Filling& filling) {
  Volume volume;
  for (int z = 0; z <= kSide; ++z) {
    for (int y = 0; y <= kSide; ++y) {
      for (int x = 0; x <= kSide; ++x) {
        for (const int at : {x, y, z}) {
          volume.places.push_back(static_cast<float>(at) / static_cast<float>(kSide));
        }
      }
    }
  }
  for (int cube = 0; cube < kCubes * kCubes * kCubes; ++cube) {
    const Place corner = {4 * (cube % kCubes), 4 * (cube / kCubes % kCubes),
                          4 * (cube / kCubes / kCubes)};
    for (const Cell& cell : filling.cells) {
      std::vector<Index> points;
      for (const Place& p : cell) {
        points.push_back(number_of({corner[0] + p[0], corner[1] + p[1], corner[2] + p[2]}));
      }
      volume.cells.points.insert(volume.cells.points.end(), points.begin(), points.end());
      volume.cells.ends.push_back(static_cast<std::int64_t>(volume.cells.points.size()));
      volume.types.push_back(filling.type);
      volume.points.push_back(points);
    }
  }
  std::vector<int> numbers(volume.types.size());
  for (std::size_t c = 0; c < numbers.size(); ++c) numbers[c] = static_cast<int>(c);
  std::vector<double> heights(volume.places.size() / 3);
  for (std::size_t p = 0; p < heights.size(); ++p) heights[p] = volume.places[3 * p + 2];
  volume.arrays.cells = {make_data_array("cell", 1, numbers)};
  volume.arrays.points = {make_data_array("height", 1, heights)};
  return volume;
}

std::string legacy_volume(bool binary, int version, const Volume& volume) {
  LegacyText text(binary, version);
  const std::size_t points = volume.places.size() / 3, cells = volume.types.size();
  text.line("DATASET UNSTRUCTURED_GRID").line("POINTS " + std::to_string(points) + " float");
  text.numbers(make_data_array("", 3, volume.places)).cells("CELLS", volume.cells);
  text.line("CELL_TYPES " + std::to_string(cells));
  text.numbers(
      make_data_array("", 1, std::vector<std::int32_t>(volume.types.begin(), volume.types.end())));
  text.line("CELL_DATA " + std::to_string(cells)).field(volume.arrays.cells);
  return text.line("POINT_DATA " + std::to_string(points)).field(volume.arrays.points).text();
}

std::string xml_volume(const VtkXmlStyle& style, const Volume& volume) {
  VtkXmlText text(style);
  const std::string body =
      "<Piece NumberOfPoints=\"" + std::to_string(volume.places.size() / 3) +
      "\" NumberOfCells=\"" + std::to_string(volume.types.size()) + "\">\n" +
      text.arrays("PointData", volume.arrays.points) +
      text.arrays("CellData", volume.arrays.cells) +
      text.arrays("Points", {make_data_array("Points", 3, volume.places)}) +
      text.arrays("Cells", {make_data_array("connectivity", 1, volume.cells.points),
                            make_data_array("offsets", 1, volume.cells.ends),
                            make_data_array("types", 1, volume.types)}) +
      "</Piece>\n";
  return text.file("UnstructuredGrid", body);
}

struct VtkVolume : VtkFile {
  /// The volume in every form that VTK's files have, and in memory.
  std::vector<LoadedMesh> forms(const Volume& volume) const {
    std::vector<LoadedMesh> loaded;
    for (const bool binary : {false, true}) {
      for (const int version : {4, 5}) {
        loaded.push_back(read("a.vtk", legacy_volume(binary, version, volume)));
      }
    }
#ifdef BRINDLE_HAS_VTK
    for (const VtkXmlStyle& style :
         {VtkXmlStyle{}, VtkXmlStyle{"binary"}, VtkXmlStyle{"appended raw", true}}) {
      loaded.push_back(read("a.vtu", xml_volume(style, volume)));
    }
#endif
    loaded.push_back(mesh_of_cells(
        {make_data_array("", 3, volume.places), make_data_array("", 1, volume.cells.points),
         make_data_array("", 1, volume.cells.ends), volume.types, volume.arrays},
        "cells"));
    return loaded;
  }
};

/// How much of space a closed surface has inside, if it is seen from outside.
double volume_inside(const Mesh& mesh) {
  double six = 0;
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d a = mesh.positions[t[0]].cast<double>();
    six += a.dot(mesh.positions[t[1]].cast<double>().cross(mesh.positions[t[2]].cast<double>()));
  }
  return six / 6;
}

double area_of(const Mesh& mesh) {
  double two = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.positions[t[0]];
    two += (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a).norm();
  }
  return two / 2;
}

bool is_closed(const Mesh& mesh) {
  std::map<std::pair<Index, Index>, int> balance;
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      ++balance[{t[i], t[(i + 1) % 3]}];
      --balance[{t[(i + 1) % 3], t[i]}];
    }
  }
  for (const auto& [edge, sum] : balance) {
    if (sum != 0) return false;
  }
  return true;
}

TEST_F(VtkVolume, EveryKindOfCellHasTheSameBoundary) {
  for (const Filling& filling : fillings()) {
    SCOPED_TRACE(filling.name);
    const Volume volume = volume_of(filling);
    for (const LoadedMesh& loaded : forms(volume)) {
      const Mesh& mesh = loaded.mesh;
      EXPECT_TRUE(is_closed(mesh));
      EXPECT_NEAR(volume_inside(mesh), 1, 1e-6) << "seen from outside";
      EXPECT_NEAR(area_of(mesh), 6, 1e-5);
      EXPECT_EQ(mesh.vertex_count(), volume.places.size() / 3) << "which keep their numbers";
      EXPECT_EQ(loaded.arrays.points, volume.arrays.points);
      EXPECT_TELLS(loaded.left_out, std::to_string(volume.types.size()) + " volume cells: the ");
      EXPECT_TELLS(loaded.left_out, " faces of their boundary are taken");
    }
  }
}

TEST_F(VtkVolume, FacesHaveTheDataOfTheirCells) {
  for (const Filling& filling : fillings()) {
    SCOPED_TRACE(filling.name);
    const Volume volume = volume_of(filling);
    const LoadedMesh loaded = read("a.vtk", legacy_volume(true, 5, volume));
    const DataArray& cell = loaded.arrays.cells.at(0);
    ASSERT_EQ(cell.rows(), loaded.mesh.triangle_count());
    for (std::size_t t = 0; t < cell.rows(); ++t) {
      int number = 0;
      std::memcpy(&number, &cell.bytes[t * sizeof number], sizeof number);
      const std::vector<Index>& points = volume.points.at(static_cast<std::size_t>(number));
      for (const Index v : loaded.mesh.triangles[t]) {
        EXPECT_NE(std::ranges::find(points, v), points.end()) << "a point of that cell";
      }
    }
  }
}

// A cube whose points were moved outwards: what is between the corners shows how far.
TEST_F(VtkVolume, PointsAmidEdgesKeepTheShape) {
  for (const Filling& filling : fillings()) {
    SCOPED_TRACE(filling.name);
    Volume volume = volume_of(filling);
    for (std::size_t p = 0; p < volume.places.size(); p += 3) {
      const Vec3 from(volume.places[p] - 0.5f, volume.places[p + 1] - 0.5f,
                      volume.places[p + 2] - 0.5f);
      const float most = from.cwiseAbs().maxCoeff();
      const Vec3 to = most > 0 ? Vec3(from * most / from.norm()) : from;
      for (int axis = 0; axis < 3; ++axis) volume.places[p + axis] = to[axis];
    }
    const Mesh mesh = read("a.vtk", legacy_volume(true, 4, volume)).mesh;
    std::set<Index> used;
    for (const Triangle& t : mesh.triangles) used.insert(t.begin(), t.end());
    for (const Index v : used) EXPECT_NEAR(mesh.positions[v].norm(), 0.5, 1e-6) << "on the ball";
    EXPECT_TRUE(is_closed(mesh));
    const double ball = std::numbers::pi / 6;
    EXPECT_LT(volume_inside(mesh), ball);
    const double rough = volume_inside(mesh) / ball;
    EXPECT_GT(rough, filling.curved ? 0.84 : 0.3);
    EXPECT_LT(rough, filling.curved ? 1.0 : 0.84);
  }
}

TEST_F(VtkVolume, IsSeenFromOutsideWhicheverWayItsPointsRun) {
  Filling filling = fillings()[0];
  for (std::size_t c = 0; c < filling.cells.size(); c += 2) {
    std::swap(filling.cells[c][0], filling.cells[c][1]);
  }
  const Mesh mesh = read("a.vtk", legacy_volume(false, 4, volume_of(filling))).mesh;
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_NEAR(volume_inside(mesh), 1, 1e-6);
}

TEST_F(VtkVolume, OfPrismsHasAllSides) {
  for (const int sides : {5, 6}) {
    Volume volume;
    for (int point = 0; point < 2 * sides; ++point) {
      const double angle = 2 * std::numbers::pi * (point % sides) / sides;
      volume.places.push_back(static_cast<float>(std::cos(angle)));
      volume.places.push_back(static_cast<float>(std::sin(angle)));
      volume.places.push_back(point < sides ? 0 : 1);
      volume.cells.points.push_back(point);
    }
    volume.cells.ends = {2 * sides};
    volume.types = {static_cast<std::uint8_t>(sides == 5 ? 15 : 16)};
    const Mesh mesh = read("a.vtk", legacy_volume(true, 5, volume)).mesh;
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_NEAR(volume_inside(mesh), 0.5 * sides * std::sin(2 * std::numbers::pi / sides), 1e-5);
  }
}

TEST_F(VtkVolume, BesideASurfaceIsLeftOut) {
  Volume volume = volume_of(fillings()[0]);
  const std::vector<Index> triangle = {0, 1, static_cast<Index>(kSide + 1)};
  volume.cells.points.insert(volume.cells.points.end(), triangle.begin(), triangle.end());
  volume.cells.ends.push_back(static_cast<std::int64_t>(volume.cells.points.size()));
  volume.types.push_back(5);
  volume.arrays.cells = {};
  const LoadedMesh loaded = read("a.vtk", legacy_volume(true, 5, volume));
  EXPECT_EQ(loaded.mesh.triangle_count(), 1u);
  EXPECT_TELLS(loaded.left_out,
               std::to_string(volume.types.size() - 1) + " volume cells: left out");
}

TEST_F(VtkVolume, OfUnknownOrDamagedCellsIsRefusedWithTheRemedy) {
  Volume volume = volume_of(fillings()[0]);
  volume.types[3] = 42;  // a polyhedron
  EXPECT_TELLS(error_of("a.vtk", legacy_volume(true, 5, volume)), "Extract Surface");
  volume.types[3] = 12;  // of four points
  EXPECT_TELLS(error_of("a.vtk", legacy_volume(true, 5, volume)), "whose type asks for 8");
  volume = volume_of(fillings()[0]);
  Volume twice = volume;
  for (std::size_t c = 0; c < volume.types.size(); ++c) {
    twice.types.push_back(volume.types[c]);
    for (const Index p : volume.points[c]) twice.cells.points.push_back(p);
    twice.cells.ends.push_back(static_cast<std::int64_t>(twice.cells.points.size()));
  }
  twice.arrays.cells = {};
  EXPECT_TELLS(error_of("a.vtk", legacy_volume(true, 5, twice)), "each face belongs to two");
}

TEST_F(VtkVolume, IsNoFileOfPoints) {
  const auto path = save("a.vtk", legacy_volume(true, 5, volume_of(fillings()[2])));
  EXPECT_FALSE(is_point_file(path));
  const LoadedPoints points = read_points(path);
  EXPECT_EQ(points.cloud.positions.size(), 9u * 9u * 9u);
  EXPECT_EQ(points.left_out.find("boundary"), std::string::npos) << points.left_out;
}

TEST_F(VtkVolume, CellsWithTwoCurvedSidesAndPlainLagrangeCellsAreSurfaces) {
  Volume volume;
  volume.places = {0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0, 1, -1, 0, 1, 2, 0};
  volume.cells = {{0, 1, 2, 3, 4, 5, 0, 1, 2}, {6, 9}};
  volume.types = {30, 69};  // QUADRATIC_LINEAR_QUAD, LAGRANGE_TRIANGLE
  const LoadedMesh loaded = read("a.vtk", legacy_volume(true, 5, volume));
  EXPECT_EQ(loaded.mesh.triangle_count(), 5u);
  EXPECT_NEAR(area_of(loaded.mesh), 4 + 1, 1e-6) << "two triangles at the sides of a rectangle";
}

}  // namespace
}  // namespace brindle
