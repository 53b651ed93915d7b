#include <filesystem>
#include <string>

#include "tool.h"

namespace brindle::test {
namespace {

namespace fs = std::filesystem;

// A torus of a few hundred vertices: enough to work on, no time to wait for.
const char* const kSmallTorus = "shape:torus,resolution=32";

using BadInput = ToolTest;

TEST_F(BadInput, MissingField) {
  expect_refusal(1, "none.csv", {"stripe", kSmallTorus, "--field", "none.csv", "--report", "r"});
}

TEST_F(BadInput, OutputFolderDoesNotExist) {
  for (const char* path : {"none/a.png", "none/a.json"}) {
    expect_refusal(1, "none", {"stripe", kSmallTorus, "--output", path});
  }
  expect_refusal(1, "none", {"stripe", kSmallTorus, "--report", "none/a.json"});
  expect_refusal(1, "none", {"compare", kSmallTorus, "--json", "none/a.json"});
}

TEST_F(BadInput, OutputIsAFolder) {
  fs::create_directory(folder / "a.png");
  expect_refusal(1, "a.png", {"stripe", kSmallTorus, "--output", "a.png"});
}

TEST_F(BadInput, OutputOfUnknownExtension) {
  expect_refusal(1, ".jpeg", {"stripe", kSmallTorus, "--output", "a.jpeg"});
  expect_refusal(1, "a", {"stripe", kSmallTorus, "--output", "a"});
}

TEST_F(BadInput, OutputsAreCheckedBeforeAnythingIsWritten) {
  expect_refusal(1, "none", {"stripe", kSmallTorus, "--output", "a.png", "-o", "none/b.obj"});
}

TEST_F(BadInput, FullDisk) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  for (const char* name : {"full.png", "full.json"}) {
    fs::create_symlink("/dev/full", folder / name);
    expect_refusal(1, name, {"stripe", kSmallTorus, "--output", name, "--size", "64x48"});
  }
  expect_refusal(1, "/dev/full", {"stripe", kSmallTorus, "--report", "/dev/full"});
  expect_refusal(1, "/dev/full", {"compare", kSmallTorus, "--json", "/dev/full"});
}

struct WrongUsage : ToolTest, testing::WithParamInterface<std::vector<std::string>> {};

TEST_P(WrongUsage, EndsWithCodeTwo) {
  std::vector<std::string> arguments = {"stripe", kSmallTorus, "--report", "out.json"};
  arguments.insert(arguments.end(), GetParam().begin(), GetParam().end());
  expect_refusal(2, GetParam().front(), arguments);
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
        std::vector<std::string>{"--phase-shift", "magic"},
        std::vector<std::string>{"--epsilon", "-1"}, std::vector<std::string>{"--epsilon", "nan"},
        std::vector<std::string>{"--momentum", "1"}, std::vector<std::string>{"--threads", "-1"},
        std::vector<std::string>{"--threads", "two"}, std::vector<std::string>{"--subdivide", "-1"},
        std::vector<std::string>{"--subdivide", "99"}, std::vector<std::string>{"--sweeps", "-1"},
        std::vector<std::string>{"--global-iterations", "0"},
        std::vector<std::string>{"--seed", "-1"}, std::vector<std::string>{"--rotate", "inf"},
        std::vector<std::string>{"--curvature-anchor", "-1"},
        std::vector<std::string>{"--curvature-direction", "x"},
        std::vector<std::string>{"--nonsense"}));

#ifdef BRINDLE_HAS_GL
INSTANTIATE_TEST_SUITE_P(Picture, WrongUsage,
                         testing::Values(std::vector<std::string>{"--view", "sideways"},
                                         std::vector<std::string>{"--camera", "30"},
                                         std::vector<std::string>{"--camera", "30,100"},
                                         std::vector<std::string>{"--size", "0x100"},
                                         std::vector<std::string>{"--size", "100"},
                                         std::vector<std::string>{"--size", "999999x999999"},
                                         std::vector<std::string>{"--colors", "red"},
                                         std::vector<std::string>{"--colors", "#ffffff"},
                                         std::vector<std::string>{"--stripe-width", "2"},
                                         std::vector<std::string>{"--up", "x"}));
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
}

}  // namespace
}  // namespace brindle::test
