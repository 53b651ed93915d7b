/// Waves of partitions, without phases.
#pragma once

#include <cstddef>
#include <optional>

#include "brindle/communicator.h"
#include "brindle/distributed_stripes.h"
#include "brindle/recipe/wave_report.h"
#include "cli/job_listener.h"
#include "input/solving_options.h"
#include "input/wave_options.h"
#include "ranks/mesh_pieces.h"
#include "ranks/piece_fields.h"

namespace brindle::tool {

/// Waves of the partition's vertices, and the time spent.
struct PieceWaves {
  WaveSet waves;
  WaveReport figures;
  std::optional<std::size_t> field_rows_nonfinite;  ///< of a field file or array, on all ranks
  FieldSupport support;                             ///< of smoothed waves
  double milliseconds = 0;
};

/// The arrays that the waves' options use.
WantedArrays wanted_arrays(const WaveOptions& options);

/// Collective. Makes the waves of the options and notes likely mistakes.
PieceWaves make_piece_waves(Communicator& ranks, const DistributedSurface& surface,
                            const ReadPiece& read, const WaveOptions& options,
                            JobListener& listener);

/// Collective. Options of the solver, including the spacing tolerance; throws what `piece_slack`
/// throws.
DistributedOptions animator_options(Communicator& ranks, const SolvingOptions& solving,
                                    std::size_t plan_below, const ReadPiece& read,
                                    const DistributedSurface& surface);

}  // namespace brindle::tool
