/// Pictures of several surfaces, each with its own stroke style.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/image.h"
#include "brindle/progress.h"
#include "brindle/renderer.h"

namespace BRINDLE_EXPORT brindle {

/// The unit of a stroke's width.
enum class WidthUnit {
  period,  ///< a share of the period, 0 to 1
  pixels   ///< of the picture, near and far
};

/// Tones of strokes that follow the light: none where the surface is as light as `none`, full width
/// where it is as dark as `full`, tapering in between. Tones go from 0 (black) to 1 (white).
struct ToneRange {
  float none = 1;
  float full = 0;
  float least = 0;  ///< share of the width that remains at `none`
};

/// The strokes of one pattern. Spans are empty or have one entry per vertex; NaN entries leave the
/// surface plain.
struct Strokes {
  const WaveSet* waves = nullptr;   ///< one wave per vertex; positions are the mesh's
  std::span<const Complex> z = {};  ///< exp(i Phi)
  Color color{0.110f, 0.196f, 0.353f};
  float opacity = 1;  ///< 0 to 1, over the surface's colour
  float width = 0.5f;
  WidthUnit unit = WidthUnit::period;            ///< of `width` and `widths`
  std::span<const float> widths = {};            ///< replaces `width`
  std::span<const float> opacities = {};         ///< replaces `opacity`
  std::span<const float> color_places = {};      ///< in the picture's colour map; replaces `color`
  std::optional<ToneRange> tone = std::nullopt;  ///< varies widths with the light
  /// Least pixels between strokes: where they are more than twice as far apart on the screen,
  /// further strokes are added. 0: only the pattern's own strokes.
  float spacing = 0;
};

/// The area between strokes, and around the tiles of a texture.
enum class BetweenStrokes {
  surface,   ///< the surface
  discarded  ///< objects behind it, in their own colours; tiles stay where their opacity is above a
             ///< half
};

/// A texture's tile where a value is at least `from`.
struct RegionTile {
  TextureTile tile;
  Color color{0.110f, 0.196f, 0.353f};  ///< of the motif
  float from = 0;
  const BrokenTiles* broken = nullptr;  ///< its motifs to leave out; null: none
};

/// Tiles along two waves. The value at the middle of a tile selects it, so tiles stay whole.
struct RegionTexture {
  const TextureWaves* waves = nullptr;
  std::vector<RegionTile> tiles = {};  ///< by rising `from`; the first one's is ignored
  std::span<const float> values = {};  ///< one per vertex, NaN: no tile; empty: the first tile
  Eigen::Vector2f shift{0, 0};         ///< of all tiles, in tiles; moves textures over time
  /// The share of its cell that a tile fills along each side, up to 1; one per vertex. Tiles become
  /// separate decals around samples of the two patterns (samples.h). The share at the middle of a
  /// tile counts; NaN or 0: no tile. Empty: 1.
  std::span<const float> sizes = {};
  /// Places of motifs in the picture's colour map, one per vertex. That at the middle of a tile
  /// counts, so a motif has one colour. NaN: the tile's own. Tiles that are pictures keep theirs.
  std::span<const float> color_places = {};
};

/// A surface of a picture. Referenced objects must outlive the call.
struct StyledSurface {
  const Mesh& mesh;
  std::span<const Vec3> normals = {};  ///< one unit normal per vertex; empty: flat facets
  Color color{0.957f, 0.937f, 0.898f};
  std::vector<Strokes> strokes = {};  ///< up to two, the second over the first
  BetweenStrokes between = BetweenStrokes::surface;
  std::span<const float> color_places = {};             ///< as in Strokes; replaces `color`
  bool shading = true;                                  ///< false: plain colours without light
  std::optional<RegionTexture> texture = std::nullopt;  ///< instead of strokes
  bool tinted = true;  ///< false: the depth cue leaves its colours as they are
  bool sliced = true;  ///< false: the camera's slice leaves it whole
};

/// The mapping of values to colours, for all surfaces of a picture.
struct ColorScale {
  ColorMap map = ColorMap::viridis;
  /// A place in the map; from there on `beyond` is drawn.
  std::optional<float> threshold = std::nullopt;
  Color beyond{0.760f, 0.110f, 0.520f};  ///< the colour above `threshold`
};

/// Depth cues of a picture.
enum class DepthCue {
  none,
  chroma,  ///< near is red, far is blue (Ropinski et al. 2006)
  haze     ///< far parts fade into the background
};

/// Options of pictures of several surfaces.
struct StyledOptions {
  RenderOptions render;  ///< camera, size, background, shading, supersampling
  ColorScale scale;
  DepthCue depth_cue = DepthCue::none;
  float occlusion = 0;         ///< 0 to 1: darkness of creases and hollows
  bool ground_shadow = false;  ///< below all surfaces
  int right_margin = 0;        ///< pixels left free for legends
  /// Points that the camera frames, relative to the origin of the first surface; empty: all
  /// surfaces. Animations keep those of their first frame.
  std::span<const Vec3> framed = {};
};

/// Maps values linearly from `lowest` .. `highest` to `first` .. `last`, clamped; NaN stays NaN.
std::vector<float> rescaled(std::span<const float> values, float lowest, float highest, float first,
                            float last);

/// The points that a camera frames without `StyledOptions::framed`: those of all triangles,
/// relative to the origin of the first surface.
std::vector<Vec3> framed_points(std::span<const StyledSurface> surfaces);

/// The camera of pictures of these surfaces; coordinates are relative to the first one's origin.
Camera styled_camera(std::span<const StyledSurface> surfaces, const StyledOptions& options);

/// Draws in the OpenGL 4.5 context that is current at construction, which must be current whenever
/// the renderer is used or destroyed.
class StyledRenderer {
 public:
  /// Throws Error, naming shader file and line, if the driver rejects the shaders.
  StyledRenderer();
  ~StyledRenderer();
  StyledRenderer(StyledRenderer&&) noexcept;
  StyledRenderer& operator=(StyledRenderer&&) noexcept;

  /// Copies the surfaces to OpenGL, in place of the last ones. The camera frames all of them.
  /// Throws Error without a surface, and if sizes do not match, a number is out of range or a
  /// surface is larger than the driver's buffers.
  void upload(std::span<const StyledSurface> surfaces);

  /// Replaces the surface of this number, from 0. All others stay in OpenGL, as do unchanged tiles.
  /// Throws what `upload` does, and Error for a number out of range; then nothing changes.
  void update(std::size_t number, const StyledSurface& surface);

  /// Draws the uploaded surfaces. Every sample of the picture shows the nearest surface; samples
  /// between discarded strokes show the objects behind, unchanged. Throws Error if an option is out
  /// of range or the picture is beyond the limits of image.h; Cancelled if `progress` cancels,
  /// between one surface and the next.
  Image draw(const StyledOptions& options, const Progress& progress = {}) const;

 private:
  struct State;
  Pimpl<State> state_;
};

/// Draws one picture in a headless context of its own. Throws what HeadlessContext and
/// StyledRenderer do.
Image render_styled(std::span<const StyledSurface> surfaces, const StyledOptions& options = {},
                    const Progress& progress = {});

}  // namespace brindle
