#include "cli/described_options.h"

#include <sstream>
#include <string_view>

#include "brindle/recipe/refusals.h"

namespace brindle::tool {
namespace {

// By any of its names.
void describe_option(CLI::Option& option, const OptionInfo& info) {
  option.description(std::string(info.help));
  const bool hidden = option.get_group().empty();
  if (!hidden) option.group(std::string(info.group));
  if (info.kind == OptionKind::flag) return;
  option.type_name(std::string(info.form));
  const NumberRange& range = info.range;
  if (info.kind == OptionKind::whole && range.contains(range.most)) {
    CLI::Range in_range(static_cast<std::int64_t>(range.least),
                        static_cast<std::int64_t>(range.most));
    // The same message as for other numbers out of range.
    const auto refuse = [in_range, &info](std::string& text) {
      return in_range(text).empty() ? "" : unlike(info, text);
    };
    option.check(CLI::Validator(refuse, in_range.get_description()));
  }
}

// The command may lack some of these options.
void link(CLI::App& app, CLI::Option& option, const OptionInfo& info) {
  for (const std::string& name : words_between_spaces(info.needs)) {
    if (CLI::Option* needed = app.get_option_no_throw("--" + name)) option.needs(needed);
  }
  for (const std::string& name : words_between_spaces(info.excludes)) {
    if (CLI::Option* other = app.get_option_no_throw("--" + name)) option.excludes(other);
  }
}

}  // namespace

const OptionInfo* row_of(const CLI::Option& option, PatternJob job) {
  for (const std::string& name : option.get_lnames()) {
    if (const OptionInfo* info = find_option(name, job)) return info;
  }
  return nullptr;
}

PatternJob job_of(const std::string& command) {
  if (command == "curves") return PatternJob::curves;
  if (command == "sample") return PatternJob::sample;
  if (command == "animate") return PatternJob::animate;
  if (command == "compare") return PatternJob::compare;
  if (command == "paths") return PatternJob::paths;
  if (command == "relief") return PatternJob::relief;
  return PatternJob::stripe;
}

void describe_options(CLI::App& app, PatternJob job) {
  for (CLI::Option* option : app.get_options([](const CLI::Option*) { return true; })) {
    const OptionInfo* info = row_of(*option, job);
    if (info == nullptr || !option->get_description().empty()) continue;
    describe_option(*option, *info);
    link(app, *option, *info);
  }
}

std::vector<std::string> words_between_spaces(std::string_view words) {
  std::istringstream stream{std::string(words)};
  std::vector<std::string> names;
  for (std::string name; stream >> name;) names.push_back(std::move(name));
  return names;
}

}  // namespace brindle::tool
