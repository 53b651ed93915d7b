/// Visible surfaces at any point of a picture, also between pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "brindle/camera.h"
#include "brindle/progress.h"
#include "brindle/render/surface_light.h"
#include "brindle/styled_picture.h"

namespace brindle {

// Whether strokes of a style, or motifs of a texture's tiles, cover a point.

/// A visible point of a triangle.
struct SeenPoint {
  const StyledSurface* surface = nullptr;
  std::size_t number = 0;  ///< of the surface, among all
  std::size_t triangle = 0;
  Vec3 barycentric = Vec3::Zero();
  /// The same half a step to the right, left, below and above in the picture; weights may be
  /// slightly negative.
  std::array<Vec3, 4> beside{};
  float step = 1;  ///< pixels
};

/// The layer that covers a point of a surface.
enum class Cover {
  plain,   ///< no pattern: no wave, or no value for the strokes
  ground,  ///< between strokes
  stroke
};

/// Twin of strokes.glsl with stripe_middle.glsl: the same ends of stripes, but unfiltered. `tone`
/// is the lightness of the surface there, 0 to 1.
Cover cover_at(const SeenPoint& point, float tone);

/// Whether strokes of the surface depend on the light.
bool follows_tone(const StyledSurface& surface);

/// Whether region borders depend on the pixel grid: each tile takes the value in its middle.
bool follows_values(const RegionTexture& texture);

/// The tile of the texture whose motif covers the point; empty if none does. Twin of
/// region_texture.glsl for unfiltered built-in tiles; picture tiles have no motif.
std::optional<std::size_t> tile_at(const SeenPoint& point);

/// Kinds of marks of a surface: one for strokes, or one per tile.
std::size_t mark_count(const StyledSurface& surface);

/// Codes of the surfaces, each followed by those of its marks; then the first free code. 0 is the
/// background.
std::vector<std::size_t> first_codes(std::span<const StyledSurface> surfaces);

/// Finds the nearest triangle at a picture point exactly, with lists of candidate triangles per
/// square of a few pixels instead of a depth grid.
class SeenSurfaces {
 public:
  /// `camera` is relative to the origin of the first surface. Surfaces and their arrays must
  /// outlive this object. Throws Cancelled.
  SeenSurfaces(std::span<const StyledSurface> surfaces, const Camera& camera,
               const PictureLight& light, int width, int height, const Progress& progress);

  /// The code at a point, in pixels from the upper left corner: background (0), surface s
  /// (`first_codes(surfaces)[s]`), its strokes (one more) or the motifs of its tile i (i + 1 more).
  /// 0 outside the picture.
  std::uint16_t code_at(double x, double y) const;

 private:
  /// A vertex in the camera: pixel coordinates times w, for weights linear on the surface; its
  /// depth along the viewing direction and its signed distance from the slice.
  struct Corner {
    double x, y, w, depth;
    double beyond;  ///< positive: cut away by the slice
  };
  struct Hit {
    std::size_t entry;
    std::array<double, 3> weights;
    bool from_behind;
  };

  void project(const StyledSurface& surface);
  void sort_into_squares(const Progress& progress);
  bool weights_at(std::size_t entry, double x, double y, Hit& hit) const;
  SeenPoint point_of(const Hit& hit, double x, double y) const;
  std::size_t surface_of(std::size_t entry) const;
  Cover cover_of(const SeenPoint& point, bool from_behind) const;
  std::uint16_t layer_of(const Hit& hit, double x, double y) const;
  bool is_open(const Hit& hit, double x, double y) const;
  float tone_of(const SeenPoint& point, bool from_behind) const;

  std::span<const StyledSurface> surfaces_;
  Camera camera_;
  Lights lights_;
  int width_, height_, columns_, rows_;
  std::vector<Corner> corners_;           // of all surfaces
  std::vector<std::size_t> first_entry_;  // of each surface: index of its first triangle among all
  std::vector<std::size_t> first_codes_;  // of each surface
  std::vector<std::array<std::size_t, 3>> triangles_;
  std::vector<std::size_t> square_begin_;  // of each square, in `listed_`
  std::vector<std::uint32_t> listed_;      // candidate triangles, ascending
};

}  // namespace brindle
