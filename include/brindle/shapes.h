/// The catalogue of built-in shapes, by name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace BRINDLE_EXPORT brindle {

/// Builds a shape from its name and, after commas, parameters that differ from their defaults:
/// "torus" or "torus,resolution=64,minor=0.3". Every shape takes `noise` (see add_noise; 0 by
/// default) and `noise_seed`.
///
/// Throws Error, listing what is known, for an unknown name or parameter, and for a value that is
/// no number or out of the parameter's range; also, before anything is made, for a resolution whose
/// vertices do not fit into memory, naming one that fits. Throws Cancelled if `progress` asks for
/// it.
Mesh make_shape(std::string_view spec, const Progress& progress = {});

/// A part of a shape. Vertices have the numbers that they have in the whole, and its positions.
struct ShapePart {
  Mesh mesh;
  std::vector<std::uint64_t> vertex_ids;  ///< ascending, one per vertex
};

/// Part `part` of `parts`, made without the others: all triangles of part 0, then those of part 1
/// and so on are those of `make_shape`. A part may have no triangle. None for shapes that can only
/// be made whole: vessels, molecule, box, bracket, gear, and those with `noise`. Throws Error as
/// `make_shape`, and for a part number out of range.
std::optional<ShapePart> make_shape_part(std::string_view spec, int part, int parts);

/// All names, in the order in which help lists them.
std::vector<std::string> shape_names();

/// A line per shape and one per parameter, with ranges and defaults.
std::string shape_help();

}  // namespace brindle
