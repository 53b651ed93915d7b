#include "brindle/files/point_output.h"

#include <array>

#include "brindle/base/array_numbers.h"
#include "brindle/base/input_file.h"
#include "brindle/files.h"
#include "brindle/files/written_arrays.h"
#include "brindle/local_positions.h"

namespace brindle {

void write_position(TextOutput& text, char separator, const Vec3& position,
                    const Eigen::Vector3d& origin) {
  const bool local = !origin.isZero(0);
  const Eigen::Vector3d place = placed(position, origin);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) text << separator;
    if (local) {
      text << place[axis];
    } else {
      text << position[axis];
    }
  }
}

void write_positions(TextOutput& text, std::string_view keyword, std::span<const Vec3> positions,
                     const Eigen::Vector3d& origin) {
  for (const Vec3& p : positions) {
    text << keyword << ' ';
    write_position(text, ' ', p, origin);
    text << '\n';
  }
}

std::string csv_name(std::string_view name) {
  const bool parts = name.find_first_of(",;\"\t\r\n ") != std::string_view::npos;
  const bool looks_like_number = name.find_first_of("0123456789+-.") == 0 || parse_number(name);
  if (!parts && !looks_like_number) return std::string(name);
  std::string quoted = "\"";
  for (const char c : name) {
    if (c == '"') quoted += c;
    quoted += c == '\n' || c == '\r' ? '_' : c;
  }
  return quoted + '"';
}

void put_csv_names(TextOutput& text, std::span<const DataArray> arrays) {
  for (const DataArray& array : arrays) {
    std::vector<std::string> names = column_names(array);
    if (is_normal(array)) names = {"nx", "ny", "nz"};
    for (const std::string& name : names) text << ',' << csv_name(name);
  }
}

void put_csv_row(TextOutput& text, std::span<const DataArray> arrays, std::size_t row) {
  for (const DataArray& array : arrays) {
    const ArrayView view = array.view();
    for_each_number(ArrayView(view.address(row, 0), view.type(), 1, view.columns(), 0,
                              static_cast<std::ptrdiff_t>(size_of(array.type))),
                    [&](std::size_t, std::size_t, auto number) { text << ',' << number; });
  }
}

void put_ply_properties(OutputStream& out, std::span<const DataArray> arrays) {
  constexpr std::array<const char*, 8> kTypes = {"float", "double", "char", "uchar",
                                                 "short", "ushort", "int",  "uint"};
  for (const DataArray& array : arrays) {
    const char* type = kTypes.at(static_cast<std::size_t>(array.type));
    std::vector<std::string> names = column_names(array);
    if (is_normal(array)) names = {"nx", "ny", "nz"};
    if (is_color(array)) names = {"red", "green", "blue"};
    if (is_uv(array)) names = {"texture_u", "texture_v", "s", "t"};
    for (const std::string& name : names) out << "property " << type << ' ' << name << '\n';
  }
}

void put_ply_row(BinaryOutput& binary, std::span<const DataArray> arrays, std::size_t row) {
  for (const DataArray& array : arrays) {
    const std::size_t size = size_of(array.type) * static_cast<std::size_t>(array.components);
    for (int copy = 0; copy < (is_uv(array) ? 2 : 1); ++copy) {
      binary.put(array.bytes.data() + row * size, size);
    }
  }
}

void write_ply_vertices(OutputStream& out, const std::string& comment,
                        const PlyVertices& vertices) {
  const char* const type = vertices.origin.isZero(0) ? "float" : "double";
  out << "ply\nformat binary_little_endian 1.0\ncomment written by brindle\n"
      << comment << "element vertex " << vertices.points.size() << '\n';
  for (const char* axis : {"x", "y", "z"}) out << "property " << type << ' ' << axis << '\n';
  put_ply_properties(out, vertices.arrays);
}

void put_ply_vertices(BinaryOutput& binary, const PlyVertices& vertices) {
  const bool local = !vertices.origin.isZero(0);
  for (std::size_t v = 0; v < vertices.points.size(); ++v) {
    if (local) {
      binary.put(placed(vertices.points[v], vertices.origin).data(), 3);
    } else {
      binary.put(vertices.points[v].data(), 3);
    }
    put_ply_row(binary, vertices.arrays, v);
  }
}

}  // namespace brindle
