/// The multilevel solver: descends a hierarchy of exact sums (docs/method.md, "Multilevel solver").
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "brindle/phases/hierarchy.h"
#include "brindle/solver.h"

namespace brindle {

/// Levels of fewer slots are small: their sweeps take next to no time.
inline constexpr Index kSmallLevel = 4096;

/// Graphs whose finest level has so many slots are large: most of the energy that can still be
/// lowered is on their levels.
inline constexpr Index kLargeLevel = Index{1} << 17;

/// The sweeps of a descent on one level.
struct LevelSweeps {
  int count;
  float over_relaxation;  ///< of all but the last, which leaves no overshoot

  float over_relaxation_of(int number) const { return number + 1 < count ? over_relaxation : 1; }
};

/// The sweeps of a descent on all levels. No finer level can correct the errors of a small one, so
/// sweeps grow in number and reach as levels shrink.
class SweepPlan {
 public:
  /// For frames: more sweeps on small levels alone. A number of sweeps converts to such a plan.
  SweepPlan(int sweeps) : sweeps_(sweeps) {}

  /// For levels that have just been built, which took longer than sweeps do: on all levels of a
  /// large graph three to twelve times as many. That leaves about the energy that four cycles leave
  /// of a plan for frames. `finest` is the number of slots of the finest level.
  static SweepPlan for_new_levels(int sweeps, Index finest);

  LevelSweeps on_level(Index slot_count) const;

 private:
  int sweeps_;
  Index large_ = 0;  ///< slots of the finest level of a large graph, 0 for others
};

/// The sweeps of a descent on one level.
void sweep_level(Level& level, SweepPlan plan);

/// Makes the gauges of the finest level its phases, those of others 1.
void set_turns(Level& level, bool is_finest);

/// As `descend`, from the phase `start` on the coarsest level.
void descend_from(Hierarchy& hierarchy, Complex start, SweepPlan plan,
                  const Progress& progress = {});

/// From the coarsest level down: prolongs the phases, then sweeps as planned. Phases end in
/// `hierarchy.levels[0].z`. There is no random start and nothing to tune; no sweep raises the
/// energy. Throws Cancelled if `progress` asks for it, as the functions below do.
void descend(Hierarchy& hierarchy, SweepPlan plan, const Progress& progress = {});

/// One cycle of `run_cycles`. `has_finest` is false if finer levels are elsewhere.
void correct(Hierarchy& hierarchy, SweepPlan plan, bool has_finest = true,
             const Progress& progress = {});

/// Further descents, each from the phases of the finest level: they become its gauges, so that a
/// coarse unknown turns the phases of its aggregate, and every level starts from Z = 1, not
/// turning. The energy does not rise. Overwrites gauges and coarse couplings, which the next
/// `renew` restores.
void run_cycles(Hierarchy& hierarchy, SweepPlan plan, int cycles, const Progress& progress);

/// The stages of `solve_multilevel`: "couple", "hierarchy", "descent" and "cycles".
std::vector<JobStage> multilevel_stages();

/// The whole solver, without the phase graph: `couple` sets the couplings of the finest level.
/// `start`, with one unit number per node, replaces the descent before the cycles; empty: none.
/// `finish` changes the phases (by node) at the end. `solve_milliseconds` are without those of
/// `couple`. Throws Error for options out of range.
PhaseSolution solve_multilevel(const Adjacency& adjacency,
                               const std::function<void(Level& finest)>& couple,
                               const SolverOptions& options, std::span<const Complex> start = {},
                               const Progress& progress = {},
                               const std::function<void(std::span<Complex> z)>& finish = {});

}  // namespace brindle
