/// Options for smoothing measured fields.
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "brindle/measured_field.h"
#include "input/vertex_values.h"

namespace brindle::tool {

struct FieldSmoothingChoice {
  float periods = 0;          ///< P; 0: as the field is given
  std::string weight;         ///< what data count by; empty: tensors by anisotropy, others alike
  std::optional<float> fill;  ///< how far holes are filled, in periods
  bool arrows = false;        ///< vectors have a sign
  float hold_out = 0;         ///< share of the data that a check hides; 0: no check
  std::optional<int> singularities;  ///< at most so many; nothing: all stay
  float memory = 0;                  ///< of the step before, in a series
  float frequency_periods = 0;       ///< the same scale for frequencies; 0: as they are

  /// Calls `add("--option", field)` for each option that sets a field.
  template <class Add>
  void visit(const Add& add) {
    add("--field-smoothing", periods);
    add("--fill", fill);
    add("--hold-out", hold_out);
    add("--field-arrows", arrows);
    add("--field-singularities", singularities);
    add("--frequency-smoothing", frequency_periods);
  }
};

/// --field-smoothing, --field-weight, --fill, --hold-out, --field-arrows, --field-singularities and
/// --frequency-smoothing.
void add_field_smoothing_options(CLI::App& app, FieldSmoothingChoice& choice);

/// The option of `FieldSmoothingChoice::weight`.
inline constexpr const char* kWeightOption = "--field-weight";

/// Whether a weight is computed from the data themselves: "", "length" or "anisotropy".
bool is_own_weight(const std::string& weight);

/// The library's options for a field of this rotational symmetry.
FieldSmoothingOptions smoothing_options(const FieldSmoothingChoice& choice, int symmetry);

FrequencySmoothingOptions frequency_smoothing_options(const FieldSmoothingChoice& choice);

}  // namespace brindle::tool
