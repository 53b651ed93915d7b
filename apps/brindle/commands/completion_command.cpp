#include <iostream>
#include <string>
#include <string_view>

#include "cli/commands.h"
#include "cli/option_parts.h"
#include "cli/option_values.h"

namespace brindle::tool {
namespace {

constexpr const char* kCompletionExamples = R"(Examples:
  brindle completion bash > brindle.bash
  brindle completion zsh > brindle.zsh

Source the file in ~/.bashrc or ~/.zshrc, there after compinit.)";

/// bash's function. zsh runs it, too, where `words` is a name of its own and unset variables are
/// errors.
constexpr std::string_view kBegin = R"(_brindle() {
  local word=${COMP_WORDS[COMP_CWORD]} last=${COMP_WORDS[COMP_CWORD-1]} offered=
  if [ "$word" = = ]; then word=; else [ "$last" != = ] || last=${COMP_WORDS[COMP_CWORD-2]}; fi
  case "$COMP_CWORD ${COMP_WORDS[1]} $last" in
)";
constexpr std::string_view kEnd = R"(  esac
  COMPREPLY=($(compgen -W "$offered" -- "$word"))
}
complete -o default -F _brindle brindle
)";
constexpr std::string_view kZsh = "autoload -U +X bashcompinit && bashcompinit\n";

/// The words of a form such as "FILE|smooth|curvature".
std::string words_of_form(const std::string& form) {
  std::string words;
  for (const std::string& word : split(form, '|')) {
    const bool literal = word.find_first_not_of("abcdefghijklmnopqrstuvwxyz_-") == word.npos;
    if (literal && !word.empty()) words += (words.empty() ? "" : " ") + word;
  }
  return words;
}

std::string offer(const std::string& where, const std::string& words, const char* condition = "") {
  return "    " + where + ") " + condition + "offered='" + words + "' ;;\n";
}

/// The values after an option; otherwise the options, or the values of an argument.
std::string cases_of(const CLI::App& command) {
  const std::string name = command.get_name();
  std::string cases, options, values;
  for (const CLI::Option* option : command.get_options()) {
    if (is_part(*option, command)) continue;
    const std::string words =
        option->get_expected_max() == 0 ? "" : words_of_form(option->get_type_name());
    if (option->get_positional()) values = words;
    for (const std::string& spelling : option->get_lnames()) {
      options += (options.empty() ? "--" : " --") + spelling;
      if (!words.empty()) cases += offer("*' " + name + " --" + spelling + "'", words);
    }
  }
  const std::string anywhere = "*' " + name + " '*";
  if (!values.empty()) return cases + offer(anywhere, values + ' ' + options);
  return cases + offer(anywhere, options, "[ \"${word#-}\" = \"$word\" ] || ");
}

std::string completion_of(const CLI::App& tool) {
  std::string names, cases;
  for (const CLI::App* command : tool.get_subcommands({})) {
    names += command->get_name() + ' ';
    cases += cases_of(*command);
  }
  for (const CLI::Option* option : tool.get_options()) {
    for (const std::string& spelling : option->get_lnames()) names += "--" + spelling + ' ';
  }
  return std::string(kBegin) + offer("'1 '*", names) + cases + std::string(kEnd);
}

struct CompletionArguments {
  std::string shell;
};

}  // namespace

Command add_completion_command(CLI::App& app) {
  return add_command<CompletionArguments>(
      app, "completion", "Print completion of the command line for a shell", kCompletionExamples,
      [](CLI::App& command, CompletionArguments& arguments) {
        command.add_option("SHELL", arguments.shell, "the shell")
            ->required()
            ->type_name("bash|zsh")
            ->check([](const std::string& shell) {
              return shell == "bash" || shell == "zsh"
                         ? ""
                         : "expected bash or zsh, got '" + shell + "'";
            });
      },
      [](const CLI::App& command, const CompletionArguments& arguments) {
        if (arguments.shell == "zsh") std::cout << kZsh;
        std::cout << completion_of(*command.get_parent());
      });
}

}  // namespace brindle::tool
