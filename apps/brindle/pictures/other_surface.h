/// Other surfaces of a picture, each with its own style.
#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "brindle/styled_picture.h"
#include "cli/option_values.h"

namespace brindle::tool {

/// The syntax of `parse_other_surface`, for messages.
inline constexpr const char* kOtherSurfaceForm =
    "MESH[@opaque|striped|discarded][@texture=TILE][@stripes=N][@rotate=DEG][@stripe-width=W]"
    "[@stripe-color=#rrggbb][@color-by=VALUE[@A..B]][@outlined][@untinted][@whole][@#rrggbb][@X,Y,"
    "Z]";

/// The colour without stripes, and between stripes.
inline constexpr Color kOtherColor{0.74f, 0.42f, 0.33f};

struct OtherSurfaceChoice {
  std::string mesh;  ///< a file or shape:NAME
  bool striped = false;
  std::string tile;  ///< built-in tile, instead of stripes; empty: none
  BetweenStrokes between = BetweenStrokes::surface;  ///< discarded only with a pattern
  std::optional<float> stripes;           ///< along its own diagonal; empty: the first's density
  std::optional<float> rotate_deg;        ///< empty: the first's turn
  std::optional<float> stripe_width;      ///< share of the period; empty: the first's
  std::optional<Color> stripe_color;      ///< of stripes and motifs; empty: the first's
  std::string color_by;                   ///< value of the colours; empty: none
  std::optional<ValueRange> color_range;  ///< of the colour map; empty: all values
  bool outlined = false;                  ///< its silhouette is drawn
  bool tinted = true;                     ///< by --depth-cue
  bool whole = false;                     ///< ignores --slice
  std::optional<Color> color;
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();

  bool has_pattern() const { return striped || !tile.empty(); }
  /// Whether it has any part for patterns only.
  bool has_pattern_style() const { return stripes || rotate_deg || stripe_width || stripe_color; }
  /// Whether values colour its stripes or motifs instead of the surface.
  bool colors_pattern() const {
    return !color_by.empty() && (striped || between == BetweenStrokes::discarded);
  }
  bool operator==(const OtherSurfaceChoice&) const = default;
};

/// "#1c325a"
std::string hex_color(const Color& color);

/// Throws CLI::ValidationError with the option for text other than `kOtherSurfaceForm`, numbers out
/// of range, and parts without effect.
OtherSurfaceChoice parse_other_surface(const std::string& option, const std::string& text);

/// The text that `parse_other_surface` parses to this choice.
std::string text_of(const OtherSurfaceChoice& choice);

/// With another pattern or none, dropping parts that lose their effect. `tile` as in the choice.
OtherSurfaceChoice with_pattern(OtherSurfaceChoice choice, bool striped, const std::string& tile,
                                BetweenStrokes between);

/// With colours by a value or none, dropping parts that lose their effect.
OtherSurfaceChoice with_color_by(OtherSurfaceChoice choice, const std::string& value);

/// The parts that its surface and pattern depend on, without its look.
OtherSurfaceChoice without_looks(OtherSurfaceChoice choice);

}  // namespace brindle::tool
