/// Frequencies that yield within bounds, so that fewer stripes must begin or end (docs/spacing.md).
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/frequency_field.h"
#include "brindle/phase_graph.h"
#include "brindle/progress.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// How far frequencies may depart from those that are asked for. A number is one.
struct Slack {
  /// S, of 0 or above: from f / (1 + S) to f (1 + S); 0: not at all.
  Slack(float s = 0) : everywhere(s) {}

  float everywhere;
  std::vector<float> by_vertex;  ///< S_i in place of `everywhere`; empty: none
  /// By vertex, from 0 to 1: where branches are unwelcome. Curl weighs up to 10 times as much
  /// there, and slack is up to 3 times as large, so that they go elsewhere. Empty: 0.
  std::vector<float> calm;

  /// Whether frequencies may change.
  bool yields() const { return everywhere > 0 || !by_vertex.empty(); }

  bool operator==(const Slack&) const = default;
};

/// What has become of the frequencies, over all vertices that a triangle joins to others (of
/// points: neighbours).
struct FrequencyChange {
  double ratio_min = 1;  ///< the frequency chosen over the one asked for
  double ratio_max = 1;
  double ratio_mean = 1;       ///< weighted by area
  double share_at_bounds = 0;  ///< of the vertices, between 0 and 1
  int sweeps = 0;              ///< over all vertices
  double residual = 0;  ///< length of the projected gradient, over that after the first sweep
};

/// Finds the frequency g = f exp(x) between bounds around the frequency f asked for with which g d
/// is as nearly the gradient of a phase as it can be: its curl is what makes branches. It minimises
///
///     sum_T w_T / A_T (c_T + sum_m (c_Tm - c_T / 3) x_m)^2
///       + eta sum_T A_T |f_T grad x|^2 + mu sum_i w_i M_i (f_i x_i)^2,   |x_i| <= log(1 + S_i)
///
/// where c_T = sum_m c_Tm is the circulation of f d around triangle T (compare the curl correction
/// in Ray et al., Periodic global parameterization, 2006), by multigrid between the bounds: that of
/// g d over g, which does not know how large g is. The mean of g / f, weighted by area, then is
/// made 1, and about 1 where it is calm. Results are bit-identical for any number of threads.
/// Turning a direction round changes nothing. Triangles whose corners have no common orientation
/// have no circulation, and those with a corner without a wave take no part; a vertex without any
/// other keeps its frequency. Points take the triangles that they make with their neighbours.
class YieldingFrequency {
 public:
  /// Throws Error for a slack that is negative or not finite and for calm beyond 0 to 1, naming the
  /// vertex, and unless lists are empty or have one entry per vertex; and Cancelled if `progress`
  /// asks for it: of points it takes a while to find the triangles.
  YieldingFrequency(const Surface& surface, const Slack& slack, const Progress& progress = {});
  ~YieldingFrequency();
  YieldingFrequency(YieldingFrequency&&) noexcept;
  YieldingFrequency& operator=(YieldingFrequency&&) noexcept;

  /// The frequency per vertex, until the next call but one. Spans have one entry per vertex and
  /// values that `stripe_pattern` takes; neither is checked. Starts from what was kept last,
  /// relative to the frequencies asked for, and then allocates nothing. `progress` hears of it
  /// where nothing was kept; whatever it throws, what was kept stays.
  std::span<const float> solve(std::span<const Vec3> positions, std::span<const Vec3> directions,
                               std::span<const float> wanted, const Progress& progress = {});

  /// Makes the last result the one to start from. Does nothing where there is none that was not
  /// kept: before `solve`, after one that failed, or once slack is another. Cannot fail.
  void keep();

  /// Another one for the same surface and slack, with nothing kept.
  YieldingFrequency sibling() const;

  /// What was kept last.
  std::span<const float> frequencies() const;

  /// Forgets what was kept.
  void restart();

  /// Of the last `solve`.
  const FrequencyChange& change() const;

 private:
  struct State;
  explicit YieldingFrequency(std::unique_ptr<State> state);
  Pimpl<State> state_;
};

}  // namespace brindle
