#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/base/array_numbers.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_pattern.h"
#include "brindle/tool_paths.h"
#include "test_folder.h"

namespace brindle {
namespace {

ToolPaths paths_of_torus() {
  const Surface surface = make_surface(make_shape("torus,resolution=48"));
  const StripePattern pattern = stripe_pattern(surface, smooth_direction_field(surface), 8);
  ToolPathOptions options;
  options.width = 1 / 8.0f;
  options.cut_length = 0.3f;
  return tool_paths(surface.mesh, stripe_curves(surface, pattern).lines, options);
}

struct ToolPathFiles : TestFolder {};

/// A move of G-code: where the machine is after it.
struct Move {
  bool works = false;  ///< G1
  std::map<char, double> at;
  double extruded = 0;
};

/// Understands what the files hold: G0, G1, modal coordinates, relative E and comments.
std::vector<Move> parsed_moves(const std::filesystem::path& path) {
  std::vector<Move> moves;
  std::map<char, double> at;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line.substr(0, line.find(';')));
    Move move;
    bool moving = false;
    for (std::string word; words >> word;) {
      const double value = std::stod(word.substr(1));
      if (word[0] == 'G')
        moving = value < 2, move.works = value == 1;
      else if (word[0] == 'E')
        move.extruded = value;
      else
        at[word[0]] = value;
    }
    move.at = at;
    if (moving) moves.push_back(move);
  }
  return moves;
}

Eigen::Vector3d place_of(const Move& move) {
  return {move.at.at('X'), move.at.at('Y'), move.at.at('Z')};
}

Machine scaled_machine() {
  Machine machine;
  machine.unit = 40;
  machine.place = Eigen::Vector3d(100, 90, 0.2);
  return machine;
}

TEST_F(ToolPathFiles, GcodeGivesPositionsAndMaterialBack) {
  const ToolPaths paths = paths_of_torus();
  const Machine machine = scaled_machine();
  write_tool_paths(folder / "a.gcode", paths, machine);
  const std::vector<Eigen::Vector3d> places = machine_points(paths, machine);
  double wanted = 0, extruded = 0, top = 0, lowest = 1e9;
  std::vector<std::size_t> traced;  // points at ends of segments
  for (std::size_t line = 0; line < paths.lines.count(); ++line) {
    for (std::size_t i = paths.lines.offsets[line] + 1; i < paths.lines.offsets[line + 1]; ++i) {
      traced.push_back(i);
      const double width = 40 * static_cast<double>(paths.widths[i - 1] + paths.widths[i]) / 2;
      wanted +=
          width * 0.2 * (places[i] - places[i - 1]).norm() / (std::numbers::pi / 4 * 1.75 * 1.75);
    }
  }
  for (const Eigen::Vector3d& place : places) {
    top = std::max(top, place.z());
    lowest = std::min(lowest, place.z());
  }
  EXPECT_NEAR(lowest, 0.2, 1e-9);
  std::size_t next = 0;
  for (const Move& move : parsed_moves(folder / "a.gcode")) {
    extruded += move.extruded;
    if (!move.works) {
      EXPECT_EQ(move.extruded, 0);
      continue;
    }
    ASSERT_LT(next, traced.size());
    ASSERT_LT((place_of(move) - places[traced[next]]).norm(), 1e-3);
    EXPECT_LE(move.at.at('F'), 1800.1);
    ++next;
  }
  EXPECT_EQ(next, traced.size());
  EXPECT_NEAR(extruded, wanted, 1e-4);
  EXPECT_NEAR(machine_metrics(paths, machine).extrusion, wanted, 1e-6 * wanted);
  EXPECT_EQ(machine_metrics(paths, machine).lifts, paths.lines.count() - 1);
}

TEST_F(ToolPathFiles, TravelStaysAboveAllPaths) {
  const ToolPaths paths = paths_of_torus();
  const Machine machine = scaled_machine();
  write_tool_paths(folder / "a.gcode", paths, machine);
  double top = 0;
  for (const Eigen::Vector3d& place : machine_points(paths, machine))
    top = std::max(top, place.z());
  Eigen::Vector3d last(0, 0, 1e9);
  for (const Move& move : parsed_moves(folder / "a.gcode")) {
    if (move.at.count('X') == 0) continue;
    const Eigen::Vector3d place = place_of(move);
    if (!move.works && (place - last).head<2>().norm() > 1e-9) {
      EXPECT_NEAR(place.z(), top + 1, 1e-3);
    }
    last = place;
  }
}

TEST_F(ToolPathFiles, FiveAxesTurnTheToolIntoTheNormal) {
  const ToolPaths paths = paths_of_torus();
  Machine machine = scaled_machine();
  machine.axes = 5;
  machine.dialect = GcodeDialect::plain;
  machine.up = Vec3::UnitY();
  write_tool_paths(folder / "a.gcode", paths, machine);
  std::vector<Vec3> normals;
  for (std::size_t line = 0; line < paths.lines.count(); ++line) {
    for (std::size_t i = paths.lines.offsets[line] + 1; i < paths.lines.offsets[line + 1]; ++i) {
      // Y up is turned into Z: x stays, z becomes -y.
      const Vec3& n = paths.lines.normals[i];
      normals.emplace_back(n.x(), -n.z(), n.y());
    }
  }
  std::size_t next = 0;
  double last_c = 0;
  for (const Move& move : parsed_moves(folder / "a.gcode")) {
    EXPECT_EQ(move.extruded, 0);
    if (move.at.count('C') > 0) {
      EXPECT_LE(std::abs(move.at.at('C') - last_c), 180.001);
      last_c = move.at.at('C');
    }
    if (!move.works) continue;
    constexpr double kRadians = std::numbers::pi / 180;
    const double a = move.at.at('A') * kRadians, c = move.at.at('C') * kRadians;
    const Eigen::Vector3d axis(std::sin(a) * std::sin(c), -std::sin(a) * std::cos(c), std::cos(a));
    ASSERT_LT((axis - normals[next].cast<double>()).norm(), 1e-3);
    ++next;
  }
  EXPECT_EQ(next, normals.size());
}

TEST_F(ToolPathFiles, OurReadersReadArraysBack) {
  const ToolPaths paths = paths_of_torus();
  write_tool_paths(folder / "a.csv", paths, {});
  write_tool_paths(folder / "a.vtp", paths, {});
  const std::vector<DataArray> csv = read_csv_arrays(folder / "a.csv");
  const std::vector<DataArray> vtp = read_points(folder / "a.vtp").arrays;
  for (const char* name : {"width", "speed", "extrusion", "join", "cut", "qw"}) {
    const DataArray *a = find_array(csv, name), *b = find_array(vtp, name);
    ASSERT_NE(a, nullptr) << name;
    ASSERT_NE(b, nullptr) << name;
    EXPECT_EQ(doubles_of(a->view()).size(), paths.lines.points.size());
    EXPECT_EQ(doubles_of(a->view()).size(), doubles_of(b->view()).size());
  }
  const std::vector<double> widths = doubles_of(find_array(csv, "width")->view());
  const std::vector<double> cuts = doubles_of(find_array(vtp, "cut")->view());
  for (std::size_t i = 0; i < widths.size(); ++i) {
    ASSERT_EQ(static_cast<float>(widths[i]), paths.widths[i]);
    ASSERT_EQ(cuts[i], paths.cut[i]);
  }
}

TEST_F(ToolPathFiles, DxfHasAPolylineForEachPath) {
  const ToolPaths paths = paths_of_torus();
  const Machine machine = scaled_machine();
  write_tool_paths(folder / "a.dxf", paths, machine);
  const std::vector<Eigen::Vector3d> places = machine_points(paths, machine);
  std::ifstream file(folder / "a.dxf");
  std::string code, value, entity;
  std::size_t polylines = 0, vertices = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  while (std::getline(file, code) && std::getline(file, value)) {
    if (code == "0") entity = value, polylines += value == "POLYLINE";
    if (code == "10") place.x() = std::stod(value);
    if (code == "20") place.y() = std::stod(value);
    if (code != "30") continue;
    place.z() = std::stod(value);
    if (entity != "VERTEX") continue;
    EXPECT_LT((place - places[vertices++]).norm(), 1e-5);
  }
  EXPECT_EQ(value, "EOF");
  EXPECT_EQ(polylines, paths.lines.count());
  EXPECT_EQ(vertices, places.size());
}

TEST_F(ToolPathFiles, RejectsOtherExtensions) {
  EXPECT_THROW(write_tool_paths(folder / "a.stl", paths_of_torus(), {}), Error);
  EXPECT_FALSE(is_tool_path_format("a.stl"));
  EXPECT_TRUE(is_tool_path_format("A.GCODE"));
}

}  // namespace
}  // namespace brindle
