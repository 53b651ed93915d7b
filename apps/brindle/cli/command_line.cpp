#include "cli/command_line.h"

#include "brindle/version.h"

namespace brindle::tool {
namespace {

// A list if the option may be repeated.
nlohmann::ordered_json value_of(const CLI::Option& option) {
  if (option.get_expected_max() == 0) return true;
  if (option.get_expected_max() > 1 ||
      option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll) {
    return option.results();
  }
  return option.results().front();
}

}  // namespace

bool is_given(const CLI::App& command, const std::string& option) {
  const CLI::Option* found = command.get_option_no_throw(option);
  return found != nullptr && found->count() > 0;
}

void refuse_given(const CLI::App& command, const std::vector<std::string>& options,
                  std::string_view why) {
  for (const std::string& option : options) {
    // A misspelt name would never be rejected.
    if (command.get_option_no_throw(option) == nullptr) row_of(option);
  }
  refuse_usage(command, [&](const IsGiven& given) { brindle::refuse_given(given, options, why); });
}

void refuse_usage(const std::function<void()>& check) {
  try {
    check();
  } catch (const RefusedOption& refused) {
    throw CLI::ValidationError(refused.option(), refused.why());
  }
}

void refuse_usage(const CLI::App& command, const std::function<void(const IsGiven& given)>& check) {
  refuse_usage(
      [&] { check([&](const std::string& option) { return is_given(command, option); }); });
}

nlohmann::ordered_json invocation_of(const CLI::App& command) {
  nlohmann::ordered_json json = {{"version", BRINDLE_VERSION}, {"command", command.get_name()}};
  auto options = nlohmann::ordered_json::object();
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0) continue;
    if (option->get_positional()) {
      json["input"] = value_of(*option);
    } else {
      options[option->get_single_name()] = value_of(*option);
    }
  }
  json["options"] = std::move(options);
  return json;
}

}  // namespace brindle::tool
