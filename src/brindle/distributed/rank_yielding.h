/// Frequencies that yield over ranks.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brindle/distributed/levels/rank_rows.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/waves/yielding_solver.h"

namespace brindle {

/// What owners say of all vertices of a rank, given what each has by vertex of its piece. Empty if
/// no rank has anything. Collective.
std::vector<float> owners_values(const RankSurface& surface, std::span<const float> of_piece);

/// The setting of a rank's part, whose vertices are own ones and ghosts; `slack` is by vertex of
/// the piece. Collective.
std::shared_ptr<const YieldingSetting> rank_yielding_setting(const RankSurface& surface,
                                                             const Slack& slack);

/// Throws Error on all ranks for a slack that `check` refuses, and for one that has a number for
/// each vertex of some pieces and for none of others. Collective.
void check_on_all(const RankSurface& surface, const Slack& slack);

}  // namespace brindle
