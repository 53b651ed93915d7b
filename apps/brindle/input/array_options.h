/// Options of waves from arrays of the mesh's file or of another one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "brindle/array_field.h"
#include "brindle/tensor_field.h"
#include "cli/option_values.h"

namespace brindle::tool {

struct ArrayOptions {
  std::optional<TensorAxis> tensor;    ///< for tensors; empty: major
  std::string frequency;               ///< name of the array with stripes per unit length
  std::string frequency_by;            ///< value that scales --stripes or --frequency
  FrequencyRange range;                ///< of the factors
  std::string mesh;                    ///< file of all arrays; empty: the mesh's own
  std::optional<Length> max_distance;  ///< to `mesh`

  /// Calls `add("--option", field)` for each option that sets a field.
  template <class Add>
  void visit(const Add& add) {
    add("--tensor", tensor);
    add("--field-mesh", mesh);
    add("--max-distance", max_distance);
  }
};

/// Whether an option's value names an array: "array:NAME", "array:points/NAME".
bool is_array(std::string_view value);

/// The text after "array:". Throws CLI::ValidationError for other values and for an empty name.
std::string parse_array(const std::string& option, const std::string& value);

/// --tensor, --frequency-by, --frequency-range, --field-mesh and --max-distance.
void add_array_options(CLI::App& app, ArrayOptions& options);

/// Throws CLI::ValidationError for options without effect. `field` is the value of --field.
void check_array_options(const CLI::App& command, const ArrayOptions& options,
                         const std::string& field);

}  // namespace brindle::tool
