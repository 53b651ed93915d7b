#include "piece_lines.h"

#include <algorithm>
#include <span>
#include <vector>

#include <Eigen/Geometry>
#include <brindle/distributed_pattern.h>

namespace brindle::paraview {
namespace {

/// Points this near to each other are one, over the length of the edge that they lie on; as the
/// library has it for whole lines.
constexpr float kSamePlace = 1e-4f;

bool at_same_place(const PieceCurves& curves, Index a, Index b) {
  const std::vector<Vec3>& points = curves.lines.points;
  return (points[a] - points[b]).norm() <= kSamePlace * std::max(curves.sizes[a], curves.sizes[b]);
}

/// The points of a line that stay. Ends of open lines do: others meet them.
std::vector<Index> points_apart(const PieceCurves& curves, std::size_t line) {
  const bool closed = curves.lines.closed[line] != 0;
  const Index begin = curves.lines.offsets[line], end = curves.lines.offsets[line + 1];
  const Index last = closed ? begin : end - 1;
  std::vector<Index> kept;
  for (Index i = begin; i < end; ++i) {
    if (kept.empty() || !at_same_place(curves, kept.back(), i)) kept.push_back(i);
  }
  while (kept.size() > 1 && at_same_place(curves, kept.back(), last)) kept.pop_back();
  if (!closed) kept.push_back(last);
  return kept;
}

/// Whether waves run to the right of the line, as seen from outside, on most of its way.
bool runs_backward(const PieceCurves& curves, std::span<const Index> points, bool closed) {
  const Polylines& lines = curves.lines;
  double left = 0;
  for (std::size_t i = closed ? 0 : 1; i < points.size(); ++i) {
    const Index a = points[i > 0 ? i - 1 : points.size() - 1], b = points[i];
    const Vec3 beside =
        (lines.normals[a] + lines.normals[b]).cross(lines.points[b] - lines.points[a]);
    left += beside.dot(curves.forward[a] + curves.forward[b]);
  }
  return left < 0;
}

void add_line(const Polylines& from, std::span<const Index> points, bool closed, Polylines& to) {
  for (const Index i : points) {
    to.points.push_back(from.points[i]);
    to.normals.push_back(from.normals[i]);
    to.places.push_back(from.places[i]);
  }
  to.offsets.push_back(static_cast<Index>(to.points.size()));
  to.closed.push_back(closed);
}

}  // namespace

Polylines piece_lines(const RankPiece& piece, const StripePattern& pattern) {
  const PieceCurves curves = piece_curves(piece.part_of(pattern));
  Polylines lines;
  lines.origin = curves.lines.origin;
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    const bool closed = curves.lines.closed[line] != 0;
    if (!closed && curves.lines.points_of(line).size() < 2) continue;
    std::vector<Index> kept = points_apart(curves, line);
    if (closed && kept.size() <= 2) continue;
    if (runs_backward(curves, kept, closed)) std::ranges::reverse(kept);
    add_line(curves.lines, kept, closed, lines);
  }
  return lines;
}

}  // namespace brindle::paraview
