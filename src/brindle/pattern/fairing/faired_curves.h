/// Fairing: removes kinks from curves on their surface.
#pragma once

#include "brindle/curves.h"
#include "brindle/pattern/lifted_waves.h"
#include "brindle/progress.h"

namespace brindle {

/// The most that `faired_curves` moves a point, times 1/f.
inline constexpr double kMostFaired = 0.1;

/// Smooths curves of `stripe_curves` by smoothing splines (Reinsch 1967) within the surface. Each
/// curve x is unrolled into the plane with its lengths and its turning angles within the surface.
/// The result is the y with the least integral of |y - x|^2 + L^4 |y''|^2, where L is `scale` times
/// 1/f. Points move there straight over the surface, by less than `kMostFaired` / f. So bends of
/// the surface are no kinks, and wide circles keep their size. Points lie a quarter of L apart, and
/// where curves pass from triangle to triangle. Open curves keep their ends, except those on
/// another curve, which follow that curve; closed curves stay closed.
///
/// Ends on other curves meet them smoothly (`JunctionSmoother`). Throws Error for a scale that is
/// not above 0 and at most 1, for curves without places, and for more points than memory holds;
/// Cancelled if `progress` cancels.
StripeCurves faired_curves(const StripeCurves& curves, const WavePattern& pattern, float scale,
                           const Progress& progress = {});

}  // namespace brindle
