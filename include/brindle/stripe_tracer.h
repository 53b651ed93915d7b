/// Curves and samples of several patterns on one surface.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "brindle/curve_measures.h"
#include "brindle/curves.h"
#include "brindle/export.h"
#include "brindle/progress.h"
#include "brindle/samples.h"
#include "brindle/stripe_pattern.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// `stripe_curves`, `measure_curves` and `stripe_samples` for repeated use: mesh data are computed
/// once. All functions throw Error for a pattern of another surface, and Cancelled if `progress`
/// cancels.
class StripeTracer {
 public:
  /// The surface must outlive this object and stay unchanged.
  explicit StripeTracer(const Surface& surface, const Progress& progress = {});
  ~StripeTracer();
  StripeTracer(StripeTracer&&) noexcept;
  StripeTracer& operator=(StripeTracer&&) noexcept;

  /// As `stripe_curves`.
  StripeCurves curves(const StripePattern& pattern, const CurveOptions& options = {},
                      const Progress& progress = {}) const;

  /// Distances between curves of this pattern, also against the requested frequencies. Empty where
  /// no curve has a neighbour, above a million points, and in a build without nanoflann.
  std::optional<CurveSpacing> spacing(const StripePattern& pattern, const StripeCurves& curves,
                                      const Progress& progress = {}) const;

  /// All crossings of the stripes of two patterns; `stripe_samples` then applies `drop_doubles`
  /// (samples.h).
  std::vector<Sample> crossings(const StripePattern& u, const StripePattern& v,
                                const Progress& progress = {}) const;

 private:
  struct State;
  Pimpl<State> state_;
};

/// Moves a pattern's stripes forward by `periods` (0.5: to the middle of the gaps). All but whole
/// and half periods need directions that run alike, so waves are first reversed as in
/// `orient_alike`. Returns the number of edges across which they still run against each other;
/// there the moved stripes jog sideways.
std::size_t shift_stripes(const Surface& surface, float periods, StripePattern& pattern);

}  // namespace brindle
