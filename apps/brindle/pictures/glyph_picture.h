/// Glyphs at samples as a picture shows them.
#pragma once

#include <span>
#include <vector>

#include "brindle/legend.h"
#include "brindle/styled_picture.h"
#include "pictures/glyph_options.h"

namespace brindle::tool {

/// What the renderer takes. Refers to the surface, and to what it holds itself, so it stays where
/// it was made.
class GlyphPicture {
 public:
  GlyphPicture(const Surface& surface, std::span<const Sample> samples, const GlyphOptions& options,
               const GlyphInput& input, const PictureOptions& picture, const Progress& progress);
  GlyphPicture(const GlyphPicture&) = delete;
  GlyphPicture& operator=(const GlyphPicture&) = delete;

  std::vector<StyledSurface> surfaces;  ///< first that with the samples
  StyledOptions styled;
  std::vector<Legend> legends;  ///< to be drawn on top

 private:
  void add_colors(std::span<const Sample> samples, const Mesh& mesh, const GlyphOptions& options,
                  const GlyphInput& input);
  StyledSurface figures(const GlyphOptions& options, const GlyphInput& input) const;

  Glyphs glyphs_;
  std::vector<float> places_;  ///< in the colour map
};

}  // namespace brindle::tool
