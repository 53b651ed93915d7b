/// How the values of options are written. Each function throws CLI::ValidationError, naming the
/// option and what it expects, so that a mistyped value ends as wrong usage.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/recipe/refusals.h"
#include "brindle/types.h"

namespace brindle::tool {

/// The wrong use of an option.
[[noreturn]] void wrong_usage(const std::string& option, const std::string& expected,
                              const std::string& value);

/// A finite number and nothing else.
float parse_number(const std::string& option, const std::string& text);

/// A finite number, zero or more.
float parse_not_negative_number(const std::string& option, const std::string& text);

/// A finite number above zero.
float parse_positive_number(const std::string& option, const std::string& text);

/// "x,y,z", finite; a file's coordinates may have more digits than a float.
Eigen::Vector3d parse_place(const std::string& option, const std::string& text);

/// "x,y,z", finite and not all zero; or an axis such as "x" or "-z".
Vec3 parse_direction(const std::string& option, const std::string& text);

/// A length in the mesh's units, or as a share of the bounding box's diagonal.
struct Length {
  float value = 0;
  bool of_diagonal = false;

  float on(float diagonal) const { return of_diagonal ? value * diagonal : value; }
};

/// The parts of "a,b,c".
std::vector<std::string> split(const std::string& text, char separator);

/// Adds an option whose text `parse(option, text)` turns into the value of `target`. What it is and
/// how its value is written is said by the table of options (described_options.h), or here.
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

/// Which of the row's words it is, from 0 on.
std::size_t parse_choice_of(const OptionInfo& row, const std::string& option,
                            const std::string& text);

/// Adds an option for a number in the range that the table of options has.
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

/// Adds an option that takes one of the few names that its form has; `value_of(name)` gives an
/// optional value.
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
