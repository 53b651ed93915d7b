#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "tool.h"

namespace brindle::test {
namespace {

namespace fs = std::filesystem;

const char* const kSheetObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n";
const std::string kLatin = "caf\xe9";            // no UTF-8
const std::string kBroken = "a\x1b[31m\nfaces";  // what a terminal would obey

struct FileNames : ToolTest {};

TEST_F(FileNames, ThatAreNotUtf8Work) {
  write_text(folder / (kLatin + ".obj"), kSheetObj);
  write_text(folder / (kLatin + ".csv"), "1,0,0\n1,0,0\n1,0,0\n1,0,0\n");
  const ToolResult result =
      run({"stripe", kLatin + ".obj", "--field", kLatin + ".csv", "--output", kLatin + ".vtp",
           "--output", kLatin + ".json", "--report", "second.json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(fs::exists(folder / (kLatin + ".vtp")));
  const auto report = nlohmann::json::parse(content(folder / (kLatin + ".json")));
  EXPECT_EQ(report["input"], "caf\\xe9.obj");
  EXPECT_EQ(report["options"]["field"], "caf\\xe9.csv");
  EXPECT_EQ(nlohmann::json::parse(content(folder / "second.json")), report);
  EXPECT_NE(result.out.find("wrote caf\\xe9.vtp"), std::string::npos) << result.out;
  EXPECT_EQ(result.out.find('\xe9'), std::string::npos) << result.out;
  EXPECT_EQ(run({"info", kLatin + ".vtp"}).exit_code, 0);
}

TEST_F(FileNames, AreNotObeyedByTheTerminal) {
  write_text(folder / (kBroken + ".obj"), "v 0 0 0\nf 1 2 3\n");
  expect_refusal(1, "a\\x1b[31m\\x0afaces.obj:2: ", {"info", kBroken + ".obj"});
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"info", kBroken + ".ply"},
        {"stripe", "shape:sphere", "--field", kBroken + ".csv", "-o", "a.json"},
        {"stripe", "shape:sphere", "-o", kBroken + "/a.ply"},
        {"stripe", "shape:sphere", "-o", kBroken},
        {"stripe", kBroken + ".obj", "-o", kBroken + ".obj"}}) {
    const ToolResult result = run(arguments);
    EXPECT_NE(result.exit_code, 0);
    EXPECT_EQ(result.err.find('\x1b'), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("\\x1b[31m\\x0afaces"), std::string::npos) << result.err;
  }
}

#ifdef BRINDLE_HAS_GL
TEST_F(FileNames, WithLineBreaksAreNotNamedInOtherFiles) {
  for (const char* extension : {".obj", ".ply"}) {
    expect_refusal(
        1, "control characters",
        {"stripe", "shape:sphere,resolution=8", "--texture", "dots", "-o", kBroken + extension});
  }
  const ToolResult result = run({"stripe", "shape:sphere,resolution=8", "--texture", "dots", "-q",
                                 "-o", kBroken + ".glb", "-o", kLatin + ".obj"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(content(folder / (kLatin + ".obj")).find("mtllib " + kLatin + ".mtl\n"),
            std::string::npos);
}
#endif

// Each of these would wait or read for ever.
TEST_F(FileNames, OfPipesAndDevicesAreRefused) {
  ASSERT_EQ(mkfifo((folder / "pipe.csv").c_str(), 0600), 0);
  fs::create_symlink("pipe.csv", folder / "pipe.ply");
  fs::create_symlink("pipe.csv", folder / "pipe.png");
  fs::create_symlink("pipe.csv", folder / "pipe.json");
  fs::create_symlink("/dev/zero", folder / "zero.csv");
  fs::create_symlink("/dev/zero", folder / "zero.png");
  write_text(folder / "a.gltf", R"({"asset": {"version": "2.0"},
    "buffers": [{"uri": "pipe.csv", "byteLength": 36}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}]})");
  const std::string remedy = "save ";
  const auto refused = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"stripe", "shape:sphere,resolution=8", "--report",
                                          "r.json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expect_refusal(1, remedy, arguments);
  };
  expect_refusal(1, remedy, {"info", "a.gltf"});
  for (const char* file : {"pipe.csv", "pipe.ply"}) {
    expect_refusal(1, remedy, {"info", file});
    expect_refusal(1, remedy, {"info", file, "--points"});
  }
  for (const char* file : {"pipe.csv", "zero.csv"}) {
    refused({"--field", file});
    refused({"--frequency-by", file});
    refused({"--slack", "0.1", "--avoid-branches", file});
    refused({"--field-mesh", file, "--field", "array:a"});
  }
  refused({"--strokes", "pipe.json"});
  refused({"--previous", "pipe.ply"});
#ifdef BRINDLE_HAS_GL
  for (const char* file : {"pipe.csv", "zero.csv"}) {
    refused({"--color-by", file, "--output", "a.png"});
    refused({"--width-by", file, "--output", "a.png"});
  }
  for (const char* file : {"pipe.png", "zero.png"}) refused({"--texture", file, "-o", "a.glb"});
#endif
}

}  // namespace
}  // namespace brindle::test
