#include "window/panels/option_catalog.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <sstream>
#include <string_view>

#include "brindle/renderer.h"
#include "cli/described_options.h"
#include "cli/option_values.h"
#include "session/session_options.h"

namespace brindle::tool {
namespace {

// Whether the part is a literal value; placeholders are in capitals or "array:NAME".
bool is_name(const std::string& part) {
  return !part.empty() && part.find_first_not_of("abcdefghijklmnopqrstuvwxyz_-") == part.npos;
}

std::vector<std::string> names_of(const OptionInfo& info) {
  if (info.kind == OptionKind::choice) return choices_of(info);
  if (info.name == "texture") return split(std::string(built_in_tile_names()), '|');
  std::vector<std::string> names;
  for (const std::string& part : split(std::string(info.form), '|')) {
    if (is_name(part)) names.push_back(part);
  }
  if (info.form.find("VALUE") != info.form.npos) {
    names.insert(names.end(), {"curvature", "height", "light", "distance:camera"});
  }
  return names;
}

CatalogOption entry_of(const OptionInfo& info) {
  CatalogOption entry;
  entry.name = info.name;
  entry.words = info.words;
  entry.help = info.help;
  entry.form = info.form;
  entry.kind = info.kind;
  entry.names = names_of(info);
  entry.files = words_between_spaces(info.files);
  entry.repeatable = info.several;
  entry.whole = info.kind == OptionKind::whole || info.slider.whole;
  entry.range = info.slider;
  entry.standard = info.standard;
  entry.excludes = words_between_spaces(info.excludes);
  return entry;
}

/// Groups in order of use; others follow in the order of the table.
constexpr std::array<std::string_view, 9> kTitles = {
    "Stripes",     "Field",   "Textures", "Look", "Colours by value", "Outlines and depth",
    "Fabrication", "Surface", "Solver"};

std::size_t rank_of(const OptionGroup& group) {
  return static_cast<std::size_t>(std::ranges::find(kTitles, group.title) - kTitles.begin());
}

/// The table's group of the options of curves or samples.
std::string_view own_title(Shown shown) { return shown == Shown::curves ? "Curves" : "Samples"; }

/// The group of a title, created if necessary.
OptionGroup& group_of(std::string_view title, std::vector<OptionGroup>& groups) {
  const auto found = std::ranges::find(groups, title, &OptionGroup::title);
  if (found != groups.end()) return *found;
  return groups.emplace_back(OptionGroup{std::string(title), {}});
}

std::string in_small_letters(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

}  // namespace

bool is_meant(const CatalogOption& option, const std::string& search) {
  const std::string all =
      in_small_letters(option.words + " --" + option.name + ' ' + option.form + ' ' + option.help);
  std::istringstream words(in_small_letters(search));
  for (std::string word; words >> word;) {
    if (all.find(word) == std::string::npos) return false;
  }
  return true;
}

std::vector<OptionGroup> option_catalog(Shown shown) {
  std::vector<OptionGroup> groups;
  const auto add = [&](bool own) {
    for (const OptionInfo* info : session_options(shown)) {
      if (is_own(*info, shown) != own) continue;
      group_of(own ? own_title(shown) : info->group, groups).options.push_back(entry_of(*info));
    }
  };
  add(true);
  if (!groups.empty()) {
    // The group's own options come first, then shared ones: colours.
    std::vector<CatalogOption>& own = groups.front().options;
    std::stable_partition(own.begin(), own.end(), [&](const CatalogOption& option) {
      return find_session_option(option.name, shown)->group == own_title(shown);
    });
  }
  const auto shared = static_cast<std::ptrdiff_t>(groups.size());
  add(false);
  std::stable_sort(
      groups.begin() + shared, groups.end(),
      [](const OptionGroup& a, const OptionGroup& b) { return rank_of(a) < rank_of(b); });
  return groups;
}

}  // namespace brindle::tool
