/// Values per vertex, and the viewpoint that some depend on.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/camera.h"
#include "brindle/data_arrays.h"
#include "brindle/surface.h"
#include "input/wave_options.h"

namespace brindle::tool {

/// The viewpoint of a future picture.
struct Viewpoint {
  CameraView view;                            ///< with the slice in file coordinates
  int width = 0;                              ///< of the picture, pixels
  int height = 0;                             ///< of the picture, pixels
  std::optional<Mesh> framed = std::nullopt;  ///< framed by the camera, instead of the surface
  UpAxis height_axis = UpAxis::z;             ///< the axis of heights
  std::optional<LightDirection> light_from = std::nullopt;  ///< of the picture
};

/// The camera of this viewpoint, relative to the origin of `mesh`. It frames all vertices of meshes
/// without triangles.
Camera camera_of(const Viewpoint& viewpoint, const Mesh& mesh);

/// Whether the command draws pictures from a viewpoint.
bool has_camera(const CLI::App& command);

/// Sources of values.
struct ValueSource {
  const Surface& surface;
  const DataArrays& arrays;  ///< of the mesh's file, per vertex and per triangle
  std::string file;          ///< the mesh's name, for messages
  const ArrayOptions& options;
  std::span<const Index> vertex_of_row;   ///< as in FileData
  const Viewpoint* viewpoint = nullptr;   ///< of the picture; null: none
  std::span<const float> coherence = {};  ///< coherence of a measured field's data; empty: none
};

struct VertexValues {
  std::vector<float> values;  ///< one per vertex; NaN without a value
  std::string title;          ///< for legends
  /// Of a given range, instead of that of the values.
  std::optional<Eigen::Vector2f> ends = std::nullopt;

  /// The range of all finite values, unless `ends` has one. Throws Error with `option` if there are
  /// none.
  Eigen::Vector2f range(const std::string& option) const;
};

/// The syntax of VALUE, for help. Heights are along the axis of --up, z by default.
inline constexpr const char* kValueNames =
    "array:NAME|FILE.csv[:COLUMN]|distance:X,Y,Z|distance:camera|curvature|height|light|coherence";

/// Throws CLI::ValidationError with the option unless `text` can name values. Messages list
/// `names`.
void check_value_name(const std::string& option, const std::string& text,
                      const std::string& names = kValueNames);

/// The values of FILE.csv or FILE.csv:COLUMN for a mesh of `vertices` vertices; rows may be those
/// of the mesh's file, as in FileData. Throws as `vertex_values` does.
VertexValues csv_values(const std::string& option, const std::string& text, std::size_t vertices,
                        std::span<const Index> vertex_of_row);

/// The numbers of an array, or the lengths of its vectors, per vertex; NaN if not finite. Throws as
/// `vertex_values` does.
std::vector<float> scalar_values(const std::string& option, const DataArray& array,
                                 std::size_t vertices, const std::string& file);

/// The file of `text`; empty if there is none.
std::string value_file(const std::string& text);

/// Whether values come from a file, not from the shape and its position.
bool is_of_file(const std::string& text);

/// Whether the values depend on the viewpoint.
bool depends_on_camera(const std::string& text);

/// Whether the values depend on the light.
bool depends_on_light(const std::string& text);

/// Whether the values depend on the up axis.
bool depends_on_up(const std::string& text);

/// Whether the values depend on the field.
bool depends_on_field(const std::string& text);

/// Values of vertices with triangles, or of points; NaN at others. Throws Error for unknown arrays
/// and columns, for rows that are neither numbers nor vectors (whose lengths are taken) or not one
/// per vertex, for camera values without a viewpoint, and for the coherence of fields that were not
/// smoothed.
VertexValues vertex_values(const std::string& option, const std::string& text,
                           const ValueSource& source);

}  // namespace brindle::tool
