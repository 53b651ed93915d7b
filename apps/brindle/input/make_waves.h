/// Waves from what options ask for.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brindle/carried_field.h"
#include "brindle/data_arrays.h"
#include "brindle/frequency_field.h"
#include "brindle/phase_graph.h"
#include "brindle/progress.h"
#include "brindle/recipe/wave_report.h"
#include "brindle/surface.h"
#include "brindle/waves_of.h"
#include "input/array_source.h"
#include "input/viewpoint.h"
#include "input/wave_options.h"

namespace brindle::tool {

/// What the file of a mesh says beside the mesh.
struct FileData {
  std::string name;          ///< of the file
  const DataArrays& arrays;  ///< a row per vertex of the surface, and per triangle
  /// Rows of a field file may stand for those of the mesh's file (`Preparation`).
  std::span<const Index> vertex_of_row = {};
  const Viewpoint* viewpoint = nullptr;  ///< of pictures; null: there are none
};

/// Waves without phases, and what is said of their field.
struct WavesOfField : WaveResult {
  std::optional<std::size_t> field_rows_nonfinite;  ///< of a field file or array
  std::string notes;                                ///< lines for the user
  std::optional<FieldStep> field_step;  ///< of a smooth field that went on from a last one
};

/// A direction field before it is turned and gets the frequencies that options ask for.
struct FoundField {
  DirectionField directions;
  FrequencyField frequencies;    ///< empty if the field says nothing of them; NaN in gaps
  FrequencyField frequencies_v;  ///< the same of crossing stripes
  std::optional<std::size_t> rows_nonfinite = {};
  MissingWaves missing = {};
  std::string notes = {};
  bool may_have_gaps = false;  ///< `frequencies`, those of a file
};

/// What takes long, and need not be made again for other frequencies.
struct BaseField : FoundField {
  FieldData data = {};                 ///< what it was made of, if it was measured
  MeasuredField measured = {};         ///< the same, weighted; empty if it was not
  DirectionField last = {};            ///< of the step before, if it counts beside the data
  std::optional<FieldStep> step = {};  ///< as WavesOfField has it
  /// Of the surface's file or another one; refers to the surface and the data.
  std::shared_ptr<const ArraySource> arrays = {};
};

/// What a smooth field goes on from.
struct LastDirections {
  DirectionField directions;  ///< one per vertex, as `SmoothFieldOptions::last` has them; or none.
                              ///< Of measured fields: what --field-memory mixes with the data
  bool same_surface = false;  ///< nothing has moved since: they are the field
  std::string notes = {};     ///< lines about them
};

/// The first half of `make_waves`, with what that throws. A smooth field goes on from `last`.
BaseField make_base_field(const Surface& surface, const WaveOptions& options, const FileData& data,
                          const LastDirections& last = {}, const Progress& progress = {});

/// What options ask of waves, whatever their field is.
WaveRequest wave_request(const WaveOptions& options);

/// The second half.
WavesOfField make_waves(const Surface& surface, const WaveOptions& options, const FileData& data,
                        BaseField field, const Progress& progress = {});

/// Throws Error if a field file or an array does not fit, CLI::ValidationError for --tensor if the
/// field turns out to be no tensor.
WavesOfField make_waves(const Surface& surface, const WaveOptions& options, const FileData& data);

}  // namespace brindle::tool
