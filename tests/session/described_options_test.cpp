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

constexpr PatternJob kJobs[] = {PatternJob::stripe,  PatternJob::curves,  PatternJob::sample,
                                PatternJob::animate, PatternJob::compare, PatternJob::relief};

/// The command that does a job. All of them take long to make, more often than they are parsed.
Command add_command(CLI::App& app, PatternJob job) {
  switch (job) {
    case PatternJob::stripe:
      return add_stripe_command(app);
    case PatternJob::curves:
      return add_curves_command(app);
    case PatternJob::sample:
      return add_sample_command(app);
    case PatternJob::animate:
      return add_animate_command(app);
    case PatternJob::compare:
      return add_compare_command(app);
    default:
      return add_relief_command(app);
  }
}

TEST(DescribedOptions, CommandsHaveTheOptionsOfTheTableAndNoOthers) {
  const std::set<std::string> others = {"help", "json"};  // `compare` writes several reports
  for (const PatternJob job : kJobs) {
    CLI::App all;
    const Command command = add_command(all, job);
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

/// Whether the command line takes this value, with the options that it needs.
bool takes(PatternJob job, const OptionInfo& info, const std::string& value) {
  CLI::App app;
  const Command command = add_command(app, job);
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
    app.parse(words);
    return true;
  } catch (const CLI::ParseError&) {
    return false;
  }
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
    for (const PatternJob job : kJobs) {
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
