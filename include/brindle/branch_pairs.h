/// Pairs of branches that a pattern can do without.
#pragma once

#include <cstddef>

#include "brindle/cross_texture.h"
#include "brindle/export.h"
#include "brindle/stripe_pattern.h"
#include "brindle/texture_pattern.h"

namespace BRINDLE_EXPORT brindle {

struct MergedBranches {
  std::size_t pairs = 0;  ///< that are gone
  std::size_t branches_before = 0, branches_after = 0;
  double energy_before = 0, energy_after = 0;
};

struct MergingOptions {
  double share = 0;      ///< by how much the energy may rise, as a share of it: 0 or above
  double distance = 10;  ///< from a branch to its opposite, in periods: above 0, 1000 at most
};

/// Removes pairs of opposite branches with a way between them of `distance` periods at most: the
/// way is taken a period longer on one side, and phases around are solved for by least squares. Of
/// all pairs those go first that raise the energy least, as long as it stays within 1 + `share`
/// times what it was; those that lower it go in any case. Works on what any solver has found;
/// phases farther than 0.4 `distance` from such a way, and fixed ones, stay as they are. Throws
/// Error for options that are not in range, for points without triangles and for a pattern of
/// another surface; Cancelled if `progress` asks for it. The pattern then is as it was.
MergedBranches merge_branches(const Surface& surface, StripePattern& pattern,
                              const MergingOptions& merging, const StripeOptions& options = {},
                              const Progress& progress = {});

/// The same of both stripe patterns of a texture, which is then oriented and measured anew. `share`
/// is of each pattern's energy; the figures are those of both, their energies added.
MergedBranches merge_branches(const Surface& surface, TexturePattern& pattern,
                              const MergingOptions& merging, const TextureOptions& options = {},
                              const Progress& progress = {});

/// The same of both waves of a cross field together. Branches of singularities, which stay, are not
/// among those of the figures.
MergedBranches merge_branches(const Surface& surface, CrossPattern& pattern,
                              const MergingOptions& merging, const StripeOptions& options = {},
                              const Progress& progress = {});

}  // namespace brindle
