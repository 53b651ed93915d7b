/// Centre lines of stripes on a part of a surface, cut where the rest of it begins.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "brindle/curves.h"
#include "brindle/pattern/curve_places.h"
#include "brindle/pattern/edge_beyond.h"
#include "brindle/pattern/end_walks.h"
#include "brindle/pattern/lifted_waves.h"

namespace brindle {

struct CurvePoint {
  Vec3 position;
  Vec3 normal;
  Vec3 forward;  ///< where the wave there runs; zero in the middle of a triangle
  float size;    ///< of the edge that it lies on, or of the triangle
  MeshPoint place;
};

/// A point in a triangle.
CurvePoint point_in_triangle(const WavePattern& pattern, const TrianglePoint& place);

/// Leaves out points at the place of others, turns the curve so that waves run to its left and lets
/// a closed one start where all do. Returns whether enough is left to be a curve.
bool tidy_curve(std::vector<CurvePoint>& curve, std::array<CurveEnd, 2>& ends);

/// Adds the places of a curve's points, and where their segments arrive.
void add_places(const Mesh& mesh, std::span<const CurvePoint> curve, bool closed, Polylines& lines);

/// A curve as far as the part reaches, with all its points.
struct CutCurve {
  struct Crossing {
    Index edge;
    Index number;  ///< along the edge, from its vertex of lower number
  };
  std::vector<CurvePoint> points;
  std::array<CurveEnd, 2> ends{};  ///< where it is not cut
  /// Where it is: the curve goes on in the triangle beyond from the same point. Where it comes from
  /// a triangle without a wave, it is that point alone.
  std::array<std::optional<Crossing>, 2> cuts = {};
  /// Of an end that runs on into a neighbour, if the rest of the surface must say to which: the
  /// walks to both, of which one at least is `beyond`. Their ways are not among the points yet.
  std::array<std::optional<std::array<Walk, 2>>, 2> walks = {};
};

struct CutCurves {
  std::vector<CutCurve> curves;       ///< open ones first
  std::size_t joined_ends = 0;        ///< as of StripeCurves
  std::size_t ends_at_neighbors = 0;  ///< the same, without those that the rest must decide
};

/// The curves of `stripe_curves`; `beyond` has an entry per edge.
CutCurves cut_stripe_curves(const LiftedWaves& waves, std::span<const EdgeBeyond> beyond,
                            const CurveOptions& options = {});

}  // namespace brindle
