#include <cmath>
#include <cstdint>
#include <cstring>
#include <set>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

#include "brindle/files.h"
#include "brindle/shapes.h"
#include "tool.h"

namespace brindle::test {
namespace {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

struct Input : ToolTest {
  Json report(const std::string& mesh, const Arguments& more = {}) const {
    Arguments arguments = {"stripe", mesh, "--report", "report.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.exit_code == 0 ? Json::parse(content(folder / "report.json")) : Json();
  }
};

// A field that runs around the z axis, so that every vertex has a direction of its own.
std::string around_axis(const Vec3& p) {
  std::ostringstream text;
  text.precision(9);
  text << -p.y() << ',' << p.x() << ",0\n";
  return text.str();
}

std::string binary_stl(const Mesh& mesh) {
  std::string file(80, ' ');
  const auto put = [&](const void* data, std::size_t size) {
    file.append(static_cast<const char*>(data), size);
  };
  const auto count = static_cast<std::uint32_t>(mesh.triangle_count());
  put(&count, 4);
  for (const Triangle& t : mesh.triangles) {
    file += std::string(12, '\0');
    for (const Index v : t) put(mesh.positions[v].data(), 12);
    file += std::string(2, '\0');
  }
  return file;
}

// The torus far from zero, as surveys have it.
void write_far_torus(const std::filesystem::path& path) {
  Mesh mesh = make_shape("torus,resolution=32");
  mesh.origin = Eigen::Vector3d(500000, 5800000, 100);
  write_mesh(path, mesh);
}

double farthest_from_far_torus(const std::filesystem::path& path) {
  const Mesh mesh = make_shape("torus,resolution=32");
  const Mesh loaded = read_mesh(path).mesh;
  EXPECT_EQ(loaded.vertex_count(), mesh.vertex_count());
  double distance = 0;
  for (std::size_t v = 0; v < std::min(loaded.vertex_count(), mesh.vertex_count()); ++v) {
    const Eigen::Vector3d here = loaded.positions[v].cast<double>() + loaded.origin;
    const Eigen::Vector3d there =
        mesh.positions[v].cast<double>() + Eigen::Vector3d(500000, 5800000, 100);
    distance = std::max(distance, (here - there).norm());
  }
  return distance;
}

TEST_F(Input, FarFromZeroIsStripedAsAtZeroAndWrittenInPlace) {
  write_far_torus(folder / "far.ply");
  write_mesh(folder / "near.ply", make_shape("torus,resolution=32"));
  const Arguments direction = {"--direction", "0.31,0.9,0.27"};
  const Json near = report("near.ply", direction);
  const Json far = report("far.ply", {"--direction", "0.31,0.9,0.27", "--output", "out.ply",
                                      "--output", "out.obj", "--output", "out.vtp"});
  for (const char* same : {"vertices", "triangles", "edges", "branches", "field_singularities"}) {
    EXPECT_EQ(far[same], near[same]) << same;
  }
  EXPECT_NEAR(far["energy"].get<double>(), near["energy"].get<double>(),
              1e-3 * near["energy"].get<double>());
  EXPECT_LT(farthest_from_far_torus(folder / "out.ply"), 1e-6);
  EXPECT_LT(farthest_from_far_torus(folder / "out.obj"), 1e-6);
  EXPECT_TRUE(contains(content(folder / "out.vtp"), "Float64"));
  const ToolResult result = run({"stripe", "far.ply"});
  EXPECT_TRUE(contains(result.err, "recentred about 500000 5800000 100")) << result.err;
  EXPECT_FALSE(contains(run({"stripe", "near.ply"}).err, "recentred"));
  const ToolResult info = run({"info", "far.ply"});
  EXPECT_TRUE(contains(info.out, "bounding box  49999")) << info.out;
  EXPECT_TRUE(contains(info.out, "recentred")) << info.out;
}

TEST_F(Input, CurvesAndSamplesFarFromZeroStandOnTheSurface) {
  write_far_torus(folder / "far.ply");
  for (const Arguments& arguments :
       {Arguments{"curves", "far.ply", "--stripes", "10", "--output", "a.csv"},
        Arguments{"sample", "far.ply", "--stripes", "10", "--output", "a.csv"}}) {
    const ToolResult result = run(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    std::istringstream lines(content(folder / "a.csv"));
    std::string header, line;
    std::getline(lines, header);
    std::getline(lines, line);
    // The columns kind, curve and closed come before the curves' positions.
    std::istringstream cells(line);
    std::string cell;
    for (int i = 0; i < (arguments[0] == "curves" ? 4 : 1); ++i) std::getline(cells, cell, ',');
    EXPECT_NEAR(std::stod(cell), 500000, 3) << line;
    std::getline(cells, cell, ',');
    EXPECT_NEAR(std::stod(cell), 5800000, 3) << line;
  }
  const ToolResult tubes =
      run({"curves", "far.ply", "--stripes", "10", "--tube-radius", "1%", "--output", "tubes.obj"});
  ASSERT_EQ(tubes.exit_code, 0) << tubes.err;
  EXPECT_NEAR(read_mesh(folder / "tubes.obj").mesh.origin.y(), 5800000, 1);
}

TEST_F(Input, FieldOfAnStlHasARowPerCornerOrPerVertex) {
  const Mesh mesh = make_shape("torus,resolution=32");
  write_text(folder / "a.stl", binary_stl(mesh));
  write_mesh(folder / "a.obj", mesh);
  std::string corners, vertices;
  for (const Vec3& p : mesh.positions) vertices += around_axis(p);
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t) corners += around_axis(mesh.positions[v]);
  }
  write_text(folder / "vertices.csv", vertices);
  write_text(folder / "corners.csv", corners);
  const Json expected = report("a.obj", {"--field", "vertices.csv"});
  const Json stl = report("a.stl", {"--field", "corners.csv"});
  // Vertices have other numbers.
  EXPECT_NEAR(stl["branches"].get<double>(), expected["branches"].get<double>(),
              0.05 * expected["branches"].get<double>());
  EXPECT_NEAR(stl["energy"].get<double>(), expected["energy"].get<double>(),
              0.02 * expected["energy"].get<double>());
  EXPECT_NEAR(stl["angle_error_mean_deg"].get<double>(),
              expected["angle_error_mean_deg"].get<double>(), 0.5);
  expect_refusal(
      1, "corners.csv",
      {"stripe", "a.stl", "--subdivide", "1", "--field", "corners.csv", "--output", "b.json"});
}

#ifdef BRINDLE_HAS_GL
TEST_F(Input, StlStandsOnZAndOtherFilesOnY) {
  const Mesh mesh = make_shape("torus,resolution=16");
  write_text(folder / "a.stl", binary_stl(mesh));
  write_mesh(folder / "a.obj", mesh);
  const auto picture = [&](const std::string& file, Arguments more) {
    more.insert(more.end(), {"--size", "64x48", "--output", "a.png"});
    const Json json = report(file, more);
    return std::pair(content(folder / "a.png"), json["picture_up"].get<std::string>());
  };
  EXPECT_TRUE(picture("a.stl", {}) == picture("a.stl", {"--up", "z"}));
  EXPECT_TRUE(picture("a.obj", {}) == picture("a.obj", {"--up", "y"}));
  EXPECT_EQ(picture("a.stl", {}).second, "z");
  std::set<std::string> pictures;
  for (const char* up : {"x", "y", "z", "-x", "-y", "-z"}) {
    const auto [bytes, said] = picture("a.stl", {"--up", up});
    EXPECT_EQ(said, up);
    pictures.insert(bytes);
  }
  EXPECT_EQ(pictures.size(), 6u);
  EXPECT_FALSE(report("a.stl", {}).contains("picture_up")) << "nothing is drawn";
  EXPECT_TRUE(contains(run({"info", "a.stl"}).out, "z in pictures, as in most .stl files"));
  EXPECT_TRUE(contains(run({"info", "a.obj"}).out, "y in pictures;"));
}
#endif

TEST_F(Input, JoinedVerticesAreWrittenWithTheirPartnersWave) {
  // Two squares with a seam of repeated vertices between them.
  write_text(folder / "seam.obj",
             "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\n"
             "f 1 2 3\nf 1 3 4\nf 5 6 7\nf 5 7 8\n");
  ASSERT_EQ(
      run({"stripe", "seam.obj", "--direction", "1,0.2,0", "--stripes", "3", "--output", "a.ply"})
          .exit_code,
      0);
  const std::string file = content(folder / "a.ply");
  const std::string end = "end_header\n";
  const char* row = file.data() + file.find(end) + end.size();
  // Position, phase, direction, frequency, branch; then sin_phase, valid and original_id.
  constexpr std::size_t kNumbers = 9;
  constexpr std::size_t kRow = kNumbers * sizeof(float) + 4 + 1 + 4;
  const auto vertex = [&](std::size_t v) {
    std::vector<float> numbers(kNumbers);
    std::memcpy(numbers.data(), row + v * kRow, kNumbers * sizeof(float));
    return numbers;
  };
  EXPECT_EQ(vertex(4), vertex(1));
  EXPECT_EQ(vertex(7), vertex(2));
  EXPECT_NEAR(vertex(4)[4], 1 / std::hypot(1, 0.2), 1e-5);
  EXPECT_NE(vertex(1), vertex(2));
}

TEST_F(Input, StripsOfAPlyFileAreAMesh) {
  write_text(folder / "a.ply",
             "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
             "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
             "end_header\n0 0 0\n0 1 0\n1 0 0\n1 1 0\n5 0 1 2 3 -1\n");
  EXPECT_EQ(report("a.ply", {"--direction", "1,0,0"})["triangles"], 2);
}

TEST_F(Input, AFileTakenForPointsIsSpokenOf) {
  std::string obj, csv;
  for (int i = 0; i < 100; ++i) {
    const std::string x = std::to_string(i % 10), y = std::to_string(i / 10);
    obj += "v " + x + ' ' + y + " 0\n";
    csv += x + ',' + y + ",0\n";
  }
  write_text(folder / "a.obj", obj + "v 0 0 0\n");
  write_text(folder / "a.csv", csv + "0,0,0\n");
  expect_refusal(1, "animate", {"animate", "a.obj", "--frames", "1", "--report", "r.json"});
#ifdef BRINDLE_HAS_NANOFLANN
  const std::string note = "a.obj has no faces: its vertices are taken for points";
  EXPECT_TRUE(contains(run({"stripe", "a.obj", "--direction", "1,0,0"}).err, note));
  EXPECT_FALSE(contains(run({"stripe", "a.obj", "--points", "--direction", "1,0,0"}).err, note));
  EXPECT_FALSE(contains(run({"stripe", "a.csv", "--direction", "1,0,0"}).err, "has no faces"));
  EXPECT_TRUE(contains(run({"info", "a.obj"}).err, note));
  for (const Arguments& arguments :
       {Arguments{"info", "a.obj"}, {"info", "a.csv"}, {"info", "a.obj", "--points"}}) {
    const ToolResult info = run(arguments);
    EXPECT_EQ(info.exit_code, 0) << info.err;
    EXPECT_TRUE(contains(info.out, "points        101, 100 in use")) << info.out;
    EXPECT_TRUE(contains(info.out, "bounding box  0 0 0 to 9 9 0")) << info.out;
    EXPECT_TRUE(contains(info.out, "spacing       1 to 1, mean 1")) << info.out;
    EXPECT_TRUE(contains(info.out, "1 points at the place of another")) << info.out;
  }
  EXPECT_TRUE(contains(run({"info", "shape:torus,resolution=32", "--points"}).out, "points"));
  write_far_torus(folder / "far.ply");
  report("far.ply", {"--points", "--direction", "1,2,3", "--output", "out.ply"});
  EXPECT_TRUE(contains(content(folder / "out.ply"), "property double x"));
  EXPECT_TRUE(contains(run({"info", "out.ply"}).out, "recentred about 500000 5800000 100"));
#endif
}

TEST_F(Input, NeighboursAreForPointsAlone) {
  for (const char* command : {"stripe", "compare", "sample", "info"}) {
    expect_refusal(2, "--neighbors", {command, "shape:torus,resolution=32", "--neighbors", "5"});
  }
}

TEST_F(Input, NamesNearToAShapeAreSuggested) {
  expect_refusal(1, "did you mean shape:torus?", {"stripe", "torus", "--report", "r.json"});
  expect_refusal(1, "did you mean shape:torus?", {"info", "torsu,resolution=32"});
  expect_refusal(2, "did you mean 'torus'?", {"info", "shape:torsu"});
  expect_refusal(2, "did you mean 'resolution'?", {"info", "shape:torus,resolutoin=3"});
  const ToolResult other = run({"info", "scan.ply"});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_FALSE(contains(other.err, "did you mean")) << other.err;
}

TEST_F(Input, InfoListsTheArraysOfAFile) {
  write_text(folder / "a.vtk",
             "# vtk DataFile Version 4.2\nof a test\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
             "0 0 0 1 0 0 1 1 0 0 1 0\nPOLYGONS 1 5\n4 0 1 2 3\nLINES 1 3\n2 0 1\nPOINT_DATA 4\n"
             "VECTORS velocity float\n3 4 0 0 0 0 nan 0 0 1 0 0\nFIELD more 1\nid 1 4 int\n"
             "7 8 9 10\nCELL_DATA 2\nSCALARS part double\nLOOKUP_TABLE default\n1 2.5\n");
  const ToolResult info = run({"info", "a.vtk"});
  EXPECT_EQ(info.exit_code, 0) << info.err;
  for (const char* line :
       {"arrays of points\n  velocity  float32 x 3  length 0 to 5, NaN in 1 rows\n",
        "  id        int32        7 to 10\n", "arrays of cells\n  part  float64  2.5 to 2.5\n",
        "1 cells that are points or lines: left out"}) {
    EXPECT_TRUE(contains(info.out, line)) << info.out;
  }
  EXPECT_EQ(report("a.vtk", {"--direction", "1,0,0"})["triangles"], 2);
}

TEST_F(Input, ExtensionsMayBeOfAnyCase) {
  const char* shape = "shape:torus,resolution=32";
  for (const std::string name : {"a.Ply", "a.OBJ", "a.gLb", "a.Gltf"}) {
    ASSERT_EQ(run({"stripe", shape, "--direction", "1,2,3", "--output", name}).exit_code, 0);
#ifndef BRINDLE_HAS_JSON
    if (name.starts_with("a.g") || name.starts_with("a.G")) continue;
#endif
    EXPECT_EQ(run({"info", name}).exit_code, 0) << name;
  }
}

}  // namespace
}  // namespace brindle::test
