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

/// `stripe_curves`, `measure_curves` and `stripe_samples`, step by step, for who asks more than
/// once: what they need of the mesh is found once. All functions throw Error for a pattern of
/// another surface, and Cancelled if `progress` asks for it.
class StripeTracer {
 public:
  /// The surface must outlive this and stay as it is.
  explicit StripeTracer(const Surface& surface, const Progress& progress = {});
  ~StripeTracer();
  StripeTracer(StripeTracer&&) noexcept;
  StripeTracer& operator=(StripeTracer&&) noexcept;

  /// As `stripe_curves`.
  StripeCurves curves(const StripePattern& pattern, const CurveOptions& options = {},
                      const Progress& progress = {}) const;

  /// How far curves of this pattern are apart, against the frequencies asked for, too. Nothing
  /// where no curve has a neighbour, where that would take more than a million points, and in a
  /// build without nanoflann.
  std::optional<CurveSpacing> spacing(const StripePattern& pattern, const StripeCurves& curves,
                                      const Progress& progress = {}) const;

  /// All crossings of the stripes of two patterns; `stripe_samples` leaves out those for which
  /// `drop_doubles` (samples.h) is there.
  std::vector<Sample> crossings(const StripePattern& u, const StripePattern& v,
                                const Progress& progress = {}) const;

 private:
  struct State;
  Pimpl<State> state_;
};

/// Moves a pattern's stripes forward by so many periods (0.5: to the middle of the gaps). For
/// anything but whole and half periods that needs directions that run alike: waves are turned round
/// first, as `orient_alike` does. Returns the number of edges across which they do not even so;
/// there the moved stripes jog sideways.
std::size_t shift_stripes(const Surface& surface, float periods, StripePattern& pattern);

}  // namespace brindle
