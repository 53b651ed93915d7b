/// Glyphs at samples in a picture.
#pragma once

#include <span>
#include <vector>

#include "brindle/legend.h"
#include "brindle/styled_picture.h"
#include "pictures/glyph_options.h"

namespace brindle::tool {

/// The renderer's input. It refers to the surface and to its own members, so it must not move.
class GlyphPicture {
 public:
  GlyphPicture(const Surface& surface, std::span<const Sample> samples, const GlyphOptions& options,
               const GlyphInput& input, const PictureOptions& picture, const Progress& progress);
  GlyphPicture(const GlyphPicture&) = delete;
  GlyphPicture& operator=(const GlyphPicture&) = delete;

  std::vector<StyledSurface> surfaces;  ///< the surface with the samples is first
  StyledOptions styled;
  std::vector<Legend> legends;  ///< drawn over the picture

 private:
  void add_colors(std::span<const Sample> samples, const Mesh& mesh, const GlyphOptions& options,
                  const GlyphInput& input);
  StyledSurface motifs(const GlyphOptions& options, const GlyphInput& input) const;

  Glyphs glyphs_;
  std::vector<float> places_;  ///< positions in the colour map
};

}  // namespace brindle::tool
