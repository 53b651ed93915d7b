#include "cli/help.h"

#include <algorithm>
#include <functional>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/option_table.h"
#include "cli/described_options.h"
#include "cli/option_parts.h"

namespace brindle::tool {
namespace {

constexpr std::size_t kColumn = 32;
constexpr int kFewExamples = 6;

/// The options of a group in the table's order, without parts of others.
std::vector<const CLI::Option*> options_of(const CLI::App& app, const std::string& group) {
  std::vector<const CLI::Option*> options = app.get_options([&](const CLI::Option* option) {
    return option->get_group() == group && !group.empty() && option->nonpositional() &&
           !is_part(*option, app);
  });
  const PatternJob job = job_of(app.get_name());
  std::ranges::stable_sort(options, std::less<>(),
                           [job](const CLI::Option* option) { return row_of(*option, job); });
  return options;
}

std::string with_few_examples(const std::string& footer) {
  std::istringstream lines(footer);
  std::string result;
  int examples = 0;
  for (std::string line; examples < kFewExamples && std::getline(lines, line);) {
    examples += line.starts_with("  brindle ");
    result += line + '\n';
  }
  return result;
}

}  // namespace

int rank_of_group(std::string_view group) {
  if (group == "Output") return -2;
  if (group == "Options") return -1;
  if (group == "Solver") return static_cast<int>(option_table().size());
  const auto rows = option_table();
  return static_cast<int>(std::ranges::find(rows, group, &OptionInfo::group) - rows.begin());
}

std::string form_of_parts(const CLI::Option& option, const CLI::App& command) {
  const OptionInfo* row = row_of(option, job_of(command.get_name()));
  if (row == nullptr) return "";
  std::string range, unit, parts;
  for (const OptionInfo* part : parts_of(*row, command)) {
    if (part->written == "@") {
      range = '[' + form_of_part(*part) + ']';
    } else if (part->written.starts_with(',')) {
      parts = "[,...]";
    } else {
      unit = '|' + form_of_part(*part);
    }
  }
  return unit + range + parts;
}

HelpFormatter::HelpFormatter() { column_width(kColumn); }

std::string HelpFormatter::make_help(const CLI::App* app, std::string name,
                                     CLI::AppFormatMode mode) const {
  command_ = app;
  // The program lists its commands, not their options.
  if (!app->get_subcommands({}).empty()) {
    return CLI::Formatter::make_help(app, std::move(name), CLI::AppFormatMode::Normal);
  }
  all_ = mode == CLI::AppFormatMode::All;
  const std::string footer = make_footer(app);
  return make_description(app) + make_usage(app, std::move(name)) + make_positionals(app) +
         groups_of(*app) + '\n' + (all_ ? footer : with_few_examples(footer));
}

std::string HelpFormatter::groups_of(const CLI::App& app) const {
  std::vector<std::string> groups = app.get_groups();
  std::ranges::stable_sort(groups, {}, rank_of_group);
  const auto is_rare = [job = job_of(app.get_name())](const CLI::Option* option) {
    const OptionInfo* row = row_of(*option, job);
    return row != nullptr && !row->common;
  };
  std::string text;
  std::size_t left_out = 0;
  for (const std::string& group : groups) {
    std::vector<const CLI::Option*> options = options_of(app, group);
    if (!all_) left_out += std::erase_if(options, is_rare);
    if (!options.empty()) text += make_group(group, false, options);
  }
  if (left_out == 0) return text;
  return text + "\n'brindle " + app.get_name() + " --help-all' lists " + std::to_string(left_out) +
         " more options and all examples;\n'brindle help' explains values, lengths, cameras and "
         "files, 'brindle help OPTION' all parts [,...]\n";
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  const std::string text = CLI::Formatter::make_option_opts(option);
  if (option->get_positional()) return text;
  const std::size_t end = std::min({text.size(), text.find(":INT"), text.find(":{"),
                                    text.find(" Needs:"), text.find(" Excludes:")});
  return text.substr(0, end) + form_of_parts(*option, *command_) + (all_ ? text.substr(end) : "");
}

}  // namespace brindle::tool
