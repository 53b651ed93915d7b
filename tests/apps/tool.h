/// Runs the brindle program as a user would.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace brindle::test {

struct ToolResult {
  int exit_code = -1;  ///< -1 if a signal ended the program
  std::string out;
  std::string err;
};

/// Runs the program with `arguments` in `folder`.
ToolResult run_tool(const std::vector<std::string>& arguments,
                    const std::filesystem::path& folder = ".");

std::string content(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, std::string_view text);

inline bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

inline constexpr const char* kTorus16 = "shape:torus,resolution=16";
inline constexpr const char* kTorus32 = "shape:torus,resolution=32";
inline constexpr const char* kTorus48 = "shape:torus,resolution=48";
inline constexpr const char* kTorus64 = "shape:torus,resolution=64";
inline constexpr const char* kSquareObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n";

/// An empty folder that goes with the test.
struct ToolTest : testing::Test {
  std::filesystem::path folder;

  void SetUp() override;
  void TearDown() override;

  ToolResult run(const std::vector<std::string>& arguments) const {
    return run_tool(arguments, folder);
  }
  std::set<std::string> listing() const;

  /// Expects that the run ends with `exit_code` and a message that has `message` in it, prints
  /// nothing else and leaves the folder as it was.
  void expect_refusal(int exit_code, std::string_view message,
                      const std::vector<std::string>& arguments) const;
};

}  // namespace brindle::test
