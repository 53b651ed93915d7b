/// Parsers of option values. They throw CLI::ValidationError with the option and the expected
/// syntax, so that a mistyped value ends as wrong usage.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/recipe/refusals.h"
#include "brindle/types.h"

namespace brindle::tool {

/// Throws for a wrong value of an option.
[[noreturn]] void wrong_usage(const std::string& option, const std::string& expected,
                              const std::string& value);

/// The whole text as a finite int, float or double; empty for other text.
template <class Number>
std::optional<Number> number_in(std::string_view text);

/// A finite number.
float parse_number(const std::string& option, const std::string& text);

/// A finite number, zero or more.
float parse_not_negative_number(const std::string& option, const std::string& text);

/// A finite number above zero.
float parse_positive_number(const std::string& option, const std::string& text);

/// "x,y,z", finite; in doubles, because coordinates of files may exceed float precision.
Eigen::Vector3d parse_place(const std::string& option, const std::string& text);

/// "x,y,z", finite and not all zero; or an axis such as "x" or "-z".
Vec3 parse_direction(const std::string& option, const std::string& text);

/// A length in the mesh's units, or relative to the bounding box's diagonal.
struct Length {
  float value = 0;
  bool of_diagonal = false;

  float on(float diagonal) const { return of_diagonal ? value * diagonal : value; }
};

/// Both ends of "A..B". Throws for other text, of which `expected` is the syntax.
std::pair<std::string, std::string> parse_ends(const std::string& option,
                                               const std::string& expected,
                                               const std::string& text);

struct ValueRange {
  float lowest = 0;
  float highest = 1;

  bool operator==(const ValueRange&) const = default;
};

/// "A..B", two finite numbers; then in rising order.
ValueRange parse_range(const std::string& option, const std::string& text);
ValueRange parse_rising_range(const std::string& option, const std::string& text);

/// The parts of "a,b,c".
std::vector<std::string> split(const std::string& text, char separator);

/// Adds an option with `target = parse(option, text)`. Description and syntax come from the option
/// table (described_options.h) or from here.
template <class Target, class Parse>
CLI::Option* add_parsed_option(CLI::App& app, const std::string& name, Target& target, Parse parse,
                               const std::string& description = "") {
  return app.add_option_function<std::string>(
      name, [name, &target, parse](const std::string& text) { target = parse(name, text); },
      description);
}

/// A number in the row's range.
float parse_number_of(const OptionInfo& row, const std::string& option, const std::string& text);

/// "0.02" or "1.5%", in the row's range.
Length parse_length_of(const OptionInfo& row, const std::string& option, const std::string& text);

/// The index of the choice in the row.
std::size_t parse_choice_of(const OptionInfo& row, const std::string& option,
                            const std::string& text);

/// Adds an option for a number in the range of its row.
template <class Target>
CLI::Option* add_number_option(CLI::App& app, const std::string& name, Target& target,
                               const std::string& description = "") {
  const auto parse = [&row = row_of(name, OptionKind::number)](const std::string& option,
                                                               const std::string& text) {
    return parse_number_of(row, option, text);
  };
  return add_parsed_option(app, name, target, parse, description);
}

/// The same for a length.
template <class Target>
CLI::Option* add_length_option(CLI::App& app, const std::string& name, Target& target) {
  const auto parse = [&row = row_of(name, OptionKind::length)](const std::string& option,
                                                               const std::string& text) {
    return parse_length_of(row, option, text);
  };
  return add_parsed_option(app, name, target, parse);
}

/// Adds an option with a few named values; `value_of(name)` returns an optional value.
template <class Target, class ValueOf>
CLI::Option* add_named_option(CLI::App& app, const std::string& name, Target& target,
                              ValueOf value_of, const std::string& description = "") {
  const std::string last_name = name.substr(name.rfind("--"));
  const auto parse = [value_of, last_name, &app](const std::string& option,
                                                 const std::string& text) {
    const auto value = value_of(text);
    if (!value) wrong_usage(option, "one of " + app.get_option(last_name)->get_type_name(), text);
    return *value;
  };
  return add_parsed_option(app, name, target, parse, description);
}

}  // namespace brindle::tool
