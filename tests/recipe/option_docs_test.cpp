// What the pages of the documentation say of options, against the table.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/option_table.h"

namespace brindle {
namespace {

/// What pages call a default of options whose standard follows from something else.
const std::map<std::string_view, std::string_view> kOtherDefaults = {
    {"cycles", "0"},         // of the multilevel solver
    {"texture", "checker"},  // of --cross
    {"up", "z"},             // of shapes
};

std::vector<const OptionInfo*> rows_of(std::string_view name) {
  std::vector<const OptionInfo*> rows;
  for (const OptionInfo& row : option_table()) {
    if (row.name == name) rows.push_back(&row);
  }
  return rows;
}

std::string without(std::string text, char character) {
  std::erase(text, character);
  return text;
}

/// Whether `text` begins with `value`, and not with a longer one.
bool begins_with(const std::string& text, std::string_view value) {
  const auto goes_on = [&] {
    const char next = text[value.size()];
    return next == '.' || next == '%' || (next >= '0' && next <= '9');
  };
  return !value.empty() && text.starts_with(value) && (text.size() == value.size() || !goes_on());
}

bool is_default(const std::string& text, const OptionInfo& row) {
  const auto other = kOtherDefaults.find(row.name);
  const std::string_view standard =
      row.standard.empty() && other != kOtherDefaults.end() ? other->second : row.standard;
  return begins_with(without(text, ' '), standard);
}

/// An option between backticks, and what a page says of it.
struct Mention {
  std::string name, value;
  std::string after;  ///< in a table what follows in the row, else the next words
  bool in_table = false;
  bool heads_row = false;  ///< of a table
};

std::string what(const Mention& mention) {
  return "--" + mention.name + (mention.value.empty() ? "" : ' ' + mention.value);
}

/// Of a value with a part, the part's name and value are meant: --field-smoothing P,fill=P.
void take_part(Mention& mention) {
  std::size_t last = 0;
  const std::string whole = mention.name, value = mention.value;
  for (const OptionInfo& row : option_table()) {
    std::istringstream wholes{std::string(row.part_of)};
    for (std::string name; wholes >> name;) {
      const bool is_key = row.written.ends_with('=') || row.written == "@";
      const std::size_t at = is_key ? value.rfind(row.written) : value.npos;
      if (name != whole || at == value.npos || at < last) continue;
      last = at;
      mention.name = row.name;
      mention.value = value.substr(at + row.written.size());
    }
  }
}

std::vector<Mention> mentions_in(const std::string& text) {
  std::vector<Mention> mentions;
  for (std::size_t at = text.find("`--"); at != text.npos; at = text.find("`--", at + 1)) {
    const std::size_t close = text.find('`', at + 1);
    if (close == text.npos) break;
    const std::size_t line = text.rfind('\n', at) + 1;
    Mention& mention = mentions.emplace_back();
    mention.in_table = text[line] == '|';
    const std::size_t next = std::min(text.find("`--", close), text.size());
    const std::size_t end =
        mention.in_table ? std::min(text.find('\n', close), text.size()) : close + 40;
    std::istringstream words(without(text.substr(at + 3, close - at - 3), '\\'));
    words >> mention.name >> mention.value;
    take_part(mention);
    mention.after = text.substr(close + 1, std::min(next, end) - close - 1);
    std::ranges::replace(mention.after, '\n', ' ');
    mention.heads_row = text.substr(line, at - line) == "| ";
  }
  return mentions;
}

/// What follows the first of `words`, if it is there.
std::optional<std::string> behind(const std::string& text, std::string_view words) {
  const std::size_t at = text.find(words);
  return at == text.npos ? std::nullopt : std::optional(text.substr(at + words.size()));
}

/// The default that a page tells. Outside of tables it stands right behind the option.
std::optional<std::string> told_default(const Mention& mention) {
  for (const std::string_view words : {" (default", " (the default", ", default "}) {
    const bool follows = mention.after.starts_with(words);
    if (!follows && !(mention.in_table && words != ", default ")) continue;
    const auto rest = behind(mention.after, words);
    if (!rest) continue;
    return rest->starts_with(')') ? mention.value : rest->substr(0, rest->find_first_of(");"));
  }
  return std::nullopt;
}

bool has_range(const std::string& text, const OptionInfo& row) {
  char* end = nullptr;
  const double least = std::strtod(text.c_str(), &end);
  const auto most = behind(end, " to ");
  return least == row.range.least && most && std::strtod(most->c_str(), nullptr) == row.range.most;
}

bool takes(const std::string& value, const OptionInfo& row) {
  if (row.kind != OptionKind::choice || value.empty()) return true;
  if (value.find('|') != value.npos) return value == row.form;
  return ('|' + std::string(row.form) + '|').find('|' + value + '|') != std::string::npos;
}

/// What is wrong with a page. Of options with several rows, one job's has to be as it is told.
std::vector<std::string> complaints_of(const std::string& text) {
  std::vector<std::string> complaints;
  for (const Mention& mention : mentions_in(text)) {
    const std::vector<const OptionInfo*> rows = rows_of(mention.name);
    const auto require = [&](bool is_right, const char* problem) {
      if (!is_right) complaints.push_back(what(mention) + ' ' + problem);
    };
    if (mention.heads_row) require(!rows.empty(), "is no option");
    if (rows.empty()) continue;
    if (mention.in_table) {
      require(std::ranges::any_of(
                  rows, [&](const OptionInfo* row) { return takes(mention.value, *row); }),
              "is no such choice");
    }
    if (const auto told = told_default(mention)) {
      require(std::ranges::any_of(rows,
                                  [&](const OptionInfo* row) {
                                    return is_default(told->substr(told->find_first_not_of(' ')),
                                                      *row);
                                  }),
              "has another default");
    }
    if (const auto told = behind(mention.after, "from "); told && mention.in_table) {
      const bool is_range = !told->empty() && (*told)[0] >= '0' && (*told)[0] <= '9';
      require(!is_range || std::ranges::any_of(
                               rows, [&](const OptionInfo* row) { return has_range(*told, *row); }),
              "has another range");
    }
  }
  return complaints;
}

/// A page without its fenced blocks.
std::string prose_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string prose;
  bool fenced = false;
  for (std::string line; std::getline(file, line);) {
    const bool fence = line.starts_with("```");
    if (!fenced && !fence) prose += line + '\n';
    fenced ^= fence;
  }
  return prose;
}

TEST(OptionDocs, SayOfOptionsWhatTheTableSays) {
  const std::filesystem::path source(BRINDLE_SOURCE);
  std::vector<std::filesystem::path> pages = {source / "README.md"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source / "docs")) {
    const bool generated = entry.path().filename() == "options.md";  // from the table
    if (entry.path().extension() == ".md" && !generated) pages.push_back(entry.path());
  }
  EXPECT_GT(pages.size(), 20U);
  std::size_t mentions = 0;
  for (const std::filesystem::path& page : pages) {
    const std::string prose = prose_of(page);
    mentions += mentions_in(prose).size();
    for (const std::string& complaint : complaints_of(prose)) {
      ADD_FAILURE() << page.filename() << ": " << complaint;
    }
  }
  EXPECT_GT(mentions, 100U);
}

TEST(OptionDocs, AreComparedInTablesAndInText) {
  using Strings = std::vector<std::string>;
  EXPECT_EQ(
      complaints_of(
          "| `--stripes N` | many (default 40) |\n| `--neighbors K` | so many, from "
          "3 to 100 (default 8) |\n| `--tensor major` (default) | that |\n"
          "Lambda (`--previous FILE,lambda=L`, default 0.025) and `--solver multilevel` (the\n"
          "default) and `--field-mesh FILE,within=L` (default 2 % of the diagonal)."),
      Strings());
  EXPECT_EQ(complaints_of("| `--strips N` | many |\n"), Strings{"--strips N is no option"});
  for (const char* wrong : {"400", "4", "40.5"}) {
    EXPECT_EQ(complaints_of(std::string("| `--stripes N` | many (default ") + wrong + ") |\n"),
              Strings{"--stripes N has another default"});
  }
  EXPECT_EQ(complaints_of("| `--stripes N`, `--neighbors K` | from 3 to 90 |\n"),
            Strings{"--neighbors K has another range"});
  EXPECT_EQ(complaints_of("| `--tensor minor` (default) | that |\n"),
            Strings{"--tensor minor has another default"});
  EXPECT_EQ(complaints_of("| `--tensor major\\|minor` | that |\n"),
            Strings{"--tensor major|minor is no such choice"});
  EXPECT_EQ(complaints_of("As the text says (`--previous FILE,lambda=L`, default 0.25)."),
            Strings{"--lambda L has another default"});
}

}  // namespace
}  // namespace brindle
