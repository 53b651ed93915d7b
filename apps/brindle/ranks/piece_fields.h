/// Direction fields of partitions, before they are turned and get frequencies.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "brindle/communicator.h"
#include "brindle/distributed_surface.h"
#include "brindle/frequency_field.h"
#include "brindle/recipe/wave_report.h"
#include "input/make_waves.h"
#include "input/wave_options.h"
#include "ranks/mesh_pieces.h"
#include "ranks/piece_rows.h"

namespace brindle::tool {

/// Of the partition's vertices; counts are over all ranks.
struct PieceField : FoundField {
  /// Of the mesh's file or another one; refers to the surface and to the read data.
  std::shared_ptr<const PieceArrays> arrays = {};
  FieldData data = {};  ///< its source, if it was measured: rows of the partition
};

/// Collective. As `make_base_field`, for partitions.
PieceField make_piece_field(Communicator& ranks, const DistributedSurface& surface,
                            const ReadPiece& read, const WaveOptions& options);

}  // namespace brindle::tool
