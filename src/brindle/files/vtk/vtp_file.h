/// VTK's XML PolyData (VTP): points with cells over them, for ParaView and all that VTK reads.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "brindle/base/output_file.h"
#include "brindle/files.h"
#include "brindle/mesh.h"

namespace brindle {

/// The content of a VTP file. Cells are numbered from 0 in the order single points, lines,
/// triangles.
struct PolyData {
  std::span<const Vec3> points = {};          ///< relative to `origin`
  std::span<const Index> single_points = {};  ///< cells of one point each
  std::span<const Index> line_offsets = {};   ///< lines + 1 entries into `line_points`, or none
  std::span<const Index> line_points = {};    ///< the points along each line
  std::span<const Triangle> triangles = {};
  std::span<const DataArray> point_arrays = {};      ///< a row per point
  std::span<const DataArray> cell_arrays = {};       ///< a row per cell
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< see `Mesh`
};

/// Writes version 1.0 of the format with raw appended data, little endian. Points are floats, or
/// doubles if they have an origin. "normal" becomes the active normals, "uv" the texture
/// coordinates, "color" the colours. Arrays have a row for every point or cell, and the names and
/// colours of `fitted_arrays`.
void write_vtp(OutputStream& out, const PolyData& data);

/// VTK's name of a type of numbers.
std::string_view vtk_type(NumberType type);

/// The text as part of an XML document, also as the value of an attribute in double quotes.
std::string xml_text(std::string_view text);

}  // namespace brindle
