#include "cli/option_parts.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>

#include "brindle/base/text.h"
#include "cli/described_options.h"
#include "cli/option_values.h"

namespace brindle::tool {
namespace {

bool has_option(const CLI::App& command, std::string_view name) {
  return command.get_option_no_throw("--" + std::string(name)) != nullptr;
}

/// Other parts stand instead of the value, or are its unit.
bool follows_value(const OptionInfo& part) {
  return part.written.starts_with(',') || part.written == "@";
}

bool is_word(const OptionInfo& part) {
  return part.kind == OptionKind::flag || part.kind == OptionKind::choice;
}

/// All that stands before a part's value, or is a flag: ",epsilon=", ",rounded", ",voigt".
std::vector<std::string> beginnings_of(const OptionInfo& part) {
  const std::string written(part.written);
  if (written != ",") return {written};
  std::vector<std::string> beginnings;
  for (const std::string& word : split(std::string(part.form), '|')) {
    beginnings.push_back(written + word);
  }
  return beginnings;
}

/// A part in a value: it begins at `begin`, its own value at `value`.
struct Place {
  std::size_t begin = 0, value = 0;
  const OptionInfo* part = nullptr;
};

/// The parts behind commas, from first to last.
std::vector<Place> places_in(const std::string& text, const std::vector<const OptionInfo*>& parts) {
  std::vector<Place> places;
  for (const OptionInfo* part : parts) {
    if (!part->written.starts_with(',')) continue;
    for (const std::string& beginning : beginnings_of(*part)) {
      for (std::size_t at = text.find(beginning); at != text.npos;
           at = text.find(beginning, at + 1)) {
        const std::size_t end = at + beginning.size();
        const bool is_key = beginning.ends_with('=');
        if (!is_key && end != text.size() && text[end] != ',') continue;
        places.push_back({at, is_key ? end : at + part->written.size(), part});
      }
    }
  }
  std::ranges::sort(places, {}, &Place::begin);
  return places;
}

/// Takes "@A..B" out of a value. Names of files and arrays may have other @ signs.
std::string taken_range(std::string& text) {
  for (std::size_t at = text.rfind('@'); at != text.npos && at > 0; at = text.rfind('@', at - 1)) {
    const std::size_t end = std::min(text.find('@', at + 1), text.size());
    const std::string range = text.substr(at + 1, end - at - 1);
    if (range.find("..") == range.npos || range.find('/') != range.npos) continue;
    text.erase(at, end - at);
    return range;
  }
  return "";
}

struct NamedValue {
  std::string name;
  std::string value;  ///< of flags: empty
};

[[noreturn]] void refuse_part(const OptionInfo& whole, const std::string& name,
                              const std::vector<const OptionInfo*>& parts) {
  std::vector<std::string> known;
  std::string list;
  for (const OptionInfo* part : parts) {
    if (!part->written.starts_with(',')) continue;
    for (const std::string& beginning : beginnings_of(*part)) {
      known.push_back(beginning.substr(1));
      list += (list.empty() ? "" : ", ") + known.back();
    }
  }
  const std::string meant = nearest(name, known);
  throw CLI::ValidationError("--" + std::string(whole.name),
                             "has no part '" + name + "'" +
                                 (meant.empty() ? "" : " (did you mean '" + meant + "'?)") +
                                 "; it has " + list);
}

/// Refuses a word and an equals sign behind a comma: only parts have them.
void refuse_unknown_part(const OptionInfo& whole, std::string_view text,
                         const std::vector<const OptionInfo*>& parts) {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz-";
  for (std::size_t comma = text.find(','); comma != text.npos; comma = text.find(',', comma + 1)) {
    const std::size_t end = text.find_first_not_of(kLetters, comma + 1);
    const bool is_key = end != text.npos && text[end] == '=' && end > comma + 1;
    if (is_key) refuse_part(whole, std::string(text.substr(comma + 1, end - comma)), parts);
  }
}

/// The option and its parts. An option whose whole value is a part, as 'none' is, is left out.
std::vector<NamedValue> options_in(const OptionInfo& whole, std::string text,
                                   const std::vector<const OptionInfo*>& parts) {
  std::vector<NamedValue> options;
  const std::vector<Place> places = places_in(text, parts);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& [begin, value, part] = places[i];
    const std::size_t end = i + 1 < places.size() ? places[i + 1].begin : text.size();
    std::string own = text.substr(value, end - value);
    if (const std::size_t comma = own.find(','); is_word(*part) && comma != own.npos) {
      refuse_part(whole, own.substr(comma + 1), parts);
    }
    refuse_unknown_part(whole, own, parts);
    if (part->kind != OptionKind::flag && own.empty()) {
      throw CLI::ValidationError(spelling_of(*part, whole), "lacks its value");
    }
    options.push_back({std::string(part->name), std::move(own)});
  }
  if (!places.empty()) text.resize(places.front().begin);
  for (const OptionInfo* part : parts) {
    if (part->written == "@") {
      const std::string range = taken_range(text);
      if (!range.empty()) options.push_back({std::string(part->name), range});
    } else if (part->kind == OptionKind::flag && text == part->written) {
      return {{std::string(part->name), ""}};
    } else if (!part->written.starts_with(',') && text.ends_with(part->written)) {
      return {{std::string(part->name), text.substr(0, text.size() - part->written.size())}};
    }
  }
  const bool takes_parts = std::ranges::any_of(
      parts, [](const OptionInfo* part) { return part->written.starts_with(','); });
  if (takes_parts) refuse_unknown_part(whole, text, parts);
  options.insert(options.begin(), {std::string(whole.name), std::move(text)});
  return options;
}

void append(const std::vector<NamedValue>& options, std::vector<std::string>& words) {
  for (const auto& [name, value] : options) {
    words.push_back("--" + name + (value.empty() ? "" : '=' + value));
  }
}

}  // namespace

const OptionInfo* whole_of(const OptionInfo& part, const CLI::App& command) {
  for (const std::string& name : words_between_spaces(part.part_of)) {
    if (has_option(command, name)) return find_option(name, job_of(command.get_name()));
  }
  return nullptr;
}

std::vector<const OptionInfo*> parts_of(const OptionInfo& whole, const CLI::App& command) {
  std::vector<const OptionInfo*> parts;
  for (const OptionInfo& row : option_table()) {
    if (!row.is_for(job_of(command.get_name())) || !has_option(command, row.name)) continue;
    const std::vector<std::string> wholes = words_between_spaces(row.part_of);
    if (std::ranges::find(wholes, whole.name) != wholes.end()) parts.push_back(&row);
  }
  return parts;
}

std::string form_of_part(const OptionInfo& part) {
  const std::string written(part.written);
  if (part.kind == OptionKind::flag) return written;
  return follows_value(part) ? written + std::string(part.form) : 'N' + written;
}

std::string spelling_of(const OptionInfo& part, const OptionInfo& whole) {
  return "--" + std::string(whole.name) + (follows_value(part) ? " ..." : " ") + form_of_part(part);
}

bool is_part(const CLI::Option& option, const CLI::App& command) {
  const OptionInfo* row = row_of(option, job_of(command.get_name()));
  return row != nullptr && whole_of(*row, command) != nullptr;
}

std::vector<std::string> with_parts_apart(const CLI::App& command,
                                          const std::vector<std::string>& words) {
  std::vector<std::string> result;
  for (auto word = words.begin(); word != words.end(); ++word) {
    if (*word == "--") {
      result.insert(result.end(), word, words.end());
      break;
    }
    result.push_back(*word);
    const std::size_t equals = word->find('=');
    const std::string name = word->substr(0, equals);
    const CLI::Option* option = name.starts_with('-') ? command.get_option_no_throw(name) : nullptr;
    const OptionInfo* row =
        option == nullptr ? nullptr : row_of(*option, job_of(command.get_name()));
    if (row == nullptr) continue;
    if (const OptionInfo* whole = whole_of(*row, command)) {
      throw CLI::ValidationError(name, "is written as " + spelling_of(*row, *whole));
    }
    if (option->get_expected_max() == 0) continue;
    const bool apart = equals == word->npos;
    if (apart && (std::next(word) == words.end() || std::next(word)->starts_with("--"))) continue;
    const std::string value = apart ? *++word : word->substr(equals + 1);
    const std::vector<const OptionInfo*> parts = parts_of(*row, command);
    const std::vector<NamedValue> options = options_in(*row, value, parts);
    if (options.size() == 1 && options.front().value == value) {
      if (apart) result.push_back(value);
      continue;
    }
    result.pop_back();
    append(options, result);
  }
  return result;
}

std::vector<std::string> command_line_with_parts_apart(const CLI::App& tool,
                                                       const std::vector<std::string>& words) {
  const auto commands = tool.get_subcommands([&](const CLI::App* command) {
    return !words.empty() && command->get_name() == words.front();
  });
  if (commands.empty()) return words;
  std::vector<std::string> result =
      with_parts_apart(*commands.front(), {words.begin() + 1, words.end()});
  result.insert(result.begin(), words.front());
  return result;
}

std::string in_command_words(const CLI::App& command, const std::string& message) {
  return with_option_names(message, [&](const std::string& name) {
    const OptionInfo* row = find_option(name, job_of(command.get_name()));
    const OptionInfo* whole = row == nullptr ? nullptr : whole_of(*row, command);
    return whole == nullptr ? "--" + name : spelling_of(*row, *whole);
  });
}

}  // namespace brindle::tool
