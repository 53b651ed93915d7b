// Where memory is short (ulimit -v), commands end: done, or with a message that says so.
#include <cstdlib>
#include <regex>
#include <string>

#include <sys/wait.h>

#include "tool.h"

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace brindle::test {
namespace {

struct MemoryLimit : ToolTest {
  // Runs the program with so many kB of addresses.
  ToolResult run_within(int kilobytes, const std::string& arguments) const {
    const auto out = folder / "out.txt", err = folder / "err.txt";
    const std::string command = "cd '" + folder.string() + "' && ulimit -v " +
                                std::to_string(kilobytes) + " && exec '" BRINDLE_TOOL "' " +
                                arguments + " >'" + out.string() + "' 2>'" + err.string() + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(out), content(err)};
  }
};

TEST_F(MemoryLimit, OfAnySizeLetsCommandsEnd) {
  for (const char* arguments :
       {"stripe shape:torus", "stripe shape:torus --subdivide 1 -o torus.vtp",
        "curves shape:trefoil -o curves.obj", "info shape:box"}) {
    for (const int kilobytes : {150'000, 200'000, 250'000, 300'000, 500'000, 1'000'000}) {
      const ToolResult result = run_within(kilobytes, arguments);
      const std::string said = std::string(arguments) + " within " + std::to_string(kilobytes) +
                               " kB ended with " + std::to_string(result.exit_code) + ": " +
                               result.err;
      EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 1) << said;
      if (result.exit_code == 1) {
        EXPECT_NE(result.err.find("memory"), std::string::npos) << said;
      }
      if (kilobytes >= 1'000'000) {
        EXPECT_EQ(result.exit_code, 0) << said;
      }
    }
  }
}

// BLAS asks for its buffer again and again where there is no memory for it, and OpenMP for threads.
TEST_F(MemoryLimit, LetsTheGlobalSolverEnd) {
  for (const int kilobytes : {250'000, 300'000, 320'000, 350'000, 400'000, 430'000, 500'000}) {
    const ToolResult result = run_within(kilobytes, "stripe shape:torus --solver global");
    const std::string said = std::to_string(kilobytes) + " kB ended with " +
                             std::to_string(result.exit_code) + ": " + result.err;
    EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 1) << said;
    if (result.exit_code == 1) {
      EXPECT_NE(result.err.find("memory"), std::string::npos) << said;
    }
  }
}

// The spacing that a refusal names.
TEST_F(MemoryLimit, RefusesPointsThatItDoesNotHoldAndNamesASpacingThatWouldDo) {
  constexpr int kKilobytes = 500'000;
  const std::string command = "curves shape:torus,resolution=24 --stripes 10 -o points.csv ";
  const ToolResult refused = run_within(kKilobytes, command + "--resample 1e-9");
  EXPECT_EQ(refused.exit_code, 1) << refused.err;
  EXPECT_FALSE(exists(folder / "points.csv"));
  std::smatch found;
  ASSERT_TRUE(std::regex_search(
      refused.err, found,
      std::regex("--resample: .* points, and memory has room for .*; the smallest spacing that "
                 "would do is ([^ \n]+)")))
      << refused.err;
  const ToolResult done = run_within(kKilobytes, command + "--quiet --resample " + found[1].str());
  EXPECT_EQ(done.exit_code, 0) << done.err;
}

TEST_F(MemoryLimit, RefusesStripesTrianglesAndTubesByName) {
  constexpr int kKilobytes = 500'000;
  const auto refusal = [&](const std::string& arguments) {
    const ToolResult result = run_within(kKilobytes, arguments);
    EXPECT_EQ(result.exit_code, 1) << arguments;
    return result.err;
  };
  EXPECT_NE(refusal("curves shape:torus --stripes 1e6 -o c.obj").find("--stripes "),
            std::string::npos);
  EXPECT_NE(refusal("stripe shape:torus --subdivide 8").find("times is possible"),
            std::string::npos);
  EXPECT_NE(refusal("info shape:torus,resolution=10000").find("resolution=10000 is too fine"),
            std::string::npos);
  EXPECT_NE(refusal("sample shape:torus --stripes 3e4 -o s.csv").find("times as many"),
            std::string::npos);
  EXPECT_EQ(listing(), (std::set<std::string>{"err.txt", "out.txt"}));
}

}  // namespace
}  // namespace brindle::test

#endif
