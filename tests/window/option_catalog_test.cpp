#include "window/panels/option_catalog.h"

#include <charconv>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "session/session_options.h"

namespace brindle::tool {
namespace {

std::map<std::string, CatalogOption> all_entries(Shown shown = Shown::stripes) {
  std::map<std::string, CatalogOption> entries;
  for (const OptionGroup& group : option_catalog(shown)) {
    EXPECT_FALSE(group.options.empty()) << group.title;
    for (const CatalogOption& option : group.options) {
      EXPECT_TRUE(entries.emplace(option.name, option).second) << option.name << " is there twice";
    }
  }
  return entries;
}

TEST(OptionCatalogTest, HasEveryOptionOfSessionsOnce) {
  for (const Shown shown : kAllShown) {
    const auto entries = all_entries(shown);
    EXPECT_EQ(entries.size(), session_options(shown).size());
    for (const OptionInfo* option : session_options(shown)) {
      const std::string name(option->name);
      ASSERT_TRUE(entries.contains(name)) << name;
      EXPECT_EQ(entries.at(name).help, option->help);
    }
  }
}

TEST(OptionCatalogTest, EveryOptionHasWordsOfItsOwn) {
  for (const Shown shown : kAllShown) {
    std::set<std::string> words;
    for (const auto& [name, option] : all_entries(shown)) {
      EXPECT_FALSE(option.words.empty()) << name;
      EXPECT_TRUE(words.insert(option.words).second) << option.words << " is there twice";
      EXPECT_LE(option.words.size(), 19u) << option.words << " leaves no room for its value";
    }
  }
}

TEST(OptionCatalogTest, OptionsAreFoundByWhatTheyAreCalledMeanAndAreFor) {
  const CatalogOption width = all_entries().at("stripe-width");
  for (const char* search :
       {"", "  ", "width", "WIDTH stripes", "stripe-width", "--stripe", "wi of"}) {
    EXPECT_TRUE(is_meant(width, search)) << search;
  }
  EXPECT_TRUE(is_meant(all_entries().at("slack"), "fewer branches")) << "by its help";
  for (const char* search : {"slack", "width slack", "stripes-width"}) {
    EXPECT_FALSE(is_meant(width, search)) << search;
  }
}

TEST(OptionCatalogTest, MessagesCallOptionsAsPanelsDo) {
  EXPECT_EQ(in_panel_words("warning: lower --stripes; or --subdivide 2", Shown::stripes),
            "warning: lower 'number of stripes'; or 'split triangles' 2");
  EXPECT_EQ(in_panel_words("farther than --max-distance", Shown::samples),
            "farther than 'farthest from it'");
  EXPECT_EQ(in_panel_words("give --output", Shown::stripes), "give --output") << "in no panel";
}

TEST(OptionCatalogTest, FilesAreThoseThatAnOptionReads) {
  const auto entries = all_entries();
  EXPECT_EQ(entries.at("texture").files, std::vector<std::string>{".png"});
  EXPECT_EQ(entries.at("strokes").files, std::vector<std::string>{".json"});
  EXPECT_TRUE(entries.at("slack").files.empty());
  for (const Shown shown : kAllShown) {
    for (const auto& [name, option] : all_entries(shown)) {
      const bool names_files =
          option.form.find("FILE") != std::string::npos || option.form == "MESH";
      const bool of_values = option.form.find("array:") != std::string::npos && name != "field";
      if (!of_values) {
        EXPECT_EQ(names_files, !option.files.empty()) << name;
      }
      for (const std::string& extension : option.files) EXPECT_EQ(extension.front(), '.') << name;
    }
  }
}

TEST(OptionCatalogTest, ANumberOfStripesIsDraggedToWholeOnes) {
  for (const char* name : {"stripes", "stripes-v", "subdivide"}) {
    EXPECT_TRUE(all_entries().at(name).whole) << name;
  }
  EXPECT_FALSE(all_entries().at("frequency").whole);
}

TEST(OptionCatalogTest, OwnOptionsOfWhatIsShownComeFirst) {
  for (const Shown shown : {Shown::curves, Shown::samples}) {
    const auto groups = option_catalog(shown);
    std::size_t own = 0;
    for (const OptionInfo* option : session_options(shown)) own += is_own(*option, shown);
    EXPECT_EQ(groups.front().options.size(), own);
    EXPECT_EQ(groups.front().title, shown == Shown::curves ? "Curves" : "Samples");
  }
  EXPECT_EQ(all_entries(Shown::curves).at("path-width").kind, OptionKind::length);
  EXPECT_EQ(all_entries().at("line-width").kind, OptionKind::number) << "of outlines, in pixels";
}

TEST(OptionCatalogTest, OptionsOfOneGroupStandTogether) {
  for (const Shown shown : kAllShown) {
    std::set<std::string> titles;
    for (const OptionGroup& group : option_catalog(shown)) {
      EXPECT_TRUE(titles.insert(group.title).second) << group.title << " is there twice";
    }
  }
  EXPECT_EQ(option_catalog().front().title, "Stripes");
  EXPECT_EQ(option_catalog().front().options.front().name, "stripes");
  EXPECT_EQ(option_catalog(Shown::samples).front().options.front().name, "glyph");
  EXPECT_EQ(option_catalog(Shown::curves).front().options.front().name, "lines");
}

TEST(OptionCatalogTest, WhatExcludesAnotherSaysSo) {
  const auto entries = all_entries();
  EXPECT_EQ(entries.at("stripes").excludes, (std::vector<std::string>{"frequency", "spacing"}));
  EXPECT_EQ(entries.at("direction").excludes, std::vector<std::string>{"field"});
}

TEST(OptionCatalogTest, KnowsTheValuesThatCountWithoutAnOption) {
  const auto entries = all_entries();
  EXPECT_EQ(entries.at("stripes").standard, "40");
  EXPECT_EQ(entries.at("solver").standard, "multilevel");
  EXPECT_EQ(entries.at("curvature-direction").standard, "max");
  EXPECT_EQ(entries.at("lambda").standard, "0.025");
  EXPECT_EQ(entries.at("subdivide").standard, "");
}

TEST(OptionCatalogTest, ChoicesHaveNamesAndStandardsAreAmongThem) {
  for (const auto& [name, option] : all_entries()) {
    if (option.kind != OptionKind::choice) continue;
    EXPECT_GT(option.names.size(), 1) << name;
    if (option.standard.empty()) continue;
    EXPECT_NE(std::ranges::find(option.names, option.standard), option.names.end())
        << name << ": " << option.standard;
  }
}

// Sliders of what is off, or follows from something else, unless it is given.
const std::set<std::string> kWithoutStandard = {"anchor-boundary",
                                                "creases",
                                                "cross-hatch",
                                                "cycles",
                                                "feature-radius",
                                                "field-singularities",
                                                "frequency",
                                                "frequency-v",
                                                "global-iterations",
                                                "line-width",
                                                "cancel-branches",
                                                "min-length",
                                                "path-width",
                                                "normal-radius",
                                                "pixel-width",
                                                "resample",
                                                "simplify",
                                                "spacing",
                                                "stripes-v",
                                                "stroke-spacing",
                                                "subdivide",
                                                "sweeps",
                                                "threshold",
                                                "tube-radius",
                                                "wales"};

TEST(OptionCatalogTest, SlidersReachTheirStandards) {
  std::set<std::string> without;
  for (const Shown shown : kAllShown) {
    for (const auto& [name, option] : all_entries(shown)) {
      const bool share = option.kind == OptionKind::length;
      const bool number = option.kind == OptionKind::whole || option.kind == OptionKind::number;
      if (!number && !share) continue;
      EXPECT_LT(option.range.lowest, option.range.highest) << name;
      if (option.range.logarithmic) {
        EXPECT_GE(option.range.lowest, 0) << name;
      }
      if (option.standard.empty()) {
        without.insert(name);
        continue;
      }
      float value = 0;
      const char* end = option.standard.data() + option.standard.size();
      const auto [rest, error] = std::from_chars(option.standard.data(), end, value);
      ASSERT_EQ(error, std::errc()) << name << ": '" << option.standard << "' is no number";
      EXPECT_EQ(std::string(rest, end), share ? "%" : "") << name;
      EXPECT_GE(value, option.range.lowest) << name;
      EXPECT_LE(value, option.range.highest) << name;
    }
  }
  EXPECT_EQ(without, kWithoutStandard);
}

TEST(OptionCatalogTest, PairsOfNumbersHaveTheirTwoNumbersAtFirst) {
  std::size_t pairs = 0;
  for (const OptionGroup& group : option_catalog()) {
    for (const CatalogOption& option : group.options) {
      if (option.kind != OptionKind::numbers) continue;
      ++pairs;
      // Those without say that all values count.
      if (option.name == "color-range") continue;
      const bool has_two = option.standard.find("..") != std::string::npos ||
                           option.standard.find(',') != std::string::npos;
      EXPECT_TRUE(has_two) << option.name;
    }
  }
  EXPECT_GE(pairs, 5u);
}

}  // namespace
}  // namespace brindle::tool
