/// Points with arrays in .obj, .csv and binary .ply files. Positions are floats, or doubles if
/// their origin is not zero.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "brindle/base/output_file.h"
#include "brindle/data_arrays.h"
#include "brindle/files/binary_numbers.h"
#include "brindle/types.h"

namespace brindle {

/// A position in a text file, with `separator` between coordinates.
void write_position(TextOutput& text, char separator, const Vec3& position,
                    const Eigen::Vector3d& origin);

/// A line per position: the keyword and the position.
void write_positions(TextOutput& text, std::string_view keyword, std::span<const Vec3> positions,
                     const Eigen::Vector3d& origin);

/// A name in a CSV file, quoted if necessary.
std::string csv_name(std::string_view name);

/// Column names of the arrays, each after a comma, and the numbers of a row. The columns of
/// "normal" are nx, ny, nz.
void put_csv_names(TextOutput& text, std::span<const DataArray> arrays);
void put_csv_row(TextOutput& text, std::span<const DataArray> arrays, std::size_t row);

/// Properties of a .ply element for arrays of valid names and types, and the numbers of a row.
/// "normal" has nx, ny, nz, "color" red, green, blue; those of "uv" are written twice.
void put_ply_properties(OutputStream& out, std::span<const DataArray> arrays);
void put_ply_row(BinaryOutput& binary, std::span<const DataArray> arrays, std::size_t row);

/// Vertices of a .ply file, with a row of each array per point.
struct PlyVertices {
  std::span<const Vec3> points;
  const Eigen::Vector3d& origin;
  std::span<const DataArray> arrays;
};

/// The start of a .ply header, with an optional comment, and the vertex element.
void write_ply_vertices(OutputStream& out, const std::string& comment, const PlyVertices& vertices);

/// The numbers of all vertices, directly after the header.
void put_ply_vertices(BinaryOutput& binary, const PlyVertices& vertices);

}  // namespace brindle
