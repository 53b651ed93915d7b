/// A sequence of patterns, each of which may continue the last one.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include <brindle/distributed_stripes.h>
#include <brindle/phase_graph.h>
#include <brindle/progress.h>
#include <brindle/stripe_animator.h>
#include <brindle/stripe_pattern.h>
#include <brindle/surface.h>

#include "rank_piece.h"

namespace brindle::paraview {

struct SeriesOptions {
  float slack = 0;        ///< as in Slack
  float lambda = 0.025f;  ///< as in AnimatorOptions: weight of the last pattern

  bool operator==(const SeriesOptions&) const = default;
};

/// A surface, or a partition of one.
struct PatternSurface {
  std::shared_ptr<const Surface> surface;
  std::shared_ptr<const RankPiece> piece;  ///< null without other ranks
  /// Global numbers that identify vertices over time; null if there are none.
  std::shared_ptr<const std::vector<std::uint64_t>> ids = {};
};

/// Whether both surfaces have the same vertices and triangles, at any positions, and the same
/// distribution to ranks.
bool same_connectivity(const PatternSurface& a, const PatternSurface& b);

/// Collective. The same on all ranks.
bool same_connectivity_everywhere(const PatternSurface& a, const PatternSurface& b);

/// Collective. The phases of a pattern at the vertices of another surface, on any ranks: matched by
/// id or, without ids, by exact position; 0 if there is no match. `waves` belong to the other
/// surface.
std::vector<Complex> phases_elsewhere(const PatternSurface& last, const StripePattern& pattern,
                                      const PatternSurface& surface, const WaveSet& waves);

/// Makes patterns as `stripe_pattern` and StripeAnimator do, or DistributedStripeAnimator with
/// several ranks. A pattern that continues another recomputes only what depends on the waves.
class PatternSeries {
 public:
  /// Collective. The pattern of these waves, valid until the next call. It continues the last one
  /// if `follows`, if the options are the same, and if the connectivity is the same or half of the
  /// vertices match (`phases_elsewhere`); otherwise it is that of `stripe_pattern`, independent of
  /// earlier ones. Unchanged waves and cells return the last pattern. A partition's pattern has
  /// phases at all vertices and triangles, including ghosts, and the global quality. Throws what
  /// StripeAnimator throws, and then discards the last pattern.
  const StripePattern& next(const PatternSurface& surface, WaveSet waves,
                            const SeriesOptions& options, bool follows,
                            const Progress& progress = {});

  /// The number of solvers built: one per pattern that does not continue another.
  int solvers_made() const { return solvers_made_; }
  /// How many patterns followed the one before.
  int patterns_followed() const { return patterns_followed_; }
  /// Whether the last pattern should have followed one whose vertices it does not have.
  bool lost_track() const { return lost_track_; }
  /// Milliseconds that the last pattern took to be solved, without measuring it.
  double solve_milliseconds() const { return solve_milliseconds_; }

 private:
  bool fits(const PatternSurface& surface, const SeriesOptions& options) const;
  bool has_pattern_of(const WaveSet& waves) const;
  void start(const PatternSurface& surface, const SeriesOptions& options);
  bool has_animator() const { return animator_.index() != 0; }
  std::optional<std::vector<Complex>> phases_to_follow(const PatternSurface& surface,
                                                       const WaveSet& waves) const;
  void solve(WaveSet waves, const Progress& progress);
  PatternQuality quality_of(const StripePattern& made) const;

  PatternSurface surface_;
  SeriesOptions options_;
  /// None before the first pattern; the last one is for pieces.
  std::variant<std::monostate, StripeAnimator, DistributedStripeAnimator> animator_;
  StripePattern pattern_;
  int solvers_made_ = 0;
  int patterns_followed_ = 0;
  bool lost_track_ = false;
  double solve_milliseconds_ = 0;
};

}  // namespace brindle::paraview
