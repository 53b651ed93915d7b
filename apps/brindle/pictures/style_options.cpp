#include "pictures/style_options.h"

#include <algorithm>
#include <array>

#include "brindle/error.h"
#include "brindle/image.h"
#include "brindle/render/parsed_words.h"
#include "cli/command_line.h"
#include "cli/described_options.h"
#include "cli/option_fields.h"
#include "input/vertex_values.h"

namespace brindle::tool {
namespace {

ValueRange parse_shares(const std::string& option, const std::string& text) {
  const ValueRange range = parse_range(option, text);
  if (std::min(range.lowest, range.highest) < 0 || std::max(range.lowest, range.highest) > 1) {
    wrong_usage(option, "two numbers A..B from 0 to 1", text);
  }
  return range;
}

ValueRange parse_tones(const std::string& option, const std::string& text) {
  const ValueRange range = parse_shares(option, text);
  if (range.lowest >= range.highest) {
    wrong_usage(option, "two tones A..B from 0 to 1, the darker one first", text);
  }
  return range;
}

WidthRange parse_width_range(const std::string& option, const std::string& text) {
  const char* expected = "two widths, from 0 to 1 or in pixels, such as 0.1..0.9 or 1px..5px";
  const auto [from, to] = parse_ends(option, expected, text);
  std::array<std::string, 2> parts = {from, to};
  const auto in_pixels =
      std::ranges::count_if(parts, [](const std::string& part) { return part.ends_with("px"); });
  if (in_pixels == 1) wrong_usage(option, expected, text);
  for (std::string& part : parts) {
    if (in_pixels > 0) part.resize(part.size() - 2);
  }
  const WidthRange range{parse_not_negative_number(option, parts[0]),
                         parse_not_negative_number(option, parts[1]),
                         in_pixels > 0 ? WidthUnit::pixels : WidthUnit::period};
  if (std::max(range.first, range.last) > (in_pixels > 0 ? 10000.0f : 1.0f)) {
    wrong_usage(option, expected, text);
  }
  return range;
}

std::optional<bool> parse_between(std::string_view name) {
  if (name == "surface") return false;
  if (name == "nothing") return true;
  return std::nullopt;
}

std::optional<bool> parse_hidden(std::string_view name) {
  if (name == "none") return false;
  if (name == "dashed") return true;
  return std::nullopt;
}

RegionChoice parse_region(const std::string& option, const std::string& from,
                          const std::string& name) {
  const std::vector<std::string> parts = split(name, '@');
  RegionChoice region;
  region.from = parse_number(option, from);
  const auto tile = parse_built_in_tile(parts.front());
  if (!tile) wrong_usage(option, "tiles " + std::string(built_in_tile_names()), name);
  region.tile = *tile;
  if (parts.size() > 1) region.color = parse_color(parts[1]);
  if (parts.size() > 2 || (parts.size() == 2 && !region.color)) {
    wrong_usage(option, "TILE or TILE@#rrggbb", name);
  }
  return region;
}

std::vector<RegionChoice> parse_regions(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  const char* expected = "FROM,TILE[@#rrggbb] once or more, by rising values";
  if (parts.size() % 2 != 0) wrong_usage(option, expected, text);
  std::vector<RegionChoice> regions;
  for (std::size_t i = 0; i < parts.size(); i += 2) {
    regions.push_back(parse_region(option, parts[i], parts[i + 1]));
    const bool rises = i == 0 || regions[i / 2].from > regions[i / 2 - 1].from;
    if (!rises) wrong_usage(option, expected, text);
  }
  return regions;
}

Eigen::Vector2f parse_shift(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() > 2) wrong_usage(option, "U or U,V in tiles", text);
  return {parse_number(option, parts[0]), parts.size() == 2 ? parse_number(option, parts[1]) : 0};
}

std::string parse_value(const std::string& option, const std::string& text) {
  check_value_name(option, text);
  return text;
}

std::string parse_width_value(const std::string& option, const std::string& text) {
  return text == "light" ? text : parse_value(option, text);
}

}  // namespace

void add_color_options(CLI::App& app, StyleOptions& options) {
  add_parsed_option(app, "--color-by", options.color_by, parse_value);
  add_parsed_option(app, "--color-range", options.color_range, parse_rising_range);
  add_named_option(app, "--colormap", options.map, parse_color_map);
  options.visit_colors(AddField(app));
}

namespace {

void add_value_options(CLI::App& app, StyleOptions& options) {
  add_parsed_option(app, "--width-by", options.width_by, parse_width_value);
  add_parsed_option(app, "--width-range", options.width_range, parse_width_range);
  add_color_options(app, options);
  add_parsed_option(app, "--opacity-by", options.opacity_by, parse_value);
  add_parsed_option(app, "--opacity-range", options.opacity_range, parse_shares);
}

void add_region_options(CLI::App& app, StyleOptions& options) {
  add_parsed_option(app, "--texture-by", options.texture_by, parse_value);
  add_parsed_option(app, "--regions", options.regions, parse_regions);
  add_parsed_option(app, "--tile-size-by", options.tile_size_by, parse_value);
  add_parsed_option(app, "--tile-size-range", options.tile_size_range, parse_shares);
  add_parsed_option(app, "--texture-shift", options.texture_shift, parse_shift);
}

}  // namespace

void add_style_options(CLI::App& app, StyleOptions& options) {
  add_fields(app, options);
  add_value_options(app, options);
  add_parsed_option(app, "--tones", options.tones, parse_tones);
  add_named_option(app, "--hidden-lines", options.hidden_dashed, parse_hidden);
  add_named_option(app, "--between", options.discard, parse_between);
  app.add_option_function<std::vector<std::string>>(
         "--with",
         [&options](const std::vector<std::string>& texts) {
           options.others.clear();
           for (const std::string& text : texts) {
             options.others.push_back(parse_other_surface("--with", text));
           }
         })
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  add_region_options(app, options);
}

namespace {

std::vector<std::string> style_options(const CLI::App& command) {
  std::vector<std::string> options;
  for (const OptionInfo& row : option_table()) {
    const bool is_style = row.styles && row.is_for(job_of(command.get_name()));
    if (is_style) options.push_back("--" + std::string(row.name));
  }
  return options;
}

}  // namespace

bool is_styled(const CLI::App& command) {
  return std::ranges::any_of(style_options(command),
                             [&](const std::string& option) { return is_given(command, option); });
}

void add_flow_option(CLI::App& app, StyleOptions& options) {
  add_parsed_option(app, "--texture-flow", options.texture_flow, parse_shift);
}

void refuse_style_options(const CLI::App& command, std::string_view why) {
  refuse_given(command, style_options(command), why);
}

namespace {

void check_widths(const CLI::App& command, const StyleOptions& options) {
  if (options.width_by.empty()) {
    refuse_given(command, {"--width-range"}, "widths follow no value; add --width-by VALUE");
  } else {
    refuse_given(command, {"--stripe-width", "--pixel-width"}, "--width-by says how wide they are");
  }
  if (options.pixel_width) {
    refuse_given(command, {"--stripe-width"}, "--pixel-width says how wide they are");
  }
  if (!options.by_light()) {
    refuse_given(command, {"--tones", "--cross-hatch"},
                 "strokes do not follow the light; add --width-by light");
  } else {
    refuse_given(command, {"--flat"}, "strokes that follow the light are drawn without it anyway");
  }
}

void check_colors(const CLI::App& command, const StyleOptions& options) {
  const std::vector<std::string> colored = options.color_values();
  if (colored.empty()) {
    refuse_given(command, {"--color-range", "--colormap", "--threshold", "--color-on"},
                 "colours follow no value; add --color-by VALUE");
  }
  for (const OtherSurfaceChoice& other : options.others) {
    if (!other.color_range || options.range_of_colors(other.color_by) == other.color_range)
      continue;
    throw CLI::ValidationError("--with", "the colours of " + other.color_by +
                                             " have two ranges, and share one map; give it once");
  }
  if (options.color_by.empty()) {
    refuse_given(
        command, {"--color-on"},
        "it is for the first surface, whose colours follow no value; add --color-by VALUE");
  }
  if (colored.size() > 1) {
    refuse_given(command, {"--threshold"},
                 "surfaces have colours of several values, " + colored[0] + " and " + colored[1] +
                     ", and T is one of them; colour all by one");
  }
  if (options.opacity_by.empty()) {
    refuse_given(command, {"--opacity-range"}, "opacity follows no value; add --opacity-by VALUE");
  }
  const bool by_value = !colored.empty() || (!options.width_by.empty() && !options.by_light());
  if (!by_value && !options.regions.empty()) {
    refuse_given(command, {"--no-legend"}, "without --legend TEXT there is none of tiles");
  } else if (!by_value) {
    refuse_given(command, {"--legend", "--no-legend"},
                 "there is none; add --color-by or --width-by VALUE, or --regions");
  }
  if (options.no_legend) refuse_given(command, {"--legend"}, "--no-legend leaves it out");
  if (options.discard && options.color_on == ColoredPart::surface) {
    refuse_given(command, {"--color-on"}, "nothing is seen of the surface between stripes");
  }
}

/// For tiles.
void check_motifs(const CLI::App& command, const StyleOptions& options, Drawn drawn) {
  const bool motifs = options.color_on == ColoredPart::motifs;
  if (options.color_on == ColoredPart::strokes) {
    refuse_given(command, {"--color-on"}, "tiles have no strokes; take surface or motifs");
  }
  if (motifs && drawn == Drawn::pictures && options.regions.empty()) {
    refuse_given(command, {"--color-on"}, "pictures have colours of their own");
  }
  if (motifs && std::ranges::any_of(options.regions, [](auto& r) { return r.color.has_value(); })) {
    refuse_given(command, {"--color-on"}, "regions have colours of their own; leave out @#RRGGBB");
  }
  if (options.discard && !motifs) {
    refuse_given(command, {"--color-by"},
                 "nothing is seen of the surface beside tiles; add --color-on motifs");
  }
}

void check_tiles(const CLI::App& command, const StyleOptions& options, Drawn drawn) {
  if (drawn != Drawn::stripes) {
    refuse_given(command,
                 {"--width-by", "--width-range", "--opacity-by", "--opacity-range", "--pixel-width",
                  "--stroke-spacing", "--tones", "--cross-hatch"},
                 "it is for stripes, not for textures");
    check_motifs(command, options, drawn);
  } else {
    if (options.color_on == ColoredPart::motifs) {
      refuse_given(command, {"--color-on"}, "stripes have no motifs; add --texture TILE");
    }
    refuse_given(command,
                 {"--texture-by", "--regions", "--texture-shift", "--texture-flow",
                  "--tile-size-by", "--tile-size-range", "--tiles"},
                 "stripes have no tiles; add --texture TILE");
  }
  if (options.tile_size_by.empty()) {
    refuse_given(command, {"--tile-size-range"}, "sizes follow no value; add --tile-size-by VALUE");
  }
  if (options.texture_by.empty()) {
    refuse_given(command, {"--regions"}, "tiles follow no value; add --texture-by VALUE");
  } else if (options.regions.empty()) {
    refuse_given(command, {"--texture-by"}, "there is one tile; add --regions FROM,TILE");
  }
}

void check_others(const CLI::App& command, const StyleOptions& options) {
  const bool outlined = std::ranges::any_of(options.others, &OtherSurfaceChoice::outlined);
  if (outlined && options.outline != OutlineStyle::none) {
    throw CLI::ValidationError(
        "--with", "@outlined has no effect here: --outline draws the silhouettes of all surfaces");
  }
  const bool tinted = std::ranges::all_of(options.others, &OtherSurfaceChoice::tinted);
  if (!tinted && options.depth_cue == DepthCue::none) {
    throw CLI::ValidationError("--with",
                               "@untinted has no effect here: nothing is tinted; add --depth-cue");
  }
  const bool whole = std::ranges::any_of(options.others, &OtherSurfaceChoice::whole);
  if (!whole) return;
  if (!is_given(command, "--slice")) {
    throw CLI::ValidationError("--with", "@whole has no effect here: nothing is cut; add --slice");
  }
  if (options.has_lines()) {
    throw CLI::ValidationError(
        "--with",
        "@whole goes without lines, which are cut as one; leave out --outline, --creases and "
        "@outlined");
  }
}

}  // namespace

void check_style_options(const CLI::App& command, const StyleOptions& options, Drawn drawn) {
  check_others(command, options);
  check_tiles(command, options, drawn);
  check_widths(command, options);
  check_colors(command, options);
  if (!options.has_lines()) {
    refuse_given(command, {"--hidden-lines", "--line-width"},
                 "no lines are drawn; add --outline solid, --creases DEG or --with MESH@outlined");
  }
}

void refuse_for_outlines(const CLI::App& command, const StyleOptions& options) {
  constexpr const char* kWhy =
      "outlines in drawings have one colour each and no background; write .png";
  refuse_given(command,
               {"--color-by", "--opacity-by", "--legend", "--no-legend", "--flat", "--transparent",
                "--depth-cue", "--occlusion", "--ground-shadow"},
               kWhy);
  for (const OtherSurfaceChoice& other : options.others) {
    if (!other.color_by.empty()) {
      throw CLI::ValidationError("--with", std::string("@color-by has no effect here: ") + kWhy);
    }
  }
}

std::vector<std::string> StyleOptions::color_values() const {
  std::vector<std::string> values;
  if (!color_by.empty()) values.push_back(color_by);
  for (const OtherSurfaceChoice& other : others) {
    const bool known = std::ranges::find(values, other.color_by) != values.end();
    if (!other.color_by.empty() && !known) values.push_back(other.color_by);
  }
  return values;
}

std::optional<ValueRange> StyleOptions::range_of_colors(const std::string& value) const {
  if (color_range && value == color_values().front()) return color_range;
  for (const OtherSurfaceChoice& other : others) {
    if (other.color_by == value && other.color_range) return other.color_range;
  }
  return std::nullopt;
}

bool StyleOptions::follows_camera() const {
  // Strokes by light are computed while drawing.
  const std::string width = by_light() ? "" : width_by;
  return std::ranges::any_of(std::array{width, color_by, opacity_by, texture_by, tile_size_by},
                             depends_on_camera);
}

bool StyleOptions::follows_field() const { return std::ranges::any_of(values(), depends_on_field); }

std::vector<UsedFile> style_files(const StyleOptions& options) {
  std::vector<UsedFile> files;
  const auto add = [&](const char* option, const std::string& value) {
    const std::string path = value_file(value);
    if (!path.empty()) files.push_back({option, path});
  };
  add("--width-by", options.width_by);
  add("--color-by", options.color_by);
  add("--opacity-by", options.opacity_by);
  add("--texture-by", options.texture_by);
  add("--tile-size-by", options.tile_size_by);
  for (const OtherSurfaceChoice& other : options.others) {
    if (!is_shape(SurfaceOptions{.mesh = other.mesh})) files.push_back({"--with", other.mesh});
    add("--with", other.color_by);
  }
  return files;
}

}  // namespace brindle::tool
