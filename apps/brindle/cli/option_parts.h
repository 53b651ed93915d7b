/// Parts of values that are options of their own elsewhere: --solver relaxation,epsilon=0.01 stands
/// for --solver relaxation and --epsilon 0.01, as sessions and other languages have it.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/option_table.h"

namespace brindle::tool {

/// The option of the command whose value has this one as a part; null if there is none.
const OptionInfo* whole_of(const OptionInfo& part, const CLI::App& command);

/// The parts that the value of a command's option may have.
std::vector<const OptionInfo*> parts_of(const OptionInfo& whole, const CLI::App& command);

/// The part as values have it, with the form of its own value: ",epsilon=E", "@A..B".
std::string form_of_part(const OptionInfo& part);

/// The part on a command line: "--solver ...,epsilon=E", "--color-by ...@A..B".
std::string spelling_of(const OptionInfo& part, const OptionInfo& whole);

/// Whether an option of the command is written as a part of another's value.
bool is_part(const CLI::Option& option, const CLI::App& command);

/// Options and values, without the name of the command, with an option for each part of a value.
/// Throws CLI::ValidationError for parts that the option does not have, for those without a value,
/// and for names of parts as options.
std::vector<std::string> with_parts_apart(const CLI::App& command,
                                          const std::vector<std::string>& words);

/// The same for a command line of the tool, whose first word names the command.
std::vector<std::string> command_line_with_parts_apart(const CLI::App& tool,
                                                       const std::vector<std::string>& words);

/// A message, which names parts as options, in the words of the command line.
std::string in_command_words(const CLI::App& command, const std::string& message);

}  // namespace brindle::tool
