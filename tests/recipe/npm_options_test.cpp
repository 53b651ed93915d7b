// Options in the npm package's types and programs, compared with the table.
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/option_table.h"

namespace brindle {
namespace {

std::string npm_source(const std::string& name) {
  std::ifstream file(BRINDLE_SOURCE "/web/package/" + name);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A property of an interface that stands for an option, and has its default.
struct NpmOption {
  std::string interface;
  std::string property;
  std::string option;
  PatternJob job = PatternJob::stripe;
};

const std::vector<NpmOption> kNpmOptions = {
    {"CreaseOption", "creaseAngle", "crease-angle"},
    {"RotateOption", "rotate", "rotate"},
    {"SmoothFieldOptions", "curvature", "curvature-anchor"},
    {"SmoothFieldOptions", "curvatureDirection", "curvature-direction"},
    {"SmoothFieldOptions", "features", "feature-anchor"},
    {"SmoothFieldOptions", "featureAngle", "feature-angle"},
    {"FrequencyOptions", "stripes", "stripes"},
    {"MeasuredFieldOptions", "fill", "fill"},
    {"StripeOptions", "slack", "slack"},
    {"StripeOptions", "cycles", "cycles"},
    {"CurveOptions", "join", "join", PatternJob::curves},
    {"CurveOptions", "trim", "trim", PatternJob::curves},
    {"CurveOptions", "fair", "fair", PatternJob::curves},
    {"AnimatorOptions", "lambda", "lambda", PatternJob::animate},
};

/// A property as an interface declares it.
struct NpmProperty {
  std::string comment;
  std::string type;
};

std::optional<NpmProperty> npm_property(const std::string& types, const NpmOption& option) {
  const std::size_t begin = types.find("export interface " + option.interface + ' ');
  if (begin == std::string::npos) return std::nullopt;
  const std::string body = types.substr(begin, types.find("\n}", begin) - begin);
  const std::size_t at = body.find("\n  " + option.property + "?: ");
  if (at == std::string::npos) return std::nullopt;
  const std::string above = body.substr(0, at + 1);
  const std::size_t comment = above.rfind("/**"), last = above.rfind(";\n");
  const std::size_t type = at + option.property.size() + 6;
  const bool has_comment =
      comment != std::string::npos && (last == std::string::npos || comment > last);
  return NpmProperty{has_comment ? above.substr(comment) : "",
                     body.substr(type, body.find(';', type) - type)};
}

/// The number that a comment calls the default.
std::optional<double> said_default_of(const std::string& comment) {
  static const std::regex said(R"([Dd]efault:? (-?[0-9.]*[0-9])|([0-9]+) if nothing is said)");
  std::smatch found;
  if (!std::regex_search(comment, found, said)) return std::nullopt;
  return std::stod(found[1].matched ? found[1] : found[2]);
}

/// 0 for options without a default.
double standard_number(std::string_view standard) {
  return standard.empty() ? 0 : std::stod(std::string(standard));
}

std::string npm_type_of(const OptionInfo& row) {
  if (row.kind == OptionKind::flag) return "boolean";
  if (row.kind != OptionKind::choice) return "number";
  std::string type = "'";
  for (const char c : row.form) type += c == '|' ? "' | '" : std::string(1, c);
  return type + "'";
}

TEST(NpmOptions, HaveTheTypesAndDefaultsOfTheTable) {
  const std::string types = npm_source("index.d.ts");
  for (const NpmOption& option : kNpmOptions) {
    SCOPED_TRACE(option.interface + '.' + option.property);
    const OptionInfo* row = find_option(option.option, option.job);
    ASSERT_NE(row, nullptr);
    const std::optional<NpmProperty> property = npm_property(types, option);
    ASSERT_TRUE(property);
    EXPECT_EQ(property->type, npm_type_of(*row));
    if (const std::optional<double> number = said_default_of(property->comment)) {
      EXPECT_EQ(*number, standard_number(row->standard));
      EXPECT_TRUE(row->range.contains(*number));
    }
  }
}

TEST(NpmOptions, AreTakenWithTheDefaultsOfTheTable) {
  const std::string programs = npm_source("realtime.js") + npm_source("brindle.js");
  std::size_t defaults = 0;
  for (const NpmOption& option : kNpmOptions) {
    SCOPED_TRACE(option.property);
    const OptionInfo& row = *find_option(option.option, option.job);
    const std::regex taken("\\b" + option.property + ": ([0-9.]+|'[a-z]+')");
    for (std::sregex_iterator at(programs.begin(), programs.end(), taken), end; at != end; ++at) {
      const std::string value = (*at)[1];
      // Arrays of one's own have no creases unless asked for.
      if (option.property == "creaseAngle" && value == "180") continue;
      ++defaults;
      if (value[0] == '\'') {
        EXPECT_EQ(value, '\'' + std::string(row.standard) + '\'');
      } else {
        EXPECT_EQ(std::stod(value), standard_number(row.standard));
      }
    }
  }
  EXPECT_GE(defaults, 10u);
}

}  // namespace
}  // namespace brindle
