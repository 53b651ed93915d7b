/// One pattern after another, of which those over one connectivity may follow each other.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
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
  float slack = 0;        ///< as Slack has it
  float lambda = 0.025f;  ///< as AnimatorOptions has it: how near a pattern stays to the last one

  bool operator==(const SeriesOptions&) const = default;
};

/// A surface, or a piece of one.
struct PatternSurface {
  std::shared_ptr<const Surface> surface;
  std::shared_ptr<const RankPiece> piece;  ///< null if this process is alone
  /// Numbers of vertices in the whole that tell them apart at any time; null if there are none.
  std::shared_ptr<const std::vector<std::uint64_t>> ids = {};
};

/// Whether vertices and triangles of both surfaces are the same, wherever they stand, and, of
/// pieces, other ranks' parts in them.
bool same_connectivity(const PatternSurface& a, const PatternSurface& b);

/// Whether that holds on all ranks. Collective.
bool same_connectivity_everywhere(const PatternSurface& a, const PatternSurface& b);

/// Collective. The phases that a pattern of one surface had at another surface's vertices,
/// whichever ranks have these now: those of one id, or, where surfaces have no ids, at exactly the
/// same place; 0 where there is none. Of `waves`, which stand on the other surface.
std::vector<Complex> phases_elsewhere(const PatternSurface& last, const StripePattern& pattern,
                                      const PatternSurface& surface, const WaveSet& waves);

/// Lays patterns as `stripe_pattern` and StripeAnimator do, over several ranks as
/// DistributedStripeAnimator does. A pattern that follows another renews what depends on the waves;
/// what depends on the connectivity stays.
class PatternSeries {
 public:
  /// The pattern of these waves, valid until the next call. It follows the last one if `follows`
  /// says so, the options are the same, and so is the surface's connectivity or at least half of
  /// its vertices (`phases_elsewhere`); otherwise it is that of `stripe_pattern`, whatever came
  /// before. The same waves on the same cells as last time give the pattern of last time.
  /// Collective over ranks; a piece's pattern has phases of all its vertices and triangles, ghosts
  /// included, and the quality of the whole. Throws what StripeAnimator does, and then forgets the
  /// last pattern.
  const StripePattern& next(const PatternSurface& surface, WaveSet waves,
                            const SeriesOptions& options, bool follows,
                            const Progress& progress = {});

  /// How many times a solver was built: for every pattern that does not follow another.
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
  void forget();
  bool has_animator() const { return animator_ || ranks_animator_; }
  void set_last_phases(std::span<const Complex> z);
  std::optional<std::vector<Complex>> phases_to_follow(const PatternSurface& surface,
                                                       const WaveSet& waves) const;
  void solve(WaveSet waves, const Progress& progress);
  FrameResult solve_frame(const WaveSet& waves, const Progress& progress);
  double energy() const;
  void measure(StripePattern& made) const;

  PatternSurface surface_;
  SeriesOptions options_;
  std::optional<StripeAnimator> animator_;
  std::optional<DistributedStripeAnimator> ranks_animator_;  ///< of pieces
  StripePattern pattern_;
  int solvers_made_ = 0;
  int patterns_followed_ = 0;
  bool lost_track_ = false;
  double solve_milliseconds_ = 0;
};

}  // namespace brindle::paraview
