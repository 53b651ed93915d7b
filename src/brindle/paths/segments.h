/// Neighbours and crossings of lines on a surface.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "brindle/geometry/box_tree.h"
#include "brindle/mesh.h"
#include "brindle/nearest.h"
#include "brindle/paths/path_order.h"
#include "brindle/polylines.h"

namespace brindle {

/// A point with the surface's unit normal.
struct PathPoint {
  Vec3 position;
  Vec3 normal;
};

/// The segments of lines, which must outlive this object.
class SegmentSearch {
 public:
  explicit SegmentSearch(const Polylines& lines);

  /// The straight distances to the next lines to the left and to the right of a direction, at right
  /// angles to it and on the same side of the surface; empty beyond `reach`.
  std::array<std::optional<float>, 2> gaps(const PathPoint& at, const Vec3& direction,
                                           float reach) const;

  /// The lines within `reach` to both sides of each line, at up to 32 points.
  LinesBeside lines_beside(float reach, const Progress& progress) const;

  /// Whether a line crosses or touches the way from a to b, seen along the normal, at most `reach`
  /// above or below it; but for the ends of the way if these are `free`.
  bool crossed(const Vec3& a, const Vec3& b, const Vec3& normal, float reach, bool free_begin,
               bool free_end) const;

 private:
  struct Segment {
    Index from, to, line;
  };
  struct Beside {
    float gap;
    Index line;
  };
  using BothSides = std::array<std::optional<Beside>, 2>;

  BothSides beside(const PathPoint& at, const Vec3& direction, float reach) const;
  template <class Take>
  void visit(const BoundingBox& box, const Take& take) const;
  static BoxTree tree_of(const Polylines& lines, std::span<const Segment> segments);

  const Polylines& lines_;
  std::vector<Segment> segments_;
  BoxTree tree_;
};

/// Ways over a surface between ends of lines.
class JoinSearch {
 public:
  /// The arguments must outlive this object.
  JoinSearch(const Mesh& mesh, const Polylines& lines) : nearest_(mesh), segments_(lines) {}

  /// The points between two ends on a straight way that is laid onto the surface; empty if it
  /// crosses a line or leaves the surface.
  std::optional<std::vector<PathPoint>> way(const PathPoint& from, const PathPoint& to,
                                            float reach) const;

 private:
  NearestOnMesh nearest_;
  SegmentSearch segments_;
};

}  // namespace brindle
