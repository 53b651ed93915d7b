/// Spacing tolerance: frequencies that vary within bounds, so that fewer stripes begin or end
/// (docs/fewer_branches.md).
#pragma once

#include <vector>

#include "brindle/export.h"
#include "brindle/frequency_field.h"
#include "brindle/phase_graph.h"
#include "brindle/progress.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// The spacing tolerance: bounds of frequencies relative to those wanted. A number converts to it.
struct Slack {
  /// S of 0 or above: frequencies from f / (1 + S) to f (1 + S); 0 for no change.
  Slack(float s = 0) : everywhere(s) {}

  float everywhere;
  std::vector<float> by_vertex;  ///< S_i in place of `everywhere`; empty: none
  /// By vertex, from 0 to 1: where to avoid branches. Curl has up to 10 times the weight there, and
  /// slack is up to 3 times as large, so that branches appear elsewhere. Empty: 0.
  std::vector<float> branch_penalty;

  /// Whether frequencies may change.
  bool relaxes() const { return everywhere > 0 || !by_vertex.empty(); }

  bool operator==(const Slack&) const = default;
};

/// The change of frequencies, over all vertices with triangles (of points: with neighbours).
struct FrequencyChange {
  double ratio_min = 1;  ///< of the frequency over the one wanted
  double ratio_max = 1;
  double ratio_mean = 1;       ///< weighted by area
  double share_at_bounds = 0;  ///< of the vertices, between 0 and 1
  int sweeps = 0;              ///< over all vertices
  double residual = 0;         ///< length of the projected gradient over that after the first sweep
};

/// Frequencies within the bounds of a Slack, one per vertex.
struct RelaxedFrequencies {
  FrequencyField frequencies;
  FrequencyChange change;
};

/// Finds the frequency g = f exp(x), within bounds around the wanted frequency f, for which g d is
/// as close to the gradient of a phase as possible: its curl causes branches. It minimises
///
///     sum_T w_T / A_T (c_T + sum_m (c_Tm - c_T / 3) x_m)^2
///       + eta sum_T A_T |f_T grad x|^2 + mu sum_i w_i M_i (f_i x_i)^2,   |x_i| <= log(1 + S_i)
///
/// where c_T = sum_m c_Tm is the circulation of f d around triangle T (compare the curl correction
/// in Ray et al., Periodic global parameterization, 2006), by multigrid with bounds. It is the
/// circulation of g d over g, which does not depend on the scale of g. Then the mean of g / f,
/// weighted by area, is made 1, and about 1 where branches are avoided. Results are bit-identical
/// for any number of threads. Signs of directions change nothing. Triangles whose corners have no
/// common orientation have no circulation; those with a corner without a wave are ignored, and a
/// vertex with no other triangles keeps its frequency. Points use the triangles with their
/// neighbours.
///
/// `waves` has one entry per vertex and values that `stripe_pattern` accepts; neither is checked.
/// Throws Error for a slack that is negative or not finite and for `branch_penalty` outside 0 to 1,
/// naming the vertex, and unless lists are empty or have one entry per vertex; Cancelled if
/// `progress` cancels.
RelaxedFrequencies relaxed_frequencies(const Surface& surface, const WaveSet& waves,
                                       const Slack& slack, const Progress& progress = {});

}  // namespace brindle
