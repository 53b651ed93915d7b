#include "brindle/files/vtk/vtp_file.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/files/binary_numbers.h"
#include "brindle/local_positions.h"

namespace brindle {
namespace {

/// Appended arrays: the XML declares them with their offsets, then all are written.
class AppendedArrays {
 public:
  explicit AppendedArrays(OutputStream& xml) : xml_(xml) {}

  /// Declares an array of `count` numbers; `write_all` calls `write` for them.
  template <class Number>
  void add(std::string_view type, std::string_view name, int components, std::size_t count,
           std::function<void(BinaryOutput&)> write) {
    add(type, name, components, std::uint64_t{count * sizeof(Number)}, std::move(write));
  }

  void add(std::string_view type, std::string_view name, int components, std::uint64_t bytes,
           std::function<void(BinaryOutput&)> write) {
    xml_ << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\""
         << components << "\" format=\"appended\" offset=\"" << offset_ << "\"/>\n";
    offset_ += sizeof bytes + bytes;
    blocks_.push_back({bytes, std::move(write)});
  }

  void write_all() const {
    BinaryOutput binary(xml_);
    for (const Block& block : blocks_) {
      binary.put(block.bytes);
      block.write(binary);
    }
  }

 private:
  struct Block {
    std::uint64_t bytes;
    std::function<void(BinaryOutput&)> write;
  };
  OutputStream& xml_;
  std::uint64_t offset_ = 0;
  std::vector<Block> blocks_;
};

constexpr std::array<std::string_view, 10> kTypeNames = {
    "Float32", "Float64", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64"};

void add_points(AppendedArrays& arrays, const PolyData& data) {
  const std::size_t count = 3 * data.points.size();
  if (data.origin.isZero(0)) {
    arrays.add<float>("Float32", "Points", 3, count, [&](BinaryOutput& binary) {
      for (const Vec3& point : data.points) binary.put(point.data(), 3);
    });
    return;
  }
  arrays.add<double>("Float64", "Points", 3, count, [&](BinaryOutput& binary) {
    for (const Vec3& point : data.points) binary.put(placed(point, data.origin).data(), 3);
  });
}

/// The arrays of all points or all cells.
void add_data(OutputStream& xml, AppendedArrays& appended, std::string_view element,
              std::span<const DataArray> arrays) {
  xml << '<' << element;
  for (const DataArray& array : arrays) {
    if (is_normal(array)) xml << " Normals=\"normal\"";
    if (is_color(array)) xml << " Scalars=\"color\"";
    if (is_uv(array)) xml << " TCoords=\"uv\"";
  }
  xml << ">\n";
  for (const DataArray& array : arrays) {
    appended.add(vtk_type(array.type), xml_text(array.name), array.components,
                 std::uint64_t{array.bytes.size()},
                 [&](BinaryOutput& binary) { binary.put(array.bytes.data(), array.bytes.size()); });
  }
  xml << "</" << element << ">\n";
}

/// The cells of one kind: concatenated points, and the end of each cell.
template <class Points, class End>
void add_cells(OutputStream& xml, AppendedArrays& arrays, std::string_view element,
               std::size_t cells, std::size_t points, const Points& point, const End& end) {
  const auto add = [&](std::string_view name, std::size_t count, auto value) {
    arrays.add<std::int64_t>("Int64", name, 1, count, [count, value](BinaryOutput& out) {
      for (std::size_t i = 0; i < count; ++i) out.put(static_cast<std::int64_t>(value(i)));
    });
  };
  xml << '<' << element << ">\n";
  add("connectivity", points, point);
  add("offsets", cells, end);
  xml << "</" << element << ">\n";
}

}  // namespace

std::string_view vtk_type(NumberType type) { return kTypeNames.at(static_cast<std::size_t>(type)); }

std::string xml_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

void write_vtp(OutputStream& out, const PolyData& data) {
  const std::size_t lines = data.line_offsets.empty() ? 0 : data.line_offsets.size() - 1;
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
         "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\""
      << data.points.size() << "\" NumberOfVerts=\"" << data.single_points.size()
      << "\" NumberOfLines=\"" << lines << "\" NumberOfStrips=\"0\" NumberOfPolys=\""
      << data.triangles.size() << "\">\n";
  AppendedArrays arrays(out);
  add_data(out, arrays, "PointData", data.point_arrays);
  add_data(out, arrays, "CellData", data.cell_arrays);
  out << "<Points>\n";
  add_points(arrays, data);
  out << "</Points>\n";
  add_cells(
      out, arrays, "Verts", data.single_points.size(), data.single_points.size(),
      [&](std::size_t i) { return data.single_points[i]; }, [](std::size_t i) { return i + 1; });
  add_cells(
      out, arrays, "Lines", lines, data.line_points.size(),
      [&](std::size_t i) { return data.line_points[i]; },
      [&](std::size_t i) { return data.line_offsets[i + 1]; });
  add_cells(
      out, arrays, "Polys", data.triangles.size(), 3 * data.triangles.size(),
      [&](std::size_t i) { return data.triangles[i / 3][i % 3]; },
      [](std::size_t i) { return 3 * (i + 1); });
  out << "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  arrays.write_all();
  out << "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace brindle
