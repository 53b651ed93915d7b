/// Frequencies of the pieces of a surface.
#pragma once

#include <string>

#include "brindle/communicator.h"
#include "brindle/distributed_surface.h"
#include "input/wave_options.h"
#include "mesh_pieces.h"
#include "piece_fields.h"

namespace brindle::tool {

/// Collective. Gives a field the frequencies that the options ask for, NaN where there are none, as
/// `make_waves` does.
void choose_piece_frequencies(Communicator& ranks, const DistributedSurface& surface,
                              const ReadPiece& read, const WaveOptions& options, PieceField& field);

}  // namespace brindle::tool
