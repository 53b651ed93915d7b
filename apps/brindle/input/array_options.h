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
  std::optional<TensorAxis> tensor;    ///< of a field that is a tensor; major if not given
  std::optional<TensorOrder> order;    ///< of a tensor's components; VTK's if not given
  std::string frequency;               ///< array of stripes per unit length
  std::string frequency_by;            ///< value that --stripes or --frequency are multiplied by
  FrequencyRange range;                ///< of the factors
  std::string mesh;                    ///< file of all arrays; empty: the mesh's own
  std::optional<Length> max_distance;  ///< to `mesh`

  /// Calls `add("--option", field)` for each option that sets a field.
  template <class Add>
  void visit(const Add& add) {
    add("--tensor", tensor);
    add("--tensor-order", order);
    add("--field-mesh", mesh);
    add("--max-distance", max_distance);
  }
};

/// Whether an option's value names an array: "array:NAME", "array:points/NAME".
bool is_array(std::string_view value);

/// The text after "array:". Throws CLI::ValidationError for other values and for an empty name.
std::string parse_array(const std::string& option, const std::string& value);

/// --tensor, --tensor-order, --frequency-by, --frequency-range, --field-mesh and --max-distance.
void add_array_options(CLI::App& app, ArrayOptions& options);

/// An array of a field as directions and tensors are read from it: in VTK's order. Throws
/// CLI::ValidationError for an order of an array that is no tensor.
DataArray ordered_array(const DataArray& array, const ArrayOptions& options);

/// Throws CLI::ValidationError for options that leave each other without effect. `field` is what
/// --field says, which may be a file.
void check_array_options(const CLI::App& command, const ArrayOptions& options,
                         const std::string& field, bool is_file);

}  // namespace brindle::tool
