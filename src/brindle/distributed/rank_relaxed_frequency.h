/// The distributed spacing tolerance.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brindle/distributed/levels/rank_rows.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/waves/relaxed_frequency_solver.h"

namespace brindle {

/// Collective. The owners' values at all vertices of a rank, from values by vertex of each
/// partition. Empty if no rank has any.
std::vector<float> owners_values(const RankSurface& surface, std::span<const float> of_piece);

/// Collective. The setting of a rank's own vertices and ghosts; `slack` is by vertex of the
/// partition.
std::shared_ptr<const RelaxedFrequencySetting> rank_relaxed_setting(const RankSurface& surface,
                                                                    const Slack& slack);

/// Collective. Throws Error on all ranks for a tolerance that `check` rejects, or that is per
/// vertex on some ranks only.
void check_on_all(const RankSurface& surface, const Slack& slack);

}  // namespace brindle
