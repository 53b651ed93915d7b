#include "cli/described_options.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/render/parsed_words.h"
#include "brindle/renderer.h"
#include "cli/commands.h"

namespace brindle::tool {
namespace {

/// The commands that do jobs, with the job of each.
struct Commands {
  CLI::App app;
  std::vector<std::pair<Command, PatternJob>> jobs = {
      {add_stripe_command(app), PatternJob::stripe},
      {add_curves_command(app), PatternJob::curves},
      {add_sample_command(app), PatternJob::sample},
      {add_animate_command(app), PatternJob::animate},
      {add_compare_command(app), PatternJob::compare},
      {add_relief_command(app), PatternJob::relief}};
};

TEST(DescribedOptions, CommandsHaveTheOptionsOfTheTableAndNoOthers) {
  const Commands commands;
  const std::set<std::string> others = {"help", "json"};  // `compare` writes several reports
  for (const auto& [command, job] : commands.jobs) {
    const CLI::App* app = command.app;
    SCOPED_TRACE(app->get_name());
    for (const CLI::Option* option : app->get_options()) {
      if (option->get_positional() || others.contains(option->get_lnames().front())) continue;
      EXPECT_NE(find_option(option->get_lnames().front(), job), nullptr) << option->get_name();
      EXPECT_FALSE(option->get_description().empty()) << option->get_name();
    }
    for (const OptionInfo& info : option_table()) {
      if (info.is_for(job)) {
        EXPECT_NE(app->get_option_no_throw("--" + std::string(info.name)), nullptr) << info.name;
      }
    }
  }
}

/// Whether the command line takes this value; `extra` are options that it needs with it.
bool takes(PatternJob job, const OptionInfo& info, const std::string& value) {
  Commands commands;
  for (const auto& [command, its_job] : commands.jobs) {
    if (its_job != job) continue;
    std::vector<std::string> words = {"--" + std::string(info.name) + "=" + value};
    std::vector<std::string> needed = words_between_spaces(info.needs);
    if (job == PatternJob::relief) needed = {"texture", "height"};
    for (const std::string& name : needed) {
      if (name == info.name) continue;
      words.push_back("--" + name + (name == "height" ? "=1" : "=dots"));
    }
    words.push_back("shape:torus");
    words.push_back(command.app->get_name());
    try {
      commands.app.parse(words);
      return true;
    } catch (const CLI::ParseError&) {
      return false;
    }
  }
  return false;
}

std::string text_of(double value, OptionKind kind) {
  std::ostringstream text;
  text.precision(9);
  if (kind == OptionKind::whole) {
    text << static_cast<long long>(value);
  } else {
    text << value;
  }
  return text.str();
}

TEST(DescribedOptions, CommandsTakeTheNumbersThatTheTableSays) {
  for (const OptionInfo& info : option_table()) {
    const bool numeric = info.kind == OptionKind::whole || info.kind == OptionKind::number ||
                         info.kind == OptionKind::length;
    if (!numeric) continue;
    const auto [least, most, above, below] = info.range;
    const double step = info.kind == OptionKind::whole ? 1 : 1e-3;
    std::vector<double> values = {1};
    if (std::isfinite(least)) values.insert(values.end(), {least - step, least, least + step});
    if (std::isfinite(most)) values.insert(values.end(), {most - step, most, most + step});
    if (!std::isfinite(most)) values.push_back(1e6);
    for (const PatternJob job : {PatternJob::stripe, PatternJob::curves, PatternJob::sample,
                                 PatternJob::animate, PatternJob::compare, PatternJob::relief}) {
      if (!info.is_for(job)) continue;
      for (const double value : values) {
        if (info.kind != OptionKind::whole && std::abs(value) >= 1e6 && value != std::floor(value))
          continue;  // beyond what a float tells from its neighbours
        EXPECT_EQ(takes(job, info, text_of(value, info.kind)), info.range.contains(value))
            << info.name << ' ' << value;
      }
      EXPECT_FALSE(takes(job, info, "many")) << info.name;
    }
  }
}

TEST(DescribedOptions, ChoicesAreAllTaken) {
  for (const OptionInfo& info : option_table()) {
    if (info.kind != OptionKind::choice || !info.is_for(PatternJob::stripe)) continue;
    std::istringstream form{std::string(info.form)};
    for (std::string value; std::getline(form, value, '|');) {
      EXPECT_TRUE(takes(PatternJob::stripe, info, value)) << info.name << ' ' << value;
    }
    EXPECT_FALSE(takes(PatternJob::stripe, info, "other")) << info.name;
  }
}

TEST(DescribedOptions, TilesAreNamedAsTheyAre) {
  const OptionInfo* texture = find_option("texture", PatternJob::stripe);
  ASSERT_NE(texture, nullptr);
  const std::string help(texture->help), from = "such as ", to = ", or ";
  const std::size_t begin = help.find(from) + from.size(), end = help.find(to);
  ASSERT_LT(begin, end);
  std::string names = help.substr(begin, end - begin);
  std::ranges::replace(names, ',', ' ');
  std::istringstream words(names);
  for (std::string name; words >> name;) {
    if (name == "or") continue;
    EXPECT_TRUE(parse_built_in_tile(name)) << name;
  }
}

}  // namespace
}  // namespace brindle::tool
