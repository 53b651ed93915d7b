/// What a report says of a run before the stripes.
#pragma once

#include <cstddef>
#include <optional>

#include "wave_figures.h"

namespace brindle::tool {

struct PreparationFigures {
  WaveFigures figures;                              ///< of the waves
  std::optional<std::size_t> field_rows_nonfinite;  ///< of a field file or array
  std::size_t vertices_joined = 0;                  ///< with others at their place
  double load_milliseconds = 0;                     ///< reading or making the mesh
  double field_milliseconds = 0;                    ///< directions and frequencies
  double topology_milliseconds = 0;                 ///< neighbourhood and normals
};

}  // namespace brindle::tool
