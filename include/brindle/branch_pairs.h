/// Cancellation of pairs of opposite branches.
#pragma once

#include <cstddef>

#include "brindle/cross_texture.h"
#include "brindle/export.h"
#include "brindle/stripe_pattern.h"
#include "brindle/texture_pattern.h"

namespace BRINDLE_EXPORT brindle {

/// Results of `cancel_branches`.
struct CancelledBranches {
  std::size_t pairs = 0;  ///< cancelled
  std::size_t branches_before = 0, branches_after = 0;
  double energy_before = 0, energy_after = 0;
};

/// Options of `cancel_branches`.
struct CancellationOptions {
  double share = 0;      ///< largest rise of the energy, as a share of it: 0 or above
  double distance = 10;  ///< from a branch to its opposite, in periods: above 0, 1000 at most
};

/// Cancels pairs of opposite branches joined by a path of at most `distance` periods. One whole
/// turn is added across the path, and the phases around it are solved by least squares. Pairs that
/// lower the energy always go. Others go in order of their cost, while the energy stays within 1 +
/// `share` times its initial value. Works on patterns of any solver. Phases farther than 0.4
/// `distance` from such a path, and fixed ones, do not change. Throws Error for options out of
/// range, points without triangles and a pattern of another surface; Cancelled if `progress`
/// cancels. Then the pattern is unchanged.
CancelledBranches cancel_branches(const Surface& surface, StripePattern& pattern,
                                  const CancellationOptions& cancellation,
                                  const StripeOptions& options = {}, const Progress& progress = {});

/// As above for both stripe patterns of a texture, which is then oriented and measured again.
/// `share` applies to each pattern's energy; the results add up both patterns.
CancelledBranches cancel_branches(const Surface& surface, TexturePattern& pattern,
                                  const CancellationOptions& cancellation,
                                  const TextureOptions& options = {},
                                  const Progress& progress = {});

/// As above for both waves of a cross field together. The results exclude branches at
/// singularities, which stay.
CancelledBranches cancel_branches(const Surface& surface, CrossPattern& pattern,
                                  const CancellationOptions& cancellation,
                                  const StripeOptions& options = {}, const Progress& progress = {});

}  // namespace brindle
