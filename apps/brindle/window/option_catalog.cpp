#include "window/option_catalog.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>

#include "brindle/renderer.h"
#include "cli/option_values.h"

namespace brindle::tool {
namespace {

struct GroupNames {
  const char* title;
  std::vector<std::string> options;
};

const std::vector<GroupNames> kGroups = {
    {"Stripes",
     {"stripes", "frequency", "stripe-width", "rotate", "along", "slack", "calm", "frequency-by",
      "frequency-range", "merge-branches", "anchor-boundary", "winding"}},
    {"Field",
     {"field", "direction", "curvature-direction", "curvature-anchor", "feature-anchor",
      "feature-angle", "feature-radius", "strokes", "tensor", "field-mesh", "max-distance"}},
    {"Look",
     {"view", "colors", "width-by", "width-range", "tones", "cross-hatch", "pixel-width",
      "stroke-spacing", "between", "flat"}},
    {"Colours by value",
     {"color-by", "color-range", "colormap", "color-on", "threshold", "opacity-by", "opacity-range",
      "legend", "no-legend"}},
    {"Outlines and depth",
     {"outline", "creases", "hidden-lines", "line-width", "occlusion", "ground-shadow", "depth-cue",
      "transparent", "with", "up"}},
    {"Textures",
     {"texture", "cross", "oriented", "stripes-v", "frequency-v", "texture-by", "regions",
      "texture-shift"}},
    {"Surface", {"subdivide", "points", "neighbors"}},
    {"Solver",
     {"solver", "phase-shift", "weights", "sweeps", "cycles", "epsilon", "momentum", "seed",
      "global-iterations", "device", "previous", "lambda", "match"}},
};
// Of what curves and samples have alone: a group of their own, first.
const std::vector<std::string> kOwn = {
    "lines",      "offset",      "join",       "min-length", "simplify",    "resample",
    "line-width", "glyph",       "glyph-size", "size-by",    "size-range",  "min-distance",
    "stripes-v",  "frequency-v", "field-v",    "wales",      "tube-radius", "tube-sides",
    "color-by",   "color-range", "colormap",   "threshold",  "legend",      "no-legend"};
constexpr const char* kMore = "More";

// Lengths are left out: they depend on the mesh's units.
const std::map<std::string, SliderRange> kRanges = {
    {"stripes", {2, 400, true}},
    {"stripes-v", {2, 400, true}},
    {"frequency", {0.01f, 1000, true}},
    {"frequency-v", {0.01f, 1000, true}},
    {"stripe-width", {0, 1}},
    {"rotate", {-180, 180}},
    {"slack", {0, 1}},
    {"merge-branches", {0.001f, 1, true}},
    {"anchor-boundary", {0, 1}},
    {"curvature-anchor", {0, 10, true}},
    {"feature-anchor", {0, 10, true}},
    {"feature-angle", {0, 180}},
    {"cross-hatch", {0, 1}},
    {"pixel-width", {0.5f, 30, true}},
    {"stroke-spacing", {4, 200, true}},
    {"creases", {0, 180}},
    {"line-width", {0.5f, 20, true}},
    {"occlusion", {0, 1}},
    {"threshold", {0, 1}},
    {"subdivide", {0, 4, false, true}},
    {"neighbors", {3, 30, false, true}},
    {"sweeps", {0, 50, false, true}},
    {"cycles", {0, 20, false, true}},
    {"epsilon", {0.0001f, 1, true}},
    {"momentum", {0, 1}},
    {"seed", {0, 100, false, true}},
    {"global-iterations", {1, 100, false, true}},
    {"lambda", {0.001f, 10, true}},
    {"offset", {-0.5f, 0.5f}},
    {"wales", {1, 400, true, true}},
    {"tube-sides", {3, 64, false, true}},
    {"min-distance", {0, 2}},
    {"glyph-size", {0.1f, 2, true}},
};

// Lengths as shares of the diagonal, "0.4%".
const std::map<std::string, SliderRange> kPercentRanges = {
    {"min-length", {0, 50}},           {"simplify", {0, 1}},
    {"resample", {0.1f, 5, true}},     {"line-width", {0.05f, 5, true}},
    {"tube-radius", {0.02f, 3, true}}, {"max-distance", {0.1f, 50, true}},
    {"feature-radius", {0, 20}},
};
constexpr const char* kLengthForm = "L|P%";

// A value to be written as it stands; what stands for something is in capitals or "array:NAME".
bool is_name(const std::string& part) {
  return !part.empty() && part.find_first_not_of("abcdefghijklmnopqrstuvwxyz_-") == part.npos;
}

// "2.5" of "... (default 2.5: ...)", "smooth" of "smooth (default)".
std::string standard_in(const std::string& help) {
  constexpr std::string_view kMark = "(default";
  const std::size_t mark = help.find(kMark);
  if (mark == help.npos) return "";
  std::size_t from = mark + kMark.size();
  if (help[from] == ')') {
    const std::size_t end = mark - 1;
    const std::size_t space = help.find_last_of(" ,", end - 1);
    from = space == help.npos ? 0 : space + 1;
    return help.substr(from, end - from);
  }
  if (help[from] != ' ') return "";
  const std::size_t end = help.find_first_of(" ):;", from + 1);
  std::string value = help.substr(from + 1, end - from - 1);
  const bool is_number =
      !value.empty() && (std::isdigit(static_cast<unsigned char>(value[0])) || value[0] == '-');
  return is_number || help[end] == ')' ? value : "";
}

std::vector<std::string> names_of(const SessionOption& option) {
  if (!option.choices.empty()) return option.choices;
  if (option.name == "texture") {
    return split(std::string(built_in_tile_names()), '|');
  }
  std::vector<std::string> names;
  for (const std::string& part : split(option.type_name, '|')) {
    if (is_name(part)) names.push_back(part);
  }
  if (option.type_name.find("VALUE") != std::string::npos) {
    names.insert(names.end(), {"curvature", "height", "light", "distance:camera"});
  }
  return names;
}

WidgetKind kind_of(const SessionOption& option) {
  if (option.flag) return WidgetKind::flag;
  if (option.type_name == kLengthForm) return WidgetKind::percent;
  if (kRanges.contains(option.name)) return WidgetKind::number;
  if (option.type_name.starts_with("A,B") || option.type_name == "DARK,LIGHT") {
    return WidgetKind::numbers;
  }
  return option.choices.empty() ? WidgetKind::text : WidgetKind::choice;
}

// Help says "larger (default)" of `max`: choices name first what counts without them.
std::string standard_of(const SessionOption& option, const CatalogOption& entry) {
  if (option.name == "rotate") return "0";
  if (option.name == "up") return "";  // y or z, as the mesh is a file or a shape
  const std::string named = standard_in(option.help);
  if (entry.kind != WidgetKind::choice) return named;
  const bool known = std::ranges::find(entry.names, named) != entry.names.end();
  return known ? named : entry.names.front();
}

CatalogOption entry_of(const SessionOption& option) {
  CatalogOption entry;
  entry.name = option.name;
  entry.help = option.help;
  entry.form = option.type_name;
  entry.kind = kind_of(option);
  entry.names = names_of(option);
  entry.file = option.type_name.find("FILE") != std::string::npos || option.name == "with";
  entry.repeatable = option.repeatable;
  const auto& ranges = entry.kind == WidgetKind::percent ? kPercentRanges : kRanges;
  if (const auto range = ranges.find(option.name); range != ranges.end()) {
    entry.range = range->second;
  }
  entry.standard = standard_of(option, entry);
  return entry;
}

}  // namespace

namespace {

using Entries = std::map<std::string, CatalogOption>;

// Takes those that there are: a build may lack what others have.
OptionGroup taken_group(const std::string& title, const std::vector<std::string>& names,
                        Entries& left) {
  OptionGroup group{title, {}};
  for (const std::string& name : names) {
    if (auto entry = left.extract(name)) group.options.push_back(std::move(entry.mapped()));
  }
  return group;
}

std::vector<std::string> names_in_order(const std::vector<SessionOption>& options) {
  std::vector<std::string> names;
  for (const SessionOption& option : options) names.push_back(option.name);
  return names;
}

}  // namespace

std::vector<OptionGroup> option_catalog(const std::vector<SessionOption>& options) {
  Entries left, own;
  std::string own_title;
  for (const SessionOption& option : options) {
    (option.own ? own : left).emplace(option.name, entry_of(option));
    if (option.own) own_title = option.group;
  }
  std::vector<OptionGroup> groups = {taken_group(own_title, kOwn, own)};
  for (const GroupNames& names : kGroups) {
    groups.push_back(taken_group(names.title, names.options, left));
  }
  left.merge(own);
  groups.push_back(taken_group(kMore, names_in_order(options), left));
  std::erase_if(groups, [](const OptionGroup& group) { return group.options.empty(); });
  return groups;
}

}  // namespace brindle::tool
