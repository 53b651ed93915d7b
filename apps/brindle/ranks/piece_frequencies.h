/// Frequencies of partitions.
#pragma once

#include <string>

#include "brindle/communicator.h"
#include "brindle/distributed_surface.h"
#include "input/wave_options.h"
#include "ranks/mesh_pieces.h"
#include "ranks/piece_fields.h"

namespace brindle::tool {

/// Collective. Sets a field's frequencies by the options, NaN if there are none, as `make_waves`
/// does.
void choose_piece_frequencies(Communicator& ranks, const DistributedSurface& surface,
                              const ReadPiece& read, const WaveOptions& options, PieceField& field);

}  // namespace brindle::tool
