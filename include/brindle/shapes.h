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

/// Throws Error, listing the valid ones, for an unknown name or parameter, and for a value that is
/// no number or out of range. Throws Error, before allocating, for a resolution whose vertices do
/// not fit in memory, naming one that fits. Throws Cancelled if `progress` cancels.
Mesh make_shape(std::string_view spec, const Progress& progress = {});

/// A part of a shape. Its vertices have the numbers and positions of the whole shape.
struct ShapePart {
  Mesh mesh;
  std::vector<std::uint64_t> vertex_ids;  ///< ascending, one per vertex
};

/// Part `part` of `parts`, made without the others. The triangles of all parts, in order, are those
/// of `make_shape`. A part may have no triangle. Empty for shapes that can only be made whole:
/// vessels, molecule, box, bracket, gear, and those with `noise`. Throws Error as `make_shape`, and
/// for a part number out of range.
std::optional<ShapePart> make_shape_part(std::string_view spec, int part, int parts);

/// A parameter of a shape.
struct ShapeParameter {
  std::string name;
  double standard = 0;
  double lower = 0, upper = 0;
  bool whole = false;  ///< integers only
  std::string help;
};

struct ShapeInfo {
  std::string name;
  std::string help;
  std::vector<ShapeParameter> parameters;
};

/// All shapes, in the order in which help lists them.
std::vector<ShapeInfo> shape_catalogue();

/// Their names.
std::vector<std::string> shape_names();

/// A line per shape and one per parameter, with ranges and defaults.
std::string shape_help();

}  // namespace brindle
