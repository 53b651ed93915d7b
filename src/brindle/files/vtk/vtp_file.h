/// VTK's XML PolyData (VTP): points and cells.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "brindle/base/output_file.h"
#include "brindle/files.h"
#include "brindle/mesh.h"

namespace brindle {

/// The content of a VTP file. Cell numbers are in the order single points, lines, triangles.
struct PolyData {
  std::span<const Vec3> points = {};          ///< relative to `origin`
  std::span<const Index> single_points = {};  ///< cells of one point
  std::span<const Index> line_offsets = {};   ///< lines + 1 entries into `line_points`, or none
  std::span<const Index> line_points = {};    ///< points along all lines
  std::span<const Triangle> triangles = {};
  std::span<const DataArray> point_arrays = {};      ///< a row per point
  std::span<const DataArray> cell_arrays = {};       ///< a row per cell
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< see `Mesh`
};

/// Writes format version 1.0 with raw appended data, little endian. Points are floats, or doubles
/// with an origin. "normal" becomes the active normals, "uv" the texture coordinates, "color" the
/// colours. Arrays have a row per point or cell, and names and colours of `fitted_arrays`.
void write_vtp(OutputStream& out, const PolyData& data);

/// VTK's name of a number type.
std::string_view vtk_type(NumberType type);

/// Escapes text for XML, also for attribute values in double quotes.
std::string xml_text(std::string_view text);

// Lines and samples as VTP streams.

/// The .vtp of `write_polylines`. Throws its errors, which name `path`.
void write_vtp_polylines(OutputStream& out, const std::filesystem::path& path,
                         std::span<const NamedLines> kinds);

/// The .vtp of `write_samples`. Throws its errors, which name `path`.
void write_vtp_samples(OutputStream& out, const std::filesystem::path& path,
                       std::span<const Sample> samples, const Eigen::Vector3d& origin,
                       std::span<const DataArray> arrays);

}  // namespace brindle
