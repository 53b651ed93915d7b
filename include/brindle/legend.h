/// Legends for colours, widths and tiles of pictures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brindle/export.h"
#include "brindle/image.h"
#include "brindle/styled_picture.h"

namespace BRINDLE_EXPORT brindle {

/// A tile of a texture and its meaning.
struct LegendTile {
  TextureTile tile;
  Color motif{0.110f, 0.196f, 0.353f};
  std::string meaning;  ///< in characters that titles may have: "from 0.4"
};

/// A bar beside a picture that shows colours, widths of strokes or both over a range of values; or
/// a list of tiles and their meanings.
struct Legend {
  std::string title;  ///< with the unit: "speed in m/s"; letters, digits and characters of units
  float lowest = 0;
  float highest = 1;
  std::optional<ColorScale> scale = std::nullopt;  ///< empty: the colour `ink`
  /// Widths of strokes at the lowest and at the highest value, in any unit; only their ratio is
  /// shown.
  std::optional<Eigen::Vector2f> widths = std::nullopt;
  std::vector<LegendTile> tiles = {};    ///< instead of a bar, from the top
  Color ground{0.957f, 0.937f, 0.898f};  ///< behind the motifs of tiles
  Color ink{0.16f, 0.17f, 0.19f};        ///< of letters and lines
};

/// The width in pixels of the strip that legends need at the right of a picture of this size.
int legend_width(const std::vector<Legend>& legends, int width, int height);

/// Draws legends, from the top, into the `legend_width` pixels at the picture's right side. Throws
/// Error for ends that are not finite.
void draw_legends(Image& image, const std::vector<Legend>& legends);

}  // namespace brindle
