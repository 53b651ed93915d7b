/// The centre lines of stripes, joined over a whole surface.
#pragma once

#include <span>
#include <vector>

#include "brindle/curves.h"
#include "brindle/pattern/lifted_waves.h"

namespace brindle {

/// The lines where sin Phi = 1, the same whichever way directions point. Several cross an edge
/// where the frequency asks for it. Points lie on edges of the mesh, where the lifted phase, linear
/// along the edge, is a peak; pieces between them are straight, and do not cross. A curve is
/// closed, or both its ends have one of the reasons of CurveEnd. Every
/// crossing of an edge is on exactly one curve; with none of the kinds `no_wave` and `nonmanifold`,
/// there are as many ends at the boundary as boundary edges are crossed, and |branch_index| ends in
/// every branch.
///
/// Points nearer to the one before than 1e-4 of the edge that they lie on are passed over, and so
/// are closed curves without three other points; the two ends of an open curve always stay.
///
/// Curves run so that waves, turned by `orient_alike`, run to their left as seen from outside:
/// neighbours run the same way, whichever way directions are given. Where the field or the surface
/// cannot be oriented, nothing is promised. Closed curves start at their point farthest along one
/// direction, the same for all.
///
/// Takes time and memory linear in the mesh and what it returns. Throws Error if there are more
/// crossings than an Index can count, and Cancelled if `progress` asks for it.
StripeCurves stripe_curves(const LiftedWaves& waves, const CurveOptions& options = {},
                           const Progress& progress = {});

/// Of the waves, at points of lines on the mesh.
std::vector<float> frequencies_along(const WavePattern& pattern, const Polylines& lines);

/// Throws Error for shares of the spacing out of range, and for `trim` together with `join`.
void check_curve_options(const CurveOptions& options);

/// Turns all phases so that peaks move forward by `periods` of a wave (0.5: to the middle of the
/// gaps). For anything but whole and half periods that needs directions that run alike: `waves` and
/// `z` are turned round with `orient_alike` first. Returns the number of edges across which they
/// do not even so; there the moved curves jog sideways.
std::size_t shift_phases(const Adjacency& neighborhood, float periods, WaveSet& waves,
                         std::span<Complex> z);

}  // namespace brindle
