/// Options for struct fields. A struct's `visit` calls `add("--option", field)` for each, or
/// `add("--option", field, parse)` with a parser of the library; the rest follows from the field's
/// type and the option table.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <type_traits>

#include <CLI/CLI.hpp>

#include "cli/option_values.h"

namespace brindle::tool {

template <class Field>
struct ValueOf {
  using Type = Field;
};
template <class Field>
struct ValueOf<std::optional<Field>> {
  using Type = Field;
};

/// Rejects text that is no integer of this type, with a message about the range.
template <class Number>
CLI::Validator whole_number() {
  return CLI::Validator(
      [](const std::string& text) {
        Number ignored{};
        if (CLI::detail::lexical_cast(text, ignored)) return std::string();
        const std::string range =
            std::is_signed_v<Number>
                ? ""
                : " from 0 to " + std::to_string(std::numeric_limits<Number>::max());
        return "expected a whole number" + range + ", got '" + text + "'";
      },
      "");
}

/// Adds an option for a field. Enumerators are in the order of the row's choices.
class AddField {
 public:
  explicit AddField(CLI::App& app) : app_(&app) {}

  template <class Field>
  void operator()(const std::string& option, Field& field) const {
    using Value = typename ValueOf<Field>::Type;
    if constexpr (std::is_same_v<Field, bool>) {
      app_->add_flag(option, field);
    } else if constexpr (std::is_enum_v<Value>) {
      const auto parse = [&row = row_of(option, OptionKind::choice)](const std::string& name,
                                                                     const std::string& text) {
        return static_cast<Value>(parse_choice_of(row, name, text));
      };
      add_parsed_option(*app_, option, field, parse);
    } else if constexpr (std::is_floating_point_v<Value>) {
      add_number_option(*app_, option, field);
    } else if constexpr (std::is_same_v<Value, Length>) {
      add_length_option(*app_, option, field);
    } else if constexpr (std::is_integral_v<Value>) {
      app_->add_option(option, field)->check(whole_number<Value>());
    } else {
      app_->add_option(option, field);  // text
    }
  }

  template <class Field, class Parse>
  void operator()(const std::string& option, Field& field, Parse parse) const {
    add_named_option(*app_, option, field, parse);
  }

 private:
  CLI::App* app_;
};

template <class Field>
void add_field(CLI::App& app, const std::string& option, Field& field) {
  const AddField add(app);
  add(option, field);
}

/// Adds the options of a struct's member `visit`.
template <class Options>
void add_fields(CLI::App& app, Options& options) {
  options.visit(AddField(app));
}

}  // namespace brindle::tool
