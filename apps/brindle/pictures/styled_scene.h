/// The content of a styled picture: surfaces with patterns, and lines over them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brindle/legend.h"
#include "brindle/line_drawing.h"
#include "input/preparation.h"
#include "pictures/picture.h"
#include "pictures/stripe_result.h"
#include "pictures/style_values.h"

namespace brindle::tool {

/// Another surface of the picture, with its stripes or texture, if any.
struct OtherSurface {
  Surface surface;
  std::optional<StripeResult> result;
};

/// Reads the surfaces of --with; patterns get this frequency. Throws Error if one cannot be read.
std::vector<Preparation> read_others(const StyleOptions& style, const WaveOptions& waves,
                                     float frequency, const Viewpoint& viewpoint,
                                     JobListener& listener);

/// Solves for their stripes and textures.
std::vector<OtherSurface> solve_others(const StyleOptions& style, std::vector<Preparation> read,
                                       const StripeOptions& options, const Progress& progress);

/// The mean over all vertices with a wave.
float mean_frequency(const WaveSet& waves);

/// All meshes as one, framed by the camera.
Mesh framed_mesh(const Mesh& mesh, std::span<const Preparation> others);

struct StripesView {
  const WaveSet& waves;
  std::span<const Complex> z;
};

/// Null if tiles are cut.
using LeftOutTiles = std::shared_ptr<const BrokenTiles>;

struct TextureView {
  const TextureWaves& waves;
  const TextureTile& tile;
  Eigen::Vector2f shift{0, 0};                ///< in tiles
  std::span<const LeftOutTiles> broken = {};  ///< for the tile, then for those of regions
};

/// The broken motifs of a styled texture: of the tile, then of those of regions.
std::vector<LeftOutTiles> left_out_tiles(std::span<const Triangle> triangles,
                                         const TextureView& texture, const StyleOptions& style,
                                         const StyleBindings& followed, const WholeTiles& whole);

/// The input of a scene, by reference.
struct StyledScene {
  const Surface& surface;
  StripesView pattern;
  std::optional<StripesView> crossing;  ///< of cross-hatching
  std::span<const OtherSurface> others;
  std::optional<TextureView> texture = std::nullopt;  ///< instead of the pattern's stripes
};

/// The options that do not depend on the surfaces.
StyledOptions styled_options(const StyleOptions& style, const PictureOptions& picture,
                             const Eigen::Vector3d& origin, const StyleBindings& followed);

/// The surfaces of a picture; that with the pattern is first. They refer to the scene and to
/// `followed`.
std::vector<StyledSurface> surfaces_of(const StyledScene& scene, const StyleOptions& style,
                                       const RenderOptions& render, const StyleBindings& followed);

/// The first one alone.
StyledSurface main_surface(const StyledScene& scene, const StyleOptions& style,
                           const RenderOptions& render, const StyleBindings& followed);

/// The line width of outlines and creases, in pixels of a picture of this height.
float line_width_of(const StyleOptions& style, int height);

/// Outlines and creases over a picture of these surfaces, which may be larger than in `options`:
/// visibility then has the resolution of `options`.
void draw_lines(Image& image, const StyledScene& scene, std::span<const StyledSurface> surfaces,
                const StyleOptions& style, const StyledOptions& options, const Progress& progress);

/// The same as pens of a drawing, all coordinates times `scale`.
std::vector<Pen> pens_of_lines(const StyledScene& scene, std::span<const StyledSurface> surfaces,
                               const StyleOptions& style, const StyledOptions& options, float scale,
                               const Progress& progress);

}  // namespace brindle::tool
