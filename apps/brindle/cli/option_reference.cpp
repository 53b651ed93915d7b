#include "cli/option_reference.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/base/text.h"
#include "brindle/option_table.h"
#include "cli/described_options.h"
#include "cli/help.h"
#include "cli/option_parts.h"

namespace brindle::tool {
namespace {

constexpr std::string_view kIntroduction = R"(# Options

This page lists the options of all commands by group, as `brindle help options` prints them. `brindle help` explains
values, arrays, lengths, cameras, solvers and output files. Parts of values are listed below their option:
`--solver relaxation,epsilon=0.01`. `view` takes the options of `stripe`; `info` takes those
of surfaces and fields.
)";

constexpr std::array<std::pair<PatternJob, std::string_view>, 7> kCommandOfJob = {
    {{PatternJob::stripe, "stripe"},
     {PatternJob::curves, "curves"},
     {PatternJob::sample, "sample"},
     {PatternJob::animate, "animate"},
     {PatternJob::compare, "compare"},
     {PatternJob::paths, "paths"},
     {PatternJob::relief, "relief"}}};

std::string commands_of(unsigned jobs) {
  std::string commands;
  for (const auto& [job, command] : kCommandOfJob) {
    if ((jobs & static_cast<unsigned>(job)) == 0) continue;
    commands += (commands.empty() ? "`" : ", `") + std::string(command) + '`';
  }
  return commands;
}

std::string code_span(std::string_view text) { return '`' + std::string(text) + '`'; }

std::string options_in(std::string_view names, std::string_view before) {
  std::string text;
  for (const std::string& name : words_between_spaces(names)) {
    text += (text.empty() ? std::string(before) : ", ") + code_span("--" + name);
  }
  return text;
}

std::string range_of(const OptionInfo& row) {
  const NumberRange& range = row.range;
  if (!range.contains((range.least + range.most) / 2)) return "";  // not bounded on both sides
  return formatted("; from %.9g to %.9g", range.least, range.most);
}

std::string entry(std::string_view option, std::string_view form, const std::string& meaning) {
  return "- " + code_span(std::string(option) + (form.empty() ? "" : " ") + std::string(form)) +
         ": " + meaning + '\n';
}

/// The jobs in which the row is a part of this option's value.
unsigned jobs_of_part(const OptionInfo& part, const OptionInfo& whole) {
  const std::vector<std::string> wholes = words_between_spaces(part.part_of);
  const bool is_part = std::ranges::find(wholes, whole.name) != wholes.end();
  return is_part ? part.jobs & whole.jobs : 0;
}

/// The jobs in which the row is an option of its own.
unsigned jobs_alone(const OptionInfo& row) {
  unsigned jobs = row.jobs;
  for (const OptionInfo& whole : option_table()) jobs &= ~jobs_of_part(row, whole);
  return jobs;
}

std::string meaning_of(const OptionInfo& row) {
  std::string meaning(row.help);
  if (!row.standard.empty() && row.help.find("default") == row.help.npos) {
    meaning += " (default " + std::string(row.standard) + ')';
  }
  return meaning + range_of(row) + options_in(row.excludes, "; excludes ");
}

/// `usual`: the jobs of the group.
std::string entry(const OptionInfo& row, unsigned usual) {
  const unsigned alone = jobs_alone(row);
  std::string text;
  if (alone != 0) {
    const std::string meaning =
        alone == row.jobs ? meaning_of(row) : "as `" + form_of_part(row) + '`';
    text = entry("--" + std::string(row.name), row.form,
                 (alone == usual ? "" : commands_of(alone) + ": ") + meaning +
                     options_in(row.needs, "; needs "));
  }
  for (const OptionInfo& part : option_table()) {
    if (jobs_of_part(part, row) == 0) continue;
    text += "  - " + code_span(form_of_part(part)) + ": " + meaning_of(part) + '\n';
  }
  return text;
}

/// The jobs of most rows.
unsigned usual_jobs(std::string_view group) {
  std::map<unsigned, int> counts;
  for (const OptionInfo& row : option_table()) counts[row.jobs] += row.group == group;
  return std::ranges::max_element(counts, {}, [](const auto& count) { return count.second; })
      ->first;
}

std::string group_text(std::string_view group) {
  const unsigned usual = usual_jobs(group);
  std::string text = "\n## " + std::string(group) + "\n\nFor " + commands_of(usual) + ".\n\n";
  for (const OptionInfo& row : option_table()) {
    if (row.group == group) text += entry(row, usual);
  }
  return text;
}

std::vector<std::string_view> groups_in_order() {
  std::vector<std::string_view> groups;
  for (const OptionInfo& row : option_table()) {
    if (std::ranges::find(groups, row.group) == groups.end()) groups.push_back(row.group);
  }
  std::ranges::stable_sort(groups, {}, rank_of_group);
  return groups;
}

bool is_in_table(const CLI::Option& option) {
  return std::ranges::any_of(option_table(), [&](const OptionInfo& row) {
    return option.check_lname(std::string(row.name));
  });
}

/// The options of a command that the table does not have.
std::string own_options(const CLI::App& command) {
  std::string lines;
  for (const CLI::Option* option : command.get_options()) {
    const bool help = option == command.get_help_ptr() || option == command.get_help_all_ptr();
    if (option->get_positional() || help || is_in_table(*option)) continue;
    const std::string form = option->get_expected_max() == 0 ? "" : option->get_type_name();
    lines += entry("--" + option->get_lnames().front(), form.substr(0, form.find(':')),
                   option->get_description());
  }
  return lines;
}

}  // namespace

std::string option_reference(const CLI::App& tool) {
  std::string text(kIntroduction);
  for (const std::string_view group : groups_in_order()) text += group_text(group);
  for (const CLI::App* command : tool.get_subcommands({})) {
    const std::string lines = own_options(*command);
    if (lines.empty()) continue;
    text += "\n## brindle " + command->get_name() + "\n\n" + lines;
  }
  return text;
}

}  // namespace brindle::tool
