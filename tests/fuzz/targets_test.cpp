#include "targets.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "promises.h"

namespace brindle::fuzz {
namespace {

namespace fs = std::filesystem;

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Whether the target takes them. A broken promise fails the test.
bool takes(const Target& target, const std::string& input) {
  try {
    return run(target, bytes_of(input));
  } catch (const BrokenPromise& broken) {
    ADD_FAILURE() << target.name << ": " << broken.what;
    return false;
  }
}

/// What fuzzers do to an input, at random.
std::string mutated(std::string input, std::mt19937& random) {
  const auto below = [&](std::size_t count) { return random() % std::max<std::size_t>(count, 1); };
  for (std::size_t changes = 1 + below(4); changes > 0 && !input.empty(); --changes) {
    const std::size_t at = below(input.size());
    switch (below(5)) {
      case 0:
        input[at] = static_cast<char>(below(256));
        break;
      case 1:
        input[at] = "0123456789-.e \n<>{}[],\"/"[below(24)];
        break;
      case 2:
        input.erase(at, 1 + below(12));
        break;
      case 3:
        input.insert(at, input.substr(below(input.size()), 1 + below(12)));
        break;
      case 4:
        if (below(4) == 0) input.resize(at);
        break;
    }
  }
  return input;
}

struct EveryTarget : testing::TestWithParam<const Target*> {};

TEST_P(EveryTarget, TakesItsFirstSeed) {
  const auto all = seeds(*GetParam());
  ASSERT_FALSE(all.empty());
  EXPECT_TRUE(takes(*GetParam(), all.front())) << all.front();
}

TEST_P(EveryTarget, KeepsItsPromisesForSeedsThatAreChanged) {
  std::mt19937 random(1);
  int taken = 0;
  for (const std::string& seed : seeds(*GetParam())) {
    for (int i = 0; i < 60; ++i) taken += takes(*GetParam(), mutated(seed, random)) ? 1 : 0;
  }
  EXPECT_GT(taken, 0) << "some are still good";
}

std::vector<const Target*> all_targets() {
  std::vector<const Target*> all;
  for (const Target& target : targets()) all.push_back(&target);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Fuzz, EveryTarget, testing::ValuesIn(all_targets()),
                         [](const auto& of) { return std::string(of.param->name); });

TEST(FuzzTargets, KeepTheirPromisesForWhatWasFound) {
  int finds = 0;
  for (const auto& entry : fs::recursive_directory_iterator(BRINDLE_FINDS)) {
    if (!entry.is_regular_file()) continue;
    const std::string name = entry.path().parent_path().filename().string();
    const Target* target = find_target(name);
    if (target == nullptr && name == "operations") continue;  // a build without the tool
    ASSERT_NE(target, nullptr) << entry.path();
    std::ifstream in(entry.path(), std::ios::binary);
    SCOPED_TRACE(entry.path());
    takes(*target, {std::istreambuf_iterator<char>(in), {}});
    ++finds;
  }
  EXPECT_GT(finds, 0);
}

TEST(FuzzTargets, RefusingIsFineBreakingAPromiseIsNot) {
  const Target refuses{"a", [](auto&, auto) { throw Error("this is refused"); }};
  EXPECT_FALSE(run(refuses, {}));
  const Target says_nothing{"b", [](auto&, auto) { throw Error(""); }};
  EXPECT_THROW(run(says_nothing, {}), BrokenPromise);
  const Target breaks{"c", [](auto&, auto) { promise(false, "what must hold"); }};
  EXPECT_THROW(run(breaks, {}), BrokenPromise);
}

}  // namespace
}  // namespace brindle::fuzz
