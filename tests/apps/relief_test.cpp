#include <cstdint>
#include <cstring>
#include <string>

#include <nlohmann/json.hpp>
#include <zlib.h>

#include "apps/tool.h"
#include "brindle/files.h"

namespace brindle::test {
namespace {

struct ReliefToolTest : ToolTest {
  nlohmann::json report(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"relief", "shape:bracket"});
    arguments.insert(arguments.end(), {"--spacing", "10%", "--report", "r.json", "-q"});
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return nlohmann::json::parse(content(folder / "r.json"));
  }
};

TEST_F(ReliefToolTest, WritesClosedMeshes) {
  const auto json = report({"--texture", "knurl", "--height", "1%", "-o", "a.stl", "-o", "a.ply",
                            "-o", "a.obj", "-o", "a.3mf"});
  EXPECT_EQ(json["closed"], true);
  EXPECT_EQ(json["intersecting_triangles"], 0);
  EXPECT_GT(json["volume"], json["volume_before"]);
  for (const char* file : {"a.stl", "a.ply", "a.obj"}) {
    const LoadedMesh read = read_mesh(folder / file);
    EXPECT_EQ(read.mesh.triangle_count(), json["triangles"]) << file;
    EXPECT_EQ(read.mesh.vertex_count(), json["vertices"]) << file;
    EXPECT_FALSE(read.repair.changed()) << file;
  }
}

/// The parts of a 3MF file have the checksums and sizes that its archive lists.
TEST_F(ReliefToolTest, Writes3mfArchives) {
  report({"--texture", "dots", "--height", "1%", "-o", "a.3mf"});
  const std::string zip = content(folder / "a.3mf");
  const auto number = [&](std::size_t at, std::size_t bytes) {
    std::uint32_t value = 0;
    std::memcpy(&value, zip.data() + at, bytes);
    return value;
  };
  ASSERT_EQ(zip.substr(zip.size() - 22, 4), "PK\5\6");
  const std::size_t files = number(zip.size() - 12, 2);
  EXPECT_EQ(files, 3u);
  std::size_t entry = number(zip.size() - 6, 4);
  std::string names;
  for (std::size_t i = 0; i < files; ++i) {
    ASSERT_EQ(zip.substr(entry, 4), "PK\1\2");
    const std::size_t size = number(entry + 24, 4), name = number(entry + 28, 2);
    const std::size_t local = number(entry + 42, 4);
    const auto* bytes = reinterpret_cast<const Bytef*>(zip.data() + local + 30 + name);
    EXPECT_EQ(crc32(0, bytes, static_cast<uInt>(size)), number(entry + 16, 4));
    EXPECT_EQ(zip.substr(entry + 46, name), zip.substr(local + 30, name));
    names += zip.substr(entry + 46, name) + ' ';
    entry += 46 + name;
  }
  EXPECT_EQ(entry, zip.size() - 22);
  EXPECT_EQ(names, "[Content_Types].xml _rels/.rels 3D/3dmodel.model ");
}

TEST_F(ReliefToolTest, LeavesFacesOut) {
  const std::vector<std::string> knurl = {"--texture", "knurl", "--height", "0.5%"};
  const auto area = [&](std::vector<std::string> more) {
    more.insert(more.begin(), knurl.begin(), knurl.end());
    return report(std::move(more))["area"].get<double>();
  };
  const double all = area({});
  EXPECT_LT(area({"--keep-flat"}), 0.5 * all);
  EXPECT_LT(area({"--only", "z@10"}), 0.4 * all);
  EXPECT_GT(area({"--only", "z@180"}), 0.999 * all);
}

TEST_F(ReliefToolTest, FillsHolesAndSaysSo) {
  run({"stripe", "shape:tube,bend=0", "-o", "tube.ply", "-q"});
  const std::vector<std::string> words = {"relief", "tube.ply",  "--texture", "dots", "--height",
                                          "1%",     "--spacing", "10%",       "-o",   "a.stl"};
  const ToolResult open = run(words);
  EXPECT_TRUE(has(open.err, "--fill-holes")) << open.err;
  std::vector<std::string> all = words;
  all.insert(all.end(), {"--fill-holes", "500%"});
  const ToolResult closed = run(all);
  EXPECT_TRUE(has(closed.err, "2 holes are filled")) << closed.err;
  EXPECT_TRUE(has(closed.out, "closed")) << closed.out;
}

TEST_F(ReliefToolTest, MakesInlaysAndCuts) {
  const auto inlay = report({"--texture", "dots", "--height", "0.1%", "--inlay", "0.5%"});
  EXPECT_EQ(inlay["closed"], true);
  EXPECT_GT(inlay["bodies"], 20);
  const auto cut = report({"--texture", "dots", "--height", "1%", "--cut"});
  EXPECT_EQ(cut["closed"], true);
  EXPECT_EQ(cut["bodies"], 1);
}

TEST_F(ReliefToolTest, RejectsWhatHasNoEffect) {
  const auto refused = [&](int code, std::string_view message, std::vector<std::string> more) {
    more.insert(more.begin(), {"relief", "shape:bracket"});
    expect_refusal(code, message, more);
  };
  refused(2, "--height", {"--texture", "knurl"});
  refused(2, "--texture", {"--height", "1"});
  refused(2, "--height", {"--texture", "knurl", "--height", "0"});
  refused(2, "--only", {"--texture", "knurl", "--height", "1%", "--only", "q"});
  refused(2, "--only", {"--texture", "knurl", "--height", "1%", "--only", "z@200"});
  refused(2, "--cut", {"--texture", "knurl", "--height", "1%", "--inlay", "1%", "--cut"});
  refused(2, "--fill-holes",
          {"--texture", "knurl", "--height", "1%", "--cut", "--fill-holes", "1"});
  refused(2, ".off", {"--texture", "knurl", "--height", "1%", "--output", "a.off"});
  refused(1, "no face", {"--texture", "knurl", "--height", "1%", "--only", "1,1,1@1"});
}

}  // namespace
}  // namespace brindle::test
