#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

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
