/// Waves of the pieces of a surface, before they have phases.
#pragma once

#include <vector>

#include "brindle/distributed/communicator.h"
#include "brindle/distributed_stripes.h"
#include "job_listener.h"
#include "solving_options.h"
#include "wave_figures.h"
#include "wave_options.h"

namespace brindle::tool {

/// Waves of the piece's vertices, and what they took.
struct PieceWaves {
  WaveSet waves;
  WaveFigures figures;
  double milliseconds = 0;
};

/// Collective. As the options ask for; notes what is wrong with them.
PieceWaves make_piece_waves(Communicator& ranks, const DistributedSurface& surface,
                            std::vector<Vec3> positions, const WaveOptions& options,
                            JobListener& listener);

DistributedOptions animator_options(const SolvingOptions& solving);

}  // namespace brindle::tool
