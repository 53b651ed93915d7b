/// The mesh of a command.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "brindle/files.h"

namespace brindle::tool {

/// Faces of a closed solid that paths leave out: its bottom and its top.
struct Lids {
  std::optional<float> degrees;  ///< from level, instead of a file
  std::string file;              ///< .csv: a number per triangle of the mesh's file; lids have 1
  Vec3 up = Vec3::UnitZ();
};

/// "30" or "lids.csv". Throws CLI::ValidationError for other text.
Lids parse_lids(const std::string& option, const std::string& text);

constexpr int kDefaultNeighbors = 8;

struct SurfaceOptions {
  std::string mesh;                        ///< a file or shape:NAME,...
  int subdivide = 0;                       ///< subdivisions of every triangle into four
  bool rounded = false;                    ///< subdivision bends triangles (`Midpoints`)
  std::optional<float> crease_angle = {};  ///< degrees, instead of `kCreaseAngle`
  bool points = false;                     ///< the vertices only
  std::optional<int> neighbors = {};       ///< per point, instead of `kDefaultNeighbors`
  Vec3 moved = Vec3::Zero();               ///< translation after reading
  std::optional<Lids> lids = {};           ///< left out after reading
  /// The mesh's file, as far as `is_points` had to read it.
  mutable std::shared_ptr<SurfaceFile> file = {};

  /// Calls `add("--option", field)` for the options of commands that accept points.
  template <class Add>
  void visit_points(const Add& add) {
    add("--points", points);
    add("--neighbors", neighbors);
  }
};

void add_surface_options(CLI::App& app, SurfaceOptions& options);

/// --points and --neighbors.
void add_point_options(CLI::App& app, SurfaceOptions& options);

/// Whether the command works on points without triangles, by option or because the file has no
/// faces.
bool is_points(const SurfaceOptions& options);

/// The mesh's file, which is opened when it is first asked for.
SurfaceFile& file_of(const SurfaceOptions& options);

/// Throws Error for points in a command that needs triangles. `command` is its name.
void refuse_points(const SurfaceOptions& options, const std::string& command);

/// A line for the user if a file without faces is read as points; else empty.
std::string describe_kind(const SurfaceOptions& options);

/// What names of built-in shapes begin with.
inline constexpr std::string_view kShapePrefix = "shape:";

/// Whether the mesh is a built-in shape.
bool is_shape(const SurfaceOptions& options);

/// The text after "shape:".
std::string_view shape_spec(const SurfaceOptions& options);

}  // namespace brindle::tool
