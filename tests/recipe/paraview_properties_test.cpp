// What panels of ParaView's filters say of options, against the table. No VTK.
#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/option_table.h"

namespace brindle {
namespace {

using Words = std::vector<std::string_view>;

constexpr PatternJob kFilterJobs[] = {PatternJob::stripe, PatternJob::curves, PatternJob::sample};

/// An entry of a list of choices, or a property without any, as words of a command line.
struct Said {
  std::string_view entry;  ///< the entry's text; empty: whatever the property's value is
  std::string_view words;  ///< "--option", "--option VALUE"; empty: what counts without options
};

/// What a property stands for, entry by entry in their order.
struct Property {
  std::string_view name;
  PatternJob job;
  std::vector<Said> said;
  std::string_view own_default = "";  ///< why its default is not the option's; empty: it is
};

const std::vector<Property>& properties() {
  static const std::vector<Property> all = {
      {"Field",
       PatternJob::stripe,
       {{"Smooth", "--field smooth"},
        {"Curvature", "--field curvature"},
        {"Direction", "--direction"},
        {"Array", "--field array:NAME"}}},
      {"Vectors", PatternJob::stripe, {{"", "--field"}}, "the first array that there is"},
      {"TensorAxis",
       PatternJob::stripe,
       {{"Major", "--tensor major"},
        {"Minor", "--tensor minor"},
        {"Largest Absolute", "--tensor max-abs"},
        {"Major Within Surface", "--tensor tangent-major"},
        {"Minor Within Surface", "--tensor tangent-minor"}}},
      {"TensorOrder",
       PatternJob::stripe,
       {{"VTK", "--tensor-order vtk"},
        {"Voigt", "--tensor-order voigt"},
        {"Plane", "--tensor-order plane"}}},
      {"CurvatureDirection",
       PatternJob::stripe,
       {{"Larger", "--curvature-direction max"}, {"Smaller", "--curvature-direction min"}}},
      {"FieldSmoothing", PatternJob::stripe, {{"", "--field-smoothing"}}},
      {"Fill", PatternJob::stripe, {{"", "--fill"}}},
      {"FieldArrows", PatternJob::stripe, {{"", "--field-arrows"}}},
      {"FieldWeight", PatternJob::stripe, {{"", "--field-weight"}}, "None, and what counts then"},
      {"TemporalSmoothing", PatternJob::animate, {{"", "--temporal-smoothing"}}},
      {"FrequencySmoothing", PatternJob::stripe, {{"", "--frequency-smoothing"}}},
      {"Direction", PatternJob::stripe, {{"", "--direction"}}, "counts if Field says so"},
      {"StripesRun",
       PatternJob::stripe,
       {{"Across the Field", ""}, {"Along the Field", "--along"}}},
      {"Rotate", PatternJob::stripe, {{"", "--rotate"}}},
      {"CreaseAngle", PatternJob::stripe, {{"", "--crease-angle"}}},
      {"SpacingBy",
       PatternJob::stripe,
       {{"Stripes", "--stripes"},
        {"Frequency", "--frequency"},
        {"Frequency Array", "--frequency array:NAME"},
        {"Stripes Times Factor by Array", "--frequency-by"},
        {"Spacing", "--spacing"}}},
      {"Stripes", PatternJob::stripe, {{"", "--stripes"}}},
      {"Frequency", PatternJob::stripe, {{"", "--frequency"}}, "counts if SpacingBy says so"},
      {"Spacing", PatternJob::stripe, {{"", "--spacing"}}, "counts if SpacingBy says so"},
      {"FrequencyArray", PatternJob::stripe, {{"", "--frequency-by"}}, "the first array"},
      {"FrequencyRange", PatternJob::stripe, {{"", "--frequency-range"}}},
      {"Slack", PatternJob::stripe, {{"", "--slack"}}},
      {"TimeAnchor", PatternJob::animate, {{"", "--lambda"}}},
      {"TextureCoordinates", PatternJob::stripe, {{"", "--uv"}}, "the representation draws them"},
      {"Join", PatternJob::curves, {{"", "--join"}}},
      {"Trim", PatternJob::curves, {{"", "--trim"}}},
      {"Fair", PatternJob::curves, {{"", "--fair"}}},
      {"MinimumLength", PatternJob::curves, {{"", "--min-length"}}},
  };
  return all;
}

/// Properties that stand for no option.
const std::map<std::string_view, std::string_view> kWithoutOption = {
    {"FieldSingularities", "--field-singularities, and -1 where it is not given"},
    {"CrossingFactor", "of SpacingBy's stripes, whichever way they are told; --stripes-v is not"},
};

/// Groups whose options have no property.
const std::map<std::string_view, std::string_view> kGroupsWithoutProperty = {
    {"Look", "ParaView draws"},
    {"Colours by value", "ParaView draws"},
    {"Textures", "ParaView draws"},
    {"Outlines and depth", "ParaView draws"},
    {"Picture", "ParaView draws"},
    {"Output", "ParaView writes, and its filter Feature Edges finds creases"},
    {"Solver", "those that the tool takes suit everybody"},
};

/// Options of the other groups that have none.
const std::map<std::string_view, std::string_view> kWithoutProperty = {
    {"subdivide", "the filter Subdivide"},
    {"rounded", "there are filters that smooth meshes"},
    {"points", "the filter takes surfaces"},
    {"neighbors", "the same"},
    {"up", "ParaView has the camera"},
    {"cross", "ParaView draws stripes"},
    {"curvature-anchor", "Field has Curvature"},
    {"feature-anchor", "not yet asked for"},
    {"feature-angle", "of feature-anchor"},
    {"feature-radius", "of feature-anchor"},
    {"normal-radius", "not yet asked for"},
    {"field-singularities", "FieldSingularities, which has a number for none"},
    {"strokes", "there is nothing to draw them with"},
    {"hold-out", "not yet asked for"},
    {"field-mesh", "the filter Resample With Dataset"},
    {"max-distance", "of field-mesh"},
    {"stripe-width", "of the representation"},
    {"avoid-branches", "not yet asked for"},
    {"cancel-branches", "takes long"},
    {"cancel-distance", "takes long"},
    {"anchor-boundary", "not yet asked for"},
    {"winding", "loops have no names in ParaView"},
    {"lines", "a filter more traces the others"},
    {"offset", "not yet asked for"},
    {"simplify", "the filter Decimate Polyline"},
    {"resample", "not yet asked for"},
    {"path-width", "ParaView draws"},
    {"stripes-v", "CrossingFactor"},
    {"frequency-v", "CrossingFactor"},
    {"field-v", "V is across U"},
    {"wales", "of knitting"},
    {"tube-radius", "the filter Tube"},
    {"tube-sides", "the filter Tube"},
    {"glyph", "the filter Glyph"},
    {"glyph-size", "the filter Glyph"},
    {"size-by", "the filter Glyph"},
    {"size-range", "the filter Glyph"},
    {"min-distance", "not yet asked for"},
};

/// A property as the XML has it.
struct Shown {
  std::map<std::string, std::string> attributes;
  std::string inside;

  std::string attribute(const std::string& name) const {
    const auto found = attributes.find(name);
    return found == attributes.end() ? "" : found->second;
  }
};

std::map<std::string, std::string> attributes_of(const std::string& tag) {
  std::map<std::string, std::string> result;
  for (std::size_t quote = tag.find("=\""); quote != tag.npos;) {
    const std::size_t name = tag.find_last_of(" \n", quote) + 1, end = tag.find('"', quote + 2);
    result[tag.substr(name, quote - name)] = tag.substr(quote + 2, end - quote - 2);
    quote = tag.find("=\"", end);
  }
  return result;
}

/// Elements whose names end so, by the order in which the text has them.
std::vector<Shown> elements(const std::string& text, const std::string& ending) {
  std::vector<Shown> found;
  for (std::size_t at = text.find(ending + ' '); at != text.npos;
       at = text.find(ending + ' ', at)) {
    const std::size_t begin = text.rfind('<', at), end = text.find('>', at);
    at += ending.size();
    const std::string name = text.substr(begin + 1, at - begin - 1);
    Shown& element = found.emplace_back();
    element.attributes = attributes_of(text.substr(begin, end - begin));
    const std::size_t close = text.find("</" + name + '>', end);
    if (text[end - 1] != '/') element.inside = text.substr(end + 1, close - end - 1);
  }
  return found;
}

std::map<std::string, Shown> shown_properties() {
  std::ifstream file(BRINDLE_SOURCE "/paraview/filters/brindle_filters.xml");
  std::stringstream text;
  text << file.rdbuf();
  std::map<std::string, Shown> shown;
  for (const Shown& element : elements(text.str(), "VectorProperty")) {
    if (element.attribute("information_only") == "1") continue;
    EXPECT_TRUE(shown.emplace(element.attribute("name"), element).second);
  }
  return shown;
}

std::string_view option_of(const Said& said) {
  return said.words.empty() ? "" : said.words.substr(2, said.words.find(' ') - 2);
}

std::string_view value_of(const Said& said) {
  const std::size_t space = said.words.find(' ');
  return space == said.words.npos ? "" : said.words.substr(space + 1);
}

/// The values of a choice, and the forms of a text.
Words alternatives(std::string_view form) {
  Words words;
  for (std::size_t begin = 0; begin <= form.size();) {
    const std::size_t end = std::min(form.find('|', begin), form.size());
    words.push_back(form.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

/// Whether the words are what counts where no option is given.
bool is_standard(const Said& said, PatternJob job) {
  if (said.words.empty()) return true;
  const OptionInfo& row = *find_option(option_of(said), job);
  return !row.standard.empty() && (value_of(said).empty() || value_of(said) == row.standard);
}

void check_entries(const Property& property, const Shown& shown) {
  const std::vector<Shown> entries = elements(shown.inside, "<Entry");
  ASSERT_EQ(entries.size(), property.said.size());
  std::map<std::string_view, Words> values;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Said& said = property.said[i];
    EXPECT_EQ(entries[i].attribute("value"), std::to_string(i));
    EXPECT_EQ(entries[i].attribute("text"), said.entry);
    const bool is_default = shown.attribute("default_values") == std::to_string(i);
    EXPECT_EQ(is_standard(said, property.job), is_default) << said.entry;
    if (said.words.empty()) continue;
    const OptionInfo& row = *find_option(option_of(said), property.job);
    if (value_of(said).empty()) continue;
    const Words words = alternatives(row.form);
    EXPECT_NE(std::ranges::find(words, value_of(said)), words.end()) << said.words;
    if (row.kind == OptionKind::choice) values[row.name].push_back(value_of(said));
  }
  for (const auto& [option, given] : values) {
    EXPECT_EQ(given, alternatives(find_option(option, property.job)->form)) << option;
  }
}

std::vector<double> numbers_of(std::string text) {
  std::ranges::replace(text, ',', ' ');
  if (const std::size_t dots = text.find(".."); dots != text.npos) text.replace(dots, 2, " ");
  std::istringstream stream(text);
  std::vector<double> numbers;
  for (double number; stream >> number;) numbers.push_back(number);
  return numbers;
}

/// Of a property without entries.
void check_value(const Property& property, const Shown& shown) {
  ASSERT_EQ(property.said.size(), 1U);
  const OptionInfo& row = *find_option(option_of(property.said[0]), property.job);
  const std::string own = shown.attribute("default_values");
  if (property.own_default.empty()) {
    // Flags and what has no standard are off at zero.
    const std::string standard(row.standard.empty() ? "0" : row.standard);
    EXPECT_EQ(numbers_of(own), numbers_of(standard));
  }
  const bool is_number = row.kind == OptionKind::whole || row.kind == OptionKind::number;
  if (is_number) {
    for (const double number : numbers_of(own)) EXPECT_TRUE(row.range.contains(number));
  }
  // Panels have sliders where there is a range; what is typed may go beyond.
  for (const Shown& range : elements(shown.inside, "RangeDomain")) {
    if (!is_number || range.attribute("min").empty()) continue;
    EXPECT_EQ(numbers_of(range.attribute("min")), std::vector{row.slider.lowest});
    EXPECT_EQ(numbers_of(range.attribute("max")), std::vector{row.slider.highest});
  }
}

TEST(ParaViewProperties, AreWhatTheTableSaysOfTheirOptions) {
  const std::map<std::string, Shown> shown = shown_properties();
  for (const Property& property : properties()) {
    SCOPED_TRACE(property.name);
    for (const Said& said : property.said) {
      ASSERT_TRUE(said.words.empty() || find_option(option_of(said), property.job)) << said.words;
    }
    const auto found = shown.find(std::string(property.name));
    ASSERT_NE(found, shown.end());
    if (property.said[0].entry.empty()) {
      check_value(property, found->second);
    } else {
      check_entries(property, found->second);
    }
  }
}

TEST(ParaViewProperties, AllStandForOptionsOrSayWhyNot) {
  std::set<std::string_view> known;
  for (const Property& property : properties()) known.insert(property.name);
  for (const auto& [name, why] : kWithoutOption) EXPECT_TRUE(known.insert(name).second) << name;
  std::set<std::string> names;
  for (const auto& [name, element] : shown_properties()) {
    EXPECT_TRUE(known.contains(name)) << name << " stands for no option, and nobody says why";
    names.insert(name);
  }
  EXPECT_EQ(names.size(), known.size());
}

TEST(ParaViewProperties, ThereAreForAllOptionsButThoseOfTheLists) {
  std::set<std::string_view> have;
  for (const Property& property : properties()) {
    for (const Said& said : property.said) have.insert(option_of(said));
  }
  std::set<std::string_view> used;
  for (const OptionInfo& row : option_table()) {
    const auto is_for = [&](PatternJob job) { return row.is_for(job); };
    if (std::ranges::none_of(kFilterJobs, is_for) || have.contains(row.name)) continue;
    const bool listed = kWithoutProperty.contains(row.name);
    EXPECT_TRUE(listed || kGroupsWithoutProperty.contains(row.group))
        << "--" << row.name << " has no property, and nobody says why";
    used.insert(listed ? row.name : row.group);
  }
  for (const auto& [name, why] : kWithoutProperty) EXPECT_TRUE(used.contains(name)) << name;
  for (const auto& [group, why] : kGroupsWithoutProperty) EXPECT_TRUE(used.contains(group));
}

}  // namespace
}  // namespace brindle
