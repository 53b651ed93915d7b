#include <filesystem>
#include <string>

#include "tool.h"

namespace brindle::test {
namespace {

namespace fs = std::filesystem;

// A torus of a few hundred vertices: enough to work on, no time to wait for.
const char* const kTriangleObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

using BadInput = ToolTest;

// The first half of a mesh file that the program itself wrote.
void write_truncated_mesh(const ToolTest& test, const std::string& name) {
  const ToolResult result = test.run({"stripe", kTorus32, "--output", name, "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const fs::path path = test.folder / name;
  fs::resize_file(path, fs::file_size(path) / 2);
}

TEST_F(BadInput, MissingMesh) {
  expect_refusal(1, "none.ply: there is no such file",
                 {"stripe", "none.ply", "--report", "out.json"});
}

TEST_F(BadInput, FolderAsMesh) {
  fs::create_directory(folder / "scans.ply");
  expect_refusal(1, "scans.ply: is a folder", {"stripe", "scans.ply", "--report", "out.json"});
}

TEST_F(BadInput, MeshOfUnknownExtension) {
  write_text(folder / "scan.xyz", kTriangleObj);
  expect_refusal(1, "scan.xyz: brindle cannot tell the format by the extension '.xyz'",
                 {"stripe", "scan.xyz", "--report", "out.json"});
}

TEST_F(BadInput, TruncatedPly) {
  write_truncated_mesh(*this, "half.ply");
  expect_refusal(1, "half.ply: is too short for the ",
                 {"stripe", "half.ply", "--report", "out.json"});
}

TEST_F(BadInput, TruncatedGlb) {
  write_truncated_mesh(*this, "half.glb");
  expect_refusal(1, "half.glb: is shorter than its header says: it is truncated",
                 {"stripe", "half.glb", "--report", "out.json"});
}

TEST_F(BadInput, ObjIndexOutOfRange) {
  write_text(folder / "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
  expect_refusal(1, "a.obj:4: vertex 4 does not exist: there are 3",
                 {"stripe", "a.obj", "--report", "out.json"});
}

TEST_F(BadInput, ObjIndexFarOutOfRange) {
  write_text(folder / "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999999999\n");
  expect_refusal(1, "a.obj:4: '99999999999999999999' is not a face's corner",
                 {"stripe", "a.obj", "--report", "out.json"});
}

TEST_F(BadInput, EmptyFile) {
  write_text(folder / "empty.ply", "");
  expect_refusal(1, "empty.ply: is empty", {"stripe", "empty.ply", "--report", "out.json"});
}

TEST_F(BadInput, MeshWithoutTriangles) {
  write_text(folder / "points.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n");
  expect_refusal(1, "points.off: has no triangles", {"info", "points.off"});
}

TEST_F(BadInput, OnlyNanPositions) {
  write_text(folder / "nan.obj", "v nan nan nan\nv nan nan nan\nv nan nan nan\nf 1 2 3\n");
  expect_refusal(
      1, "nan.obj: has no usable triangle: the corners of all have coordinates that are no numbers",
      {"stripe", "nan.obj", "--report", "out.json"});
}

TEST_F(BadInput, MissingField) {
  expect_refusal(1, "none.csv: there is no such file",
                 {"stripe", kTorus32, "--field", "none.csv", "--report", "r.json"});
}

TEST_F(BadInput, FieldWithTooFewRows) {
  write_text(folder / "mesh.obj", kTriangleObj);
  write_text(folder / "short.csv", "1,0,0\n0,1,0\n");
  expect_refusal(1, "'short.csv' has 2 rows, but the mesh has 3 vertices",
                 {"stripe", "mesh.obj", "--field", "short.csv", "--report", "r.json"});
}

TEST_F(BadInput, FieldWithAWord) {
  write_text(folder / "mesh.obj", kTriangleObj);
  write_text(folder / "word.csv", "1,0,0\n0,north,0\n1,0,0\n");
  expect_refusal(1, "'word.csv', line 2: '0,north,0' is not a row of numbers",
                 {"stripe", "mesh.obj", "--field", "word.csv", "--report", "r.json"});
}

TEST_F(BadInput, FieldWithImpossibleFrequency) {
  write_text(folder / "mesh.obj", kTriangleObj);
  write_text(folder / "f.csv", "1,0,0,5\n1,0,0,-5\n1,0,0,5\n");
  expect_refusal(1, "'f.csv', line 2: the frequency must be a finite number above zero",
                 {"stripe", "mesh.obj", "--field", "f.csv", "--report", "r.json"});
}

const char* const kNoFolder = "the folder 'none' does not exist, create it first";

TEST_F(BadInput, OutputFolderDoesNotExist) {
  for (const char* path : {"none/a.png", "none/a.obj", "none/a.json"}) {
    expect_refusal(1, kNoFolder, {"stripe", kTorus32, "--output", path});
  }
  expect_refusal(1, kNoFolder, {"stripe", kTorus32, "--report", "none/a.json"});
  expect_refusal(1, kNoFolder, {"compare", kTorus32, "--json", "none/a.json"});
}

TEST_F(BadInput, OutputIsAFolder) {
  fs::create_directory(folder / "a.png");
  expect_refusal(1, "cannot write 'a.png': it is a folder",
                 {"stripe", kTorus32, "--output", "a.png"});
}

TEST_F(BadInput, OutputOfUnknownExtension) {
  expect_refusal(2, "unknown extension '.jpeg'", {"stripe", kTorus32, "--output", "a.jpeg"});
  expect_refusal(2, "'a'", {"stripe", kTorus32, "--output", "a"});
}

TEST_F(BadInput, OutputsAreCheckedBeforeAnythingIsWritten) {
  expect_refusal(1, kNoFolder, {"stripe", kTorus32, "--output", "a.png", "-o", "none/b.obj"});
}

TEST_F(BadInput, FullDisk) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  for (const char* name :
       {"full.png", "full.obj", "full.ply", "full.vtp", "full.gltf", "full.glb", "full.json"}) {
    fs::create_symlink("/dev/full", folder / name);
    std::vector<std::string> arguments = {"stripe", kTorus32, "--output", name};
    if (std::string(name) == "full.png") arguments.insert(arguments.end(), {"--size", "64x48"});
    expect_refusal(1, "cannot write '" + std::string(name) + "': No space left on device",
                   arguments);
  }
  expect_refusal(1, "cannot write '/dev/full': No space left on device",
                 {"stripe", kTorus32, "--report", "/dev/full"});
  expect_refusal(1, "cannot write '/dev/full': No space left on device",
                 {"compare", kTorus32, "--json", "/dev/full"});
}

TEST_F(BadInput, SizesThatFloatsCannotMeasure) {
  const auto triangle = [&](const std::string& size) {
    write_text(folder / "a.obj", "v 0 0 0\nv " + size + " 0 0\nv 0 " + size + " 0\nf 1 2 3\n");
  };
  for (const char* size : {"1e-20", "1e-12", "1e12", "1e17"}) {
    triangle(size);
    expect_refusal(1, "a.obj: surface: neighbours are ", {"stripe", "a.obj", "--report", "r.json"});
    expect_refusal(1, "give coordinates in other units", {"curves", "a.obj", "--report", "r.json"});
  }
  triangle("1e19");
  expect_refusal(1, "larger units", {"stripe", "a.obj", "--report", "r.json"});
  for (const char* size : {"1e-9", "1e8"}) {
    triangle(size);
    EXPECT_EQ(run({"stripe", "a.obj", "--stripes", "1"}).exit_code, 0) << size;
  }
}

/// "640 x 480" of "640x480".
std::string spaced(const std::string& size) {
  const std::size_t middle = size.find('x');
  if (middle == std::string::npos) return size;
  return size.substr(0, middle) + " x " + size.substr(middle + 1);
}

struct WrongUsage : ToolTest, testing::WithParamInterface<std::vector<std::string>> {};

TEST_P(WrongUsage, EndsWithCodeTwo) {
  std::vector<std::string> arguments = {"stripe", kTorus32, "--report", "out.json"};
  arguments.insert(arguments.end(), GetParam().begin(), GetParam().end());
  const std::string& option = GetParam().front();
  expect_refusal(2, option, arguments);
  // What was given is named, or what is missing, or what does not go together.
  const std::string reason = run(arguments).err;
  const auto names = [&](const std::string& value) {
    return reason.find("'" + value + "'") != std::string::npos ||
           reason.find(" " + value + " ") != std::string::npos ||
           reason.find("= " + value) != std::string::npos ||
           reason.find(", got " + value + "\n") != std::string::npos ||
           reason.find(spaced(value)) != std::string::npos;
  };
  const std::string& value = GetParam().back();
  const std::size_t equals = value.find('=');  // of a part
  const bool names_value =
      names(value) || (equals != value.npos && names(value.substr(equals + 1)));
  const bool names_conflict = reason.find("excludes") != std::string::npos;
  const bool names_lack = reason.find("missing") != std::string::npos ||
                          reason.find("not expected") != std::string::npos;
  EXPECT_TRUE(names_value || names_conflict || names_lack) << reason;
}

INSTANTIATE_TEST_SUITE_P(
    Stripe, WrongUsage,
    testing::Values(
        std::vector<std::string>{"--frequency", "0"}, std::vector<std::string>{"--frequency", "-3"},
        std::vector<std::string>{"--frequency", "inf"},
        std::vector<std::string>{"--frequency", "nan"},
        std::vector<std::string>{"--frequency", "1e99"},
        std::vector<std::string>{"--frequency", "1e-99"},
        std::vector<std::string>{"--frequency", "ten"},
        std::vector<std::string>{"--frequency", "10x"}, std::vector<std::string>{"--frequency", ""},
        std::vector<std::string>{"--frequency"}, std::vector<std::string>{"--stripes", "0"},
        std::vector<std::string>{"--stripes", "-40"}, std::vector<std::string>{"--stripes", "inf"},
        std::vector<std::string>{"--stripes", "nan"},
        std::vector<std::string>{"--stripes", "40", "--frequency", "3"},
        std::vector<std::string>{"--direction", "1,0"},
        std::vector<std::string>{"--direction", "1,0,0,0"},
        std::vector<std::string>{"--direction", "0,0,0"},
        std::vector<std::string>{"--direction", "1,nan,0"},
        std::vector<std::string>{"--direction", "up"},
        std::vector<std::string>{"--direction", "1,0,0", "--field", "curvature"},
        std::vector<std::string>{"--solver", "magic"},
        std::vector<std::string>{"--solver", "multilevel,phase-shift=magic"},
        std::vector<std::string>{"--solver", "multilevel,epsilon=-1"},
        std::vector<std::string>{"--solver", "multilevel,epsilon=nan"},
        std::vector<std::string>{"--solver", "multilevel,momentum=1"},
        std::vector<std::string>{"--threads", "-1"}, std::vector<std::string>{"--threads", "two"},
        std::vector<std::string>{"--subdivide", "-1"},
        std::vector<std::string>{"--subdivide", "99"},
        std::vector<std::string>{"--solver", "multilevel,sweeps=-1"},
        std::vector<std::string>{"--solver", "multilevel,cycles=-1"},
        std::vector<std::string>{"--solver", "multilevel,weights=magic"},
        std::vector<std::string>{"--solver", "multilevel,iterations=0"},
        std::vector<std::string>{"--solver", "multilevel,seed=-1"},
        std::vector<std::string>{"--rotate", "inf"},
        std::vector<std::string>{"--curvature-anchor", "-1"},
        std::vector<std::string>{"--curvature-anchor", "1e30"},
        std::vector<std::string>{"--feature-anchor", "1e30"},
        std::vector<std::string>{"--field", "smooth,x"}, std::vector<std::string>{"--nonsense"}));

#ifdef BRINDLE_HAS_GL
INSTANTIATE_TEST_SUITE_P(Picture, WrongUsage,
                         testing::Values(std::vector<std::string>{"--view", "sideways"},
                                         std::vector<std::string>{"--camera", "30"},
                                         std::vector<std::string>{"--camera", "30,100"},
                                         std::vector<std::string>{"--light-from", "left"},
                                         std::vector<std::string>{"--light-from", "30"},
                                         std::vector<std::string>{"--light-from", "30,91"},
                                         std::vector<std::string>{"--light-from", "30,20,1"},
                                         std::vector<std::string>{"--light-from", "inf,20"},
                                         std::vector<std::string>{"--slice", "50%"},
                                         std::vector<std::string>{"--slice", "w=2"},
                                         std::vector<std::string>{"--slice", "x=y"},
                                         std::vector<std::string>{"--slice", "xy=1"},
                                         std::vector<std::string>{"--slice", "x=1,2"},
                                         std::vector<std::string>{"--slice", "0,0,0,0,0,0"},
                                         std::vector<std::string>{"--slice", "0,0,0,1,0"},
                                         std::vector<std::string>{"--size", "0x100"},
                                         std::vector<std::string>{"--size", "100"},
                                         std::vector<std::string>{"--size", "999999x999999"},
                                         std::vector<std::string>{"--colors", "red"},
                                         std::vector<std::string>{"--colors", "#ffffff"},
                                         std::vector<std::string>{"--stripe-width", "2"},
                                         std::vector<std::string>{"--up", "w"}));
#endif

TEST_F(BadInput, UnknownShapesAndParameters) {
  expect_refusal(2, "nosuch", {"stripe", "shape:nosuch"});
  expect_refusal(2, "colour", {"stripe", "shape:torus,colour=3"});
  expect_refusal(2, "resolution", {"info", "shape:torus,resolution=many"});
}

TEST_F(BadInput, CommandsThatAreNone) {
  expect_refusal(2, "brindle --help", {});
  expect_refusal(2, "paint", {"paint", "shape:torus"});
  expect_refusal(2, "MESH", {"stripe"});
  expect_refusal(2, "MESH", {"info"});
  for (const char* command : {"stripe", "compare", "curves", "sample", "animate"}) {
    expect_refusal(2, "MESH", {command, ""});
  }
}

#ifdef BRINDLE_HAS_JSON

TEST_F(BadInput, StrokesThatCannotBeFollowed) {
  const auto refused = [&](const std::string& part, const std::string& text) {
    write_text(folder / "s.json", text);
    expect_refusal(1, part, {"stripe", kTorus32, "--strokes", "s.json", "--report", "r.json"});
  };
  refused("s.json: damaged JSON: parse error at line 2, column 3", "{\"strokes\":\n  ]");
  refused("s.json: strokes[0] has no length", R"({"strokes": [{"radius": 1, "points": []}]})");
  refused("s.json: strokes[0]: point 1 is 4",
          R"({"strokes": [{"radius": 0.1, "points": [[1, 0, 0], [5, 0, 0]]}]})");
  expect_refusal(1, "none.json",
                 {"stripe", kTorus32, "--strokes", "none.json", "--report", "r.json"});
  write_text(folder / "s.json", "{}");
  expect_refusal(2, "is read by --strokes",
                 {"stripe", kTorus32, "--strokes", "s.json", "--report", "s.json"});
}

#endif

}  // namespace
}  // namespace brindle::test
