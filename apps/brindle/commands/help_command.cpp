#include <algorithm>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/base/text.h"
#include "cli/commands.h"
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
         "\n'brindle help TOPIC' explains one, 'brindle help COMMAND' lists a command's options.\n";
}

std::string form_of_topics() {
  std::string form;
  for (const HelpTopic& topic : kHelpTopics) form += std::string(topic.name) + '|';
  return form + kReference;
}

std::string text_of(const std::string& name, const CLI::App& tool) {
  const auto topic = std::ranges::find(kHelpTopics, std::string_view(name), &HelpTopic::name);
  if (topic != kHelpTopics.end()) return std::string(topic->text);
  if (name == kReference) return option_reference(tool);
  std::vector<std::string> known = {kReference};
  for (const HelpTopic& other : kHelpTopics) known.emplace_back(other.name);
  for (const CLI::App* command : tool.get_subcommands({})) {
    if (command->get_name() == name) return command->help(tool.get_name());
    known.push_back(command->get_name());
  }
  const std::string meant = nearest(name, known);
  throw CLI::ValidationError("TOPIC",
                             "'" + shown(name) + "' is neither a topic nor a command" +
                                 (meant.empty() ? "" : " (did you mean '" + meant + "'?)") +
                                 "; 'brindle help' lists the topics");
}

}  // namespace

Command add_help_command(CLI::App& app) {
  return add_command<HelpArguments>(
      app, "help", "Explain values, lengths, cameras and files", "",
      [](CLI::App& command, HelpArguments& arguments) {
        command.add_option("TOPIC", arguments.topic, "a topic, or a command; default: list topics")
            ->type_name(form_of_topics());
      },
      [](const CLI::App& command, const HelpArguments& arguments) {
        std::cout << (arguments.topic.empty() ? list_of_topics()
                                              : text_of(arguments.topic, *command.get_parent()));
      });
}

}  // namespace brindle::tool
