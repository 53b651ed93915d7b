/// Options for smoothing measured fields.
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "brindle/measured_field.h"
#include "brindle/recipe/field_data.h"
#include "input/array_source.h"
#include "input/vertex_values.h"

namespace brindle::tool {

struct FieldDetailChoice {
  float periods = 0;          ///< P; 0: no smoothing
  std::string weight;         ///< weight of the data; empty: tensors by anisotropy, others alike
  std::optional<float> fill;  ///< distance over which holes are filled, in periods
  bool arrows = false;        ///< vectors have signs
  std::optional<int> singularities;  ///< keep at most so many; empty: all
  float memory = 0;                  ///< weight of the last step of a series
  float frequency_periods = 0;       ///< the same smoothing for frequencies; 0: none

  /// Calls `add("--option", field)` for each option that sets a field.
  template <class Add>
  void visit(const Add& add) {
    add("--field-detail", periods);
    add("--fill", fill);
    add("--field-arrows", arrows);
    add("--field-singularities", singularities);
    add("--frequency-detail", frequency_periods);
  }
};

/// --field-detail, --field-weight, --fill, --field-arrows, --field-singularities and
/// --frequency-detail.
void add_field_detail_options(CLI::App& app, FieldDetailChoice& choice);

/// Whether a weight is computed from the data themselves: "", "length" or "anisotropy".
bool is_own_weight(const std::string& weight);

/// Weights of data per vertex or, for some, per triangle. Throws Error for arrays and columns as
/// `vertex_values` does.
FieldWeight field_weight(const ValueSource& source, const ArraySource& arrays,
                         const FieldDetailChoice& choice, bool of_triangles);

/// The library's options for a field of this rotational symmetry.
FieldDetailOptions detail_options(const FieldDetailChoice& choice, int symmetry);

FrequencyDetailOptions frequency_detail_options(const FieldDetailChoice& choice);

}  // namespace brindle::tool
