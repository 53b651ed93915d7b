/// Pictures of stripes and textures, with coloured triangles and marks on top (paper, Fig. 8).
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "brindle/broken_tiles.h"
#include "brindle/camera.h"
#include "brindle/corner_phases.h"
#include "brindle/export.h"
#include "brindle/image.h"
#include "brindle/mesh.h"
#include "brindle/phase_graph.h"
#include "brindle/progress.h"
#include "brindle/texture_waves.h"

namespace BRINDLE_EXPORT brindle {

/// A triangle's colour; `amount` 0 shows the stripes alone, 1 the colour alone.
struct TriangleColor {
  Color color;
  float amount = 0;
};

/// A disc that faces the camera, with a size in pixels, hidden by objects in front of it.
struct Mark {
  Vec3 position;
  Color color;
};

/// Coloured triangles and marks on top of a pattern.
struct Overlay {
  std::vector<TriangleColor> triangle_colors;  ///< one per triangle, or empty
  std::vector<Mark> marks;
};

/// Branches in red and singularities of the field in amber, each with a mark at its centre so that
/// tiny triangles are found. `corners` has one entry per triangle.
Overlay branch_overlay(const Mesh& mesh, std::span<const CornerPhases> corners);

/// One value per triangle through `error_color`, from 0 to `largest`; negative values and NaN (no
/// value) leave a triangle as it is.
Overlay error_overlay(std::span<const float> values, float largest);

/// Tiles that need no file: a motif in one colour on the ground of another. All but arrows and
/// scales are symmetric under 180 degrees about their middle and suit fields without orientation.
/// Checker, dots, plus and knurl are also symmetric under 90 degrees and suit cross fields.
enum class BuiltInTile {
  stripes,     ///< across U, as `Renderer` draws stripes of width 0.5
  checker,     ///< two by two squares, one in the middle
  dots,        ///< one in the middle
  arrows,      ///< one that points along U
  bricks,      ///< two courses along U, the second shifted by half a brick
  hatch,       ///< strokes along U, crossed by others along V
  plus,        ///< a plus sign
  minus,       ///< a minus sign along U
  plus_minus,  ///< a plus sign in the middle and a minus sign at the corner
  knurl,       ///< diamonds, pyramids as a relief
  weave,       ///< two strands along U over and under two along V
  scales       ///< two rows of scales that point along U
};

/// The names above, separated by `|`.
std::string_view built_in_tile_names();

/// The signed distance from texture coordinates to the motif's border, in sides of the tile,
/// negative inside; coordinates repeat after 1.
float tile_distance(BuiltInTile tile, float u, float v);

/// A built-in tile, or a picture whose transparent parts show the surface.
using TextureTile = std::variant<BuiltInTile, Image>;

/// The height of a tile as a relief, from 0 to 1. Motifs of built-in tiles are plateaus with steep
/// flanks, except for pyramids (knurl), strands (weave) and slopes (scales). Pictures have their
/// grey values, interpolated between pixels: black and transparent pixels are 0, white ones 1.
float tile_height(const TextureTile& tile, float u, float v);

/// The smallest detail of this height, in sides of the tile.
float tile_detail(const TextureTile& tile);

/// The motifs of a tile to keep whole: those of a built-in tile, or the part of a picture that is
/// not transparent.
TileMotifs tile_motifs(const TextureTile& tile);

/// As above for tiles that are moved by `shift`, and each shrunk about its middle to at most `size`
/// of its cell. A shrunk tile is one motif.
TileMotifs motifs_within(const TileMotifs& motifs, float size, const Eigen::Vector2f& shift);

/// Whether a tile's motif has room around it: arrows, dots, signs, bricks, knurl, and pictures
/// that are transparent all along their sides. Other tiles continue in the next one.
bool has_own_shape(const TextureTile& tile);

/// The tile as an opaque picture: a motif with smooth edges in `side` x `side` pixels, or a picture
/// over `ground`. U runs to the right, V up. Throws Error for sides that `check_image_size`
/// rejects.
Image tile_picture(const TextureTile& tile, int side, const Color& motif, const Color& ground);

/// A pixel's linear light, premultiplied by alpha: red, green, blue and alpha.
Eigen::Vector4f premultiplied_light(const Pixel& pixel);

/// The picture itself if no side is longer than `longest`, otherwise halved until none is: pixels
/// become means of their light.
Image reduced(Image image, int longest);

/// A drawing. Everything but the mesh may be empty: without normals facets are flat, without waves
/// the surface is plain. Triangles with a corner without a wave are plain, too.
struct SurfaceDrawing {
  const Mesh& mesh;
  std::span<const Vec3> normals = {};  ///< one unit normal per vertex
  const WaveSet* waves = nullptr;      ///< one wave per vertex; positions are the mesh's
  std::span<const Complex> z = {};     ///< one phase exp(i Phi) per vertex
  std::span<const TriangleColor> triangle_colors = {};  ///< one per triangle
  std::span<const Mark> marks = {};
  /// With `texture_tile`: a texture instead of stripes.
  const TextureWaves* texture_waves = nullptr;
  const TextureTile* texture_tile = nullptr;  ///< motifs have the colour of stripes
  /// Motifs of the tile to leave out, one entry per triangle; null: none.
  const BrokenTiles* broken_tiles = nullptr;
  std::span<const Vec3> framed = {};  ///< points that the camera frames; empty: the mesh's
};

/// Changes to an uploaded drawing. Empty spans and null waves keep the previous data; marks are
/// always replaced.
struct DrawingChange {
  std::span<const Vec3> positions = {};  ///< one per vertex
  std::span<const Vec3> normals = {};    ///< one per vertex
  const WaveSet* waves = nullptr;
  std::span<const Complex> z = {};
  std::span<const TriangleColor> triangle_colors = {};
  std::span<const Mark> marks = {};
  const TextureWaves* texture_waves = nullptr;  ///< of an uploaded texture
  const BrokenTiles* broken_tiles = nullptr;    ///< with `texture_waves`; null: none
};

/// The sampling of a picture.
enum class PictureQuality {
  interactive,  ///< one evaluation a pixel, silhouettes smoothed with 4 samples
  final         ///< `supersampling` evaluations along each side of a pixel, each with 4 samples
};

/// Options of a picture.
struct RenderOptions {
  int width = 1200;                               ///< pixels
  int height = 900;                               ///< pixels
  CameraView camera;                              ///< the mesh is framed from this side
  std::optional<LightDirection> light_from = {};  ///< empty: the upper left
  Color base_color{0.957f, 0.937f, 0.898f};
  Color stripe_color{0.110f, 0.196f, 0.353f};
  float stripe_width = 0.5f;  ///< share of the period, 0 to 1
  Color background_center{0.980f, 0.980f, 0.976f};
  Color background_edge{0.855f, 0.867f, 0.882f};
  bool transparent = false;  ///< no background: its alpha is 0
  bool shading = true;       ///< false: plain colours without light
  /// Pixels. Empty: in proportion to 6 pixels in a picture of 1200x900, at least 4.
  std::optional<float> mark_radius = {};
  PictureQuality quality = PictureQuality::final;
  int supersampling = 2;  ///< 1 to 4: evaluations along each side of a pixel of a final picture
  int tile_side = 2560;   ///< a picture is drawn in parts of at most this number squared of
                          ///< evaluations; at least 64
};

/// The radius of marks in a picture with these options, in pixels.
float mark_radius_of(const RenderOptions& options);

/// Colours that make overlays stand out: a light grey surface with faint stripes.
RenderOptions with_faint_stripes(RenderOptions options);

/// Draws in the OpenGL 4.5 context that is current at construction, which must be current whenever
/// the renderer is used or destroyed.
class Renderer {
 public:
  /// Throws Error, naming shader file and line, if the driver rejects the shaders.
  Renderer();
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Copies the drawing to OpenGL, in place of the last one. Throws Error if sizes do not match or
  /// the drawing is larger than the driver's buffers.
  void upload(const SurfaceDrawing& drawing);

  /// Copies what has changed since the last upload. The camera keeps framing the uploaded mesh, so
  /// that moving vertices do not move it. Throws as `upload` does.
  void update(const DrawingChange& change);

  /// Reads phases from another owner's OpenGL buffer, 2 floats a vertex, such as
  /// `GpuAnimator::phases`, until the next `upload`, or `update` with phases. Pictures show the
  /// buffer's content when they are drawn, without a copy. Throws Error if the buffer is too small.
  void use_phases(unsigned buffer);

  /// Draws the uploaded drawing. Pictures larger than the driver's framebuffers are drawn in tiles.
  /// Throws Error if an option is out of its range or the picture is beyond the limits of image.h;
  /// Cancelled if `progress` cancels, between one tile and the next.
  Image draw(const RenderOptions& options, const Progress& progress = {}) const;

 private:
  struct State;
  Pimpl<State> state_;
};

/// Draws one picture in a headless context of its own. Throws what HeadlessContext and Renderer do.
Image render_picture(const SurfaceDrawing& drawing, const RenderOptions& options = {},
                     const Progress& progress = {});

}  // namespace brindle
