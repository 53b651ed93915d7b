/// What colours, widths and tiles of a picture mean.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brindle/export.h"
#include "brindle/image.h"
#include "brindle/styled_picture.h"

namespace BRINDLE_EXPORT brindle {

/// A tile of a texture and what it stands for.
struct LegendTile {
  TextureTile tile;
  Color figure{0.110f, 0.196f, 0.353f};
  std::string meaning;  ///< in the signs that titles may have: "from 0.4"
};

/// A bar beside a picture: colours, widths of strokes, or both, of the values between two ends; or
/// tiles and their meanings.
struct Legend {
  std::string title;  ///< with the unit: "speed in m/s". Letters, digits and the signs of units
  float lowest = 0;
  float highest = 1;
  std::optional<ColorScale> scale = std::nullopt;  ///< else `ink`
  /// Widths of strokes at the lowest and at the highest value, in any unit: what they are to each
  /// other is shown.
  std::optional<Eigen::Vector2f> widths = std::nullopt;
  std::vector<LegendTile> tiles = {};    ///< instead of a bar, the first one on top
  Color ground{0.957f, 0.937f, 0.898f};  ///< behind the figures of tiles
  Color ink{0.16f, 0.17f, 0.19f};        ///< of letters and lines
};

/// Pixels at the right side that legends of a picture of this size need.
int legend_width(const std::vector<Legend>& legends, int width, int height);

/// Draws legends, the first on top, into the `legend_width` pixels at the picture's right side.
/// Throws Error for ends that are no numbers.
void draw_legends(Image& image, const std::vector<Legend>& legends);

}  // namespace brindle
