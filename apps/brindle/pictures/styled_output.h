/// Pictures in the style that was asked for.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "input/preparation.h"
#include "input/solving_options.h"
#include "pictures/picture.h"
#include "pictures/style_values.h"
#include "pictures/styled_scene.h"

namespace brindle::tool {

/// All that a style follows, found before a long job begins.
struct StyleInput {
  StyleValues values;
  std::vector<Preparation> others;  ///< without waves unless they have a pattern
};

/// Reads values and other surfaces of a picture whose pattern has the waves `drawn`. Throws Error
/// for what is not there or does not fit.
StyleInput read_style_input(const StyleOptions& style, const Preparation& prepared,
                            const WaveSet& drawn, const SurfaceOptions& surface,
                            const WaveOptions& waves, const PictureOptions& picture,
                            JobListener& listener);

/// Its two parts, one after the other, for those who read only one of them again: other surfaces,
/// then values, which depend on these only if they follow the camera. `agreement` is that of a
/// measured field's data, or empty.
std::vector<Preparation> read_style_others(const StyleOptions& style, const Mesh& mesh,
                                           const WaveSet& drawn, const WaveOptions& waves,
                                           const PictureOptions& picture, JobListener& listener);
StyleValues read_style_values(const StyleOptions& style, const Preparation& prepared,
                              std::span<const Preparation> others, const SurfaceOptions& surface,
                              const WaveOptions& waves, const PictureOptions& picture,
                              std::span<const float> agreement);

/// What is drawn beside a pattern.
struct StylePatterns {
  std::shared_ptr<const StripePattern> crossing;  ///< of cross-hatching; else null
  std::shared_ptr<const std::vector<OtherSurface>> others;
};

/// Solves for strokes that cross the others; null if the style has none.
std::shared_ptr<const StripePattern> make_crossing(const Surface& surface,
                                                   const StripeResult& result,
                                                   const StyleOptions& style,
                                                   const StripeOptions& solving,
                                                   const Progress& progress);

/// Solves what the style needs beside the pattern; takes the other surfaces of `input`.
StylePatterns make_style_patterns(const Surface& surface, const StripeResult& result,
                                  const StyleOptions& style, StyleInput& input,
                                  const StripeOptions& solving, const Progress& progress);

/// A scene as the renderer takes it. Refers to what it was made of and to `followed`, which may be
/// moved but not copied.
struct StyledPicture {
  StyleBindings followed;
  std::vector<LeftOutTiles> broken;  ///< of a texture
  StyledScene scene;
  std::vector<StyledSurface> surfaces;
  StyledOptions options;

  StyledPicture(StyleBindings what, StyledScene drawn)
      : followed(std::move(what)), scene(std::move(drawn)) {}
  StyledPicture(StyledPicture&&) = default;
};

StyledPicture styled_picture(const Surface& surface, const StripeResult& result,
                             const StylePatterns& patterns, const StyleOptions& style,
                             const StyleInput& input, const PictureOptions& picture);

/// Outlines, creases and legends on the picture that the renderer has drawn with these options, or
/// on a larger one that was made of it.
void draw_on_top(Image& image, const StyledPicture& picture, const StyleOptions& style,
                 const StyledOptions& drawn, const Progress& progress);

/// A .png picture, or an .svg or .pdf drawing of stripes' outlines. Throws Error if no OpenGL
/// context is to be had or the file cannot be written; Cancelled if `progress` asks for it.
void write_styled_picture(const std::filesystem::path& path, const Surface& surface,
                          const StripeResult& result, const StylePatterns& patterns,
                          const StyleOptions& style, const StyleInput& input,
                          const PictureOptions& picture, const Progress& progress);

}  // namespace brindle::tool
