/// Windings: how many stripes wind round a loop of the surface as helices.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brindle/export.h"
#include "brindle/stripe_pattern.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// The phase gained round a loop, in periods: a whole number. 0: stripes are rings there; 1 or -1:
/// they are one spiral; 2 or -2: two, and so on. Above zero they are right-handed screws, as
/// corkscrews are, below zero left-handed ones, whichever way directions point. Where waves mostly
/// run along the loop, so that stripes cross it, the number counts them and is not negative.
/// Nothing where the field cannot be oriented along the loop, or a vertex has no wave.
using Winding = std::optional<int>;

/// Those of all loops. Throws Error for a pattern or loops of another surface.
std::vector<Winding> windings(const Surface& surface, std::span<const SurfaceLoop> loops,
                              const StripePattern& pattern);

/// The boundaries of a connected piece of the surface, with one orientation of the field all over.
struct WindingSum {
  std::vector<std::size_t> boundaries;  ///< numbers of loops, two or more
  /// What is gained round all of them together, in periods: the indices of the branches and
  /// singularities between them. 0: what winds in at some winds out at others.
  int periods = 0;
};

/// Those of all pieces with two boundaries or more, each of which has a winding. Throws Error as
/// `windings` does.
std::vector<WindingSum> winding_sums(const Surface& surface, std::span<const SurfaceLoop> loops,
                                     const StripePattern& pattern);

/// How many branches a piece of the surface has: where it has any, or singularities of its field,
/// the windings of its loops may differ.
std::size_t branches_of_piece(const Surface& surface, const SurfaceLoop& loop,
                              const StripePattern& pattern);

/// What a loop is to have.
struct WantedWinding {
  std::string loop;  ///< a name of `surface_loops`; empty: the surface has one way round alone
  int periods = 0;
};

/// Waves that run round a loop with this many periods, the closed change of phase of least norm:
/// no stripes of theirs branch, but where `reference` has singularities. On a sleeve they are its
/// wales: the direction is that of a harmonic map, the frequency what `periods` asks for.
/// `reference` (a direction per vertex, up to sign) says which way is which where the surface or a
/// field has no orientation; it should run along the loop. Throws Error as `wind` does, and unless
/// the number is above 0.
WaveSet waves_round(const Surface& surface, const DirectionField& reference,
                    const WantedWinding& wanted);

/// A pattern with the windings that were wanted, and what it took.
struct WoundPattern {
  StripePattern pattern;  ///< its waves are turned
  std::vector<Winding> before, after;
  double energy_before = 0;
  double largest_turn_deg = 0;  ///< of a wave's direction
  double mean_turn_deg = 0;
  double largest_frequency_change = 0;  ///< |f' / f - 1|
};

/// Adds to the waves of `pattern` the closed change of phase of least norm (the harmonic one-form)
/// that has the periods that are missing, which turns all of them by a small angle, and solves
/// again. Round a boundary that is named, it runs to the nearest boundary that is not; other loops
/// keep their numbers. All boundaries of a piece may be named where what is asked of them adds up
/// (`winding_sums`). Branches and singularities stay what they were, and so does what they make
/// differ between loops. Throws Error for a surface without a way round, for names that are none,
/// an empty name where there are several ways round (naming them), a boundary without another,
/// boundaries that do not add up (saying what the last would have to have), a loop without a
/// winding, numbers beyond a million, where waves would change by as much as they are or the solver
/// comes to other numbers, and what `stripe_pattern` throws.
WoundPattern wind(const Surface& surface, const StripePattern& pattern,
                  std::span<const WantedWinding> wanted, const StripeOptions& options = {},
                  const Progress& progress = {});

}  // namespace brindle
