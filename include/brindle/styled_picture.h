/// Pictures of several surfaces, each with strokes of its own style.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "brindle/color_map.h"
#include "brindle/export.h"
#include "brindle/progress.h"
#include "brindle/renderer.h"

namespace BRINDLE_EXPORT brindle {

/// What a stroke's width is measured in.
enum class WidthUnit {
  period,  ///< a share of the period, 0 to 1
  pixels   ///< of the picture: about the same on the whole screen
};

/// Strokes that follow the light: none where the surface is as light as `none`, at their full width
/// where it is as dark as `full`, tapering in between. Tones go from 0 (black) to 1 (white).
struct ToneRange {
  float none = 1;
  float full = 0;
  float least = 0;  ///< share of the width that is left where there would be none
};

/// The strokes of one pattern. Spans are empty or have an entry per vertex; where an entry is NaN,
/// the surface is plain.
struct Strokes {
  const WaveSet* waves = nullptr;   ///< one wave per vertex; positions are the mesh's
  std::span<const Complex> z = {};  ///< exp(i Phi)
  Color color{0.110f, 0.196f, 0.353f};
  float opacity = 1;  ///< 0 to 1, over the surface's colour
  float width = 0.5f;
  WidthUnit unit = WidthUnit::period;        ///< of `width` and `widths`
  std::span<const float> widths = {};        ///< instead of `width`
  std::span<const float> opacities = {};     ///< instead of `opacity`
  std::span<const float> color_places = {};  ///< in the picture's colour map, instead of `color`
  std::optional<ToneRange> tone = std::nullopt;  ///< shades strokes
  /// Pixels between strokes, or up to twice as many: where they lie farther apart on the screen,
  /// further ones grow between them. 0: the pattern's own strokes alone.
  float spacing = 0;
};

/// What is seen between strokes, and beside the tiles of a texture.
enum class BetweenStrokes {
  surface,   ///< the surface
  discarded  ///< what lies behind, in its own colours; tiles are there where they are opaque by
             ///< half
};

/// A texture's tile where a value is at least `from`.
struct RegionTile {
  TextureTile tile;
  Color color{0.110f, 0.196f, 0.353f};  ///< of a figure
  float from = 0;
  const BrokenTiles* broken = nullptr;  ///< its figures to leave out; null: none
};

/// Tiles along two waves; tiles are whole: the value in the middle of one says which it is.
struct RegionTexture {
  const TextureWaves* waves = nullptr;
  std::vector<RegionTile> tiles = {};  ///< by rising `from`; the first one's does not count
  std::span<const float> values = {};  ///< one per vertex, NaN: no tile; empty: the first tile
  Eigen::Vector2f shift{0, 0};         ///< of all tiles, in tiles: lets textures flow with time
  /// How much of its place a tile fills, along each side and up to 1, one share per vertex: tiles
  /// become decals, apart from each other, around samples of the two patterns (samples.h). That in
  /// the middle of a tile counts; where it is NaN or 0 there is no tile. Empty: all of it.
  std::span<const float> sizes = {};
  /// Of figures, in the picture's colour map, one per vertex: that in the middle of a tile counts,
  /// so that a figure has one colour. NaN: the tile's own. Tiles that are pictures keep theirs.
  std::span<const float> color_places = {};
};

/// A surface of a picture. What it refers to must live as long as the call that it is given to.
struct StyledSurface {
  const Mesh& mesh;
  std::span<const Vec3> normals = {};  ///< one unit normal per vertex; empty: flat facets
  Color color{0.957f, 0.937f, 0.898f};
  std::vector<Strokes> strokes = {};  ///< up to two, the second over the first
  BetweenStrokes between = BetweenStrokes::surface;
  std::span<const float> color_places = {};             ///< as those of strokes, instead of `color`
  bool shading = true;                                  ///< false: plain colours without light
  std::optional<RegionTexture> texture = std::nullopt;  ///< instead of strokes
  bool tinted = true;  ///< false: the picture's depth cue leaves its colours as they are
  bool sliced = true;  ///< false: the camera's slice leaves it whole
};

/// How values become colours, for all surfaces of a picture.
struct ColorScale {
  ColorMap map = ColorMap::viridis;
  std::optional<float> threshold = std::nullopt;  ///< a place in the map, from which on
  Color beyond{0.760f, 0.110f, 0.520f};           ///< this is the colour
};

/// What lets depth be seen.
enum class DepthCue {
  none,
  chroma,  ///< near is red, far is blue (Ropinski et al. 2006)
  haze     ///< what is far fades into the background
};

struct StyledOptions {
  RenderOptions render;  ///< camera, size, background, shading, supersampling
  ColorScale scale;
  DepthCue depth_cue = DepthCue::none;
  float occlusion = 0;         ///< 0 to 1: how dark creases and hollows are
  bool ground_shadow = false;  ///< below all surfaces
  int right_margin = 0;        ///< pixels left free, for legends
  /// Points that the camera frames, relative to the origin of the first surface; empty: all
  /// surfaces. Moving pictures keep those of their first frame.
  std::span<const Vec3> framed = {};
};

/// Values from `lowest` .. `highest` to `first` .. `last`, evenly, and no further; NaN stays NaN.
std::vector<float> rescaled(std::span<const float> values, float lowest, float highest, float first,
                            float last);

/// What a camera frames unless `StyledOptions::framed` says otherwise: the points of all triangles,
/// relative to the origin of the first surface.
std::vector<Vec3> framed_points(std::span<const StyledSurface> surfaces);

/// Where pictures of these surfaces are taken from; coordinates are relative to the first one's
/// origin.
Camera styled_camera(std::span<const StyledSurface> surfaces, const StyledOptions& options);

/// Draws in the OpenGL 4.5 context that is current when it is made; that context must be
/// current whenever it is used or destroyed.
class StyledRenderer {
 public:
  /// Throws Error, naming shader file and line, if the driver does not take the shaders.
  StyledRenderer();
  ~StyledRenderer();
  StyledRenderer(StyledRenderer&&) noexcept;
  StyledRenderer& operator=(StyledRenderer&&) noexcept;

  /// Copies the surfaces to OpenGL, in place of the last ones. The camera frames all of them.
  /// Throws Error if there is none, sizes do not match, a number is out of its range or a surface
  /// is larger than the driver's buffers.
  void upload(std::span<const StyledSurface> surfaces);

  /// Copies one surface anew, in place of that of this number, from 0; all others stay in OpenGL as
  /// they are, and so do tiles that are the same. Throws what `upload` does, and Error for a number
  /// that there is not; then all is as it was.
  void update(std::size_t number, const StyledSurface& surface);

  /// Draws what was uploaded. Every sample of the picture shows the surface nearest to the viewer
  /// there; samples between discarded strokes show what lies behind, untouched. Throws Error if an
  /// option is out of its range or the picture is beyond the limits of image.h; Cancelled if
  /// `progress` asks for it, between one surface and the next.
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
