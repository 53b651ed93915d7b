/// Lines to files.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "brindle/geometry/polylines.h"

namespace brindle {

/// Lines of one kind, with a name: letters, digits and underscores.
struct NamedLines {
  std::string name;
  const Polylines& lines;
};

/// Whether `write_polylines` knows the path's extension.
bool is_polyline_format(const std::filesystem::path& path);

/// Writes by the path's extension, whole or not at all:
/// .obj  points, and lines (`l`) in a group per kind;
/// .ply  binary: points with normals, the number of their line and of its kind, and edges;
/// .vtp  lines, with the number of their kind, whether they are closed and their length;
/// .csv  a row per point: kind, line, closed, x, y, z, nx, ny, nz.
/// A closed line comes back to its first point, which is not repeated but in .vtp and .obj's lists.
/// Throws Error for another extension, for more points than an Index can count, and what write_file
/// throws.
void write_polylines(const std::filesystem::path& path, std::span<const NamedLines> kinds);

}  // namespace brindle
