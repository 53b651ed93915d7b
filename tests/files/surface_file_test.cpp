#include <cstdint>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/files.h"
#include "parametric_meshes.h"
#include "vtk_surfaces.h"

namespace brindle {
namespace {

struct SurfaceFiles : VtkFile {};

/// Bytes that this process has read from files until now.
std::uint64_t bytes_read() {
  std::ifstream counts("/proc/self/io");
  std::string name;
  for (std::uint64_t count = 0; counts >> name >> count;) {
    if (name == "rchar:") return count;
  }
  return 0;
}

std::string text_of_plane(std::size_t resolution, const std::string& name,
                          const std::filesystem::path& folder) {
  write_mesh(folder / name, make_plane({.resolution = static_cast<int>(resolution)}));
  std::ifstream in(folder / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST_F(SurfaceFiles, AreReadOnceWhateverIsAsked) {
  if (bytes_read() == 0) GTEST_SKIP() << "this system does not count what a process reads";
  const std::uint64_t self = [] {  // what counting takes
    const std::uint64_t before = bytes_read();
    return bytes_read() - before;
  }();
  std::vector<std::pair<std::string, std::string>> files;
  for (const char* name : {"a.obj", "a.ply", "a.vtp", "a.glb", "a.gltf"}) {
    files.emplace_back(name, text_of_plane(300, name, folder));
  }
  const DataArrays arrays = every_type();
#ifdef BRINDLE_HAS_VTK
  files.emplace_back("b.vtp", poly_data({}, arrays, 1000));
  files.emplace_back("b.vtu", grid({}, {{0, 1, 4, 3}, {4}}, {9}));
#endif
  files.emplace_back("b.vtk", legacy(false, 5, arrays));
  for (const auto& [name, content] : files) {
    const auto path = save(name, content);
    const std::uint64_t before = bytes_read();
    SurfaceFile file(path);
    EXPECT_TRUE(file.has_faces());
    EXPECT_TRUE(file.has_faces());
    EXPECT_GT(file.mesh().mesh.triangle_count(), 0u);
    const std::uint64_t read = bytes_read() - before - self;
    EXPECT_GE(read, content.size()) << name;
    EXPECT_LE(read, content.size() + content.size() / 10 + 40000) << name;
  }
}

TEST_F(SurfaceFiles, CanBeAskedAgain) {
  SurfaceFile file(save("a.vtk", legacy(true, 5, {})));
  EXPECT_TRUE(file.has_faces());
  const Mesh mesh = file.mesh().mesh;
  EXPECT_EQ(file.mesh().mesh.triangles, mesh.triangles);
  EXPECT_EQ(file.points().cloud.positions.size(), 9u);
}

TEST_F(SurfaceFiles, FacesAreFoundWhereverTheyStand) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  std::string many, comment = "# " + std::string(40000, 'c') + '\n';
  for (int i = 0; i < 20000; ++i) many += "v 1 2 3.25\n";
  for (const std::string& text :
       {vertices + "f 1 2 3", vertices + "f 1 2 3\n" + many, "f 1 2 3\n" + vertices + many,
        vertices + "  f 1 2 3\r\n" + many, many + vertices + "f 1 2 \\\n3\n" + comment,
        vertices + "f 1 2 3\n" + comment}) {
    EXPECT_TRUE(SurfaceFile(save("a.obj", text)).has_faces());
  }
  for (const std::string& text : {many, many + comment, vertices + "# f\nfoo f\nl 1 \\\nf\n"}) {
    EXPECT_FALSE(SurfaceFile(save("a.obj", text)).has_faces());
  }
}

TEST_F(SurfaceFiles, LinesAreNoSurfaceUnlessTheirPointsAreAskedFor) {
  const std::string vtk =
      "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
      "0 0 0 1 0 0 0 1 0\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n0 1\n";
  const std::vector<std::pair<std::string, std::string>> files = {
      {"a.vtk", vtk + "LINES 1 4\n3 0 1 2\n"},
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n"},
      {"a.ply", ply}};
  for (const auto& [name, text] : files) {
    SurfaceFile file(save(name, text));
    EXPECT_FALSE(file.has_faces()) << name;
    try {
      file.is_point_cloud();
      FAIL() << name;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("read it as points"), std::string::npos)
          << error.what();
    }
    EXPECT_EQ(file.points().cloud.positions.size(), 3u) << name;
  }
  EXPECT_TRUE(SurfaceFile(save("b.vtk", vtk + "VERTICES 1 2\n1 0\n")).is_point_cloud());
  EXPECT_FALSE(SurfaceFile(save("c.vtk", vtk + "LINES 1 3\n2 0 1\nPOLYGONS 1 4\n3 0 1 2\n"))
                   .is_point_cloud());
}

TEST_F(SurfaceFiles, ThatCannotBeReadSayWhyAsMeshes) {
  SurfaceFile file(folder / "none.vtk");
  EXPECT_TRUE(file.has_faces());
  EXPECT_THROW(file.mesh(), Error);
}

}  // namespace
}  // namespace brindle
