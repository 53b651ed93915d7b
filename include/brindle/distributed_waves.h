/// Waves on a surface partitioned over processes.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "brindle/array_field.h"
#include "brindle/distributed_surface.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/waves_of.h"

namespace BRINDLE_EXPORT brindle {

/// Collective. `frequencies_by` of array_field.h for the whole surface, at the vertices of the
/// partition; the owner's number of a vertex counts. Throws Error on all ranks, as that does.
FrequencyField frequencies_by(const DistributedSurface& surface, const DataArray& array,
                              float frequency, const FrequencyRange& range = {});

/// A partition as the surface of waves. Its functions are collective and return the results of a
/// `WholeSurface` for the whole; the owner's values of a vertex count, and those of ghost triangles
/// do not. Rank 0 smooths the whole, and needs memory for it. Errors are thrown on all ranks, and
/// Cancelled if the `progress` of any rank cancels.
class PieceSurface final : public WaveSurface {
 public:
  /// Keeps references to both; `piece` is the mesh that the surface was made from.
  PieceSurface(const DistributedSurface& surface, const Mesh& piece)
      : surface_(surface), piece_(piece) {}

  std::vector<Vec3> positions() const override { return piece_.positions; }
  std::span<const Vec3> normals() const override { return surface_.normals(); }
  bool any(bool here) const override;
  std::size_t opposite_edges() const override;
  /// The mean frequency and the number are over all ranks.
  std::size_t drop_waves(DirectionField& directions, FrequencyField& frequencies) const override;
  SmoothedFrequencies smooth_frequencies(std::span<const float> frequencies,
                                         const FrequencySmoothingOptions& options,
                                         const Progress& progress) const override;
  std::pair<SmoothedField, FieldSmoothingMetrics> smooth_field(
      const MeasuredField& measured, std::span<const float> places, const DirectionField& last,
      const FieldSmoothingOptions& options, const Progress& progress) const override;

 private:
  const DistributedSurface& surface_;
  const Mesh& piece_;
};

}  // namespace brindle
