/// Measured fields and frequencies of pieces at the scale of their stripes.
#pragma once

#include "brindle/distributed/communicator.h"
#include "brindle/distributed_surface.h"
#include "input/make_waves.h"
#include "input/wave_options.h"
#include "mesh_pieces.h"
#include "piece_fields.h"

namespace brindle::tool {

/// Collective. What `make_waves` makes of the whole's field, which was not turned: `frequencies`
/// are NaN where there is no wave. Fills `made.detail` and `made.agreement`. Throws
/// CLI::ValidationError on all ranks for weights that cannot be, and what the library throws.
void see_piece_at_detail(Communicator& ranks, const DistributedSurface& surface,
                         const ReadPiece& read, const WaveOptions& options,
                         const FrequencyField& frequencies, PieceField& field,
                         WavesAndCrossing& made, const Progress& progress);

}  // namespace brindle::tool
