/// Measured fields of pieces.
#pragma once

#include "brindle/communicator.h"
#include "brindle/distributed_surface.h"
#include "brindle/measured_field.h"
#include "input/wave_options.h"
#include "mesh_pieces.h"
#include "piece_fields.h"

namespace brindle::tool {

/// Collective. The data of a field with what they count by; nothing without --field-detail. Throws
/// CLI::ValidationError on all ranks for weights that cannot be, and what the library throws.
MeasuredField piece_measured(Communicator& ranks, const DistributedSurface& surface,
                             const ReadPiece& read, const WaveOptions& options,
                             const PieceField& field);

}  // namespace brindle::tool
