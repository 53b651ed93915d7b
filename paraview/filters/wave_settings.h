/// What a filter's properties say of waves, and the waves that follow.
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
  by_array         ///< `stripes` along the diagonal, times a factor that follows an array
};

struct WaveSettings {
  FieldSource field = FieldSource::smooth;
  CurvatureDirection curvature_direction = CurvatureDirection::maximum;
  TensorAxis tensor_axis = TensorAxis::major;
  Vec3 direction = Vec3::UnitZ();  ///< of FieldSource::direction
  float detail = 0;                ///< of an array, in periods; 0: as it is given
  float fill = 2;                  ///< how far holes in an array are filled, in periods
  bool arrows = false;             ///< vectors of an array have a sign
  int singularities = -1;          ///< at most so many are left; below 0: all stay
  float memory = 0;                ///< how much the field of the time before counts beside them
  float frequency_detail = 0;      ///< the same scale for an array of frequencies
  float turn_deg = 0;              ///< about the normals, counter-clockwise seen from their tips
  FrequencySource frequency_source = FrequencySource::along_diagonal;
  float stripes = 40;
  float frequency = 1;
  FrequencyRange range;

  /// Whether directions follow from the surface and these settings alone.
  bool is_made() const { return field == FieldSource::smooth || field == FieldSource::curvature; }
  bool needs_frequency_array() const {
    return frequency_source == FrequencySource::array ||
           frequency_source == FrequencySource::by_array;
  }
};

/// The directions of FieldSource::smooth and ::curvature, before `turn_deg`; with a piece,
/// collective, those of the whole at its vertices. They go on from the directions `last`, one per
/// vertex (`SmoothFieldOptions::last`), on all ranks or on none.
DirectionField made_directions(const Surface& surface, const WaveSettings& settings,
                               const RankPiece* piece = nullptr, DirectionField last = {});

/// Arrays that waves are made of, null where the settings do not ask for them: a row per vertex.
struct WaveArrays {
  const DataArray* vectors = nullptr;  ///< 3 numbers a row, 2 in the plane, or a tensor's 6 or 9
  const DataArray* frequencies = nullptr;
  const DataArray* weights = nullptr;  ///< how much data count; null: tensors by their anisotropy
  // Where they are cells', as they are: a row per triangle.
  const DataArray* cell_vectors = nullptr;
  const DataArray* cell_weights = nullptr;
};

/// `made` has what `made_directions` gave where the settings ask for it, `last` what was seen at
/// the time before, or nothing, on all ranks alike. There is no wave where an array is not finite,
/// and cannot be filled. With a piece, collective: the whole's diagonal and numbers count, and a
/// vertex of several ranks has the wave that its owner says. Throws Error for what arrays and
/// numbers cannot be.
WaveResult make_waves(const Surface& surface, const WaveSettings& settings, DirectionField made,
                      const WaveArrays& arrays, const DirectionField& last = {},
                      const RankPiece* piece = nullptr);

}  // namespace brindle::paraview
