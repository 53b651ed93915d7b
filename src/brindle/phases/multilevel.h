/// The multilevel solver: descends a hierarchy of exact sums (docs/method.md).
#pragma once

#include "brindle/phases/hierarchy.h"

namespace brindle {

/// Levels of fewer slots are small: they cost next to nothing.
inline constexpr Index kSmallLevel = 4096;

/// The sweeps that a descent makes on one level.
struct LevelSweeps {
  int count;
  float over_relaxation;  ///< of all but the last, which leaves no overshoot behind

  float over_relaxation_of(int number) const { return number + 1 < count ? over_relaxation : 1; }
};

/// Finest levels of so many slots are large: what sweeps leave undone there is much of what energy
/// is left.
inline constexpr Index kLargeLevel = Index{1} << 17;

/// The sweeps of a descent where so many are asked for. What a small level leaves undone no finer
/// level can mend: sweeps grow in number and reach as levels shrink.
class SweepPlan {
 public:
  /// What frames can afford: more sweeps on small levels alone. A number of sweeps is such a plan.
  SweepPlan(int sweeps) : sweeps_(sweeps) {}

  /// What costs little beside building the levels: on all levels of a large graph three to twelve
  /// times as many, which leaves about what four cycles left of the plan of frames
  /// (docs/method.md). `finest` is how many slots the finest level has.
  static SweepPlan for_new_levels(int sweeps, Index finest);

  LevelSweeps on_level(Index slot_count) const;

 private:
  int sweeps_;
  Index large_ = 0;  ///< slots of the finest level of a large graph; 0: it is none
};

/// The sweeps of a descent on one level.
void sweep_level(Level& level, SweepPlan plan);

/// Makes gauges of the phases that a level has: of the finest of all its phases, of others 1.
void set_turns(Level& level, bool is_finest);

/// From this phase on the coarsest level down to the finest, as `descend` does.
void descend_from(Hierarchy& hierarchy, Complex start, SweepPlan plan,
                  const Progress& progress = {});

/// From the coarsest level down: prolong the phases, then coloured sweeps, as many as planned.
/// Phases end in `hierarchy.levels[0].z`. No random start and nothing to tune; each sweep can only
/// lower the energy.
void descend(Hierarchy& hierarchy, SweepPlan plan, const Progress& progress = {});

/// One cycle of `run_cycles`. `has_finest` tells whether the first level is the finest, as it is
/// unless finer ones are elsewhere.
void correct(Hierarchy& hierarchy, SweepPlan plan, bool has_finest = true,
             const Progress& progress = {});

/// So many further descents, each from the phases that the finest level has: they become its
/// gauges, so that a coarse unknown turns the phases of its aggregate, and not turning (Z = 1) is
/// where every level starts. The energy cannot rise. Overwrites gauges and coarse couplings; the
/// next `renew` restores them. Throws Cancelled if `progress` asks for it.
void run_cycles(Hierarchy& hierarchy, SweepPlan plan, int cycles, const Progress& progress);

/// The stages of the multilevel solver: "couple", "hierarchy", "descent" and "cycles".
std::vector<JobStage> multilevel_stages();

}  // namespace brindle
