/// The multilevel solver: descends a hierarchy of exact sums (docs/method.md, "Multilevel solver").
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "brindle/phases/hierarchy.h"
#include "brindle/solver.h"

namespace brindle {

/// Levels with fewer slots are small: their sweeps take almost no time.
inline constexpr Index kSmallLevel = 4096;

/// Graphs with at least this many slots on the finest level are large: most of the energy that can
/// still be lowered is on their levels.
inline constexpr Index kLargeLevel = Index{1} << 17;

/// The sweeps of a descent on one level.
struct LevelSweeps {
  int count;
  float over_relaxation;  ///< of all sweeps but the last, which leaves no overshoot

  float over_relaxation_of(int number) const { return number + 1 < count ? over_relaxation : 1; }
};

/// The sweeps of a descent on all levels. Finer levels cannot correct the errors of a small level,
/// so small levels get more sweeps, which are over-relaxed.
class SweepPlan {
 public:
  /// For frames: only small levels get more sweeps. A number of sweeps converts to such a plan.
  SweepPlan(int sweeps) : sweeps_(sweeps) {}

  /// For new levels, where building takes longer than sweeping: levels of a large graph get three
  /// to twelve times as many sweeps. This leaves about the energy that four cycles of a frame plan
  /// leave. `finest` is the number of slots of the finest level.
  static SweepPlan for_new_levels(int sweeps, Index finest);

  LevelSweeps on_level(Index slot_count) const;

 private:
  int sweeps_;
  Index large_ = 0;  ///< slots of the finest level of a large graph, 0 for others
};

/// Sweeps one level as planned.
void sweep_level(Level& level, SweepPlan plan);

/// Sets the gauges of the finest level to its phases, those of other levels to 1.
void set_turns(Level& level, bool is_finest);

/// As `descend`, but starts from the phase `start` on the coarsest level.
void descend_from(Hierarchy& hierarchy, Complex start, SweepPlan plan,
                  const Progress& progress = {});

/// From the coarsest level down, prolongs the phases and sweeps as planned. Phases end in
/// `hierarchy.levels[0].z`. There is no random start and no parameter to tune; no sweep raises the
/// energy. Throws Cancelled if `progress` cancels, as the functions below do.
void descend(Hierarchy& hierarchy, SweepPlan plan, const Progress& progress = {});

/// One cycle of `run_cycles`. `has_finest` is false if finer levels are on other processes.
void correct(Hierarchy& hierarchy, SweepPlan plan, bool has_finest = true,
             const Progress& progress = {});

/// Further descents. Each starts from the phases of the finest level, which become its gauges: a
/// coarse unknown turns the phases of its aggregate, and every level starts from Z = 1, no turn.
/// The energy does not rise. Overwrites gauges and coarse couplings, until the next `renew`.
void run_cycles(Hierarchy& hierarchy, SweepPlan plan, int cycles, const Progress& progress);

/// The whole solver without a phase graph: `couple` sets the couplings of the finest level. A
/// nonempty `start`, one unit number per node, replaces the descent before the cycles. `finish`
/// changes the phases (by node) before their energy is measured. `solve_milliseconds` exclude
/// `couple`. Throws Error for options out of range.
PhaseSolution solve_multilevel(const Adjacency& adjacency,
                               const std::function<void(Level& finest)>& couple,
                               const SolverOptions& options, std::span<const Complex> start = {},
                               const Progress& progress = {},
                               const std::function<void(std::span<Complex> z)>& finish = {});

// Valid ranges of solver options.

/// Throws Error for options out of range.
void check_solver_options(const SolverOptions& options);

}  // namespace brindle
