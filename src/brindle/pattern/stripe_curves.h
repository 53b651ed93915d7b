/// The centre lines of stripes, joined over a whole surface.
#pragma once

#include <span>
#include <vector>

#include "brindle/curves.h"
#include "brindle/pattern/lifted_waves.h"

namespace brindle {

/// Returns the lines where sin Phi = 1, independent of the signs of directions. They may cross an
/// edge several times. Points lie on edges of the mesh where the lifted phase, linear along the
/// edge, is a peak; the pieces between them are straight and do not cross. A curve is closed, or
/// both its ends have a reason (CurveEnd). Every crossing of an edge is on exactly one curve.
/// Without ends of the kinds `no_wave` and `nonmanifold`, every crossing of a boundary edge is an
/// end, and every branch has |branch_index| ends.
///
/// Points nearer to the previous one than 1e-4 of their edge's length are dropped, and so are
/// closed curves of fewer than three points. Both ends of an open curve always stay.
///
/// Waves, oriented by `orient_alike`, run to the left of curves as seen from outside, so
/// neighbouring curves run the same way. This is not guaranteed where the field or the surface
/// cannot be oriented. Closed curves start at their point farthest along a fixed direction.
///
/// Time and memory are linear in the mesh and the result. Throws Error for options that
/// `check_curve_options` rejects, for more crossings than an Index or memory can hold, and for
/// `fair` in a build without fairing; Cancelled if `progress` cancels.
StripeCurves stripe_curves(const LiftedWaves& waves, const CurveOptions& options = {},
                           const Progress& progress = {});

/// The frequencies of the waves at points of lines on the mesh.
std::vector<float> frequencies_along(const WavePattern& pattern, const Polylines& lines);

/// Throws Error for shares of the spacing out of range, and for `trim` together with `join`.
void check_curve_options(const CurveOptions& options);

/// Shifts all phases so that peaks move forward by `periods` of a wave (0.5: to the middle of the
/// gaps). Shifts other than whole and half periods need directions that run alike, so `waves` and
/// `z` are first reversed according to `orient_alike`. Returns the number of edges across which
/// directions still run against each other; the moved curves jog sideways there.
std::size_t shift_phases(const Adjacency& neighborhood, float periods, WaveSet& waves,
                         std::span<Complex> z);

}  // namespace brindle
