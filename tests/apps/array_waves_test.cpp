// Waves from arrays of the mesh's file, or of another one.
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

#include "tool.h"
#include "vtp_text.h"

namespace brindle::test {
namespace {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;
using Row = std::vector<double>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A hill over unit squares.
TextMesh hill(int side = 11, double height = 1) {
  TextMesh mesh;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double u = 10.0 * x / (side - 1), v = 10.0 * y / (side - 1);
      // Floats, as the file has them.
      mesh.positions.push_back({static_cast<float>(u), static_cast<float>(v),
                                static_cast<float>(height * std::sin(u / 4) * std::cos(v / 5))});
    }
  }
  for (int y = 0; y + 1 < side; ++y) {
    for (int x = 0; x + 1 < side; ++x) {
      const int v = y * side + x;
      mesh.triangles.push_back({v, v + 1, v + side + 1});
      mesh.triangles.push_back({v, v + side + 1, v + side});
    }
  }
  return mesh;
}

using RowAt = std::function<Row(double x, double y)>;

TextArray per_point(const TextMesh& mesh, const std::string& name, const RowAt& row) {
  TextArray array{name, 1, {}};
  for (const auto& [x, y, z] : mesh.positions) {
    const Row numbers = row(x, y);
    array.components = static_cast<int>(numbers.size());
    array.numbers.insert(array.numbers.end(), numbers.begin(), numbers.end());
  }
  return array;
}

TextArray per_cell(const TextMesh& mesh, const std::string& name, const RowAt& row) {
  TextMesh centers;
  for (const auto& t : mesh.triangles) {
    std::array<double, 3> center{};
    for (const int corner : t) {
      for (std::size_t i = 0; i < 3; ++i) {
        center[i] += mesh.positions[static_cast<std::size_t>(corner)][i] / 3;
      }
    }
    centers.positions.push_back(center);
  }
  return per_point(centers, name, row);
}

Row vortex(double x, double y) { return {3 - y, x - 2, 0.5}; }

struct ArrayWaves : ToolTest {
  void write(const std::string& name, const TextMesh& mesh) const {
    write_text(folder / name, vtp_text(mesh));
  }
  Json report(Arguments arguments) const {
    arguments.insert(arguments.begin(), {"stripe"});
    arguments.insert(arguments.end(), {"--report", "report.json"});
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.exit_code == 0 ? Json::parse(content(folder / "report.json")) : Json();
  }
  /// The stripes' centre lines, all their digits.
  std::string lines(Arguments arguments) const {
    arguments.insert(arguments.begin(), {"curves"});
    arguments.insert(arguments.end(), {"--output", "lines.obj", "--quiet"});
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return content(folder / "lines.obj");
  }
};

/// Only columns that are called so are frequencies of a vector with a name.
TEST_F(ArrayWaves, OtherColumnsOfACsvFileAreNoFrequencies) {
  write_text(folder / "square.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
  const auto frequency = [&](const std::string& names, const std::string& row) {
    write_text(folder / "field.csv", names + row + row + row + row);
    return report({"square.obj", "--field", "field.csv"})["frequency_max"].get<double>();
  };
  const double by_default = frequency("v:0,v:1,v:2\n", "1,0.2,0\n");
  EXPECT_EQ(frequency("v:0,v:1,v:2,pressure\n", "1,0.2,0,20\n"), by_default);
  EXPECT_EQ(frequency("v_x,v_y,v_z,p,t\n", "1,0.2,0,20,0\n"), by_default);
  EXPECT_EQ(frequency("v:0,v:1,v:2,frequency\n", "1,0.2,0,7\n"), 7);
  EXPECT_EQ(frequency("v:0,v:1,v:2,frequency,t\n", "1,0.2,0,7,0\n"), 7);
  EXPECT_EQ(frequency("x,y,z,f\n", "1,0.2,0,7\n"), 7);  // as in files without names
}

TEST_F(ArrayWaves, TheOnlyTensorOfACsvFileIsItsField) {
  write_text(folder / "square.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
  const std::string names = "S:XX,S:YY,S:ZZ,S:XY,S:YZ,S:XZ", row = "3,1,0,0.5,0,0\n";
  write_text(folder / "one.csv", names + "\n" + row + row + row + row);
  EXPECT_EQ(lines({"square.obj", "--field", "one.csv"}),
            lines({"square.obj", "--field", "one.csv:S"}));
  write_text(folder / "two.csv", names + ",T:XX,T:YY,T:ZZ,T:XY,T:YZ,T:XZ\n" + "3,1,0,0.5,0,0," +
                                     row + "3,1,0,0.5,0,0," + row + "3,1,0,0.5,0,0," + row +
                                     "3,1,0,0.5,0,0," + row);
  expect_refusal(1, "choose one: two.csv:S", {"stripe", "square.obj", "--field", "two.csv"});
}

/// Fibres are measured without a sign; wind that blows both ways cancels out between both.
TEST_F(ArrayWaves, SignsOfVectorsDoNotCountUnlessAskedFor) {
  TextMesh mesh = hill(21, 0);
  const auto fiber = [](double x, double y) {
    const double sign = std::fmod(x * x * 37 + y * 53, 2) < 1 ? -1 : 1;
    return Row{sign, sign * 0.05 * std::sin(x / 6), 0};
  };
  mesh.points = {per_point(mesh, "fiber", fiber)};
  mesh.cells = {per_cell(mesh, "of cells", fiber)};
  write("flat.vtp", mesh);
  write("other.vtp", hill(27, 0));
  for (const Arguments& more : std::vector<Arguments>{
           {}, {"--subdivide", "1"}, {"--subdivide", "2"}, {"--field-mesh", "flat.vtp"}}) {
    for (const std::string name : {"array:fiber", "array:of cells"}) {
      const bool other = !more.empty() && more.front() == "--field-mesh";
      Arguments arguments = {other ? "other.vtp" : "flat.vtp", "--field", name, "--stripes", "8"};
      arguments.insert(arguments.end(), more.begin(), more.end());
      const Json found = report(arguments);
      EXPECT_EQ(found["branches"], 0) << name << ' ' << testing::PrintToString(more);
      EXPECT_EQ(found["vertices_without_wave"], 0) << name << ' ' << testing::PrintToString(more);
    }
  }
  const Arguments oriented = {"flat.vtp",    "--field", "array:fiber", "--stripes", "8",
                              "--subdivide", "1",       "--texture",   "dots",      "--oriented"};
  EXPECT_GT(report(oriented)["vertices_without_wave"], 100);
}

TEST_F(ArrayWaves, AlongAConstantVectorAreThoseAlongADirection) {
  TextMesh mesh = hill();
  const auto row = [](double, double) { return Row{0.25, 1, -0.5}; };
  mesh.points = {per_point(mesh, "v", row)};
  mesh.cells = {per_cell(mesh, "of cells", row)};
  write("hill.vtp", mesh);
  const std::string expected = lines({"hill.vtp", "--direction", "0.25,1,-0.5"});
  EXPECT_TRUE(has(expected, "\nl "));
  EXPECT_EQ(lines({"hill.vtp", "--field", "array:v"}), expected);
  EXPECT_EQ(lines({"hill.vtp", "--field", "array:of cells"}), expected);
  EXPECT_EQ(lines({"hill.vtp", "--field", "array:v", "--subdivide", "1"}),
            lines({"hill.vtp", "--direction", "0.25,1,-0.5", "--subdivide", "1"}));
}

TEST_F(ArrayWaves, AreThoseOfACsvFileBitForBit) {
  TextMesh mesh = hill();
  mesh.points = {per_point(mesh, "velocity", vortex),
                 per_point(mesh, "density", [](double x, double) { return Row{0.5 + x / 10}; })};
  mesh.points[0].numbers[30] = kNaN;
  mesh.points[0].numbers[60] = mesh.points[0].numbers[61] = mesh.points[0].numbers[62] = 0;
  write("hill.vtp", mesh);
  std::ostringstream field;
  field.precision(17);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (std::size_t i = 0; i < 3; ++i) field << mesh.points[0].numbers[3 * v + i] << ',';
    field << mesh.points[1].numbers[v] << '\n';
  }
  write_text(folder / "field.csv", field.str());
  EXPECT_EQ(lines({"hill.vtp", "--field", "array:velocity", "--frequency", "array:density"}),
            lines({"hill.vtp", "--field", "field.csv"}));
  const Json report = this->report({"hill.vtp", "--field", "array:velocity"});
  EXPECT_EQ(report.at("field_rows_nonfinite"), 1);
  EXPECT_EQ(report.at("vertices_without_wave"), 2);
}

TEST_F(ArrayWaves, AreThoseOfNamedColumns) {
  TextMesh mesh = hill(11, 0);
  mesh.points = {per_point(mesh, "v", vortex)};
  write("hill.vtp", mesh);
  std::string one = "speed,velocity:2,velocity:1,velocity:0,Points:0,Points:1,Points:2\n";
  std::string turned = "velocity_2,velocity_1,velocity_0,frequency\n";
  std::string two = "a:x,a:y,a:z,velocity:x,velocity:y,velocity:z\n";
  std::string beside = "x,y,z,nx,ny,nz,vx,vy,vz\n";  // positions and normals are no field
  std::string stress = "stress:xx,stress:yy,stress:zz,stress:xy,stress:yz,stress:xz\n";
  const auto text = [](double number) { return std::to_string(number); };
  for (const auto& [x, y, z] : mesh.positions) {
    const Row v = vortex(x, y);
    one += "1," + text(v[2]) + ',' + text(v[1]) + ',' + text(v[0]) + ",1,2,3\n";
    turned += text(v[2]) + ',' + text(v[1]) + ',' + text(v[0]) + ",0.25\n";
    two += "0,1,0," + text(v[0]) + ',' + text(v[1]) + ',' + text(v[2]) + '\n';
    beside += text(x) + ',' + text(y) + ',' + text(z) + ",0,0,1," + text(v[0]) + ',' + text(v[1]) +
              ',' + text(v[2]) + '\n';
    stress += "3,1,2,0,0,0\n";
  }
  write_text(folder / "one.csv", one);
  write_text(folder / "turned.csv", turned);
  write_text(folder / "two.csv", two);
  write_text(folder / "beside.csv", beside);
  write_text(folder / "stress.csv", stress);
  const std::string expected = lines({"hill.vtp", "--field", "array:v"});
  EXPECT_EQ(lines({"hill.vtp", "--field", "one.csv"}), expected);
  EXPECT_EQ(lines({"hill.vtp", "--field", "two.csv:velocity"}), expected);
  EXPECT_EQ(lines({"hill.vtp", "--field", "beside.csv"}), expected);
  EXPECT_EQ(lines({"hill.vtp", "--field", "turned.csv"}),
            lines({"hill.vtp", "--field", "array:v", "--frequency", "0.25"}));
  expect_refusal(1, "two.csv has several vectors: a (3), velocity (3); choose one: two.csv:a",
                 {"stripe", "hill.vtp", "--field", "two.csv"});
  expect_refusal(1, "two.csv: no array 'velocty'; did you mean 'velocity'?",
                 {"stripe", "hill.vtp", "--field", "two.csv:velocty"});
  const Json minor = report({"hill.vtp", "--field", "stress.csv:stress", "--tensor", "minor"});
  EXPECT_EQ(minor.at("energy"), report({"hill.vtp", "--direction", "0,1,0"}).at("energy"));
  EXPECT_EQ(report({"hill.vtp", "--field", "stress.csv", "--tensor", "minor"}).at("energy"),
            minor.at("energy"));
  expect_refusal(2, "is no tensor",
                 {"stripe", "hill.vtp", "--field", "one.csv:velocity", "--tensor", "minor"});
  expect_refusal(2, "add --field array:NAME or FILE.csv:NAME",
                 {"stripe", "hill.vtp", "--tensor", "minor"});
}

TEST_F(ArrayWaves, OfFilledHolesAreMarkedInFiles) {
  TextMesh mesh = hill();
  mesh.points = {per_point(mesh, "v", [](double x, double y) {
    return x > 4 && x < 6 && y > 4 && y < 6 ? Row{0, 0, 0} : Row{1, 0.1 * y, 0};
  })};
  write("holes.vtp", mesh);
  const Json filled = report({"holes.vtp", "--field", "array:v", "--field-smoothing", "1",
                              "--stripes", "6", "--output", "filled.vtp"});
  EXPECT_GT(filled.at("vertices_filled"), 0);
  EXPECT_GT(filled.at("coherence_filled_mean"), 0.9);
  const std::string text = run({"info", "filled.vtp"}).out;
  EXPECT_TRUE(has(text, "filled       uint8        0 to 1")) << text;
  report({"holes.vtp", "--field", "array:v", "--stripes", "6", "--output", "plain.vtp"});
  EXPECT_FALSE(has(run({"info", "plain.vtp"}).out, "filled"));
}

TEST_F(ArrayWaves, AlongTensorsDependOnTheOrderOfComponents) {
  TextMesh mesh = hill(11, 0);
  mesh.points = {per_point(mesh, "vtk", [](double, double) { return Row{1, 1, 0, 2, 0, 0}; }),
                 per_point(mesh, "voigt", [](double, double) { return Row{1, 1, 0, 0, 0, 2}; }),
                 per_point(mesh, "plane",
                           [](double, double) {
                             return Row{1, 1, 2};
                           }),
                 per_point(mesh, "square",
                           [](double, double) {
                             return Row{1, 3, 1, 1};
                           }),
                 per_point(mesh, "vector", [](double, double) {
                   return Row{1, 0, 0};
                 })};
  mesh.cells = {per_cell(mesh, "of cells", [](double, double) { return Row{1, 1, 2}; })};
  write("plate.vtp", mesh);
  const std::string expected = lines({"plate.vtp", "--field", "array:vtk"});
  const auto in_order = [&](const std::string& name, const std::string& order) {
    return Arguments{"plate.vtp", "--field", "array:" + name, "--tensor", "major," + order};
  };
  EXPECT_EQ(lines(in_order("vtk", "vtk")), expected);
  EXPECT_EQ(lines(in_order("voigt", "voigt")), expected);
  for (const char* name : {"plane", "square", "of cells"}) {
    EXPECT_EQ(lines(in_order(name, "plane")), expected) << name;
  }
  const auto refused = [&](int code, const std::string& words, Arguments arguments) {
    arguments.insert(arguments.begin(), "stripe");
    expect_refusal(code, words, arguments);
  };
  refused(1, "a tensor in the plane has 3", in_order("voigt", "plane"));
  refused(1, "Voigt's order has 6", in_order("vector", "voigt"));
  refused(2, "is no tensor", in_order("vector", "vtk"));
  refused(2, "the field is no tensor", {"plate.vtp", "--tensor", "major,voigt"});
}

TEST_F(ArrayWaves, OfCellsAreMovedToPoints) {
  TextMesh mesh = hill();
  mesh.cells = {per_cell(mesh, "velocity", vortex)};
  mesh.points = {per_point(mesh, "exact", vortex)};
  write("hill.vtp", mesh);
  const Json cells = report({"hill.vtp", "--field", "array:velocity", "--stripes", "6"});
  const Json points = report({"hill.vtp", "--field", "array:exact", "--stripes", "6"});
  EXPECT_NEAR(cells.at("energy").get<double>(), points.at("energy").get<double>(), 0.02);
  EXPECT_EQ(cells.at("vertices_without_wave"), 0);
}

TEST_F(ArrayWaves, AreTakenByNames) {
  TextMesh mesh = hill();
  mesh.points = {per_point(mesh, "v",
                           [](double, double) {
                             return Row{1, 0, 0};
                           }),
                 per_point(mesh, "speed", [](double x, double) { return Row{x}; })};
  mesh.cells = {per_cell(mesh, "v", [](double, double) { return Row{0, 1, 0}; })};
  write("hill.vtp", mesh);
  EXPECT_EQ(lines({"hill.vtp", "--field", "array:v"}), lines({"hill.vtp", "--direction", "1,0,0"}));
  EXPECT_EQ(lines({"hill.vtp", "--field", "array:points/v"}),
            lines({"hill.vtp", "--direction", "1,0,0"}));
  EXPECT_EQ(lines({"hill.vtp", "--field", "array:cells/v"}),
            lines({"hill.vtp", "--direction", "0,1,0"}));
  expect_refusal(1,
                 "hill.vtp: no array 'sped'; did you mean 'speed'? There are per point: v (3), "
                 "speed; and per cell: v (3)",
                 {"stripe", "hill.vtp", "--field", "array:sped"});
  expect_refusal(1, "no array 'nothing'; there are per point",
                 {"stripe", "hill.vtp", "--frequency-by", "array:nothing"});
  expect_refusal(1, "'speed' has 1 numbers in a row",
                 {"stripe", "hill.vtp", "--field", "array:speed"});
  write("bare.vtp", hill());
  expect_refusal(1, "bare.vtp: no array 'v': it has no arrays",
                 {"stripe", "bare.vtp", "--field", "array:v"});
}

TEST_F(ArrayWaves, ThatAreMistypedAreWrongUsage) {
  write("hill.vtp", hill());
  expect_refusal(2, "array:NAME", {"stripe", "hill.vtp", "--field", "array:"});
  expect_refusal(2, "array:NAME", {"stripe", "hill.vtp", "--frequency-by", "speed"});
  expect_refusal(2, "--frequency", {"stripe", "hill.vtp", "--frequency", "speed"});
  for (const std::string range :
       {"2.5..0.4", "1..", "1..1", "0..1", "1..2,3", "1..2,invers", "-1..2", "1..nan"}) {
    expect_refusal(2, "--frequency-by ...@A..B",
                   {"stripe", "hill.vtp", "--frequency-by", "array:a@" + range});
  }
  expect_refusal(2, "major|minor|max-abs",
                 {"stripe", "hill.vtp", "--field", "array:a", "--tensor", "largest"});
  expect_refusal(2, "built-in shapes have no arrays",
                 {"stripe", "shape:torus,resolution=8", "--field", "array:a"});
  expect_refusal(2, "built-in shapes have no arrays",
                 {"sample", "shape:torus,resolution=8", "--frequency", "array:a"});
}

TEST_F(ArrayWaves, HaveFrequenciesByNumbers) {
  TextMesh mesh = hill();
  mesh.points = {per_point(mesh, "speed", [](double x, double) { return Row{x - 3}; }),
                 per_point(mesh, "same", [](double, double) { return Row{7}; }),
                 per_point(mesh, "velocity", [](double x, double) {
                   return Row{0, x, 0};
                 })};
  mesh.cells = {per_cell(mesh, "of cells", [](double x, double) { return Row{x}; })};
  write("hill.vtp", mesh);
  const auto extent = [&](Arguments more) {
    more.insert(more.begin(), {"hill.vtp", "--frequency", "0.2"});
    const Json report = this->report(more);
    return std::pair(report.at("frequency_min").get<double>(),
                     report.at("frequency_max").get<double>());
  };
  EXPECT_EQ(extent({"--frequency-by", "array:speed"}), (std::pair{0.08, 0.5}));
  EXPECT_EQ(extent({"--frequency-by", "array:velocity"}), (std::pair{0.08, 0.5}));
  EXPECT_EQ(extent({"--frequency-by", "array:of cells"}), (std::pair{0.08, 0.5}));
  EXPECT_EQ(extent({"--frequency-by", "array:same"}), (std::pair{0.2, 0.2}));
  const Arguments half = {"--frequency-by", "array:speed@0.5..1"};
  EXPECT_EQ(extent(half), (std::pair{0.1, 0.2}));
  const Arguments more = {"--frequency-by", "array:speed", "--subdivide", "1"};
  EXPECT_EQ(extent(more), (std::pair{0.08, 0.5}));
  // Denser to the right, or to the left.
  const auto right_of_middle = [&](const std::string& range) {
    Arguments arguments = {"sample",
                           "hill.vtp",
                           "--stripes",
                           "20",
                           "--direction",
                           "1,0,0",
                           "--frequency-by",
                           "array:speed@" + range,
                           "-o",
                           "samples.csv",
                           "-q"};
    EXPECT_EQ(run(arguments).exit_code, 0);
    std::istringstream rows(content(folder / "samples.csv"));
    std::string row;
    std::getline(rows, row);
    int balance = 0;
    while (std::getline(rows, row)) balance += std::stod(row) > 5 ? 1 : -1;
    return balance;
  };
  EXPECT_GT(right_of_middle("0.3..1"), 20);
  EXPECT_LT(right_of_middle("0.3..1,inverse"), -20);
}

TEST_F(ArrayWaves, AreMissingWhereFrequenciesAre) {
  TextMesh mesh = hill();
  mesh.points = {per_point(mesh, "speed", [](double x, double) { return Row{1 + x / 10}; })};
  mesh.points[0].numbers[5] = mesh.points[0].numbers[17] = kNaN;
  write("hill.vtp", mesh);
  for (const char* option : {"--frequency", "--frequency-by"}) {
    const Json report = this->report({"hill.vtp", option, "array:speed"});
    EXPECT_EQ(report.at("vertices_without_frequency"), 2);
    EXPECT_EQ(report.at("vertices_without_wave"), 2);
    const ToolResult result = run({"stripe", "hill.vtp", option, "array:speed"});
    EXPECT_TRUE(has(result.err, "2 vertices have no wave: ")) << result.err;
    EXPECT_FALSE(has(result.err, "vertices have no wave: the smooth field")) << result.err;
  }
  mesh.points[0].numbers[40] = 0;
  write("hill.vtp", mesh);
  expect_refusal(1, "'speed': the frequency of vertex 40",
                 {"stripe", "hill.vtp", "--frequency", "array:speed"});
}

TEST_F(ArrayWaves, RunAlongTensors) {
  // On a plane: eigenvalues 3 along x, 1 along y, 2 along z.
  TextMesh mesh = hill(11, 0);
  mesh.points = {
      per_point(mesh, "stress", [](double, double) { return Row{3, 1, -4, 0, 0, 0}; }),
      per_point(mesh, "nine", [](double, double) { return Row{3, 0, 0, 0, 1, 0, 0, 0, -4}; }),
      per_point(mesh, "skew", [](double, double) { return Row{3, 1, 0, -1, 1, 0, 0, 0, -4}; }),
      per_point(mesh, "vector", [](double, double) {
        return Row{1, 0, 0};
      })};
  mesh.cells = {per_cell(mesh, "of cells", [](double, double) { return Row{3, 1, -4, 0, 0, 0}; })};
  write("plate.vtp", mesh);
  const std::string along_x = lines({"plate.vtp", "--direction", "1,0,0"});
  for (const char* name : {"stress", "nine", "skew", "of cells"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(lines({"plate.vtp", "--field", std::string("array:") + name}), along_x);
  }
  const ToolResult result = run({"stripe", "plate.vtp", "--field", "array:skew"});
  EXPECT_TRUE(has(result.err, "the array 'skew' is a tensor: waves run along its major axis"));
  EXPECT_TRUE(has(result.err, "at 121 vertices the tensor 'skew' is not symmetric")) << result.err;
  EXPECT_FALSE(has(run({"stripe", "plate.vtp", "--field", "array:stress", "--tensor", "major"}).err,
                   "tensor"));
  for (const char* axis : {"minor", "max-abs"}) {
    expect_refusal(1, "121 vertices have no wave: the tensor's axis is within 15 degrees",
                   {"stripe", "plate.vtp", "--field", "array:stress", "--tensor", axis});
  }
  expect_refusal(2, "is no tensor",
                 {"stripe", "plate.vtp", "--field", "array:vector", "--tensor", "major"});
}

TEST_F(ArrayWaves, AlongTensorsAreCounted) {
  // The axis of the largest eigenvalue turns towards the normal with x; for y > 8 there is none.
  TextMesh mesh = hill(11, 0);
  mesh.points = {per_point(mesh, "stress", [](double x, double y) {
    if (y > 8.5) return Row{2, 2, 1, 0, 0, 0};
    const double s = std::cos(0.15 * x), c = std::sin(0.15 * x);
    return Row{s * s, 0, c * c, 0, 0, s * c};
  })};
  write("plate.vtp", mesh);
  const Json report = this->report({"plate.vtp", "--field", "array:stress", "--stripes", "5"});
  // 0.15 x is above 75 degrees, or 1.309, for x of 9 and 10.
  EXPECT_EQ(report.at("tensor_vertices_near_normal"), 2 * 9);
  EXPECT_EQ(report.at("tensor_vertices_isotropic"), 2 * 11);
  EXPECT_EQ(report.at("vertices_without_wave"), 40);
  const ToolResult result = run({"stripe", "plate.vtp", "--field", "array:stress"});
  EXPECT_TRUE(has(result.err, "18 vertices have no wave: the tensor's axis")) << result.err;
  EXPECT_TRUE(has(result.err, "22 vertices have no wave: the tensor has")) << result.err;
  EXPECT_FALSE(has(result.err, "zero, not finite")) << "no other reason: " << result.err;
}

TEST_F(ArrayWaves, MayBeTakenFromAnotherMesh) {
  TextMesh coarse = hill(6, 0), fine = hill(21, 0);
  coarse.points = fine.points = {};
  // Without its centre, at which opposite vectors meet.
  const auto round = [](double x, double y) { return vortex(x + 3, y + 4); };
  coarse.points = {
      per_point(coarse, "velocity", round),
      per_point(coarse, "density", [](double x, double) { return Row{0.2 + x / 25}; })};
  fine.points = {per_point(fine, "velocity", round),
                 per_point(fine, "density", [](double x, double) { return Row{0.2 + x / 25}; })};
  write("coarse.vtp", coarse);
  write("fine.vtp", fine);
  const Arguments waves = {"--field", "array:velocity", "--frequency", "array:density"};
  const auto metrics = [&](Arguments files) {
    files.insert(files.end(), waves.begin(), waves.end());
    return report(files);
  };
  // A linear field is that of the finer mesh, and a mesh's own is the same, bit for bit.
  const Json expected = metrics({"fine.vtp"});
  const Json carried = metrics({"fine.vtp", "--field-mesh", "coarse.vtp"});
  EXPECT_NEAR(carried.at("energy").get<double>(), expected.at("energy").get<double>(), 1e-6);
  EXPECT_EQ(carried.at("frequency_max"), expected.at("frequency_max"));
  EXPECT_EQ(carried.at("vertices_too_far"), 0);
  EXPECT_FALSE(expected.contains("vertices_too_far"));
  Arguments itself = {"fine.vtp", "--field-mesh", "fine.vtp,within=0"};
  itself.insert(itself.end(), waves.begin(), waves.end());
  Arguments own = {"fine.vtp"};
  own.insert(own.end(), waves.begin(), waves.end());
  EXPECT_EQ(lines(itself), lines(own));
}

TEST_F(ArrayWaves, OfAnotherMeshEndFarFromIt) {
  TextMesh whole = hill(11, 0), part = hill(6, 0);
  for (auto& position : part.positions) {
    for (double& x : position) x /= 2;  // up to x and y of 5
  }
  part.points = {per_point(part, "velocity", [](double, double) { return Row{1, 0, 0}; })};
  part.cells = {per_cell(part, "region", [](double, double) { return Row{2}; })};
  write("whole.vtp", whole);
  write("part.vtp", part);
  const auto without_wave = [&](const std::string& other) {
    const Json report =
        this->report({"whole.vtp", "--field", "array:velocity", "--field-mesh", other});
    EXPECT_EQ(report.at("vertices_too_far"), report.at("vertices_without_wave"));
    return report.at("vertices_too_far").get<int>();
  };
  EXPECT_EQ(without_wave("part.vtp"), 121 - 36) << "2 % of the diagonal is less than an edge";
  EXPECT_EQ(without_wave("part.vtp,within=1"), 121 - 36 - 12);
  EXPECT_EQ(without_wave("part.vtp,within=1.5"), 121 - 49);
  EXPECT_EQ(without_wave("part.vtp,within=100%"), 0);
  // Frequencies alone may be another mesh's, and waves end with them; cells count, too.
  const Json cells =
      report({"whole.vtp", "--frequency", "array:region", "--field-mesh", "part.vtp"});
  EXPECT_EQ(cells.at("frequency_min"), 2);
  EXPECT_EQ(cells.at("frequency_max"), 2);
  EXPECT_EQ(cells.at("vertices_too_far"), 121 - 36);
  EXPECT_EQ(cells.at("vertices_without_frequency"), 0);
  const ToolResult result =
      run({"stripe", "whole.vtp", "--field", "array:velocity", "--field-mesh", "part.vtp"});
  EXPECT_TRUE(has(result.err,
                  "85 vertices have no wave: they are farther than --field-mesh ...,within=L|P%"))
      << result.err;
  expect_refusal(1, "part.vtp: no array 'speed'",
                 {"stripe", "whole.vtp", "--field", "array:speed", "--field-mesh", "part.vtp"});
}

TEST_F(ArrayWaves, MayBeTakenFromPoints) {
  const TextMesh mesh = hill(11, 0);
  write("hill.vtp", mesh);
  std::string points = "velocity:0,velocity:1,velocity:2,Points:0,Points:1,Points:2\n";
  for (const auto& [x, y, z] : mesh.positions) {
    points += "0,2,1," + std::to_string(x) + ',' + std::to_string(y) + ",0\n";
  }
  write_text(folder / "points.csv", points);
  EXPECT_EQ(lines({"hill.vtp", "--field", "array:velocity", "--field-mesh", "points.csv"}),
            lines({"hill.vtp", "--direction", "0,2,1"}));
#ifdef BRINDLE_HAS_NANOFLANN
  const Json report = this->report({"points.csv", "--field", "array:velocity"});
  EXPECT_EQ(report.at("kind"), "points");
  EXPECT_EQ(report.at("energy"), this->report({"points.csv", "--direction", "0,2,1"}).at("energy"));
#endif
}

TEST_F(ArrayWaves, OfAnotherMeshAreForShapesToo) {
  const ToolResult made = run({"stripe", "shape:torus,resolution=24", "-o", "torus.vtp", "-q"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const Json report = this->report({"shape:torus,resolution=24", "--field", "array:direction",
                                    "--frequency", "array:frequency", "--field-mesh", "torus.vtp"});
  EXPECT_EQ(report.at("vertices_without_wave"), 0);
  expect_refusal(2, "--field-mesh",
                 {"stripe", "shape:torus,resolution=24", "--field", "array:direction",
                  "--field-mesh", "torus.vtp", "-o", "torus.vtp"});
}

struct GlobeTool : ToolTest {
  /// A field file with these columns for every vertex of the globe.
  void write_columns(const std::string& name, const std::string& columns,
                     const std::function<std::string(double x, double y, double z)>& row) {
    std::string text = columns + "\n";
    std::istringstream lines(content(folder / "globe.obj"));
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string kind;
      double x = 0, y = 0, z = 0;
      if (words >> kind >> x >> y >> z && kind == "v") text += row(x, y, z) + "\n";
    }
    write_text(folder / name, text);
  }
  double energy_of(const std::string& field) {
    const ToolResult made = run({"stripe", "globe.obj", "--field", field, "--stripes", "12",
                                 "--report", "report.json", "-q"});
    EXPECT_EQ(made.exit_code, 0) << made.err;
    return Json::parse(content(folder / "report.json"))["energy"].get<double>();
  }
};

TEST_F(GlobeTool, WindsTowardsEastAndNorthAreVectors) {
  ASSERT_EQ(run({"stripe", "shape:sphere,resolution=12", "-o", "globe.obj", "-q"}).exit_code, 0);
  write_columns("winds.csv", "east,north", [](double, double, double) { return "2,1"; });
  write_columns("vectors.csv", "wind:0,wind:1,wind:2", [](double x, double y, double z) {
    const double r = std::hypot(x, y), all = std::hypot(x, y, z);
    if (r < 1e-6 * all) return std::string("nan,nan,nan");
    const double north_z = r / all, north_r = -z / all;
    return std::to_string(-2 * y / r + north_r * x / r) + "," +
           std::to_string(2 * x / r + north_r * y / r) + "," + std::to_string(north_z);
  });
  EXPECT_NEAR(energy_of("winds.csv"), energy_of("vectors.csv"), 1e-4);
  EXPECT_GT(energy_of("winds.csv"), 0.001);
}

TEST_F(GlobeTool, RefusesEastAndNorthBesideAGlobe) {
  ASSERT_EQ(run({"stripe", "shape:torus,resolution=12", "-o", "globe.obj", "-q"}).exit_code, 0);
  write_columns("winds.csv", "east,north", [](double, double, double) { return "2,1"; });
  expect_refusal(1, "globe around 0,0,0", {"stripe", "globe.obj", "--field", "winds.csv"});
}

}  // namespace
}  // namespace brindle::test
