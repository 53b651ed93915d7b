/// Glyphs at samples.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/glyphs.h"
#include "brindle/image.h"
#include "brindle/legend.h"
#include "brindle/styled_picture.h"
#include "input/preparation.h"
#include "pictures/picture.h"
#include "pictures/style_options.h"
#include "pictures/style_values.h"

namespace brindle::tool {

/// The glyph: a shape, or a picture on quads.
struct GlyphChoice {
  GlyphShape shape = GlyphShape::disc;
  std::string picture;  ///< of quads: a PNG file
};

struct GlyphOptions {
  GlyphChoice glyph;
  float size = 0.8f;  ///< share of the spacing
  std::string size_by;
  std::optional<ValueRange> size_range;  ///< shares of `size` at the smallest and largest value
  StyleOptions style;                    ///< its colours
};

void add_glyph_options(CLI::App& app, GlyphOptions& options);

/// Throws CLI::ValidationError for options without effect beside others.
void check_glyph_options(const CLI::App& command, const GlyphOptions& options);

/// Input files of values.
std::vector<UsedFile> glyph_files(const GlyphOptions& options);

/// Values of glyphs, one per vertex, and the picture of quads.
struct GlyphInput {
  std::optional<VertexValues> size, color;
  std::optional<Image> picture;  ///< of quads
};

/// The picture of quads; empty for other shapes. Throws what read_png throws.
std::optional<Image> read_glyph_picture(const GlyphOptions& options);

GlyphInput read_glyph_input(const GlyphOptions& options, const Preparation& prepared,
                            const SurfaceOptions& surface, const WaveOptions& waves,
                            const PictureOptions& picture);

/// Throws Error without an OpenGL context or if the file cannot be written.
void write_glyphs(const std::filesystem::path& path, const Surface& surface,
                  std::span<const Sample> samples, const GlyphOptions& options,
                  const GlyphInput& input, const PictureOptions& picture, const Progress& progress);

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
