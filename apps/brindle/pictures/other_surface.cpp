#include "pictures/other_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/base/formatted.h"
#include "brindle/render/parsed_words.h"
#include "cli/option_values.h"

namespace brindle::tool {
namespace {

Color color_in(const std::string& option, const std::string& text) {
  const auto color = parse_color(text);
  if (!color) wrong_usage(option, "colours like #1c325a, 1c325a or steelblue", text);
  return *color;
}

/// "stripes=30" and the like. False for other names.
bool take_stripe_style(const std::string& option, const std::string& name, const std::string& text,
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
  } else {
    return false;
  }
  return true;
}

/// What stands behind a sign. False for anything that it may not be.
bool take_part(const std::string& option, const std::string& part, OtherSurfaceChoice& choice) {
  const std::size_t equals = part.find('=');
  if (equals != part.npos) {
    return take_stripe_style(option, part.substr(0, equals), part.substr(equals + 1), choice);
  }
  if (part == "striped" || part == "discarded") {
    choice.striped = true;
    if (part == "discarded") choice.between = BetweenStrokes::discarded;
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

}  // namespace

std::string hex_color(const Color& color) {
  const auto channel = [](float value) {
    return static_cast<unsigned>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
  };
  return formatted("#%02x%02x%02x", channel(color.red), channel(color.green), channel(color.blue));
}

OtherSurfaceChoice parse_other_surface(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = split(text, '@');
  OtherSurfaceChoice choice;
  choice.mesh = parts.front();
  if (choice.mesh.empty()) wrong_usage(option, kOtherSurfaceForm, text);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (!take_part(option, parts[i], choice)) wrong_usage(option, kOtherSurfaceForm, text);
  }
  if (choice.has_stripe_style() && !choice.striped) {
    throw CLI::ValidationError(option, "'" + text +
                                           "' has a style of stripes, and none: add @striped or "
                                           "@discarded");
  }
  return choice;
}

std::string text_of(const OtherSurfaceChoice& choice) {
  std::string text = choice.mesh;
  if (choice.striped) {
    text += choice.between == BetweenStrokes::discarded ? "@discarded" : "@striped";
  }
  const auto add = [&](std::string_view name, const std::optional<float>& value) {
    if (value) text += "@" + std::string(name) + formatted("=%.9g", static_cast<double>(*value));
  };
  add("stripes", choice.stripes);
  add("rotate", choice.rotate_deg);
  add("stripe-width", choice.stripe_width);
  if (choice.stripe_color) text += "@stripe-color=" + hex_color(*choice.stripe_color);
  if (!choice.tinted) text += "@untinted";
  if (choice.whole) text += "@whole";
  if (choice.color) text += "@" + hex_color(*choice.color);
  if (!choice.moved.isZero(0)) {
    text += formatted("@%.17g,%.17g,%.17g", choice.moved.x(), choice.moved.y(), choice.moved.z());
  }
  return text;
}

OtherSurfaceChoice without_stripe_style(OtherSurfaceChoice choice) {
  choice.stripes.reset();
  choice.rotate_deg.reset();
  choice.stripe_width.reset();
  choice.stripe_color.reset();
  return choice;
}

OtherSurfaceChoice without_looks(OtherSurfaceChoice choice) {
  choice.between = BetweenStrokes::surface;
  choice.stripe_width.reset();
  choice.stripe_color.reset();
  choice.color.reset();
  choice.tinted = true;
  choice.whole = false;
  return choice;
}

}  // namespace brindle::tool
