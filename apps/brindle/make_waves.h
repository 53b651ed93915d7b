/// Waves from what options ask for.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "brindle/data_arrays.h"
#include "brindle/frequency_field.h"
#include "brindle/phase_graph.h"
#include "brindle/surface.h"
#include "wave_figures.h"
#include "wave_options.h"

namespace brindle::tool {

/// What the file of a mesh says beside the mesh.
struct FileData {
  std::string name;          ///< of the file
  const DataArrays& arrays;  ///< a row per vertex of the surface, and per triangle
  /// Rows of a field file may stand for those of the mesh's file (`Preparation`).
  std::span<const Index> vertex_of_row = {};
};

/// Waves without phases, and the frequencies of those that cross them.
struct WavesAndCrossing {
  WaveSet waves;                                    ///< one wave per vertex
  FrequencyField frequencies_v;                     ///< one per vertex; empty: those of `waves`
  std::optional<std::size_t> field_rows_nonfinite;  ///< of a field file or array
  MissingWaves missing;
  std::string notes;  ///< lines for the user
};

/// Throws Error if a field file or an array does not fit, CLI::ValidationError for --tensor if the
/// field turns out to be no tensor.
WavesAndCrossing make_waves(const Surface& surface, const WaveOptions& options,
                            const FileData& data);

}  // namespace brindle::tool
