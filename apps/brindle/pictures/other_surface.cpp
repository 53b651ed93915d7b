#include "pictures/other_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/base/text.h"
#include "brindle/render/parsed_words.h"
#include "cli/option_values.h"
#include "input/vertex_values.h"

namespace brindle::tool {
namespace {

Color color_in(const std::string& option, const std::string& text) {
  const auto color = parse_color(text);
  if (!color) wrong_usage(option, "colours like #1c325a, 1c325a or steelblue", text);
  return *color;
}

/// Rejects values that depend on the first surface's picture.
std::string value_of_other(const std::string& option, const std::string& text) {
  constexpr const char* kNames = "array:NAME|FILE.csv[:COLUMN]|distance:X,Y,Z|curvature|height";
  check_value_name(option, text, kNames);
  if (depends_on_camera(text) || depends_on_field(text)) {
    throw CLI::ValidationError(
        option, "'" + text + "' is a value of the first surface alone; take one of " + kNames);
  }
  return text;
}

/// Parses parts such as "stripes=30". False for other names.
bool take_named(const std::string& option, const std::string& name, const std::string& text,
                OtherSurfaceChoice& choice) {
  if (name == "stripes") {
    choice.stripes = parse_positive_number(option + " @stripes", text);
  } else if (name == "rotate") {
    choice.rotate_deg = parse_number(option + " @rotate", text);
  } else if (name == "stripe-width") {
    choice.stripe_width = parse_not_negative_number(option + " @stripe-width", text);
    if (*choice.stripe_width > 1) wrong_usage(option + " @stripe-width", "a share up to 1", text);
  } else if (name == "stripe-color") {
    choice.stripe_color = color_in(option + " @stripe-color", text);
  } else if (name == "texture") {
    if (!parse_built_in_tile(text)) {
      wrong_usage(option + " @texture", "one of " + std::string(built_in_tile_names()), text);
    }
    choice.tile = text;
  } else if (name == "color-by") {
    choice.color_by = value_of_other(option + " @color-by", text);
  } else {
    return false;
  }
  return true;
}

/// Parses the text after an @ sign. False if it is not valid.
bool take_part(const std::string& option, const std::string& part, OtherSurfaceChoice& choice) {
  const std::size_t equals = part.find('=');
  if (equals != part.npos) {
    return take_named(option, part.substr(0, equals), part.substr(equals + 1), choice);
  }
  if (part.find("..") != part.npos) {
    choice.color_range = parse_rising_range(option + " @color-by", part);
    return !choice.color_by.empty();
  }
  if (part == "striped") {
    choice.striped = true;
  } else if (part == "discarded") {
    choice.between = BetweenStrokes::discarded;
  } else if (part == "outlined") {
    choice.outlined = true;
  } else if (part == "untinted") {
    choice.tinted = false;
  } else if (part == "whole") {
    choice.whole = true;
  } else if (part.find(',') != part.npos) {
    choice.moved = parse_place(option, part);
  } else if (part != "opaque") {
    choice.color = parse_color(part);
    return choice.color.has_value();
  }
  return true;
}

/// The reason why a part of the choice has no effect, with a remedy; empty if all have.
std::string effectless_part(const OtherSurfaceChoice& choice) {
  if (choice.has_pattern_style() && !choice.has_pattern()) {
    return "has a style of stripes, and none: add @striped, @discarded or @texture=TILE";
  }
  if (choice.striped && !choice.tile.empty()) {
    return "has tiles instead of stripes: leave out @striped or @texture";
  }
  if (choice.stripe_width && !choice.tile.empty()) {
    return "has tiles, which are as wide as they are: leave out @stripe-width";
  }
  if (choice.stripe_color && choice.colors_pattern()) {
    return "has colours of @color-by where @stripe-color would be: leave out one of them";
  }
  if (choice.color && choice.colors_pattern() && choice.between == BetweenStrokes::discarded) {
    return "has colours of @color-by, and nothing is seen of @" + hex_color(*choice.color) +
           ": leave out one of them";
  }
  return "";
}

}  // namespace

std::string hex_color(const Color& color) {
  const auto channel = [](float value) {
    return static_cast<unsigned>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
  };
  return formatted("#%02x%02x%02x", channel(color.red), channel(color.green), channel(color.blue));
}

namespace {

/// The kind of a part that may occur once, such as a colour; empty for others.
std::string kind_of_part(const std::string& part) {
  if (part == "opaque" || part == "striped" || part == "discarded") {
    return "one of @opaque, @striped and @discarded";
  }
  if (part == "outlined" || part == "untinted" || part == "whole") return "";
  const std::size_t equals = part.find('=');
  if (equals != part.npos) return "one @" + part.substr(0, equals);
  if (part.find("..") != part.npos) return "one range";
  return part.find(',') != part.npos ? "one place" : "one colour";
}

void refuse_repeated(const std::string& option, const std::string& text,
                     const std::vector<std::string>& parts) {
  std::vector<std::string> kinds;
  for (const std::string& part : parts) {
    const std::string kind = kind_of_part(part);
    if (!kind.empty() && std::ranges::find(kinds, kind) != kinds.end()) {
      throw CLI::ValidationError(option, "'" + text + "' has more than " + kind + ": leave one");
    }
    kinds.push_back(kind);
  }
}

}  // namespace

OtherSurfaceChoice parse_other_surface(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = split(text, '@');
  OtherSurfaceChoice choice;
  choice.mesh = parts.front();
  if (choice.mesh.empty()) wrong_usage(option, kOtherSurfaceForm, text);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (!take_part(option, parts[i], choice)) wrong_usage(option, kOtherSurfaceForm, text);
  }
  refuse_repeated(option, text, {parts.begin() + 1, parts.end()});
  const bool alone = choice.between == BetweenStrokes::discarded;
  if (alone && choice.tile.empty()) choice.striped = true;
  const std::string why = effectless_part(choice);
  if (!why.empty()) throw CLI::ValidationError(option, "'" + text + "' " + why);
  return choice;
}

std::string text_of(const OtherSurfaceChoice& choice) {
  std::string text = choice.mesh;
  if (choice.between == BetweenStrokes::discarded) {
    text += "@discarded";
  } else if (choice.striped) {
    text += "@striped";
  }
  if (!choice.tile.empty()) text += "@texture=" + choice.tile;
  const auto add = [&](std::string_view name, const std::optional<float>& value) {
    if (value) text += "@" + std::string(name) + formatted("=%.9g", static_cast<double>(*value));
  };
  add("stripes", choice.stripes);
  add("rotate", choice.rotate_deg);
  add("stripe-width", choice.stripe_width);
  if (choice.stripe_color) text += "@stripe-color=" + hex_color(*choice.stripe_color);
  if (!choice.color_by.empty()) text += "@color-by=" + choice.color_by;
  if (const auto& range = choice.color_range) {
    text += formatted("@%.9g..%.9g", static_cast<double>(range->lowest),
                      static_cast<double>(range->highest));
  }
  if (choice.outlined) text += "@outlined";
  if (!choice.tinted) text += "@untinted";
  if (choice.whole) text += "@whole";
  if (choice.color) text += "@" + hex_color(*choice.color);
  if (!choice.moved.isZero(0)) {
    text += formatted("@%.17g,%.17g,%.17g", choice.moved.x(), choice.moved.y(), choice.moved.z());
  }
  return text;
}

namespace {

OtherSurfaceChoice without_effectless(OtherSurfaceChoice choice) {
  if (!choice.has_pattern()) {
    choice.stripes.reset();
    choice.rotate_deg.reset();
  }
  if (!choice.striped) choice.stripe_width.reset();
  if (!choice.has_pattern() || choice.colors_pattern()) choice.stripe_color.reset();
  if (choice.colors_pattern() && choice.between == BetweenStrokes::discarded) choice.color.reset();
  return choice;
}

}  // namespace

OtherSurfaceChoice with_pattern(OtherSurfaceChoice choice, bool striped, const std::string& tile,
                                BetweenStrokes between) {
  choice.striped = striped;
  choice.tile = tile;
  choice.between = between;
  return without_effectless(std::move(choice));
}

OtherSurfaceChoice with_color_by(OtherSurfaceChoice choice, const std::string& value) {
  if (choice.color_by != value) choice.color_range.reset();
  choice.color_by = value;
  return without_effectless(std::move(choice));
}

OtherSurfaceChoice without_looks(OtherSurfaceChoice choice) {
  choice.between = BetweenStrokes::surface;
  choice.stripe_width.reset();
  choice.stripe_color.reset();
  choice.color_by.clear();
  choice.color_range.reset();
  choice.outlined = false;
  choice.color.reset();
  choice.tinted = true;
  choice.whole = false;
  return choice;
}

}  // namespace brindle::tool
