/// What a report says of a run before the stripes.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "brindle/carried_field.h"
#include "brindle/recipe/wave_report.h"

namespace brindle {

struct PreparationFigures {
  WaveReport figures;                               ///< of the waves
  std::optional<std::size_t> field_rows_nonfinite;  ///< of a field file or array
  std::optional<FieldStep> field_step;  ///< of a smooth field that went on from a last one
  float turn_deg = 0;                   ///< by which waves are turned from their field
  std::vector<float> agreement;         ///< of a measured field's data, per vertex; mostly empty
  std::size_t vertices_joined = 0;      ///< with others at their place
  double load_milliseconds = 0;         ///< reading or making the mesh
  double field_milliseconds = 0;        ///< directions and frequencies
  double topology_milliseconds = 0;     ///< neighbourhood and normals
};

}  // namespace brindle
