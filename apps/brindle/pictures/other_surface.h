/// Other surfaces of a picture, each with a style of its own.
#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "brindle/styled_picture.h"

namespace brindle::tool {

/// What `parse_other_surface` reads, for messages.
inline constexpr const char* kOtherSurfaceForm =
    "MESH[@opaque|striped|discarded][@texture=TILE][@stripes=N][@rotate=DEG][@stripe-width=W]"
    "[@stripe-color=#rrggbb][@color-by=VALUE][@outlined][@untinted][@whole][@#rrggbb][@X,Y,Z]";

/// Of surfaces without stripes, and between stripes.
inline constexpr Color kOtherColor{0.74f, 0.42f, 0.33f};

struct OtherSurfaceChoice {
  std::string mesh;  ///< a file or shape:NAME
  bool striped = false;
  std::string tile;  ///< built-in, of a texture instead of stripes; empty: none
  BetweenStrokes between = BetweenStrokes::surface;  ///< discarded only with a pattern
  std::optional<float> stripes;       ///< along its own diagonal; else as dense as the first's
  std::optional<float> rotate_deg;    ///< else as the first's field is turned
  std::optional<float> stripe_width;  ///< share of the period; else that of the first
  std::optional<Color> stripe_color;  ///< of stripes and figures; else that of the first
  std::string color_by;               ///< value that colours follow; empty: none
  bool outlined = false;              ///< its silhouette is drawn
  bool tinted = true;                 ///< by --depth-cue
  bool whole = false;                 ///< whatever --slice takes away
  std::optional<Color> color;
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();

  bool has_pattern() const { return striped || !tile.empty(); }
  /// Whether it has anything that only patterns have.
  bool has_pattern_style() const { return stripes || rotate_deg || stripe_width || stripe_color; }
  /// Whether values colour its stripes or figures, and not the surface.
  bool colors_pattern() const {
    return !color_by.empty() && (striped || between == BetweenStrokes::discarded);
  }
  bool operator==(const OtherSurfaceChoice&) const = default;
};

/// "#1c325a"
std::string hex_color(const Color& color);

/// Throws CLI::ValidationError, naming the option, for anything else than `kOtherSurfaceForm`, for
/// numbers out of range, and for what has no effect beside the rest.
OtherSurfaceChoice parse_other_surface(const std::string& option, const std::string& text);

/// The text of which `parse_other_surface` makes the choice.
std::string text_of(const OtherSurfaceChoice& choice);

/// With another pattern, or none, and without what then has no effect. `tile` as in the choice.
OtherSurfaceChoice with_pattern(OtherSurfaceChoice choice, bool striped, const std::string& tile,
                                BetweenStrokes between);

/// With colours that follow a value, or none, and without what then has no effect.
OtherSurfaceChoice with_color_by(OtherSurfaceChoice choice, const std::string& value);

/// What its surface and its pattern follow from, without what it only looks like.
OtherSurfaceChoice without_looks(OtherSurfaceChoice choice);

}  // namespace brindle::tool
