#include <filesystem>
#include <string>

#include "tool.h"

namespace brindle::test {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

const char* const kField = "1,0,0,2\n1,0,0,2\n1,0,0,2\n1,0,0,2\n";

struct UsedFiles : ToolTest {
  void SetUp() override {
    ToolTest::SetUp();
    write_text(folder / "mesh.obj", kSquareObj);
    write_text(folder / "field.csv", kField);
    fs::create_directory(folder / "sub");
    fs::create_symlink(folder / "mesh.obj", folder / "link.ply");
    fs::create_hard_link(folder / "mesh.obj", folder / "twin.ply");
  }
  void expect_kept(const std::string& message, const Arguments& arguments) const {
    expect_refusal(2, message, arguments);
    EXPECT_EQ(content(folder / "mesh.obj"), kSquareObj);
    EXPECT_EQ(content(folder / "field.csv"), kField);
  }
};

TEST_F(UsedFiles, OfTheInputAreNotOverwritten) {
  expect_kept("'mesh.obj' is read by MESH", {"stripe", "mesh.obj", "-o", "mesh.obj"});
  expect_kept("MESH", {"stripe", "./sub/../mesh.obj", "-o", "mesh.obj"});
  expect_kept("MESH", {"stripe", "mesh.obj", "-o", (folder / "mesh.obj").string()});
  expect_kept("MESH", {"stripe", "link.ply", "-o", "mesh.obj"});
  expect_kept("MESH", {"stripe", "mesh.obj", "-o", "link.ply"});
  expect_kept("MESH", {"stripe", "mesh.obj", "-o", "twin.ply"});
  expect_kept("MESH", {"curves", "mesh.obj", "-o", "mesh.obj"});
  expect_kept("--field", {"sample", "mesh.obj", "--field", "field.csv", "-o", "field.csv"});
  expect_kept("--field-v", {"sample", "mesh.obj", "--field-v", "field.csv", "-o", "field.csv"});
  expect_kept("--field-v",
              {"curves", "mesh.obj", "--lines", "v", "--field-v", "field.csv", "-o", "field.csv"});
}

TEST_F(UsedFiles, OfTheInputAreNotOverwrittenByReports) {
  fs::create_symlink(folder / "mesh.obj", folder / "link.json");
  for (const char* command : {"stripe", "curves", "sample", "animate"}) {
    expect_kept("MESH", {command, "mesh.obj", "--report", "link.json"});
  }
  expect_kept("MESH", {"compare", "mesh.obj", "--json", "link.json"});
  fs::create_symlink(folder / "field.csv", folder / "field.json");
  expect_kept("--field", {"compare", "mesh.obj", "--field", "field.csv", "--json", "field.json"});
}

TEST_F(UsedFiles, BesideGltfMeshesAreNotOverwritten) {
  write_text(folder / "a.gltf", R"({"buffers": [{"uri": "data.ply"}, {"uri": "data:,"}]})");
  write_text(folder / "data.ply", "ply");
  expect_kept("'data.ply' is read by MESH", {"stripe", "a.gltf", "-o", "data.ply"});
  EXPECT_EQ(content(folder / "data.ply"), "ply");
}

TEST_F(UsedFiles, AreNotWrittenTwice) {
  expect_kept("twice", {"stripe", "mesh.obj", "-o", "a.ply", "-o", "sub/../a.ply"});
  expect_kept("twice", {"stripe", "mesh.obj", "-o", "a.json", "--report", "a.json"});
  expect_kept("twice", {"curves", "mesh.obj", "-o", "a.csv", "-o", "a.csv"});
  expect_kept("twice", {"sample", "mesh.obj", "-o", "a.json", "--report", "a.json"});
}

TEST_F(UsedFiles, OfReportsEndInJson) {
  write_text(folder / "victim.obj", kSquareObj);
  for (const char* command : {"stripe", "curves", "sample", "animate"}) {
    expect_kept(".json", {command, "mesh.obj", "--report", "victim.obj"});
    expect_kept(".json", {command, "mesh.obj", "--report", "report"});
  }
  expect_kept(".json", {"compare", "mesh.obj", "--json", "victim.obj"});
  EXPECT_EQ(content(folder / "victim.obj"), kSquareObj);
}

TEST_F(UsedFiles, ThatAreDevicesTakeWhatTheyGet) {
  EXPECT_EQ(run({"stripe", "mesh.obj", "--report", "/dev/null"}).exit_code, 0);
}

#ifdef BRINDLE_HAS_GL

TEST_F(UsedFiles, BesideMeshesCount) {
  ASSERT_EQ(run({"stripe", "mesh.obj", "-q", "--size", "64x48", "-o", "a_texture.png"}).exit_code,
            0);
  const std::string tile = content(folder / "a_texture.png");
  expect_kept("--texture", {"stripe", "mesh.obj", "--texture", "a_texture.png", "-o", "a.obj"});
  expect_kept("twice",
              {"stripe", "mesh.obj", "--texture", "dots", "-o", "a.obj", "-o", "a_texture.png"});
  EXPECT_EQ(content(folder / "a_texture.png"), tile);
  const ToolResult result =
      run({"stripe", "mesh.obj", "--texture", "dots", "-o", "b.obj", "-o", "b.ply"});
  EXPECT_EQ(result.exit_code, 0) << "both show one tile: " << result.err;
}

#endif

}  // namespace
}  // namespace brindle::test
