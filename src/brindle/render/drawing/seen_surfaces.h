/// What is seen at any point of a picture, between pixels as well.
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

/// How many kinds of marks a surface has: one of strokes, or one of every tile.
std::size_t mark_count(const StyledSurface& surface);

/// The codes of the surfaces themselves, those of their marks behind each; then the first that is
/// free. 0 is nothing.
std::vector<std::size_t> first_codes(std::span<const StyledSurface> surfaces);

/// Finds the nearest triangle at a point of the picture, exactly: no grid of depths is kept, only
/// lists of the triangles that may be seen in each square of a few pixels.
class SeenSurfaces {
 public:
  /// `camera` is relative to the origin of the first surface. Surfaces and what they refer to must
  /// live as long as this. Throws Cancelled if `progress` asks for it.
  SeenSurfaces(std::span<const StyledSurface> surfaces, const Camera& camera,
               const PictureLight& light, int width, int height, const Progress& progress);

  /// What is seen at a point, in pixels from the upper left corner: nothing (0), surface number s
  /// (`first_codes(surfaces)[s]`), its strokes (one more) or, of a texture, the figures of its tile
  /// i (i + 1 more). Beyond the picture nothing is.
  std::uint16_t code_at(double x, double y) const;

 private:
  /// A vertex as the camera sees it: places in pixels times w, for weights that are linear on the
  /// surface; the distance along the viewing direction, and that from the camera's slice.
  struct Corner {
    double x, y, w, depth;
    double beyond;  ///< the slice, and so not seen; below 0: on this side of it
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
  std::vector<std::size_t> first_entry_;  // of each surface: its triangles among all
  std::vector<std::size_t> first_codes_;  // of each surface
  std::vector<std::array<std::size_t, 3>> triangles_;
  std::vector<std::size_t> square_begin_;  // of each square, in `listed_`
  std::vector<std::uint32_t> listed_;      // triangles that may be seen there, in order
};

}  // namespace brindle
