/// A piece of a surface as what waves are on.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "brindle/distributed/communicator.h"
#include "brindle/distributed_surface.h"
#include "brindle/waves_of.h"
#include "mesh_pieces.h"

namespace brindle::tool {

/// Its functions are collective and give what those of a `WholeSurface` give of the whole.
class PieceSurface final : public WaveSurface {
 public:
  /// Refers to all of them.
  PieceSurface(Communicator& ranks, const DistributedSurface& surface, const ReadPiece& read)
      : ranks_(ranks), surface_(surface), read_(read) {}

  std::vector<Vec3> positions() const override { return read_.piece.mesh.positions; }
  std::span<const Vec3> normals() const override { return surface_.normals(); }
  bool any(bool here) const override { return ranks_.any(here); }
  /// The mean frequency and the number are those of all ranks.
  std::size_t drop_waves(DirectionField& directions, FrequencyField& frequencies) const override;
  DetailedFrequencies frequencies_at_detail(std::span<const float> frequencies,
                                            const FrequencyDetailOptions& options,
                                            const Progress& progress) const override;
  std::pair<DetailedField, FieldDetailFigures> field_at_detail(
      const MeasuredField& measured, std::span<const float> places, const DirectionField& last,
      const FieldDetailOptions& options, const Progress& progress) const override;

 private:
  Communicator& ranks_;
  const DistributedSurface& surface_;
  const ReadPiece& read_;
};

}  // namespace brindle::tool
