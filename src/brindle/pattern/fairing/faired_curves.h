/// Curves without kinks, on their surface.
#pragma once

#include "brindle/curves.h"
#include "brindle/pattern/lifted_waves.h"
#include "brindle/progress.h"

namespace brindle {

/// The most that `faired_curves` moves a point, times 1/f.
inline constexpr double kMostFaired = 0.1;

/// Smoothing splines (Reinsch 1967) of curves that `stripe_curves` made, within the surface: each
/// is unrolled into the plane as it runs through its triangles, with its lengths and the angles by
/// which it turns, and becomes the y with the least integral of |y - x|^2 + L^4 |y''|^2 for a
/// length L of `scale` times 1/f; its points go there straight over the surface, by less than
/// `kMostFaired` / f. So bends of the surface are no kinks, and wide circles stay as large as they
/// are. Points lie a quarter of L apart, and where curves go from triangle to triangle. Open curves
/// keep their ends, but for those that lie on another curve, which they follow; closed ones stay
/// closed.
///
/// Ends on other curves get there smoothly (`JunctionSmoother`). Throws Error for a scale that is
/// not above 0 and at most 1, for curves without places, and where memory would not hold the
/// points, and Cancelled if `progress` asks for it.
StripeCurves faired_curves(const StripeCurves& curves, const WavePattern& pattern, float scale,
                           const Progress& progress = {});

}  // namespace brindle
