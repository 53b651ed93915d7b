/// Help beyond commands: topics and the reference of options.
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tool.h"

namespace brindle::test {
namespace {

using Words = std::set<std::string>;

const std::vector<std::string> kCommands = {"stripe", "compare", "curves",  "sample", "animate",
                                            "info",   "render",  "gallery", "bench",  "help"};

Words all_matches(const std::string& text, const std::regex& pattern) {
  Words matches;
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at) {
    matches.insert((*at)[1]);
  }
  return matches;
}

struct HelpTool : ToolTest {};

TEST_F(HelpTool, TopicsAreListedAndExplained) {
  const std::string list = run({"help"}).out;
  const Words topics = all_matches(list, std::regex("\n  ([a-z]+) "));
  EXPECT_EQ(topics, Words({"arrays", "values", "lengths", "cameras", "outputs", "options"}));
  for (const std::string& topic : topics) {
    const ToolResult result = run({"help", topic});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_GT(result.out.size(), 500u) << topic;
    if (topic == "options") continue;
    std::istringstream lines(result.out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 98u) << line;
  }
  EXPECT_EQ(run({"help", "curves"}).out, run({"curves", "--help"}).out);
}

TEST_F(HelpTool, UnknownTopicsAreWrongUsage) {
  expect_refusal(2, "'lenghts' is neither a topic nor a command (did you mean 'lengths'?)",
                 {"help", "lenghts"});
}

/// Options that topics name exist.
TEST_F(HelpTool, TopicsNameOptionsThatThereAre) {
  const std::regex option("(--[a-z-]+)");
  Words known;
  for (const std::string& command : kCommands) {
    known.merge(all_matches(run({command, "--help-all"}).out, option));
  }
  for (const char* topic : {"arrays", "values", "lengths", "cameras", "outputs"}) {
    for (const std::string& name : all_matches(run({"help", topic}).out, option)) {
      EXPECT_TRUE(known.contains(name)) << topic << ' ' << name;
    }
  }
}

TEST_F(HelpTool, TheReferenceIsThePageOfTheDocumentation) {
  if (!has(run({"--version"}).out, "window")) GTEST_SKIP() << "'brindle view' has no options";
  const std::filesystem::path page = std::filesystem::path(BRINDLE_SOURCE) / "docs/options.md";
  EXPECT_EQ(run({"help", "options"}).out, content(page))
      << "brindle help options > docs/options.md";
}

TEST_F(HelpTool, TheReferenceHasAllOptions) {
  const std::string page = run({"help", "options"}).out;
  for (const std::string& command : kCommands) {
    for (const std::string& name :
         all_matches(run({command, "--help-all"}).out, std::regex("\n  (?:-.,)?(--[a-z-]+)"))) {
      if (name == "--help-all" || name == "--help") continue;
      EXPECT_TRUE(has(page, "- `" + name + ' ') || has(page, "- `" + name + '`')) << name;
    }
  }
}

}  // namespace
}  // namespace brindle::test
