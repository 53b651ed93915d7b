/// Patterns over partitions: what commands do before their results are written.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "brindle/distributed/surface/gathered_surface.h"
#include "brindle/distributed_pattern.h"
#include "brindle/distributed_stripes.h"
#include "brindle/quality.h"
#include "input/preparation.h"
#include "input/second_waves.h"
#include "input/used_files.h"
#include "outputs/outputs.h"
#include "ranks/mesh_pieces.h"
#include "ranks/rank_run.h"

namespace brindle::tool {

/// Collective. All input files: `files`, and the pieces of a .pvtp. Throws if ranks see different
/// ones.
std::vector<UsedFile> rank_inputs(const RankRun& run, const SurfaceOptions& surface,
                                  std::vector<UsedFile> files);

/// Throws CLI::ValidationError for values of options that ranks do not have.
void check_rank_options(const WaveOptions& waves, const SolvingOptions& solving);

/// Collective. A partition with its waves and the time spent.
struct RankPreparation : PreparationMetrics {
  ReadPiece read;
  std::optional<DistributedSurface> surface;
  WaveSet waves;
};
RankPreparation prepare_piece(const RankRun& run, const JobArguments& arguments, bool all_arrays,
                              JobListener& listener);

/// A solved pattern of a partition, with a row per vertex of it.
struct RankPattern {
  StripePattern pattern;
  std::optional<CreaseSlip> slip;
  DistributedStripeAnimator animator;

  PiecePattern of(const RankPreparation& prepared) const {
    return {*prepared.surface, pattern.waves, pattern.solution.z, pattern.phase_shift};
  }
};

/// Collective. `waves` are those of `prepared`, or V's.
RankPattern solve_piece(const RankRun& run, const RankPreparation& prepared, WaveSet waves,
                        const SolvingOptions& solving, JobListener& listener);

/// U's waves turned by 90 degrees, with V's own frequency if there is one.
WaveSet rank_waves_of_v(const RankPreparation& prepared, const SecondWaveOptions& options);

/// Collective. The pattern of the whole surface, on rank 0.
StripePattern whole_pattern(const GatheredSurface& whole, const RankPreparation& prepared,
                            const RankPattern& solved);

/// On rank 0, the whole surface as one process prepares it, without waves and arrays.
Preparation whole_preparation(const GatheredSurface& whole, const RankPreparation& prepared);

/// Collective. Names the stage of all ranks.
void enter_stage(const RankRun& run, JobListener& listener, const char* name);

}  // namespace brindle::tool
