#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/base/input_file.h"
#include "brindle/base/memory_file.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/polylines.h"
#include "brindle/shapes.h"
#include "test_folder.h"

namespace brindle {
namespace {

struct MemoryFiles : TestFolder {};

TEST_F(MemoryFiles, AreReadAsFilesOfTheSystemAre) {
  const Mesh mesh = make_shape("torus,resolution=12");
  for (const std::string kind : {"obj", "ply", "vtp"}) {
    const std::filesystem::path path = folder / ("torus." + kind);
    write_mesh(path, mesh);
    const MemoryFile memory("memory." + kind, whole_input(path, "a file"));
    const LoadedMesh theirs = read_mesh(path), ours = read_mesh(memory.name());
    EXPECT_EQ(ours.mesh.positions, theirs.mesh.positions) << kind;
    EXPECT_EQ(ours.mesh.triangles, theirs.mesh.triangles) << kind;
  }
}

TEST_F(MemoryFiles, AreWrittenAsFilesOfTheSystemAre) {
  Polylines lines;
  lines.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  lines.normals.assign(3, {0, 0, 1});
  lines.offsets = {0, 3};
  lines.closed = {0};
  const std::vector<NamedLines> kinds = {{"stripes", lines, {}}};
  for (const std::string kind : {"obj", "ply", "vtp", "csv"}) {
    const std::filesystem::path path = folder / ("lines." + kind);
    write_polylines(path, kinds);
    MemoryFile memory("lines." + kind);
    write_polylines(memory.name(), kinds);
    EXPECT_EQ(memory.content, whole_input(path, "a file")) << kind;
    EXPECT_FALSE(std::filesystem::exists(memory.name())) << kind;
  }
}

TEST_F(MemoryFiles, ThatAreDamagedAreNamedInErrors) {
  const MemoryFile memory("torn.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n");
  try {
    read_mesh(memory.name());
    FAIL();
  } catch (const Error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("torn.obj:3: ")) << error.what();
  }
}

}  // namespace
}  // namespace brindle
