/// The maker's hand on where stripes begin, wind and branch.
#pragma once

#include <optional>
#include <string>
#include <vector>

#ifdef BRINDLE_HAS_JSON
#include <nlohmann/json.hpp>
#endif

#include "brindle/branch_pairs.h"
#include "brindle/stripe_pattern.h"
#include "brindle/windings.h"

namespace brindle {

struct MakingOptions {
  std::optional<float> anchor_boundary;  ///< periods from the rim to the first stripe
  std::vector<WantedWinding> windings;
  std::optional<float> merge_branches;  ///< how much the energy may rise, as a share of it
};

/// What became of them.
struct MakingFigures {
  std::vector<SurfaceLoop> loops;
  std::vector<Winding> windings;              ///< one per loop
  std::vector<std::size_t> branches;          ///< of the piece that the loop is on
  std::vector<Eigen::Vector3d> centers;       ///< of loops, in the coordinates of files
  std::vector<WindingSum> sums;               ///< of pieces with several boundaries
  std::vector<Winding> windings_before = {};  ///< empty if none were asked for
  double energy_before = 0;
  double largest_turn_deg = 0, mean_turn_deg = 0, largest_frequency_change = 0;
  std::optional<MergedBranches> merged;
  std::size_t fixed_vertices = 0;  ///< whose phase --anchor-boundary gives
};

/// `stripe_pattern` with what the options ask for.
StripePattern make_pattern(const Surface& surface, WaveSet waves, StripeOptions stripes,
                           const MakingOptions& options, const Progress& progress,
                           MakingFigures& figures);

/// Fills in the loops of the surface and their windings.
void measure_windings(const Surface& surface, const StripePattern& pattern, MakingFigures& figures);

#ifdef BRINDLE_HAS_JSON
/// Keys for a report, and lines for people.
void add_to_json(const MakingFigures& figures, nlohmann::ordered_json& json);
std::string lines_of(const MakingFigures& figures);
#endif

}  // namespace brindle
