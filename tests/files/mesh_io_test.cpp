#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/base/random.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/progress.h"
#include "brindle/shapes.h"
#include "brindle/shapes/parametric_shapes.h"
#include "parametric_meshes.h"
#include "progress_reports.h"
#include "test_folder.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

struct MeshIo : TestFolder {
  fs::path save(const std::string& name, const std::string& content) const {
    std::ofstream(folder / name, std::ios::binary) << content;
    return folder / name;
  }

  static std::string load(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  LoadedMesh read(const std::string& name, const std::string& content) const {
    return read_mesh(save(name, content));
  }

  /// The message of the error that reading ends with; empty if it does not.
  std::string error_of(const fs::path& path) const {
    try {
      read_mesh(path);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
  std::string error_of(const std::string& name, const std::string& content) const {
    return error_of(save(name, content));
  }
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

#define EXPECT_NAMES(message, part) \
  EXPECT_TRUE(contains(message, part)) << "message: '" << (message) << "'"

template <class Value>
std::string bytes(std::initializer_list<Value> values) {
  std::string result;
  for (const Value value : values) {
    result.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  return result;
}

std::string reversed(std::string text) { return {text.rbegin(), text.rend()}; }

const std::string kPyramidObj =
    "# a pyramid\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 1\n"
    "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\nf 4 3 2 1\n";

const std::string kPyramidOff =
    "OFF\n5 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 .5 1\n"
    "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n4 3 2 1 0\n";

std::string ply_header(const std::string& format, const std::string& vertices = "3",
                       const std::string& faces = "1") {
  return "ply\nformat " + format + " 1.0\ncomment made by hand\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

const std::string kTriangleBytes =
    bytes<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + "\3" + bytes<std::int32_t>({0, 1, 2});

std::string stl_facet(int x) {
  const std::string at = std::to_string(x);
  return "facet normal 0 0 1\nouter loop\nvertex " + at + " 0 0\nvertex 1 " + at + " 0\nvertex " +
         at + " 1 5\nendloop\nendfacet\n";
}

std::string binary_stl(const Mesh& mesh) {
  std::string file(80, ' ');
  file += bytes({static_cast<std::uint32_t>(mesh.triangle_count())});
  for (const Triangle& t : mesh.triangles) {
    file += bytes<float>({0, 0, 0});
    for (const Index v : t) {
      file.append(reinterpret_cast<const char*>(mesh.positions[v].data()), 12);
    }
    file += std::string(2, '\0');
  }
  return file;
}

bool same_shape(const Mesh& a, const Mesh& b) {
  if (a.triangle_count() != b.triangle_count()) return false;
  for (std::size_t t = 0; t < a.triangle_count(); ++t) {
    for (int c = 0; c < 3; ++c) {
      if (a.positions[a.triangles[t][c]] != b.positions[b.triangles[t][c]]) return false;
    }
  }
  return true;
}

#ifdef BRINDLE_HAS_JSON
const std::vector<std::string> kWritten = {"a.obj", "a.ply", "a.gltf", "a.glb"};
#else
const std::vector<std::string> kWritten = {"a.obj", "a.ply"};
#endif

TEST_F(MeshIo, ReadsBackWhatItWrote) {
  for (const std::string shape :
       {"torus,resolution=40", "sheets,resolution=8", "mobius,noise=0.3,resolution=6"}) {
    const Mesh mesh = make_shape(shape);
    for (const std::string& name : kWritten) {
      write_mesh(folder / name, mesh);
      const LoadedMesh loaded = read_mesh(folder / name);
      EXPECT_TRUE(same_shape(loaded.mesh, mesh)) << name;
      EXPECT_EQ(loaded.mesh.vertex_count(), mesh.vertex_count()) << name;
      EXPECT_EQ(loaded.repair, MeshRepair{}) << name;
    }
  }
}

/// Large enough that every format needs more than one piece.
Mesh large_mesh() { return make_shape("torus,resolution=400"); }

TEST_F(MeshIo, ReadingTellsHowFarItIsAndMayBeCancelledAnywhere) {
  const Mesh mesh = large_mesh();
  for (const char* name : {"m.obj", "m.ply", "m.glb"
#ifdef BRINDLE_HAS_VTK
                           ,
                           "m.vtp"
#endif
       }) {
    const fs::path path = folder / name;
    write_mesh(path, mesh);
    std::vector<double> fractions;
    const LoadedMesh whole = read_mesh(path, Progress([&](std::string_view stage, double fraction) {
                                         EXPECT_EQ(stage, "loading " + path.string());
                                         fractions.push_back(fraction);
                                         return true;
                                       }));
    ASSERT_GT(fractions.size(), 2u) << name;
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end())) << name;
    EXPECT_GT(fractions.back(), 0.9) << name;
    EXPECT_LE(fractions.back(), 1) << name;
    for (std::size_t last = 0; last < fractions.size(); ++last) {
      testing_support::Reports reports(static_cast<int>(last));
      EXPECT_THROW(read_mesh(path, reports.progress()), Cancelled) << name;
    }
    EXPECT_EQ(read_mesh(path).mesh.triangles, whole.mesh.triangles) << name;
  }
}

TEST_F(MeshIo, KeepsNumbersOfVerticesThatNoTriangleUses) {
  const Mesh mesh{{{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {8, 8, 8}, {0, 1, 0}}, {{4, 1, 2}}};
  for (const std::string name : {"a.obj", "a.ply"}) {
    write_mesh(folder / name, mesh);
    const LoadedMesh loaded = read_mesh(folder / name);
    EXPECT_EQ(loaded.mesh.positions, mesh.positions) << name;
    EXPECT_EQ(loaded.mesh.triangles, mesh.triangles) << name;
    EXPECT_EQ(loaded.repair.vertices_unreferenced, 2u) << name;
  }
}

TEST_F(MeshIo, JoinsVerticesAtOnePlaceButKeepsTheirNumbers) {
  const LoadedMesh loaded =
      read("seam.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 4 5 3\n");
  EXPECT_EQ(loaded.mesh.vertex_count(), 5u);
  EXPECT_EQ(loaded.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 4, 2}}));
  EXPECT_EQ(loaded.repair.vertices_joined, 1u);
  EXPECT_EQ(loaded.repair.vertices_unreferenced, 1u);
}

TEST_F(MeshIo, ReadsObjWithAllKindsOfCorners) {
  const LoadedMesh loaded =
      read("a.obj",
           "o thing\r\nv 0 0 0 1.0\r\nv 1 0 0 0.5 0.5 0.5\nvt 0 0\nvn 0 0 1\n"
           "v +1 1e0 0\nv 0 1 0\ng x\nusemtl y\n  f 1/1/1 2//1 \\\n 3/1  # end\n"
           "f -4 -2/1 -1\n");
  EXPECT_EQ(loaded.mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(loaded.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST_F(MeshIo, PassesOverAByteOrderMark) {
  const std::string mark = "\xef\xbb\xbf";
  EXPECT_EQ(read("a.obj", mark + "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\n").mesh.positions,
            (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}}));
  EXPECT_EQ(read("a.off", mark + kPyramidOff).mesh.triangle_count(), 6u);
}

TEST_F(MeshIo, ReadsPolygons) {
  EXPECT_EQ(read("a.obj", kPyramidObj).mesh.triangle_count(), 6u);
  EXPECT_TRUE(same_shape(read("a.off", kPyramidOff).mesh, read("a.obj", kPyramidObj).mesh));
}

TEST_F(MeshIo, ReadsFacesThatComeBeforeTheirVertices) {
  EXPECT_EQ(read("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").mesh.triangle_count(), 1u);
}

/// A square of area 16 with a window of area 4, as one face with a bridge, in every text format.
std::vector<std::pair<std::string, std::string>> squares_with_windows() {
  const std::string places = "0 0 0\n4 0 0\n4 4 0\n0 4 0\n1 1 0\n1 3 0\n3 3 0\n3 1 0\n";
  std::string obj;
  std::istringstream lines(places);
  for (std::string line; std::getline(lines, line);) obj += "v " + line + '\n';
  const std::string face = "10 0 1 2 3 0 4 5 6 7 4\n", obj_face = "f 1 2 3 4 1 5 6 7 8 5\n";
  return {{"a.obj", obj + obj_face},
          {"b.obj", obj_face + obj},
          {"a.off", "OFF\n8 1 0\n" + places + face},
          {"a.ply", ply_header("ascii", "8", "1") + places + face},
          {"a.vtk", "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 8 float\n" +
                        places + "POLYGONS 1 11\n" + face}};
}

TEST_F(MeshIo, WindowsOfFacesStayOpenInEveryFormat) {
  for (const auto& [name, text] : squares_with_windows()) {
    const LoadedMesh loaded = read(name, text);
    double area = 0;
    for (const auto& [a, b, c] : loaded.mesh.triangles) {
      const std::vector<Vec3>& p = loaded.mesh.positions;
      area += 0.5 * static_cast<double>((p[b] - p[a]).cross(p[c] - p[a]).norm());
    }
    EXPECT_NEAR(area, 12, 1e-6) << name;
    EXPECT_EQ(loaded.left_out, "") << name;
  }
}

TEST_F(MeshIo, FacesThatCrossThemselvesAreTold) {
  const LoadedMesh loaded =
      read("a.obj", kPyramidObj + "v 5 0 0\nv 7 0 0\nv 5 1 0\nv 7 2 0\nf 6 7 8 9\n");
  EXPECT_NAMES(loaded.left_out, "1 polygons cross themselves");
  EXPECT_NAMES(loaded.left_out, "number 5,");
}

TEST_F(MeshIo, ColorsAndCoordinatesOfObjAreSaidToBeLeftOut) {
  const std::string face = "f 1 2 3\n";
  const auto left_out = [&](const std::string& vertices) {
    return read("a.obj", vertices + face).left_out;
  };
  EXPECT_EQ(left_out("v 0 0 0\nv 1 0 0 1\nv 0 1 0 # 1 2 3\nvn 0 0 1\n"), "");
  const std::string both = left_out("v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nvt 0 0\n");
  EXPECT_NAMES(both, "colors of vertices: left out");
  EXPECT_NAMES(both, "texture coordinates: left out");
  EXPECT_EQ(std::count(both.begin(), both.end(), '\n'), 2);
  EXPECT_NAMES(read_points(save("b.obj", "v 0 0 0 1 0 0\n")).left_out, "colors");
}

TEST_F(MeshIo, ObjThatIsNoTextIsNamedAsWhatItIs) {
  std::string wide = "\xff\xfe";
  for (const char letter : kPyramidObj) wide += {letter, '\0'};
  EXPECT_NAMES(error_of("a.obj", wide), "UTF-16");
  EXPECT_NAMES(error_of("a.obj", std::string("\xff\xff\xfe") + "created by me\n\n"), "FreeSurfer");
  EXPECT_NAMES(error_of("a.obj", wide.substr(2)), "binary");
  EXPECT_TRUE(SurfaceFile(save("a.obj", wide)).has_faces()) << "its mesh says why";
  EXPECT_THROW(read_points(save("a.obj", wide)), Error);
}

TEST_F(MeshIo, StlIsReadInCapitals) {
  std::string text = "solid a\n" + stl_facet(0) + stl_facet(2) + "endsolid a\n";
  const Mesh small = read("a.stl", text).mesh;
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  EXPECT_EQ(read("b.stl", text).mesh.triangles, small.triangles);
}

TEST_F(MeshIo, ReadsOffVariants) {
  const std::string square =
      "# c\n0 0 0 1 2 3 4\n\n1 0 0 1 2 3 4\n0 1 0 1 2 3 4\n3 0 1 2 255 0 0\n";
  for (const std::string header :
       {"OFF\n3 1 0\n", "COFF # colours\n\n3 1 0\n", "OFF 3 1 0\n", "STCNOFF\n3 1\n"}) {
    EXPECT_EQ(read("a.off", header + square).mesh.triangle_count(), 1u) << header;
  }
}

TEST_F(MeshIo, ReadsPlyOfEveryEncoding) {
  std::string big;
  for (const float value : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
    big += reversed(bytes({value}));
  big += "\3";
  for (const std::int32_t value : {0, 1, 2}) big += reversed(bytes({value}));
  const Mesh text = read("a.ply", ply_header("ascii") + "0 0 0\n1 0 0\n\n0 1 0\n3 0 1 2\n").mesh;
  EXPECT_EQ(text.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(text.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_TRUE(
      same_shape(read("a.ply", ply_header("binary_little_endian") + kTriangleBytes).mesh, text));
  EXPECT_TRUE(same_shape(read("a.ply", ply_header("binary_big_endian") + big).mesh, text));
}

TEST_F(MeshIo, PassesOverWhatElseAPlyFileHolds) {
  const std::string header =
      "ply\r\nformat binary_little_endian 1.0\nelement camera 1\nproperty list uchar double m\n"
      "property short s\nelement vertex 3\nproperty uchar red\nproperty double x\nproperty double "
      "y\n"
      "property float n\nproperty double z\nelement face 1\nproperty uchar flag\n"
      "property list int ushort vertex_index\nproperty list uchar float uv\nend_header\n";
  std::string body = "\2" + bytes<double>({1, 2}) + bytes<std::int16_t>({7});
  for (const std::array<double, 3>& p : {std::array{0., 0., 0.}, {1., 0., 0.}, {0., 1., 4.}}) {
    body += "\xff" + bytes({p[0], p[1]}) + bytes<float>({5}) + bytes({p[2]});
  }
  body +=
      "\1" + bytes<std::int32_t>({3}) + bytes<std::uint16_t>({0, 1, 2}) + "\1" + bytes<float>({1});
  const Mesh mesh = read("a.ply", header + body).mesh;
  EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 4}}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

DataArray floats(const char* name, int components, const std::vector<float>& numbers) {
  return make_data_array(name, components, numbers);
}

TEST_F(MeshIo, StoresArraysInPly) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const std::vector<DataArray> arrays = {floats("normal", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1}),
                                         floats("color", 3, {1, 0, 0.5f, 2, -1, NAN, 0, 0, 0}),
                                         floats("phase", 1, {1.5f, 2.5f, 3.5f}),
                                         floats("direction", 3, {1, 0, 0, 1, 0, 0, 1, 0, 0})};
  write_mesh(folder / "a.ply", mesh, arrays);
  const std::string file = load(folder / "a.ply");
  for (const std::string property :
       {"float nx", "uchar red", "float phase\n", "float direction_z"}) {
    EXPECT_NAMES(file, "property " + property);
  }
  const std::string first = bytes<float>({0, 0, 0, 0, 0, 1}) + std::string("\xff\0\x80", 3) +
                            bytes<float>({1.5f, 1, 0, 0});
  EXPECT_NAMES(file, "end_header\n" + first);
  EXPECT_TRUE(same_shape(read_mesh(folder / "a.ply").mesh, mesh));
}

TEST_F(MeshIo, StoresNormalsInObj) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const DataArray normal = floats("normal", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1});
  write_mesh(folder / "a.obj", mesh, std::span(&normal, 1));
  EXPECT_NAMES(load(folder / "a.obj"), "vn 0 0 1\nf 1//1 2//2 3//3\n");
}

TEST_F(MeshIo, RefusesArraysThatAFormatCannotHold) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const auto error = [&](const std::string& name, const DataArray& array) -> std::string {
    try {
      write_mesh(folder / name, mesh, std::span(&array, 1));
    } catch (const Error& e) {
      EXPECT_FALSE(fs::exists(folder / name));
      return e.what();
    }
    return "";
  };
  EXPECT_NAMES(error("a.obj", floats("phase", 1, {1, 2, 3})), ".ply");
  EXPECT_NAMES(error("a.ply", floats("phase", 1, {1, 2})), "2 rows, not 3");
  EXPECT_NAMES(error("a.glb", floats("stress", 6, std::vector<float>(18))),
               "array 'stress' (6 components) is not kept in .glb");
  EXPECT_NAMES(error("a.xyz", floats("phase", 1, {1, 2, 3})), ".glb");
}

TEST_F(MeshIo, WritesNothingWhereItCannot) {
  EXPECT_THROW(write_mesh(folder / "none" / "a.ply", make_plane({.resolution = 2})), Error);
  EXPECT_THROW(write_mesh(folder / "a.glb", Mesh{}), Error);
  EXPECT_TRUE(fs::is_empty(folder));
}

// --- bad input ---------------------------------------------------------------------------------

TEST_F(MeshIo, MissingFileIsNamed) {
  EXPECT_NAMES(error_of(folder / "none.ply"), "none.ply: there is no such file");
}

TEST_F(MeshIo, FolderIsRefused) {
  fs::create_directory(folder / "a.ply");
  EXPECT_NAMES(error_of(folder / "a.ply"), "is a folder");
}

TEST_F(MeshIo, DeviceIsRefused) {
  if (!fs::exists("/dev/zero")) GTEST_SKIP() << "this system has no /dev/zero";
  EXPECT_NAMES(error_of("/dev/zero"), "not a regular file");
}

TEST_F(MeshIo, UnknownExtensionListsTheKnown) {
  EXPECT_NAMES(error_of("a.docx", kPyramidObj),
               ".vtp, .vtu, .vtk, .ply, .obj, .stl, .off, .gltf and .glb");
  EXPECT_NAMES(error_of("noextension", kPyramidObj), ".ply");
  EXPECT_NAMES(error_of("pieces.pvtp", kPyramidObj), "mpirun");
}

TEST_F(MeshIo, ExtensionsAreReadInCapitalsToo) {
  EXPECT_EQ(read("A.OBJ", kPyramidObj).mesh.triangle_count(), 6u);
  const Mesh plane = make_plane({.resolution = 2});
  for (const std::string name : {"a.oBj", "a.Ply", "a.VTP", "a.Gltf", "a.gLB"}) {
    write_mesh(folder / name, plane);
  }
  EXPECT_EQ(read_mesh(folder / "a.Ply").mesh.triangles, plane.triangles);
#ifdef BRINDLE_HAS_JSON
  EXPECT_EQ(read_mesh(folder / "a.Gltf").mesh.triangles, plane.triangles);
  EXPECT_EQ(read_mesh(folder / "a.gLB").mesh.triangles, plane.triangles);
#endif
}

TEST_F(MeshIo, MessagesShowNoBytesThatATerminalObeys) {
  const std::string bad = "\x1b[2J\xff";
  const std::vector<std::pair<std::string, std::string>> files = {
      {"a.obj", "v 0 0 " + bad + "\n"},
      {"b.obj", "v 0 0 0\nf 1 1 " + bad + "\n"},
      {"a.off", "OFF\n1 1 0\n0 0 " + bad + "\n3 0 0 0\n"},
      {"b.off", bad + "\n"},
      {"c.off", "OFF\n1 1 0\n0 0 0\n3 0 0 " + bad + "\n"},
      {"a.ply", "ply\n" + bad + "\n"},
      {"b.ply", "ply\nformat " + bad + "\n"},
      {"c.ply", "ply\nformat ascii 1.0\nelement v 1\nproperty " + bad + " x\n"},
      {"d.ply", ply_header("ascii") + "0 0 " + bad + "\n"},
      {"a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 " + bad + "\n"},
#ifdef BRINDLE_HAS_JSON
      {"a.gltf", "{\"" + bad + "\":}"},
#endif
  };
  for (const auto& [name, content] : files) {
    const std::string message = error_of(name, content);
    EXPECT_NAMES(message, name);
    for (const char c : message) EXPECT_TRUE(c >= 0x20 && c < 0x7f) << message;
    // However long the word is.
    std::string longer = content;
    longer.insert(longer.find(bad), 100000, 'x');
    EXPECT_LT(error_of(name, longer).size(), 1000u) << name;
  }
#ifdef BRINDLE_HAS_JSON
  const std::string escaped =
      error_of("b.gltf", R"({"meshes":[{"primitives":[{"attributes":{"\u001b[2J":"x"}}]}]})");
  EXPECT_NAMES(escaped, "'\\x1b[2J' must be");
#endif
}

TEST_F(MeshIo, KnowsWhereEveryVertexOfTheFileWent) {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const LoadedMesh plain = read("a.obj", square + "f 1 2 3\n");
  EXPECT_TRUE(plain.vertex_of_row.empty());
  const LoadedMesh seam = read("b.obj", square + "v 1 0 0\nv 1 1 0\nf 1 2 3\nf 4 5 3\n");
  EXPECT_EQ(seam.vertex_of_row, (std::vector<Index>{0, 1, 2, 1, 4}));
  EXPECT_FALSE(seam.renumbered);

  const Mesh torus = make_torus({.resolution = 20});
  const LoadedMesh stl = read("a.stl", binary_stl(torus));
  EXPECT_TRUE(stl.renumbered);
  ASSERT_EQ(stl.vertex_of_row.size(), 3 * torus.triangle_count());
  for (std::size_t t = 0; t < torus.triangle_count(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(stl.mesh.positions[stl.vertex_of_row[3 * t + c]],
                torus.positions[torus.triangles[t][c]]);
    }
  }
}

// A mesh far from zero, as surveys have it. Its floats near zero are exact there, too.
Mesh far_torus() {
  Mesh mesh = make_torus({.resolution = 24});
  mesh.origin = Eigen::Vector3d(500000.5, 5800000.25, 120);
  return mesh;
}

double farthest(const Mesh& a, const Mesh& b) {
  double distance = 0;
  for (std::size_t v = 0; v < a.vertex_count(); ++v) {
    const Eigen::Vector3d way =
        (a.positions[v].cast<double>() + a.origin) - (b.positions[v].cast<double>() + b.origin);
    distance = std::max(distance, way.norm());
  }
  return distance;
}

TEST_F(MeshIo, MeshesFarFromZeroKeepTheirShapeAndTheirPlace) {
  const Mesh mesh = far_torus();
  for (const std::string& name : kWritten) {
    write_mesh(folder / name, mesh);
    const LoadedMesh loaded = read_mesh(folder / name);
    EXPECT_EQ(loaded.repair, MeshRepair{}) << name;
    EXPECT_EQ(loaded.mesh.triangles, mesh.triangles) << name;
    ASSERT_EQ(loaded.mesh.vertex_count(), mesh.vertex_count()) << name;
    EXPECT_LT((loaded.mesh.origin - mesh.origin).norm(), 0.1) << name;
    EXPECT_LT(farthest(loaded.mesh, mesh), 1e-6) << name;
  }
}

TEST_F(MeshIo, TextOfOtherFormatsFarFromZeroKeepsItsShape) {
  const Mesh far = far_torus();
  std::ostringstream off, stl;
  off.precision(12);
  stl.precision(12);
  off << "OFF\n" << far.vertex_count() << ' ' << far.triangle_count() << " 0\n";
  const auto place = [&](std::ostream& out, Index v) {
    const Eigen::Vector3d p = far.positions[v].cast<double>() + far.origin;
    out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  };
  for (Index v = 0; v < far.vertex_count(); ++v) place(off, v);
  stl << "solid a\n";
  for (const Triangle& t : far.triangles) {
    off << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    stl << "facet normal 0 0 0\nouter loop\n";
    for (const Index v : t) place(stl << "vertex ", v);
    stl << "endloop\nendfacet\n";
  }
  stl << "endsolid a\n";
  for (const auto& [name, text] : {std::pair{"a.off", off.str()}, {"a.stl", stl.str()}}) {
    const LoadedMesh loaded = read(name, text);
    EXPECT_EQ(loaded.mesh.triangle_count(), far.triangle_count()) << name;
    EXPECT_EQ(loaded.mesh.vertex_count(), far.vertex_count()) << name;
    EXPECT_FALSE(loaded.repair.changed()) << name;
    EXPECT_LT((loaded.mesh.origin - far.origin).norm(), 0.1) << name;
    float difference = 0;
    for (std::size_t t = 0; t < far.triangle_count(); ++t) {
      const Vec3 side = loaded.mesh.positions[loaded.mesh.triangles[t][1]] -
                        loaded.mesh.positions[loaded.mesh.triangles[t][0]];
      const Vec3 expected = far.positions[far.triangles[t][1]] - far.positions[far.triangles[t][0]];
      difference = std::max(difference, (side - expected).norm());
    }
    EXPECT_LT(difference, 3e-5f) << name;  // 12 digits
  }
}

TEST_F(MeshIo, AVertexThatNoFaceUsesDoesNotHoldTheOriginBack) {
  const LoadedMesh loaded = read("a.obj",
                                 "v 0 0 0\nv 500000 5800000 0\nv 500000.1 5800000 0\n"
                                 "v 500000 5800000.1 0\nf 2 3 4\n");
  EXPECT_EQ(loaded.mesh.triangle_count(), 1u);
  EXPECT_NEAR((loaded.mesh.positions[2] - loaded.mesh.positions[1]).norm(), 0.1, 1e-6);
}

TEST_F(MeshIo, PicturesBesideMeshesFarFromZeroStandThereToo) {
  Mesh mesh = far_torus();
  const DataArray uv = floats("uv", 2, std::vector<float>(2 * mesh.vertex_count(), 0));
  write_textured_mesh(folder / "a.ply", mesh, std::span(&uv, 1), "png");
  EXPECT_LT(farthest(read_mesh(folder / "a.ply").mesh, mesh), 1e-6);
}

TEST_F(MeshIo, NumbersBeyondFloatAreRoundedOrSetAside) {
  const std::string rest = "v 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_EQ(read("a.obj", "v 1e-60 -1e-400 0\n" + rest).mesh.positions[0], Vec3::Zero());
  for (const std::string huge : {"1e39", "1e300", "-1e400"}) {
    EXPECT_NAMES(error_of("a.obj", "v 0 0 " + huge + "\n" + rest), "no numbers");
    const LoadedMesh loaded = read("b.obj", "v 0 0 0\n" + rest + "v 0 0 " + huge + "\nf 1 2 4\n");
    EXPECT_EQ(loaded.repair.vertices_not_finite, 1u);
    EXPECT_EQ(loaded.mesh.triangle_count(), 1u);
  }
}

TEST_F(MeshIo, EmptyFileIsAnErrorInEveryFormat) {
  for (const std::string name : {"a.obj", "a.ply", "a.off", "a.stl", "a.gltf", "a.glb"}) {
    EXPECT_NAMES(error_of(name, ""), "is empty") << name;
  }
}

TEST_F(MeshIo, MeshWithoutTrianglesIsAnError) {
  EXPECT_NAMES(error_of("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n"), "no triangles");
  EXPECT_NAMES(error_of("a.off", "OFF\n1 0 0\n0 0 0\n"), "no triangles");
  EXPECT_NAMES(error_of("a.ply", ply_header("ascii", "1", "0") + "0 0 0\n"), "no triangles");
  EXPECT_NAMES(error_of("a.stl", "solid a\nendsolid a\n"), "no triangles");
}

TEST_F(MeshIo, AllNanIsAnError) {
  EXPECT_NAMES(error_of("a.obj", "v nan 0 0\nv 1 nan 0\nv 0 1 NaN\nf 1 2 3\n"), "no numbers");
  EXPECT_NAMES(error_of("a.obj", "v inf 0 0\nv 1 1e99 0\nv 0 1 -inf\nf 1 2 3\n"), "no numbers");
  EXPECT_NAMES(error_of("a.ply", ply_header("ascii") + "nan 0 0\n1 nan 0\nnan 1 nan\n3 0 1 2\n"),
               "no numbers");
}

TEST_F(MeshIo, FlatTrianglesAloneAreAnError) {
  EXPECT_NAMES(error_of("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\nf 1 1 2\n"), "an area");
}

TEST_F(MeshIo, SomeBadTrianglesAreReported) {
  const LoadedMesh loaded =
      read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nf 1 2 3\nf 1 2 4\nf 1 1 2\nf 3 2 1\n");
  EXPECT_EQ(loaded.mesh.triangle_count(), 1u);
  EXPECT_EQ(loaded.repair, (MeshRepair{.vertices_not_finite = 1,
                                       .vertices_unreferenced = 1,
                                       .triangles_not_finite = 1,
                                       .triangles_degenerate = 1,
                                       .triangles_duplicate = 1}));
}

TEST_F(MeshIo, ObjIndicesOutOfRangeNameTheLine) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const std::string face : {"f 1 2 4", "f 0 1 2", "f 1 2 -4", "f 1 2 99999999999999999999",
                                 "f 1 2 5000000000", "f 1 2 x", "f 1 2 1.5", "f /1 2 3", "f 1 2"}) {
    const std::string message = error_of("a.obj", vertices + "f 1 2 3\n" + face + "\nf 3 2 1\n");
    EXPECT_NAMES(message, "a.obj:5: ") << face;
  }
  EXPECT_NAMES(error_of("a.obj", "f 1 2 3\nf 1 2 9\nf 1 2 7\n" + vertices), "a.obj:2: vertex 9");
}

TEST_F(MeshIo, ObjCoordinatesThatAreNoNumbersNameTheLine) {
  EXPECT_NAMES(error_of("a.obj", "v 0 0 0\nv 1 zero 0\n"), "a.obj:2: ");
  EXPECT_NAMES(error_of("a.obj", "v 0 0 0\nv 1 0\n"), "a.obj:2: ");
}

TEST_F(MeshIo, TruncatedPlyIsAnErrorWhereverItIsCut) {
  write_mesh(folder / "whole.ply", make_plane({.resolution = 3}));
  const std::string binary = load(folder / "whole.ply");
  const std::string text = ply_header("ascii") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const std::string& whole : {binary, text}) {
    // The last line end of a text file is not missed, and half of its last number is one too.
    const std::size_t last = &whole == &text ? whole.size() - 2 : whole.size() - 1;
    for (std::size_t size = 0; size <= last; ++size) {
      if (whole == text && size > last - 1) continue;
      EXPECT_NE(error_of("a.ply", whole.substr(0, size)), "") << size;
    }
  }
}

TEST_F(MeshIo, AbsurdPlyHeadersDoNotAskForMemory) {
  for (const std::string format : {"ascii", "binary_little_endian"}) {
    for (const std::string count : {"4000000000", "9223372036854775807", "100000000"}) {
      EXPECT_NAMES(error_of("a.ply", ply_header(format, count) + kTriangleBytes), "too short");
      EXPECT_NE(error_of("a.ply", ply_header(format, "3", count) + kTriangleBytes), "");
    }
    EXPECT_NE(error_of("a.ply", ply_header(format, "-3") + kTriangleBytes), "");
    EXPECT_NE(error_of("a.ply", ply_header(format, "many") + kTriangleBytes), "");
    EXPECT_NE(error_of("a.ply", ply_header(format, "99999999999999999999") + kTriangleBytes), "");
  }
  EXPECT_NE(error_of("a.ply",
                     "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n"
                     "element face 4000000000\nend_header\n"),
            "");
}

TEST_F(MeshIo, PlyWithAbsurdListsOrCornersIsAnError) {
  const std::string header = ply_header("ascii") + "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_NAMES(error_of("a.ply", header + "3 0 1 3\n"), "a.ply:14: ");
  EXPECT_NAMES(error_of("a.ply", header + "3 0 1 -1\n"), "a.ply:14: ");
  EXPECT_NAMES(error_of("a.ply", header + "3 0 1 1.5\n"), "a.ply:14: ");
  EXPECT_NAMES(error_of("a.ply", header + "2.5 0 1 2\n"), "a.ply:14: ");
  EXPECT_NAMES(error_of("a.ply", header + "2000000000 0 1 2\n"), "a.ply:14: ");
  EXPECT_NAMES(error_of("a.ply", header + "nan 0 1 2\n"), "a.ply:14: ");
  std::string damaged = ply_header("binary_little_endian") + kTriangleBytes;
  damaged[damaged.size() - 13] = '\xff';
  EXPECT_NE(error_of("a.ply", damaged), "");
}

TEST_F(MeshIo, PlyWithoutCoordinatesIsAnError) {
  EXPECT_NAMES(error_of("a.ply",
                        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                        "property list uchar int y\nend_header\n0 1 1\n"),
               "without 'y'");
}

TEST_F(MeshIo, TruncatedOffIsAnError) {
  EXPECT_NAMES(error_of("a.off", kPyramidOff.substr(0, 40)), "truncated");
  EXPECT_NAMES(error_of("a.off", "OFF\n4000000000 4000000000 0\n0 0 0\n"), "too short");
  EXPECT_NAMES(error_of("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "a.off:6: ");
  EXPECT_NAMES(error_of("a.off", "OFF BINARY\n3 1 0\n"), "truncated");
}

TEST_F(MeshIo, TruncatedStlIsAnError) {
  const std::string binary = binary_stl(make_plane({.resolution = 2}));
  const std::string text = "solid a\n" + stl_facet(0) + stl_facet(2) + "endsolid a\n";
  for (std::size_t size = 1; size < text.size() - 4; ++size) {
    EXPECT_NE(error_of("a.stl", text.substr(0, size)), "") << size;
  }
  for (std::size_t size = 1; size < binary.size(); size += 7) {
    EXPECT_NE(error_of("a.stl", binary.substr(0, size)), "") << size;
  }
}

#ifdef BRINDLE_HAS_JSON

TEST_F(MeshIo, JoinsTheCornersOfStl) {
  const Mesh mesh = make_torus({.resolution = 20});
  const LoadedMesh loaded = read("a.stl", binary_stl(mesh));
  EXPECT_TRUE(same_shape(loaded.mesh, mesh));
  EXPECT_EQ(loaded.mesh.vertex_count(), mesh.vertex_count());
  EXPECT_EQ(loaded.repair.vertices_unreferenced, 0u);
  const LoadedMesh text = read("a.stl", "solid a\n" + stl_facet(0) + stl_facet(2) + "endsolid a\n");
  EXPECT_EQ(text.mesh.triangle_count(), 2u);
}

TEST_F(MeshIo, TruncatedGlbIsAnErrorWhereverItIsCut) {
  write_mesh(folder / "whole.glb", make_plane({.resolution = 2}));
  const std::string whole = load(folder / "whole.glb");
  for (std::size_t size = 0; size < whole.size(); size += 5) {
    EXPECT_NE(error_of("a.glb", whole.substr(0, size)), "") << size;
  }
}

/// A glTF file with one triangle, in which `change` may be made.
std::string gltf_triangle(const std::string& old = "", const std::string& now = "") {
  std::string text =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
      "nodes":[{"children":[1],"translation":[5,0,0]},{"mesh":0,"scale":[2,2,2]}],
      "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
      "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],
      "max":[1,1,0]},{"bufferView":1,"componentType":5121,"count":3,"type":"SCALAR"}],
      "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":3},
      {"buffer":0,"byteLength":36,"byteStride":9007199254740992}],
      "buffers":[{"byteLength":40,"uri":"data:application/octet-stream;base64,)"
      "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAECAA==\"}]}";
  if (!old.empty()) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    text.replace(at, old.size(), now);
  }
  return text;
}

TEST_F(MeshIo, MovesMeshesOfGltfToTheirNodes) {
  const Mesh mesh = read("a.gltf", gltf_triangle()).mesh;
  EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{5, 0, 0}, {7, 0, 0}, {5, 2, 0}}));
}

TEST_F(MeshIo, ReadsAttributesOfGltfAsArrays) {
  // All from the numbers of the positions, by other names.
  const auto with = [&](const std::string& attributes, const std::string& node) {
    std::string text = gltf_triangle("\"POSITION\":0", "\"POSITION\":0," + attributes);
    return text.replace(text.find("\"scale\":[2,2,2]"), 15, node);
  };
  const std::vector<float> numbers = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const LoadedMesh loaded =
      read("a.gltf", with(R"("NORMAL":0,"_WIND":0,"_Speed":1,"COLOR_1":0)", "\"scale\":[1,1,1]"));
  const std::vector<DataArray>& arrays = loaded.arrays.points;
  ASSERT_EQ(arrays.size(), 4u);
  EXPECT_EQ(*find_array(arrays, "normal"), make_data_array("normal", 3, numbers));
  EXPECT_EQ(*find_array(arrays, "wind"), make_data_array("wind", 3, numbers));
  EXPECT_EQ(*find_array(arrays, "color_1"), make_data_array("color_1", 3, numbers));
  EXPECT_EQ(*find_array(arrays, "Speed"),
            make_data_array("Speed", 1, std::vector<std::uint8_t>{0, 1, 2}));
  // A quarter turn about z, and twice as wide: normals turn, other vectors do not.
  const LoadedMesh turned = read(
      "b.gltf", with(R"("NORMAL":0,"_WIND":0)", "\"matrix\":[0,2,0,0,-1,0,0,0,0,0,1,0,0,0,0,1]"));
  EXPECT_EQ(vectors_of(find_array(turned.arrays.points, "normal")->view(), "normals"),
            (std::vector<Vec3>{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}}));
  EXPECT_EQ(*find_array(turned.arrays.points, "wind"), make_data_array("wind", 3, numbers));
}

TEST_F(MeshIo, TurnsMirroredMeshesOfGltfInsideOut) {
  const Mesh mesh = read("a.gltf", gltf_triangle("[2,2,2]", "[-2,2,2]")).mesh;
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 2, 1}}));
}

TEST_F(MeshIo, ContradictoryGltfIsAnError) {
  const std::vector<std::pair<std::string, std::string>> changes = {
      {R"("children":[1])", R"("children":[0])"},
      {R"("mesh":0)", R"("children":[0],"mesh":0)"},
      {R"("mesh":0)", R"("mesh":7)"},
      {R"("children":[1])", R"("children":[1,1])"},
      {R"("children":[1])", R"("children":[-1])"},
      {R"("nodes":[0])", R"("nodes":[2])"},
      {R"("scene":0)", R"("scene":1)"},
      {R"("count":3,"type":"VEC3")", R"("count":4,"type":"VEC3")"},
      {R"("count":3,"type":"VEC3")", R"("count":4000000000,"type":"VEC3")"},
      {R"("count":3,"type":"SCALAR")", R"("count":9,"type":"SCALAR")"},
      {R"("count":3,"type":"SCALAR")", R"("count":1e30,"type":"SCALAR")"},
      {R"("byteLength":36)", R"("byteLength":35)"},
      {R"("byteLength":40)", R"("byteLength":30)"},
      {R"("byteOffset":36)", R"("byteOffset":9007199254740992)"},
      {R"("bufferView":0,"componentType":5126,"count":3)",
       R"("bufferView":2,"componentType":5126,"count":2049)"},
      {R"("POSITION":0)", R"("POSITION":1)"},
      {R"("POSITION":0)", R"("POSITION":2)"},
      {R"("indices":1)", R"("indices":0)"},
      {"5121", "5126"},
      {"AAECAA==", "AAEJAA=="},
      {"{\"asset\"", "{\"a\":" + std::string(100000, '[')},
  };
  for (const auto& [old, now] : changes) {
    EXPECT_NE(error_of("a.gltf", gltf_triangle(old, now)), "") << now.substr(0, 80);
  }
}

#endif

std::string damaged(const std::string& whole, std::uint64_t seed) {
  std::string file = whole;
  std::uint64_t drawn = 0;
  const auto random = [&](std::size_t below) {
    return static_cast<std::size_t>(random_number(seed, drawn++) * static_cast<double>(below));
  };
  if (seed % 4 == 0) file.resize(random(file.size()));
  for (std::size_t i = 0; i <= seed % 3 && !file.empty(); ++i) {
    char& byte = file[random(file.size())];
    // In text, another digit does more harm than another letter.
    byte = static_cast<char>(seed % 2 ? random(256) : '0' + random(10));
  }
  return file;
}

TEST_F(MeshIo, DamagedFilesOfEveryFormatEndInAMeshOrAnError) {
  const Mesh mesh = make_plane({.resolution = 2});
  std::vector<std::pair<std::string, std::string>> files = {
      {"a.obj", kPyramidObj},
      {"b.off", kPyramidOff},
      {"c.ply", ply_header("ascii") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"d.stl", "solid a\n" + stl_facet(0) + stl_facet(2) + "endsolid a\n"},
      {"e.stl", binary_stl(mesh)}};
  for (const std::string& name : kWritten) {
    write_mesh(folder / name, mesh);
    files.emplace_back("written_" + name, load(folder / name));
  }
  for (const auto& [name, whole] : files) {
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
      try {
        const LoadedMesh loaded = read(name, damaged(whole, seed));
        for (const Vec3& p : loaded.mesh.positions) ASSERT_TRUE(p.allFinite()) << name;
        for (const Triangle& t : loaded.mesh.triangles) {
          for (const Index v : t) ASSERT_LT(v, loaded.mesh.vertex_count()) << name;
        }
      } catch (const Error& error) {
        EXPECT_NAMES(std::string(error.what()), name);
      }
    }
  }
}

TEST_F(MeshIo, RandomBytesAreAnErrorWithEveryExtension) {
  for (const std::string name : {"a.obj", "a.ply", "a.off", "a.stl", "a.gltf", "a.glb"}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      std::string noise(3000, ' ');
      for (std::size_t i = 0; i < noise.size(); ++i) {
        noise[i] = static_cast<char>(static_cast<unsigned char>(random_number(seed, i) * 256));
      }
      EXPECT_NE(error_of(name, noise), "") << name;
    }
  }
}

TEST_F(MeshIo, KeepsTheVertexNumbersOfTheSharedModels) {
  const fs::path models = BRINDLE_SHARED_MODELS;
  if (!fs::exists(models / "horse.ply")) GTEST_SKIP() << "no models in " << models;
  const std::vector<std::tuple<std::string, std::size_t, std::size_t>> counts = {
      {"horse.ply", 48485, 0},
      {"nefertiti.obj", 49971, 0},
      {"stanford-bunny.obj", 35947, 35947 - 34834},
      {"spot.obj", 2930, 0}};
  for (const auto& [name, vertices, unreferenced] : counts) {
    const LoadedMesh loaded = read_mesh(models / name);
    EXPECT_EQ(loaded.mesh.vertex_count(), vertices) << name;
    EXPECT_EQ(loaded.repair, MeshRepair{.vertices_unreferenced = unreferenced}) << name;
  }
}

DataArray corners_of_a_picture() { return floats("uv", 2, {0, 0, 1, 0, 0, 1}); }

Mesh one_triangle() { return {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}}; }

TEST_F(MeshIo, TexturedMeshesNameTheirPictureBesideThem) {
  const std::vector<DataArray> uv = {corners_of_a_picture()};
  for (const char* name : {"my mesh.obj", "my mesh.ply", "my mesh.vtp"}) {
    write_textured_mesh(folder / name, one_triangle(), uv, "picture");
    for (const fs::path& file : textured_mesh_files(folder / name)) {
      EXPECT_TRUE(fs::exists(file)) << file;
    }
    EXPECT_EQ(load(folder / "my mesh_texture.png"), "picture");
    fs::remove(folder / "my mesh_texture.png");
  }
  EXPECT_NE(load(folder / "my mesh.obj").find("vt 1 0\n"), std::string::npos);
  EXPECT_NE(load(folder / "my mesh.obj").find("f 1/1 2/2 3/3\n"), std::string::npos);
  EXPECT_NE(load(folder / "my mesh.mtl").find("map_Kd my mesh_texture.png\n"), std::string::npos);
  EXPECT_EQ(read_mesh(folder / "my mesh.obj").mesh.positions, one_triangle().positions);
  EXPECT_EQ(read_mesh(folder / "my mesh.ply").mesh.triangles, one_triangle().triangles);
}

TEST_F(MeshIo, GltfHoldsItsPictureAndTurnsVDown) {
  const std::vector<DataArray> uv = {corners_of_a_picture()};
  write_textured_mesh(folder / "a.glb", one_triangle(), uv, "12345");
  const std::string file = load(folder / "a.glb");
  EXPECT_EQ(file.substr(file.size() - 8), std::string("12345\0\0\0", 8));
  EXPECT_EQ(file.size() % 4, 0u);
  std::array<float, 6> stored{};
  std::memcpy(stored.data(), file.data() + file.size() - 8 - sizeof stored, sizeof stored);
  EXPECT_EQ(stored, (std::array<float, 6>{0, 1, 1, 1, 0, 0}));
  EXPECT_EQ(textured_mesh_files(folder / "a.glb"), std::vector<fs::path>{folder / "a.glb"});
}

TEST_F(MeshIo, TexturedMeshesNeedCoordinates) {
  EXPECT_THROW(write_textured_mesh(folder / "a.glb", one_triangle(), {}, "png"), Error);
  const std::vector<DataArray> short_uv = {floats("uv", 2, {0, 0})};
  EXPECT_THROW(write_textured_mesh(folder / "a.obj", one_triangle(), short_uv, "png"), Error);
  EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
}  // namespace brindle
