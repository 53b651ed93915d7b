#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "brindle/data_arrays.h"
#include "brindle/files.h"
#include "brindle/shapes.h"
#include "brindle/types.h"
#include "files/written_vtp.h"
#include "tool.h"

namespace brindle::test {
namespace {

using Arguments = std::vector<std::string>;
using Json = nlohmann::json;

struct MeshOutput : ToolTest {
  void runs(const Arguments& arguments) const {
    const ToolResult result = run(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  WrittenVtp vtp(const std::string& name) const { return {content(folder / name)}; }

  /// Nine vertices, eight triangles; the one in the middle has no direction.
  void save_square_with_a_hole_in_its_field() const {
    std::string mesh, field;
    for (int i = 0; i < 9; ++i) {
      mesh += "v " + std::to_string(i % 3) + " " + std::to_string(i / 3) + " 0\n";
      field += i == 4 ? "nan,0,0\n" : "1,0,0\n";
    }
    for (const int i : {1, 2, 4, 5}) {
      const auto corner = [&](int step) { return " " + std::to_string(i + step); };
      mesh += "f" + corner(0) + corner(1) + corner(4) + corner(3) + "\n";
    }
    write_text(folder / "square.obj", mesh);
    write_text(folder / "field.csv", field);
  }
};

std::vector<Vec3> points_of(const WrittenVtp& file) {
  const std::vector<float> numbers = file.array<float>("Points", "Points");
  std::vector<Vec3> points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) points.emplace_back(&numbers[i]);
  return points;
}

TEST_F(MeshOutput, KeepsArraysOfTheInputWhoseNamesAreTaken) {
  const Mesh mesh = make_shape("sphere,resolution=8");
  std::vector<double> given;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) given.push_back(static_cast<double>(v));
  write_mesh(folder / "in.vtp", mesh,
             std::vector<DataArray>{make_data_array("frequency", 1, given),
                                    make_data_array("frequency_input", 1, given)},
             {});
  const ToolResult result = run({"stripe", "in.vtp", "--stripes", "8", "-o", "a.vtp"});
  EXPECT_NE(result.err.find("the input's array 'frequency' is kept as 'frequency_input_input'"),
            std::string::npos)
      << result.err;
  for (const char* name : {"frequency_input", "frequency_input_input"}) {
    EXPECT_EQ(vtp("a.vtp").array<double>("PointData", name), given) << name;
  }
  // What a pattern wrote gives way to the next one.
  const ToolResult again = run({"stripe", "a.vtp", "--stripes", "9", "-o", "b.vtp"});
  EXPECT_EQ(again.err.find("is kept as"), std::string::npos) << again.err;
  EXPECT_NE(vtp("b.vtp").array<float>("PointData", "frequency"),
            vtp("a.vtp").array<float>("PointData", "frequency"));
  EXPECT_EQ(vtp("b.vtp").array<double>("PointData", "frequency_input"), given);
  for (const char* command : {"curves", "sample"}) {
    const ToolResult lines = run({command, "in.vtp", "--stripes", "8", "-o", "lines.csv"});
    EXPECT_EQ(lines.exit_code, 0) << lines.err;
    EXPECT_EQ(lines.err.find("is kept as") != std::string::npos, command == std::string("curves"))
        << "samples have frequency_u and frequency_v: " << lines.err;
  }
}

TEST_F(MeshOutput, WhereThereIsNoWaveThereIsNoNumber) {
  save_square_with_a_hole_in_its_field();
  runs({"stripe", "square.obj", "--field", "field.csv", "--frequency", "0.3", "-o", "a.vtp"});
  const WrittenVtp file = vtp("a.vtp");
  const auto phase = file.array<float>("PointData", "phase");
  const auto sine = file.array<float>("PointData", "sin_phase");
  const auto valid = file.array<std::uint8_t>("PointData", "valid");
  const auto direction = file.array<float>("PointData", "direction");
  for (std::size_t v = 0; v < 9; ++v) {
    EXPECT_EQ(valid[v], v != 4);
    EXPECT_EQ(std::isnan(phase[v]), v == 4);
    EXPECT_EQ(std::isnan(sine[v]), v == 4);
    EXPECT_EQ(direction[3 * v], v == 4 ? 0 : 1);
    if (v != 4) {
      EXPECT_FLOAT_EQ(sine[v], std::sin(phase[v]));
    }
  }
}

TEST_F(MeshOutput, GltfHasNumbersEverywhere) {
  save_square_with_a_hole_in_its_field();
  runs({"stripe", "square.obj", "--field", "field.csv", "--frequency", "0.3", "-o", "a.glb"});
  const std::string file = content(folder / "a.glb");
  std::uint32_t length = 0;
  std::memcpy(&length, file.data() + 12, 4);
  const Json json = Json::parse(file.substr(20, length));
  const auto numbers = [&](const std::string& name) {
    const Json& attributes = json["meshes"][0]["primitives"][0]["attributes"];
    const Json& accessor = json["accessors"][attributes.at(name).get<std::size_t>()];
    const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    std::vector<float> result(view["byteLength"].get<std::size_t>() / 4);
    std::memcpy(result.data(), file.data() + 28 + length + view["byteOffset"].get<std::size_t>(),
                4 * result.size());
    return result;
  };
  for (const char* name : {"_PHASE", "_SIN_PHASE", "_FREQUENCY", "_DIRECTION", "_BRANCH"}) {
    for (const float number : numbers(name)) EXPECT_TRUE(std::isfinite(number)) << name;
  }
  EXPECT_EQ(numbers("_VALID"), (std::vector<float>{1, 1, 1, 1, 0, 1, 1, 1, 1}));
  EXPECT_EQ(numbers("_ORIGINAL_ID"), (std::vector<float>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST_F(MeshOutput, OriginalIdsAreRowsOfTheFile) {
  std::string stl = "solid a\n";
  for (const char* corners : {"0 0 0|1 0 0|0 1 0", "1 0 0|1 1 0|0 1 0"}) {
    std::string facet = std::string("facet normal 0 0 1\nouter loop\nvertex ") + corners;
    for (std::size_t at = 0; (at = facet.find('|', at)) != std::string::npos;) {
      facet.replace(at, 1, "\nvertex ");
    }
    stl += facet + "\nendloop\nendfacet\n";
  }
  write_text(folder / "a.stl", stl + "endsolid a\n");
  using Ids = std::vector<std::int64_t>;
  runs({"stripe", "a.stl", "-o", "a.vtp", "--report", "a.json"});
  EXPECT_EQ(vtp("a.vtp").array<std::int64_t>("PointData", "original_id"), (Ids{0, 1, 2, 4}));
  EXPECT_EQ(Json::parse(content(folder / "a.json"))["vertices_joined"], 2);
  runs({"stripe", "a.stl", "--subdivide", "1", "-o", "b.vtp"});
  EXPECT_EQ(vtp("b.vtp").array<std::int64_t>("PointData", "original_id"),
            (Ids{0, 1, 2, 4, -1, -1, -1, -1, -1}));
  // Vertices of other files stay, and keep their numbers.
  write_text(folder / "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 4 5 3\n");
  runs({"stripe", "a.obj", "--subdivide", "1", "-o", "c.vtp"});
  EXPECT_EQ(vtp("c.vtp").array<std::int64_t>("PointData", "original_id"),
            (Ids{0, 1, 2, 3, 4, -1, -1, -1, -1, -1}));
}

TEST_F(MeshOutput, BranchesOfTrianglesAreThoseOfTheReport) {
  runs({"stripe", "shape:sphere,resolution=20", "-o", "a.vtp", "-o", "a.ply", "-o", "a.json"});
  const auto branch = vtp("a.vtp").array<std::uint8_t>("CellData", "branch");
  const Json report = Json::parse(content(folder / "a.json"));
  EXPECT_EQ(branch.size(), report["triangles"].get<std::size_t>());
  EXPECT_EQ(std::count(branch.begin(), branch.end(), 1), report["branches"].get<int>());
  EXPECT_NE(content(folder / "a.ply").find("vertex_indices\nproperty uchar branch\n"),
            std::string::npos);
}

TEST_F(MeshOutput, CornerPhasesAreThoseOfTheVertices) {
  runs({"stripe", "shape:torus,resolution=40", "-o", "a.vtp"});
  const WrittenVtp file = vtp("a.vtp");
  const auto corner = file.array<float>("CellData", "corner_phase");
  const auto sine = file.array<float>("PointData", "sin_phase");
  const auto vertex = file.array<std::int64_t>("Polys", "connectivity");
  ASSERT_EQ(corner.size(), vertex.size());
  for (std::size_t i = 0; i < corner.size(); ++i) {
    if (std::isnan(corner[i])) continue;
    EXPECT_NEAR(std::sin(corner[i]), sine[static_cast<std::size_t>(vertex[i])], 1e-4f);
  }
}

TEST_F(MeshOutput, UvSplitsVerticesThatRememberTheirNumber) {
  runs({"stripe", "shape:sphere,resolution=20", "-o", "a.vtp"});
  runs({"stripe", "shape:sphere,resolution=20", "--uv", "-o", "uv.vtp", "-o", "uv.obj"});
  const WrittenVtp plain = vtp("a.vtp"), split = vtp("uv.vtp");
  EXPECT_NE(split.text.find("TCoords=\"uv\""), std::string::npos);
  EXPECT_NE(content(folder / "uv.obj").find("\nvt "), std::string::npos);
  const std::vector<Vec3> before = points_of(plain), after = points_of(split);
  const auto ids = split.array<std::int64_t>("PointData", "original_id");
  const auto uv = split.array<float>("PointData", "uv");
  const auto sine = plain.array<float>("PointData", "sin_phase");
  ASSERT_GT(after.size(), before.size());
  ASSERT_EQ(ids.size(), after.size());
  std::size_t added = 0;
  for (std::size_t v = 0; v < after.size(); ++v) {
    if (v < before.size()) {
      EXPECT_EQ(ids[v], static_cast<std::int64_t>(v));
    }
    added += ids[v] < 0;
    if (ids[v] < 0) continue;
    const auto id = static_cast<std::size_t>(ids[v]);
    EXPECT_EQ(after[v], before[id]);
    // A crest is the middle of the tile.
    EXPECT_NEAR(-std::cos(6.2831853f * uv[2 * v]), sine[id], 1e-3f);
  }
  EXPECT_GT(added, 0u);
}

TEST_F(MeshOutput, UvWithoutEffectIsRefused) {
  expect_refusal(2, "--uv", {"stripe", "shape:torus", "--uv"});
  expect_refusal(2, "--uv", {"stripe", "shape:torus", "--uv", "-o", "a.json"});
  expect_refusal(2, "--uv", {"stripe", "shape:torus", "--uv", "--points", "-o", "a.ply"});
  if (run({"stripe", "shape:torus", "-o", "a.png"}).exit_code != 0) return;  // no pictures here
  std::filesystem::remove(folder / "a.png");
  expect_refusal(2, "--uv", {"stripe", "shape:torus", "--uv", "--texture", "dots", "-o", "a.vtp"});
}

/// Every type with every number of components, of bytes that no conversion would keep.
std::vector<DataArray> all_kinds(std::size_t rows, const std::string& prefix) {
  std::vector<DataArray> arrays;
  std::uint32_t state = 7;
  for (const NumberType type :
       {NumberType::float32, NumberType::float64, NumberType::int8, NumberType::uint8,
        NumberType::int16, NumberType::uint16, NumberType::int32, NumberType::uint32,
        NumberType::int64, NumberType::uint64}) {
    for (const int components : {1, 2, 3, 6, 9}) {
      DataArray array{prefix + std::string(name_of(type)) + "_" + std::to_string(components),
                      type,
                      components,
                      {}};
      array.bytes.resize(rows * static_cast<std::size_t>(components) * size_of(type));
      for (std::byte& byte : array.bytes) {
        state = state * 1664525 + 1013904223;
        byte = static_cast<std::byte>(state >> 24);
      }
      arrays.push_back(std::move(array));
    }
  }
  return arrays;
}

std::string bytes_of(const DataArray& array) {
  return {reinterpret_cast<const char*>(array.bytes.data()), array.bytes.size()};
}

TEST_F(MeshOutput, AllArraysOfTheInputAreKeptBitForBit) {
  const Mesh torus = make_shape("torus,resolution=20");
  DataArrays input{all_kinds(torus.vertex_count(), "p "), all_kinds(torus.triangle_count(), "c ")};
  input.points[0].name = "<\"heat\"> & more";
  write_mesh(folder / "in.vtp", torus, input.points, input.cells);
  // Of so coarse a torus every ring would be a face of its own, with vertices of its own.
  runs({"stripe", "in.vtp", "--crease-angle", "180", "-o", "out.vtp"});
  runs({"stripe", "out.vtp", "--crease-angle", "180", "-o", "again.vtp"});
  for (const char* name : {"out.vtp", "again.vtp"}) {
    const WrittenVtp file = vtp(name);
    input.points[0].name = "&lt;&quot;heat&quot;&gt; &amp; more";
    for (const DataArray& array : input.points) {
      EXPECT_EQ(file.bytes("PointData", array.name), bytes_of(array)) << array.name;
    }
    for (const DataArray& array : input.cells) {
      EXPECT_EQ(file.bytes("CellData", array.name), bytes_of(array)) << array.name;
    }
  }
}

TEST_F(MeshOutput, ArraysThatAFormatCannotHoldAreNamed) {
  const Mesh torus = make_shape("torus,resolution=20");
  const std::vector<DataArray> points = {
      make_data_array("stress", 9, std::vector<float>(9 * torus.vertex_count())),
      make_data_array("speed", 1, std::vector<double>(torus.vertex_count(), 0.5))};
  const DataArray region = make_data_array("region", 1, std::vector<int>(torus.triangle_count()));
  write_mesh(folder / "in.vtp", torus, points, {&region, 1});
  const ToolResult glb = run({"stripe", "in.vtp", "-o", "a.glb"});
  EXPECT_EQ(glb.exit_code, 0);
  EXPECT_NE(glb.err.find("array 'stress' (9 components) is not kept in .glb\n"), std::string::npos)
      << glb.err;
  EXPECT_NE(glb.err.find("array 'region' (per triangle) is not kept in .glb\n"), std::string::npos);
  EXPECT_EQ(glb.err.find("speed"), std::string::npos);
  EXPECT_NE(content(folder / "a.glb").find("\"_SPEED\""), std::string::npos);
  const ToolResult obj = run({"stripe", "in.vtp", "-o", "a.obj"});
  EXPECT_NE(obj.err.find("array 'speed' (1 component) is not kept in .obj\n"), std::string::npos);
  const ToolResult both = run({"stripe", "in.vtp", "-o", "a.ply", "-o", "a.vtp"});
  EXPECT_EQ(both.err.find("not kept"), std::string::npos) << both.err;
  EXPECT_EQ(run({"stripe", "in.vtp", "-q", "-o", "a.obj"}).err, "");
}

TEST_F(MeshOutput, ArraysOfAPatternTakeThePlaceOfThoseOfAnEarlierOne) {
  const Mesh torus = make_shape("torus,resolution=20");
  const std::vector<DataArray> points = {
      make_data_array("sin_phase", 1, std::vector<float>(torus.vertex_count())),
      make_data_array("phase", 2, std::vector<double>(2 * torus.vertex_count())),
      make_data_array("valid", 1, std::vector<float>(torus.vertex_count()))};
  const DataArray branch = make_data_array("branch", 1, std::vector<int>(torus.triangle_count()));
  write_mesh(folder / "in.vtp", torus, points, {&branch, 1});
  runs({"stripe", "in.vtp", "-o", "out.vtp"});
  runs({"stripe", "shape:torus,resolution=20", "-o", "plain.vtp"});
  EXPECT_TRUE(content(folder / "out.vtp") == content(folder / "plain.vtp"));
}

TEST_F(MeshOutput, ArraysFollowSplitTriangles) {
  const Mesh sphere = make_shape("sphere,resolution=20");
  std::vector<std::int64_t> numbers(sphere.triangle_count());
  for (std::size_t t = 0; t < numbers.size(); ++t) numbers[t] = static_cast<std::int64_t>(t);
  const DataArray place = make_data_array("place", sphere.positions);
  const DataArray number = make_data_array("number", 1, numbers);
  write_mesh(folder / "in.vtp", sphere, {&place, 1}, {&number, 1});
  for (const Arguments& more :
       std::vector<Arguments>{{"--uv"}, {"--texture", "dots"}, {"--cross"}}) {
    Arguments arguments = {"stripe", "in.vtp", "-o", "out.vtp"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    if (more[0] != "--uv" && run({"stripe", "in.vtp", "-o", "a.png"}).exit_code != 0) continue;
    runs(arguments);
    const WrittenVtp file = vtp("out.vtp");
    const std::vector<Vec3> points = points_of(file);
    const auto places = file.array<float>("PointData", "place");
    ASSERT_EQ(places.size(), 3 * points.size());
    for (std::size_t v = 0; v < points.size(); ++v) {
      ASSERT_LT((points[v] - Vec3(&places[3 * v])).norm(), 1e-6f) << more[0];
    }
    const auto corners = file.array<std::int64_t>("Polys", "connectivity");
    const auto triangles = file.array<std::int64_t>("CellData", "number");
    ASSERT_EQ(corners.size(), 3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      Vec3 inside = Vec3::Zero(), whole = Vec3::Zero();
      float size = 0;
      for (std::size_t m = 0; m < 3; ++m) {
        inside += points[static_cast<std::size_t>(corners[3 * t + m])] / 3;
        const Triangle& original = sphere.triangles[static_cast<std::size_t>(triangles[t])];
        whole += sphere.positions[original[m]] / 3;
        size = std::max(
            size, (sphere.positions[original[m]] - sphere.positions[original[(m + 1) % 3]]).norm());
      }
      ASSERT_LT((inside - whole).norm(), 0.5f * size) << more[0];
    }
  }
}

TEST_F(MeshOutput, CurvesAndSamplesHaveLinearFunctionsExactly) {
  const Mesh knot = make_shape("trefoil");
  std::vector<double> linear;
  for (const Vec3& p : knot.positions) {
    linear.push_back(2.0 * static_cast<double>(p[0]) - static_cast<double>(p[1]) +
                     0.5 * static_cast<double>(p[2]));
  }
  std::vector<std::int64_t> numbers(knot.triangle_count());
  for (std::size_t t = 0; t < numbers.size(); ++t) numbers[t] = static_cast<std::int64_t>(t);
  const std::vector<DataArray> of_points = {
      make_data_array("linear", 1, linear),
      make_data_array("always", 1, std::vector<double>(knot.vertex_count(), 300))};
  const DataArray number = make_data_array("number", 1, numbers);
  write_mesh(folder / "in.vtp", knot, of_points, {&number, 1});
  runs({"curves", "in.vtp", "--resample", "1%", "-o", "curves.vtp", "-o", "curves.ply"});
  runs({"sample", "in.vtp", "-o", "samples.vtp", "-o", "samples.csv"});
  for (const char* name : {"curves.vtp", "samples.vtp"}) {
    const WrittenVtp file = vtp(name);
    const std::vector<Vec3> points = points_of(file);
    const auto found = file.array<double>("PointData", "linear");
    ASSERT_EQ(found.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3& p = points[i];
      ASSERT_NEAR(found[i], 2 * p[0] - p[1] + 0.5f * p[2], 2e-5) << name;
    }
    for (const double number_300 : file.array<double>("PointData", "always")) {
      ASSERT_DOUBLE_EQ(number_300, 300);
    }
    const auto triangle = file.array<std::uint32_t>("PointData", "triangle");
    const auto carried = file.array<std::int64_t>("PointData", "number");
    EXPECT_TRUE(std::equal(triangle.begin(), triangle.end(), carried.begin(), carried.end()));
  }
  EXPECT_NE(content(folder / "samples.csv").find(",frequency_u,frequency_v,linear,always,number\n"),
            std::string::npos);
  EXPECT_NE(content(folder / "curves.ply").find("property double linear\n"), std::string::npos);
  const ToolResult obj = run({"curves", "in.vtp", "-o", "curves.obj"});
  EXPECT_NE(obj.err.find("array 'linear' (1 component) is not kept in .obj\n"), std::string::npos)
      << obj.err;
}

/// Points must be where their triangle and barycentric coordinates say.
void expect_on_mesh(const WrittenVtp& mesh, const WrittenVtp& points) {
  const std::vector<Vec3> vertices = points_of(mesh), places = points_of(points);
  const auto corners = mesh.array<std::int64_t>("Polys", "connectivity");
  const auto triangle = points.array<std::uint32_t>("PointData", "triangle");
  const auto share = points.array<float>("PointData", "barycentric");
  ASSERT_GT(places.size(), 100u);
  ASSERT_EQ(triangle.size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    Vec3 there = Vec3::Zero();
    for (std::size_t m = 0; m < 3; ++m) {
      const auto corner = static_cast<std::size_t>(corners[3 * triangle[i] + m]);
      there += share[3 * i + m] * vertices[corner];
    }
    ASSERT_LT((there - places[i]).norm(), 1e-5f) << i;
  }
}

TEST_F(MeshOutput, CurvesAndSamplesSayWhereTheyAreOnTheMesh) {
  const std::string shape = "shape:trefoil";
  runs({"stripe", shape, "-o", "mesh.vtp"});
  const WrittenVtp mesh = vtp("mesh.vtp");
  runs({"curves", shape, "--join", "--lines", "both", "-o", "curves.vtp", "--report", "c.json"});
  expect_on_mesh(mesh, vtp("curves.vtp"));
  runs({"curves", shape, "--resample", "1%", "-o", "even.vtp", "-o", "even.csv"});
  expect_on_mesh(mesh, vtp("even.vtp"));
  EXPECT_NE(content(folder / "even.csv")
                .find("nz,triangle,barycentric_x,barycentric_y,barycentric_z,frequency\n"),
            std::string::npos);
  runs({"sample", shape, "-o", "samples.vtp", "--report", "s.json"});
  expect_on_mesh(mesh, vtp("samples.vtp"));
  const auto frequency = vtp("samples.vtp").array<float>("PointData", "frequency_u");
  const float everywhere = vtp("mesh.vtp").array<float>("PointData", "frequency")[0];
  for (const float f : frequency) EXPECT_NEAR(f, everywhere, 1e-4f * everywhere);
  for (const char* report : {"c.json", "s.json"}) {
    const Json json = Json::parse(content(folder / report));
    for (const char* key :
         {"version", "command", "input", "options", "vertices_joined", "frequency_min",
          "frequency_max", "vertices_without_wave", "edges_per_period_min"}) {
      EXPECT_TRUE(json.contains(key)) << report << ' ' << key;
    }
  }
}

}  // namespace
}  // namespace brindle::test
