/// Wave properties of a filter, and the resulting waves.
#pragma once

#include <optional>
#include <vector>

#include <brindle/array_field.h>
#include <brindle/data_arrays.h>
#include <brindle/direction_field.h>
#include <brindle/measured_field.h>
#include <brindle/normals.h>
#include <brindle/phase_graph.h>
#include <brindle/surface.h>
#include <brindle/tensor_field.h>
#include <brindle/waves_of.h>

#include "rank_piece.h"

namespace brindle::paraview {

/// Where directions come from.
enum class FieldSource { smooth, curvature, direction, array };

/// Where frequencies come from.
enum class FrequencySource {
  along_diagonal,  ///< `stripes` along the diagonal of the bounding box
  per_length,      ///< `frequency`, stripes per unit length
  array,           ///< an array of stripes per unit length
  by_array,        ///< `stripes` along the diagonal, times a factor that follows an array
  spacing          ///< one stripe per `spacing`
};

struct WaveSettings {
  FieldSource field = FieldSource::smooth;
  CurvatureDirection curvature_direction = CurvatureDirection::maximum;
  TensorAxis tensor_axis = TensorAxis::major;
  Vec3 direction = Vec3::UnitZ();  ///< of FieldSource::direction
  WaveRequest request;             ///< smoothing of arrays, and the turn about the normals
  FrequencySource frequency_source = FrequencySource::along_diagonal;
  float stripes = 40;
  float frequency = 1;
  float spacing = 1;
  FrequencyRange range;

  /// Whether directions depend on the surface and these settings alone.
  bool is_made() const { return field == FieldSource::smooth || field == FieldSource::curvature; }
  bool needs_frequency_array() const {
    return frequency_source == FrequencySource::array ||
           frequency_source == FrequencySource::by_array;
  }
};

/// The directions of FieldSource::smooth and ::curvature, before they are turned; with a partition,
/// collective, and those of the whole surface. They start from the directions `last`, one per
/// vertex (`SmoothFieldOptions::last`), on all ranks or on none.
DirectionField made_directions(const Surface& surface, const WaveSettings& settings,
                               const RankPiece* piece = nullptr, DirectionField last = {});

/// Arrays of waves, null unless the settings use them: a row per vertex.
struct WaveArrays {
  const DataArray* vectors = nullptr;  ///< 3 numbers a row, 2 in the plane, or a tensor's 6 or 9
  const DataArray* frequencies = nullptr;
  const DataArray* weights = nullptr;  ///< weights of the data; null: tensors by their anisotropy
  // Cell arrays, unchanged: a row per triangle.
  const DataArray* cell_vectors = nullptr;
  const DataArray* cell_weights = nullptr;
};

/// `made` is from `made_directions` if the settings use it, `last` the last time's smoothed field
/// or empty, the same on all ranks. There is no wave where an array is not finite and not filled.
/// With a partition, collective: diagonal and extents are those of the whole, and shared vertices
/// have the owner's wave. Throws Error for invalid arrays and numbers.
WaveResult make_waves(const Surface& surface, const WaveSettings& settings, DirectionField made,
                      const WaveArrays& arrays, const DirectionField& last = {},
                      const RankPiece* piece = nullptr);

}  // namespace brindle::paraview
