/// Help beyond commands: topics, the reference of options, completion.
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "brindle/renderer.h"
#include "tool.h"

namespace brindle::test {
namespace {

using Words = std::set<std::string>;

const std::vector<std::string> kCommands = {"stripe",  "compare", "curves", "paths",   "sample",
                                            "animate", "info",    "render", "gallery", "help"};

Words all_matches(const std::string& text, const std::regex& pattern) {
  Words matches;
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at) {
    matches.insert((*at)[1]);
  }
  return matches;
}

struct HelpTool : ToolTest {
  /// bash's offers for the last of `words`.
  Words offered(const std::string& words) const {
    write_text(folder / "brindle.bash", run({"completion", "bash"}).out);
    write_text(folder / "try.bash", "set -u\n. ./brindle.bash\nCOMP_WORDS=(" + words +
                                        ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_brindle\n"
                                        "printf '%s\\n' \"${COMPREPLY[@]}\" >offered\n");
    const std::string command = "cd '" + folder.string() + "' && bash try.bash";
    EXPECT_EQ(std::system(command.c_str()), 0) << words;
    std::istringstream lines(content(folder / "offered"));
    Words offers;
    for (std::string line; std::getline(lines, line);) offers.insert(line);
    return offers;
  }
};

TEST_F(HelpTool, TopicsAreListedAndExplained) {
  const std::string list = run({"help"}).out;
  const Words topics = all_matches(list, std::regex("\n  ([a-z]+) "));
  EXPECT_EQ(topics, Words({"inputs", "arrays", "values", "lengths", "cameras", "outputs", "solver",
                           "options"}));
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
  expect_refusal(
      2, "'lenghts' is neither a topic nor a command or an option (did you mean 'lengths'?)",
      {"help", "lenghts"});
  expect_refusal(2, "expected bash or zsh, got 'fish'", {"completion", "fish"});
}

/// Options that topics name exist.
TEST_F(HelpTool, TopicsNameOptionsThatThereAre) {
  const std::regex option("(--[a-z-]+)");
  Words known;
  for (const std::string& command : kCommands) {
    known.merge(all_matches(run({command, "--help-all"}).out, option));
  }
  for (const char* topic :
       {"inputs", "arrays", "values", "lengths", "cameras", "outputs", "solver"}) {
    for (const std::string& name : all_matches(run({"help", topic}).out, option)) {
      EXPECT_TRUE(known.contains(name)) << topic << ' ' << name;
    }
  }
}

/// Options of a text of help, without --help and --help-all, and the lines of each.
std::vector<std::string> listed_options(const std::string& help) {
  std::vector<std::string> options;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    const bool begins = line.starts_with("  -") && !has(line, "--help");
    if (begins) {
      options.push_back(line);
    } else if (!options.empty() && line.starts_with("                    ")) {
      options.back() += '\n' + line;
    }
  }
  return options;
}

TEST_F(HelpTool, IsShort) {
  for (const std::string& command : kCommands) {
    SCOPED_TRACE(command);
    const std::string help = run({command, "--help"}).out;
    const std::vector<std::string> options = listed_options(help);
    EXPECT_LE(options.size(), 30u);
    constexpr std::size_t kColumn = 32;
    for (const std::string& option : options) {
      EXPECT_LE(option.size() - (option.rfind('\n') + 1), kColumn + 70) << option;
    }
    if (has(help, "--output")) {
      EXPECT_TRUE(has(options.front(), "--output")) << options.front();
    }
  }
  EXPECT_LE(listed_options(run({"stripe", "--help-all"}).out).size(), 70u);
}

TEST_F(HelpTool, OptionsAreExplainedWithTheirParts) {
  const std::string solver = run({"help", "solver"}).out;
  for (const char* key : {",epsilon=E ", ",iterations=N ", ",weights=paper|cotangent\n"}) {
    EXPECT_TRUE(has(solver, std::string("\n  ") + key)) << key;
  }
  EXPECT_TRUE(has(run({"help", "color-by"}).out, "\n  @A..B "));
  EXPECT_TRUE(has(run({"help", "texture"}).out, built_in_tile_names()));
  // A part leads to its option.
  const std::string epsilon = run({"help", "epsilon"}).out;
  EXPECT_TRUE(epsilon.starts_with("--solver ...,epsilon=E\n"));
  EXPECT_TRUE(has(epsilon, "\n--solver multilevel|relaxation|averaged|global\n"));
  EXPECT_TRUE(run({"help", "stripes"}).out.starts_with("--stripes N\n"));
  EXPECT_TRUE(has(run({"stripe", "--help-all"}).out, "--color-by VALUE[@A..B]"));
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

TEST_F(HelpTool, CompletionOffersCommandsOptionsAndChoices) {
  EXPECT_EQ(offered("brindle str"), Words{"stripe"});
  EXPECT_EQ(offered("brindle --ver"), Words{"--version"});
  EXPECT_EQ(offered("brindle stripe a.ply --solv"), Words{"--solver"});
  const Words solvers = {"multilevel", "relaxation", "averaged", "global"};
  EXPECT_EQ(offered("brindle stripe a.ply --solver ''"), solvers);
  EXPECT_EQ(offered("brindle stripe --solver ="), solvers);
  EXPECT_EQ(offered("brindle stripe --solver = mu"), Words{"multilevel"});
  EXPECT_EQ(offered("brindle animate --solver m"), Words{"multilevel"});
  EXPECT_EQ(offered("brindle stripe --up -"), Words({"-x", "-y", "-z"}));
  EXPECT_EQ(offered("brindle stripe --field c"), Words{"curvature"});
  EXPECT_EQ(offered("brindle help le"), Words{"lengths"});
  EXPECT_EQ(offered("brindle completion ''").count("zsh"), 1u);
}

TEST_F(HelpTool, CompletionLeavesFilesToTheShell) {
  for (const char* words : {"brindle stripe ''", "brindle stripe a.ply --output ''",
                            "brindle stripe --field wind", "brindle stripe a.ply --stripes 4"}) {
    EXPECT_EQ(offered(words), Words{""}) << words;
  }
}

TEST_F(HelpTool, CompletionHasAllOptions) {
  for (const std::string& command : kCommands) {
    Words options =
        all_matches(run({command, "--help-all"}).out, std::regex("\n  (?:-.,)?(--[a-z-]+)"));
    for (const std::string& offer : offered("brindle " + command + " --")) options.erase(offer);
    EXPECT_EQ(options, Words()) << command;
  }
}

}  // namespace
}  // namespace brindle::test
