/// Output of styled pictures.
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

/// The input of a style, read before a long job.
struct StyleInput {
  StyleValues values;
  std::vector<Preparation> others;  ///< with waves only if they have a pattern
};

/// Reads values and other surfaces for a pattern with the waves `drawn`. Throws Error for input
/// that is missing or does not fit.
StyleInput read_style_input(const StyleOptions& style, const Preparation& prepared,
                            const WaveSet& drawn, const SurfaceOptions& surface,
                            const WaveOptions& waves, const PictureOptions& picture,
                            JobListener& listener);

/// Its two parts, to reread only one: other surfaces, then values, which depend on the surfaces
/// only if they depend on the camera. `coherence` is the coherence of a measured field's data, or
/// empty.
std::vector<Preparation> read_style_others(const StyleOptions& style, const Mesh& mesh,
                                           const WaveSet& drawn, const WaveOptions& waves,
                                           const PictureOptions& picture, JobListener& listener);
StyleValues read_style_values(const StyleOptions& style, const Preparation& prepared,
                              std::span<const Preparation> others, const SurfaceOptions& surface,
                              const WaveOptions& waves, const PictureOptions& picture,
                              std::span<const float> coherence);

/// Patterns besides the main one.
struct StylePatterns {
  std::shared_ptr<const StripePattern> crossing;  ///< of cross-hatching; else null
  std::shared_ptr<const std::vector<OtherSurface>> others;
};

/// Solves for crossing strokes; null if the style has none.
std::shared_ptr<const StripePattern> make_crossing(const Surface& surface,
                                                   const StripeResult& result,
                                                   const StyleOptions& style,
                                                   const StripeOptions& solving,
                                                   const Progress& progress);

/// Solves for the style's further patterns; moves the other surfaces of `input`.
StylePatterns make_style_patterns(const Surface& surface, const StripeResult& result,
                                  const StyleOptions& style, StyleInput& input,
                                  const StripeOptions& solving, const Progress& progress);

/// The renderer's scene. It refers to its sources and to `followed`, which may be moved but not
/// copied.
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

/// Outlines, creases and legends over the renderer's picture with these options, or over an
/// enlarged copy.
void draw_on_top(Image& image, const StyledPicture& picture, const StyleOptions& style,
                 const StyledOptions& drawn, const Progress& progress);

/// A .png picture, or an .svg or .pdf drawing of stripe outlines. Throws Error without an OpenGL
/// context or if the file cannot be written; throws Cancelled.
void write_styled_picture(const std::filesystem::path& path, const Surface& surface,
                          const StripeResult& result, const StylePatterns& patterns,
                          const StyleOptions& style, const StyleInput& input,
                          const PictureOptions& picture, const Progress& progress);

}  // namespace brindle::tool
