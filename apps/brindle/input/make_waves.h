/// Waves from options.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brindle/carried_phases.h"
#include "brindle/data_arrays.h"
#include "brindle/frequency_field.h"
#include "brindle/phase_graph.h"
#include "brindle/progress.h"
#include "brindle/recipe/wave_report.h"
#include "brindle/surface.h"
#include "brindle/waves_of.h"
#include "input/array_source.h"
#include "input/wave_options.h"
#include "input/wave_source.h"

namespace brindle::tool {

/// Waves without phases, and notes on their field.
struct WavesOfField : WaveResult {
  std::optional<std::size_t> field_rows_nonfinite;  ///< of a field file or array
  std::string notes;                                ///< lines for the user
  std::optional<FieldStep> field_step;  ///< of a smooth field that continues the last one
};

/// A direction field, before it is turned and options set its frequencies.
struct FoundField {
  DirectionField directions;
  FrequencyField frequencies;    ///< empty if the field has none; NaN in gaps
  FrequencyField frequencies_v;  ///< the same of crossing stripes
  std::optional<std::size_t> rows_nonfinite = {};
  MissingWaves missing = {};
  std::string notes = {};
  bool may_have_gaps = false;  ///< whether `frequencies`, those of a file, may have gaps
};

/// The expensive part, reusable for other frequencies.
struct BaseField : FoundField {
  FieldData data = {};                 ///< its source, if it was measured
  MeasuredField measured = {};         ///< the same, weighted; empty if not measured
  DirectionField last = {};            ///< of the last step, if it has a weight besides the data
  std::optional<FieldStep> step = {};  ///< as WavesOfField has it
  /// Of the surface's file or another one; refers to the surface and the data.
  std::shared_ptr<const ArraySource> arrays = {};
};

/// The field that a smooth field starts from.
struct LastDirections {
  DirectionField directions;  ///< one per vertex, for `SmoothFieldOptions::last`; may be empty. For
                              ///< measured fields, --temporal-smoothing mixes them with the data
  bool same_surface = false;  ///< unchanged surface: these are the field
  std::string notes = {};     ///< lines about them
};

/// The first half of `make_waves`; throws the same. A smooth field starts from `last`.
BaseField make_base_field(const Surface& surface, const WaveOptions& options, const FileData& data,
                          const LastDirections& last = {}, const Progress& progress = {});

BaseField make_base_field(const WaveSource& source, const WaveOptions& options,
                          const LastDirections& last = {}, const Progress& progress = {});

/// Options of waves that are independent of the field.
WaveRequest wave_request(const WaveOptions& options);

/// The second half.
WavesOfField make_waves(const Surface& surface, const WaveOptions& options, const FileData& data,
                        BaseField field, const Progress& progress = {});
WavesOfField make_waves(const WaveSource& source, const WaveOptions& options, BaseField field,
                        const Progress& progress = {});

/// Throws Error if a field file or an array does not fit, CLI::ValidationError for --tensor with a
/// field that is no tensor.
WavesOfField make_waves(const Surface& surface, const WaveOptions& options, const FileData& data);

}  // namespace brindle::tool
