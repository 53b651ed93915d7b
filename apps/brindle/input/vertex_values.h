/// Numbers per vertex that styles follow, from what options ask for.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/surface.h"
#include "input/array_options.h"
#include "input/viewpoint.h"

namespace brindle::tool {

/// What values may be taken from.
struct ValueSource {
  const Surface& surface;
  const DataArrays& arrays;  ///< of the mesh's file: a row per vertex, and per triangle
  std::string file;          ///< the mesh's, for messages
  const ArrayOptions& options;
  std::span<const Index> vertex_of_row;   ///< as FileData has it
  const Viewpoint* viewpoint = nullptr;   ///< of the picture; null: there is none
  std::span<const float> agreement = {};  ///< of a measured field's data; empty: there is none
};

struct VertexValues {
  std::vector<float> values;  ///< one per vertex; NaN: none
  std::string title;          ///< for legends
  /// Of a range that is given, and not that of the values themselves.
  std::optional<Eigen::Vector2f> ends = std::nullopt;

  /// The ends of all finite values, unless others are given. Throws Error, naming `option`, if
  /// there are none.
  Eigen::Vector2f range(const std::string& option) const;
};

/// What VALUE may be, for the help text. Heights are z, or along the axis that --up names.
inline constexpr const char* kValueNames =
    "array:NAME|FILE.csv[:COLUMN]|distance:X,Y,Z|distance:camera|curvature|height|light|agreement";

/// Throws CLI::ValidationError, naming the option, unless `text` can name values. `names` are those
/// that messages list.
void check_value_name(const std::string& option, const std::string& text,
                      const std::string& names = kValueNames);

/// The values of FILE.csv or FILE.csv:COLUMN for a mesh of so many vertices; rows may stand for
/// those of the mesh's file, as FileData has them. Throws as `vertex_values` does.
VertexValues csv_values(const std::string& option, const std::string& text, std::size_t vertices,
                        std::span<const Index> vertex_of_row);

/// The numbers of an array that has one a row, or the lengths of its vectors; a row per vertex, NaN
/// where it is not finite. Throws as `vertex_values` does.
std::vector<float> scalar_values(const std::string& option, const DataArray& array,
                                 std::size_t vertices, const std::string& file);

/// The file that `text` names values of; empty if it names none.
std::string value_file(const std::string& text);

/// Whether values belong to a file, and not to the shape and its place.
bool is_of_file(const std::string& text);

/// Whether the values are others from another viewpoint.
bool depends_on_camera(const std::string& text);

/// Whether they are others where the light comes from elsewhere.
bool depends_on_light(const std::string& text);

/// Whether they are others where another axis points up.
bool depends_on_up(const std::string& text);

/// Whether they are others where the field is.
bool depends_on_field(const std::string& text);

/// Values of vertices that triangles use, or that are points; none at others. Throws Error for
/// arrays and columns that are not there, that have not one number a row (vectors
/// count by their lengths) or not a row per vertex, for values of a camera without a
/// viewpoint, and for the agreement of data that were not seen at any scale.
VertexValues vertex_values(const std::string& option, const std::string& text,
                           const ValueSource& source);

}  // namespace brindle::tool
