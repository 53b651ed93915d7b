/// The catalogue of built-in shapes, by name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "brindle/export.h"
#include "brindle/mesh.h"

namespace BRINDLE_EXPORT brindle {

/// Builds a shape from its name and, after commas, parameters that are not to have their defaults:
/// "torus" or "torus,resolution=64,minor=0.3". Every shape takes `noise` (see add_noise; 0 by
/// default) and `noise_seed`.
///
/// Throws Error, listing what is known, for an unknown name or parameter, and for a value that is
/// no number or out of the parameter's range.
Mesh make_shape(std::string_view spec);

/// All names, in the order in which help lists them.
std::vector<std::string> shape_names();

/// A line per shape and one per parameter, with ranges and defaults.
std::string shape_help();

}  // namespace brindle
