/// Measured fields of partitions.
#pragma once

#include "brindle/communicator.h"
#include "brindle/distributed_surface.h"
#include "brindle/measured_field.h"
#include "input/wave_options.h"
#include "ranks/mesh_pieces.h"
#include "ranks/piece_fields.h"

namespace brindle::tool {

/// Collective. The data of a field with their weights; empty without --field-smoothing. Throws on
/// all ranks: CLI::ValidationError for invalid weights, and what the library throws.
MeasuredField piece_measured(Communicator& ranks, const DistributedSurface& surface,
                             const ReadPiece& read, const WaveOptions& options,
                             const PieceField& field);

}  // namespace brindle::tool
