/// Outlines of regions of a function on the plane, at sub-grid precision.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "brindle/line_drawing.h"
#include "brindle/progress.h"

namespace brindle {

/// A closed line, without repeating the first point.
using OutlineLoop = std::vector<Eigen::Vector2d>;

/// Samples a picture at every half pixel, so that wider regions are never missed, and locates the
/// outlines by bisection.
class RegionTracer {
 public:
  using CodeAt = std::function<std::uint16_t(double x, double y)>;

  /// `code_at` maps a point, in pixels from the upper left corner, to its region code; 0 outside
  /// the picture. It must outlive this object and is called from many threads. Throws Cancelled.
  RegionTracer(int width, int height, const CodeAt& code_at, const Progress& progress);

  /// Closed outlines of all codes from `first` to `last`, which are on their left on the screen;
  /// holes run the other way. Points are within a thousandth of a pixel of the change, and
  /// lines within `tolerance` pixels, for outlines that do not turn within a tenth of a pixel.
  /// Throws Cancelled.
  std::vector<OutlineLoop> outlines(std::uint16_t first, std::uint16_t last, double tolerance,
                                    const Progress& progress) const;

 private:
  struct Region {
    std::uint16_t first, last;
    bool has(std::uint16_t code) const { return first <= code && code <= last; }
  };
  /// A line enters a cell across `edge` and leaves it across `next`. Edge 2 p runs from grid point
  /// p to the right, edge 2 p + 1 downwards.
  struct Passage {
    std::size_t edge, next;
  };

  std::size_t point_number(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  Eigen::Vector2d place_of(std::size_t point) const;
  bool covered(const Region& region, const Eigen::Vector2d& place) const {
    return region.has(code_at_(place.x(), place.y()));
  }
  void add_passages(const Region& region, int column, int row,
                    std::vector<Passage>& passages) const;
  std::vector<Passage> passages_of(const Region& region, const Progress& progress) const;
  Eigen::Vector2d crossing(const Region& region, std::size_t edge) const;
  Eigen::Vector2d change_between(const Region& region, Eigen::Vector2d in,
                                 Eigen::Vector2d out) const;
  void refine(const Region& region, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
              double tolerance, int depth, OutlineLoop& loop) const;

  int columns_, rows_;
  const CodeAt& code_at_;
  std::vector<std::uint16_t> codes_;
};

// Smooth curves through points.

/// A closed path of cubic Béziers within `tolerance` pixels of all points (Schneider 1990, Graphics
/// Gems): the first point, then two control points and the end of each segment; the last end is the
/// first point. Turns of more than 35 degrees within two thirds of a pixel stay corners. Empty for
/// fewer than three points.
Stroke smooth_closed_path(std::span<const Eigen::Vector2d> points, double tolerance);

}  // namespace brindle
