/// Other surfaces of a picture, each with a style of its own.
#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "brindle/styled_picture.h"

namespace brindle::tool {

/// What `parse_other_surface` reads, for messages.
inline constexpr const char* kOtherSurfaceForm =
    "MESH[@opaque|striped|discarded][@stripes=N][@rotate=DEG][@stripe-width=W]"
    "[@stripe-color=#rrggbb][@untinted][@whole][@#rrggbb][@X,Y,Z]";

/// Of surfaces without stripes, and between stripes.
inline constexpr Color kOtherColor{0.74f, 0.42f, 0.33f};

struct OtherSurfaceChoice {
  std::string mesh;  ///< a file or shape:NAME
  bool striped = false;
  BetweenStrokes between = BetweenStrokes::surface;  ///< discarded only if striped
  std::optional<float> stripes;       ///< along its own diagonal; else as dense as the first's
  std::optional<float> rotate_deg;    ///< else as the first's field is turned
  std::optional<float> stripe_width;  ///< share of the period; else that of the first
  std::optional<Color> stripe_color;  ///< else that of the first
  bool tinted = true;                 ///< by --depth-cue
  bool whole = false;                 ///< whatever --slice takes away
  std::optional<Color> color;
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();

  /// Whether it has anything that only stripes have.
  bool has_stripe_style() const { return stripes || rotate_deg || stripe_width || stripe_color; }
  bool operator==(const OtherSurfaceChoice&) const = default;
};

/// "#1c325a"
std::string hex_color(const Color& color);

/// Throws CLI::ValidationError, naming the option, for anything else than `kOtherSurfaceForm`, for
/// numbers out of range and for a style of stripes without stripes.
OtherSurfaceChoice parse_other_surface(const std::string& option, const std::string& text);

/// The text of which `parse_other_surface` makes the choice.
std::string text_of(const OtherSurfaceChoice& choice);

/// Without what only stripes have.
OtherSurfaceChoice without_stripe_style(OtherSurfaceChoice choice);

/// What its surface and its pattern follow from, without what it only looks like.
OtherSurfaceChoice without_looks(OtherSurfaceChoice choice);

}  // namespace brindle::tool
