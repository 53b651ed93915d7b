#include "brindle/option_table.h"

#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "brindle/recipe/refusals.h"

namespace brindle {
namespace {

constexpr PatternJob kJobs[] = {PatternJob::stripe,  PatternJob::curves,  PatternJob::sample,
                                PatternJob::animate, PatternJob::compare, PatternJob::paths,
                                PatternJob::relief};

std::set<std::string> words(std::string_view text, char separator = ' ') {
  std::istringstream stream{std::string(text)};
  std::set<std::string> result;
  for (std::string word; std::getline(stream, word, separator);) result.insert(word);
  return result;
}

bool is_numeric(const OptionInfo& info) {
  return info.kind == OptionKind::whole || info.kind == OptionKind::number ||
         info.kind == OptionKind::length;
}

double number_of(std::string_view text) {
  double value = std::nan("");
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Each option alone, as a reason by itself.
TEST(OptionTable, SaysWhatRanksReject) {
  std::size_t rejected = 0;
  for (const PatternJob job : {PatternJob::stripe, PatternJob::curves, PatternJob::sample}) {
    for (const OptionInfo& info : option_table()) {
      if (!info.is_for(job)) continue;
      const std::string option = "--" + std::string(info.name);
      std::string why;
      try {
        check_one_process([&](const std::string& asked) { return asked == option; }, job);
      } catch (const RefusedOption& refused) {
        EXPECT_EQ(refused.option(), option);
        why = refused.why();
        ++rejected;
      }
      EXPECT_EQ(why, info.one_process) << option;
    }
  }
  EXPECT_GT(rejected, 20u);
}

TEST(OptionTable, HasOneRowForANameAndAJob) {
  for (const PatternJob job : kJobs) {
    std::set<std::string_view> names;
    for (const OptionInfo& info : option_table()) {
      if (info.is_for(job)) {
        EXPECT_TRUE(names.insert(info.name).second) << info.name;
      }
    }
    EXPECT_GT(names.size(), 30U);
  }
}

TEST(OptionTable, SaysOfEveryOptionWhatItIs) {
  for (const OptionInfo& info : option_table()) {
    SCOPED_TRACE(info.name);
    EXPECT_NE(info.jobs, 0U);
    EXPECT_FALSE(info.group.empty());
    EXPECT_FALSE(info.help.empty());
    EXPECT_LE(info.help.size(), 70U) << "more than a line of --help";
    EXPECT_FALSE(info.help.ends_with('.'));
    EXPECT_EQ(info.form.empty(), info.kind == OptionKind::flag);
    EXPECT_EQ(info.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), info.name.npos);
  }
}

/// A style changes how a pattern is drawn, not the pattern.
TEST(OptionTable, StylesChangePicturesAlone) {
  std::size_t styles = 0;
  for (const OptionInfo& info : option_table()) {
    if (!info.styles) continue;
    ++styles;
    SCOPED_TRACE(info.name);
    constexpr OptionStage kLater = OptionStage::style | OptionStage::values | OptionStage::margin;
    const auto stages = static_cast<unsigned>(info.stale);
    EXPECT_EQ(stages & ~static_cast<unsigned>(kLater), 0U);
    EXPECT_FALSE(info.is_for(PatternJob::curves));
    EXPECT_FALSE(info.is_for(PatternJob::compare));
  }
  EXPECT_GT(styles, 30U);
}

TEST(OptionTable, FindsRowsByNameAndJob) {
  for (const OptionInfo& info : option_table()) {
    for (const PatternJob job : kJobs) {
      if (info.is_for(job)) {
        EXPECT_EQ(find_option(info.name, job), &info) << info.name;
      }
    }
  }
  EXPECT_EQ(find_option("wales", PatternJob::stripe), nullptr);
  EXPECT_EQ(find_option("", PatternJob::stripe), nullptr);
}

TEST(OptionTable, NamesMeanTheSameInEveryJob) {
  std::map<std::string_view, OptionKind> kinds;
  for (const OptionInfo& info : option_table()) {
    const auto [known, is_new] = kinds.emplace(info.name, info.kind);
    EXPECT_EQ(known->second, info.kind) << info.name;
  }
}

TEST(OptionTable, LinksOptionsThatThereAre) {
  for (const OptionInfo& info : option_table()) {
    for (const PatternJob job : kJobs) {
      if (!info.is_for(job)) continue;
      for (const std::string& name : words(info.needs)) {
        EXPECT_NE(find_option(name, job), nullptr) << info.name << " needs " << name;
      }
      // Who excludes another is excluded by it.
      for (const std::string& name : words(info.excludes)) {
        const OptionInfo* other = find_option(name, job);
        if (other != nullptr) {
          EXPECT_TRUE(words(other->excludes).contains(std::string(info.name)));
        }
      }
    }
  }
}

/// Parts of values are told from each other, and from the value.
TEST(OptionTable, PartsBelongToOptionsThatThereAre) {
  for (const OptionInfo& part : option_table()) {
    SCOPED_TRACE(part.name);
    EXPECT_EQ(part.part_of.empty(), part.written.empty());
    if (part.written.starts_with(',') && part.written != ",") {
      EXPECT_EQ(part.written.ends_with('='), part.kind != OptionKind::flag);
    }
    if (part.written == ",") {
      EXPECT_EQ(part.kind, OptionKind::choice);
    }
    for (const std::string& name : words(part.part_of)) {
      bool is_part = false;
      for (const PatternJob job : kJobs) {
        const OptionInfo* whole = part.is_for(job) ? find_option(name, job) : nullptr;
        if (whole == nullptr) continue;
        is_part = true;
        EXPECT_TRUE(whole->part_of.empty());
        for (const OptionInfo& other : option_table()) {
          const bool is_beside = other.is_for(job) && words(other.part_of).contains(name);
          if (is_beside && &other != &part && part.written != ",") {
            EXPECT_NE(other.written, part.written) << other.name;
          }
        }
      }
      EXPECT_TRUE(is_part) << name;
    }
  }
}

TEST(OptionTable, StandardsAreValuesThatTheOptionTakes) {
  for (const OptionInfo& info : option_table()) {
    if (info.standard.empty()) continue;
    SCOPED_TRACE(info.name);
    if (info.kind == OptionKind::choice) {
      EXPECT_TRUE(words(info.form, '|').contains(std::string(info.standard)));
    }
    if (is_numeric(info)) {
      EXPECT_TRUE(info.range.contains(number_of(info.standard)));
    }
  }
}

TEST(OptionTable, HelpHasTheMetricsOfTheRow) {
  for (const OptionInfo& info : option_table()) {
    SCOPED_TRACE(info.name);
    const std::string_view words = "(default ";
    const std::size_t at = info.help.find(words);
    if (info.standard.empty() || at == info.help.npos) continue;
    const std::string_view told = info.help.substr(at + words.size());
    EXPECT_TRUE(told.starts_with(info.standard));
    EXPECT_NE(std::string_view(":;) ").find(told[info.standard.size()]), words.npos);
  }
}

TEST(OptionTable, SlidersStayInRange) {
  for (const OptionInfo& info : option_table()) {
    if (!is_numeric(info)) continue;
    SCOPED_TRACE(info.name);
    const SliderRange& slider = info.slider;
    EXPECT_LT(slider.lowest, slider.highest);
    if (slider.logarithmic) {
      EXPECT_GE(slider.lowest, 0);
    }
    // The ends of a range that leaves its ends out are only approached.
    const auto within = [&](double value) {
      return info.range.contains(value) || value == info.range.least || value == info.range.most;
    };
    EXPECT_TRUE(within(slider.lowest) && within(slider.highest));
  }
}

TEST(NumberRange, LeavesOutTheEndsThatItSays) {
  const NumberRange open{.least = 0, .most = 1, .above_least = true, .below_most = true};
  const NumberRange closed{.least = 0, .most = 1};
  EXPECT_FALSE(open.contains(0) || open.contains(1));
  EXPECT_TRUE(closed.contains(0) && closed.contains(1));
  EXPECT_TRUE(open.contains(0.5));
  EXPECT_FALSE(closed.contains(-1e-9) || closed.contains(1 + 1e-9));
  EXPECT_FALSE(NumberRange().contains(INFINITY) || NumberRange().contains(NAN));
}

}  // namespace
}  // namespace brindle
