#include <algorithm>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/base/text.h"
#include "brindle/option_table.h"
#include "brindle/renderer.h"
#include "cli/commands.h"
#include "cli/described_options.h"
#include "cli/option_parts.h"
#include "cli/option_reference.h"
#include "commands/help_topics.h"

namespace brindle::tool {
namespace {

constexpr const char* kReference = "options";

struct HelpArguments {
  std::string topic;
};

std::string list_of_topics() {
  std::string text = "Topics:\n";
  const auto add = [&](std::string_view name, std::string_view summary) {
    text += "  " + std::string(name) + std::string(12 - name.size(), ' ');
    text += std::string(summary) + '\n';
  };
  for (const HelpTopic& topic : kHelpTopics) add(topic.name, topic.summary);
  add(kReference, "all options, as Markdown");
  return text +
         "\n'brindle help TOPIC' explains one, 'brindle help COMMAND' lists a command's options,\n"
         "'brindle help OPTION', without dashes, the parts of an option's value.\n";
}

std::string form_of_topics() {
  std::string form;
  for (const HelpTopic& topic : kHelpTopics) form += std::string(topic.name) + '|';
  return form + kReference;
}

std::string line_of(const std::string& form, std::string_view help) {
  constexpr std::size_t kColumn = 24;
  const std::string line = "  " + form;
  const bool fits = line.size() < kColumn;
  return line +
         (fits ? std::string(kColumn - line.size(), ' ') : '\n' + std::string(kColumn, ' ')) +
         std::string(help) + '\n';
}

/// The names that a value may have, where its form and help do not list them.
std::string list_of_names(const OptionInfo& option) {
  if (option.name != "texture") return "";
  return "  TILE: " + std::string(built_in_tile_names()) + '\n';
}

/// The parts of an option's value; empty if it has none.
std::string list_of_parts(const OptionInfo& option, const CLI::App& command) {
  std::string text;
  for (const OptionInfo* part : parts_of(option, command)) {
    text += line_of(form_of_part(*part), part->help);
  }
  const std::string name = "--" + std::string(option.name);
  return text.empty() ? "" : "\nA value of " + name + " may also have these parts:\n\n" + text;
}

/// An option, by its name without dashes, and the parts of its value; empty if there is none.
std::string text_of_option(const std::string& name, const CLI::App& tool) {
  for (const CLI::App* command : tool.get_subcommands({})) {
    const OptionInfo* option = find_option(name, tool::job_of(command->get_name()));
    if (option == nullptr || command->get_option_no_throw("--" + name) == nullptr) continue;
    const OptionInfo* whole = whole_of(*option, *command);
    if (whole != nullptr) {
      return spelling_of(*option, *whole) + "\n  " + std::string(option->help) + "\n\n" +
             text_of_option(std::string(whole->name), tool);
    }
    return "--" + name + (option->form.empty() ? "" : ' ' + std::string(option->form)) + "\n  " +
           std::string(option->help) + '\n' + list_of_names(*option) +
           list_of_parts(*option, *command);
  }
  return "";
}

std::string text_of(const std::string& name, const CLI::App& tool) {
  const std::string option = text_of_option(name, tool);
  const auto topic = std::ranges::find(kHelpTopics, std::string_view(name), &HelpTopic::name);
  if (topic != kHelpTopics.end()) {
    return std::string(topic->text) + (option.empty() ? "" : '\n' + option);
  }
  if (name == kReference) return option_reference(tool);
  std::vector<std::string> known = {kReference};
  for (const OptionInfo& row : option_table()) known.emplace_back(row.name);
  for (const HelpTopic& other : kHelpTopics) known.emplace_back(other.name);
  for (const CLI::App* command : tool.get_subcommands({})) {
    if (command->get_name() == name) return command->help(tool.get_name());
    known.push_back(command->get_name());
  }
  if (!option.empty()) return option;
  const std::string meant = nearest(name, known);
  throw CLI::ValidationError("TOPIC",
                             "'" + shown(name) + "' is neither a topic nor a command or an option" +
                                 (meant.empty() ? "" : " (did you mean '" + meant + "'?)") +
                                 "; 'brindle help' lists the topics");
}

}  // namespace

Command add_help_command(CLI::App& app) {
  return add_command<HelpArguments>(
      app, "help", "Explain values, lengths, cameras and solvers", "",
      [](CLI::App& command, HelpArguments& arguments) {
        command
            .add_option("TOPIC", arguments.topic, "topic, command or option; default: list topics")
            ->type_name(form_of_topics());
      },
      [](const CLI::App& command, const HelpArguments& arguments) {
        std::cout << (arguments.topic.empty() ? list_of_topics()
                                              : text_of(arguments.topic, *command.get_parent()));
      });
}

}  // namespace brindle::tool
