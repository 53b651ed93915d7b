// Ranks that are asked for different things, see different files, or wait for ever.
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <sys/stat.h>

#include "mpi_tool/mpi_tool.h"

namespace brindle {
namespace {

using test::MpiTool;
using test::run_tool;
using test::ToolResult;
using test::Words;

void expect_in(const ToolResult& result, const std::string& text) {
  EXPECT_NE(result.err.find(text), std::string::npos) << text << "\n" << result.err;
}

TEST_F(MpiTool, RefusesRanksWithDifferentWords) {
  const std::vector<std::pair<Words, Words>> pairs = {
      {{"stripe", "shape:torus"}, {"stripe", "shape:sphere"}},
      {{"stripe", "shape:torus"}, {"curves", "shape:torus"}},
      {{"stripe", "shape:torus", "--frames", "3"}, {"stripe", "shape:torus", "--frames", "2"}},
      {{"stripe", "shape:torus", "--frames", "3"}, {"stripe", "shape:torus"}},
      {{"stripe", "shape:torus", "--stripes", "30"}, {"stripe", "shape:torus", "--stripes", "40"}},
      {{"stripe", "shape:torus", "-o", "out.pvtp"}, {"stripe", "shape:torus", "-o", "b.pvtp"}},
      {{"stripe", "shape:torus"}, {"stripe", "shape:torus", "--nonsense"}},
      {{"stripe", "shape:torus"}, {"stripe", "--help"}},
      {{"--version"}, {"sample", "shape:torus"}},
  };
  for (const auto& [first, second] : pairs) {
    const ToolResult result = with_others(1, first, 1, second);
    const auto line = [](const Words& words) {
      std::string text;
      for (const std::string& word : words) text += " " + word;
      return text;
    };
    expect_failure(result, 2, "different words");
    expect_in(result, "rank 0:" + line(first) + " ");
    expect_in(result, "rank 1:" + line(second) + " ");
    EXPECT_EQ(result.out, "");
  }
  const ToolResult result = with_others(3, {"stripe", "shape:torus"}, 1, {"stripe", "shape:box"});
  expect_failure(result, 2, "rank 0: stripe shape:torus");
  expect_in(result, "rank 3: stripe shape:box");
}

TEST_F(MpiTool, LetsEachRankChooseItsThreads) {
  const Words shared = {"stripe", "shape:torus,resolution=20", "--stripes", "30", "--along"};
  Words first = shared, second = shared;
  first.insert(first.end(), {"--quiet", "--threads=2"});
  second.insert(second.begin() + 1, {"--threads", "1"});
  const ToolResult result = with_others(2, first, 1, second);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
}

/// Either the list of pieces, or what one of them holds, is another one in another folder.
TEST_F(MpiTool, RefusesRanksThatSeeDifferentFiles) {
  namespace fs = std::filesystem;
  const std::string mesh = "shape:torus,resolution=20";
  ASSERT_EQ(on(4, {mesh, "--output", "in.pvtp", "--quiet"}).exit_code, 0);
  fs::create_directories(folder / "b");
  for (const std::string& name : listing()) {
    if (name.starts_with("in")) fs::copy(folder / name, folder / "b" / name);
  }
  const auto both = [&](int ranks) {
    return with_others(1, {"stripe", "in.pvtp"}, ranks - 1, {"stripe", "in.pvtp"}, "b");
  };
  for (const int ranks : {2, 3, 4}) EXPECT_EQ(both(ranks).exit_code, 0) << "copies";
  const auto refused = [&](const char* changed) {
    for (const int ranks : {2, 3, 4}) {
      const ToolResult result = both(ranks);
      EXPECT_EQ(result.exit_code, 2);
      expect_in(result, std::string(changed) + "' is not the same file");
      expect_in(result, "rank 0: ");
    }
  };
  // Of the same size: with a stripe more.
  const ToolResult other = run_tool(
      [&] {
        Words words = mpirun();
        words.insert(words.end(), {"-n", "4", "-wdir", "b", BRINDLE_TOOL_ALONE, "stripe", mesh,
                                   "--stripes", "41", "--output", "in.pvtp", "--quiet"});
        return words;
      }(),
      folder);
  ASSERT_EQ(other.exit_code, 0) << other.err;
  ASSERT_EQ(fs::file_size(folder / "in_1.vtp"), fs::file_size(folder / "b" / "in_1.vtp"));
  refused(".vtp");
  test::write_text(folder / "b" / "in.pvtp", test::content(folder / "in.pvtp") + "\n");
  refused("in.pvtp");
}

TEST_F(MpiTool, RefusesRanksWithDifferentFieldMeshes) {
  std::filesystem::create_directories(folder / "b");
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nproperty float v\nelement face 1\nproperty list uchar int "
      "vertex_indices\nend_header\n0 0 0 1\n1 0 0 2\n0 1 0 ";
  test::write_text(folder / "other.ply", ply + "3\n3 0 1 2\n");
  test::write_text(folder / "b" / "other.ply", ply + "4\n3 0 1 2\n");
  const Words words = {"stripe",    "shape:torus",    "--field-mesh",
                       "other.ply", "--frequency-by", "array:v"};
  const ToolResult result = with_others(1, words, 1, words, "b");
  expect_failure(result, 2, "'other.ply' is not the same file");
}

/// Rank 0 waits for a pipe that nobody reads, the others for rank 0.
TEST_F(MpiTool, TellsWhereRanksWaitForEver) {
  ASSERT_EQ(mkfifo((folder / "report.json").c_str(), 0600), 0);
  for (const int ranks : {2, 4}) {
    const ToolResult result =
        on(ranks, {"shape:torus,resolution=20", "--report", "report.json", "--stall-limit", "0.5"});
    EXPECT_EQ(result.exit_code, 1);
    expect_in(result, "has waited");
    expect_in(result, " at '");
    expect_in(result, "--stall-limit 0.5");
    EXPECT_EQ(result.err.find("rank 0 has waited"), std::string::npos) << result.err;
  }
}

TEST_F(MpiTool, RefusesStallLimitsThatAreNone) {
  expect_failure(on(2, {"shape:torus", "--stall-limit", "-1"}), 2, "--stall-limit");
  expect_failure(on(2, {"shape:torus", "--stall-limit", "soon"}), 2, "--stall-limit");
  EXPECT_EQ(on(2, {"shape:torus,resolution=20", "--stall-limit", "0", "--quiet"}).exit_code, 0);
}

}  // namespace
}  // namespace brindle
