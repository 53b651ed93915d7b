/// Waves of the pieces of a surface, before they have phases.
#pragma once

#include <cstddef>
#include <optional>

#include "brindle/communicator.h"
#include "brindle/distributed_stripes.h"
#include "brindle/recipe/wave_report.h"
#include "cli/job_listener.h"
#include "input/solving_options.h"
#include "input/wave_options.h"
#include "mesh_pieces.h"
#include "piece_fields.h"

namespace brindle::tool {

/// Waves of the piece's vertices, and what they took.
struct PieceWaves {
  WaveSet waves;
  WaveReport figures;
  std::optional<std::size_t> field_rows_nonfinite;  ///< of a field file or array, on all ranks
  FieldSupport support;                             ///< of smoothed waves
  double milliseconds = 0;
};

/// The arrays that the options take waves from.
WantedArrays wanted_arrays(const WaveOptions& options);

/// Collective. As the options ask for; notes what is wrong with them.
PieceWaves make_piece_waves(Communicator& ranks, const DistributedSurface& surface,
                            const ReadPiece& read, const WaveOptions& options,
                            JobListener& listener);

/// Collective. How phases are found, slack and all; throws what `piece_slack` throws.
DistributedOptions animator_options(Communicator& ranks, const SolvingOptions& solving,
                                    std::size_t plan_below, const ReadPiece& read,
                                    const DistributedSurface& surface);

}  // namespace brindle::tool
