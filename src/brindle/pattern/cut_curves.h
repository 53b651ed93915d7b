/// Centre lines of stripes on a part of a surface, cut where the rest of it begins.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "brindle/curves.h"
#include "brindle/pattern/curve_places.h"
#include "brindle/pattern/lifted_waves.h"

namespace brindle {

struct CurvePoint {
  Vec3 position;
  Vec3 normal;
  Vec3 forward;  ///< where the wave there runs; zero in the middle of a triangle
  float size;    ///< of the edge that it lies on, or of the triangle
  MeshPoint place;
};

/// Leaves out points at the place of others, turns the curve so that waves run to its left and lets
/// a closed one start where all do. Returns whether enough is left to be a curve.
bool tidy_curve(std::vector<CurvePoint>& curve, std::array<CurveEnd, 2>& ends);

/// Adds the places of a curve's points, and where their segments arrive.
void add_places(const Mesh& mesh, std::span<const CurvePoint> curve, bool closed, Polylines& lines);

/// What the rest of the surface has at an edge of the part.
enum class EdgeBeyond : std::uint8_t {
  nothing,
  triangle,    ///< the other one of two
  nonmanifold  ///< so many that with the part's own there are three or more
};

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
};

/// The curves of `stripe_curves`, open ones first; `beyond` has an entry per edge.
std::vector<CutCurve> cut_stripe_curves(const LiftedWaves& waves,
                                        std::span<const EdgeBeyond> beyond);

}  // namespace brindle
