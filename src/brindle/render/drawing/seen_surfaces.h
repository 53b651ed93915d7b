/// Visible surfaces at any point of a picture, also between pixels.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "brindle/camera.h"
#include "brindle/progress.h"
#include "brindle/render/drawing/cover.h"
#include "brindle/render/surface_light.h"
#include "brindle/styled_picture.h"

namespace brindle {

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
