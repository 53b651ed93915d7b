/// Winding numbers: how many stripes wind around a loop of the surface as helices.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brindle/export.h"
#include "brindle/stripe_pattern.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// The phase gained around a loop, in periods: a whole number. 0: stripes are rings there; 1 or -1:
/// one spiral; 2 or -2: two, and so on. Positive windings are right-handed screws, negative ones
/// left-handed, for any signs of directions. Where waves mostly run along the loop, so that stripes
/// cross it, the number counts them and is not negative. Empty if the field cannot be oriented
/// along the loop, or a vertex has no wave.
using Winding = std::optional<int>;

/// The windings of all loops. Throws Error for a pattern or loops of another surface.
std::vector<Winding> windings(const Surface& surface, std::span<const SurfaceLoop> loops,
                              const StripePattern& pattern);

/// The boundaries of a connected component, on which the field has one orientation.
struct WindingSum {
  std::vector<std::size_t> boundaries;  ///< numbers of loops, two or more
  /// The phase gained around all of them together, in periods: the sum of the indices of the
  /// branches and singularities between them. At 0, stripes that wind in at some boundaries wind
  /// out at others.
  int periods = 0;
};

/// The sums of all components with two or more boundaries that each have a winding. Throws Error as
/// `windings` does.
std::vector<WindingSum> winding_sums(const Surface& surface, std::span<const SurfaceLoop> loops,
                                     const StripePattern& pattern);

/// The number of branches in a loop's component. With branches, or singularities of the field, the
/// windings of its loops may differ.
std::size_t branches_of_piece(const Surface& surface, const SurfaceLoop& loop,
                              const StripePattern& pattern);

/// The requested winding of a loop.
struct WantedWinding {
  std::string loop;  ///< a name of `surface_loops`; empty: the only loop of the surface
  int periods = 0;
};

/// Waves that run around a loop with this many periods: the closed change of phase of least norm.
/// Their stripes branch only where `reference` has singularities. On a sleeve they are its wales:
/// the direction is that of a harmonic map, the frequency follows from `periods`. `reference` (a
/// direction per vertex, up to sign) gives an orientation where the surface or a field has none; it
/// should run along the loop. Throws Error as `wind` does, and unless the number is above 0.
WaveSet waves_round(const Surface& surface, const DirectionField& reference,
                    const WantedWinding& wanted);

/// A pattern with the requested windings, and the changes made.
struct WoundPattern {
  StripePattern pattern;  ///< its waves are turned
  std::vector<Winding> before, after;
  double energy_before = 0;
  double largest_turn_deg = 0;  ///< of a wave's direction
  double mean_turn_deg = 0;
  double largest_frequency_change = 0;  ///< |f' / f - 1|
};

/// Adds to the waves of `pattern` the closed change of phase of least norm (the harmonic one-form)
/// with the missing periods, which turns all of them by a small angle, and solves again. Around a
/// named boundary, it runs to the nearest boundary that is not named; other loops keep their
/// numbers. All boundaries of a component may be named if the requests add up (`winding_sums`).
/// Branches and singularities stay, and so do the differences between loops that they cause. Throws
/// Error for a surface without a loop, unknown names, an empty name with several loops (naming
/// them), a boundary without another, boundaries that do not add up (naming the last one's winding
/// that would), a loop without a winding, numbers beyond a million, if waves would change by as
/// much as they are or the solver reaches other numbers, and what `stripe_pattern` throws.
WoundPattern wind(const Surface& surface, const StripePattern& pattern,
                  std::span<const WantedWinding> wanted, const StripeOptions& options = {},
                  const Progress& progress = {});

}  // namespace brindle
