#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/point_output.h"
#include "brindle/files/vtk/vtp_file.h"
#include "brindle/files/written_arrays.h"
#include "brindle/local_positions.h"

namespace brindle {
namespace {

using Kinds = std::span<const NamedLines>;

std::size_t point_count(Kinds kinds) {
  std::size_t count = 0;
  for (const NamedLines& kind : kinds) count += kind.lines.points.size();
  return count;
}

/// The origin of the first kind: all kinds lie on the same mesh.
Eigen::Vector3d origin_of(Kinds kinds) {
  return kinds.empty() ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : kinds[0].lines.origin;
}

/// A point relative to the common origin.
Vec3 moved(const Vec3& point, const Polylines& lines, Kinds kinds) {
  if (lines.origin == origin_of(kinds)) return point;
  return (placed(point, lines.origin) - origin_of(kinds)).cast<float>();
}

/// Calls `use(kind, line, first)` for each line; `first` counts the points of all kinds.
template <class Use>
void for_each_line(Kinds kinds, const Use& use) {
  Index before = 0;
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    const Polylines& lines = kinds[kind].lines;
    for (std::size_t line = 0; line < lines.count(); ++line) {
      use(kind, line, before + lines.offsets[line]);
    }
    before += static_cast<Index>(lines.points.size());
  }
}

/// The arrays of all kinds, joined, in the form of the file.
using LineArrays = std::vector<DataArray>;

bool same_arrays(const NamedLines& a, const NamedLines& b) {
  return std::equal(a.arrays.begin(), a.arrays.end(), b.arrays.begin(), b.arrays.end(),
                    [](const DataArray& x, const DataArray& y) {
                      return x.name == y.name && x.type == y.type && x.components == y.components;
                    });
}

LineArrays gathered_arrays(const std::filesystem::path& path, Kinds kinds) {
  if (kinds.empty()) return {};
  LineArrays all = kinds[0].arrays;
  for (const NamedLines& kind : kinds) {
    check_rows(path, kind.arrays, kind.lines.points.size(), "point");
    if (!same_arrays(kind, kinds[0])) {
      throw Error("cannot write '" + shown(path.string()) + "': the arrays of '" + kind.name +
                  "' are not those of '" + kinds[0].name + "'");
    }
    for (std::size_t i = 0; i < all.size() && &kind != kinds.data(); ++i) {
      const std::vector<std::byte>& more = kind.arrays[i].bytes;
      all[i].bytes.insert(all[i].bytes.end(), more.begin(), more.end());
    }
  }
  return all;
}

void write_obj_lines(OutputStream& out, Kinds kinds) {
  TextOutput text(out);
  text << "# written by brindle\n";
  for (const NamedLines& kind : kinds) {
    write_positions(text, "v", kind.lines.points, kind.lines.origin);
  }
  std::size_t group = kinds.size();
  for_each_line(kinds, [&](std::size_t kind, std::size_t line, Index first) {
    if (group != kind) text << "g " << kinds[kind].name << '\n';
    group = kind;
    const std::size_t size = kinds[kind].lines.points_of(line).size();
    text << 'l';
    for (std::size_t i = 0; i < size; ++i) text << ' ' << first + i + 1;
    if (kinds[kind].lines.closed[line]) text << ' ' << first + 1;
    text << '\n';
  });
}

/// The points of all kinds, relative to a common origin.
struct LinePoints {
  std::vector<Vec3> points;
  DataArray normals;
};

LinePoints line_points(Kinds kinds) {
  std::vector<Vec3> points, normals;
  for (const NamedLines& kind : kinds) {
    for (const Vec3& p : kind.lines.points) points.push_back(moved(p, kind.lines, kinds));
    normals.insert(normals.end(), kind.lines.normals.begin(), kind.lines.normals.end());
  }
  return {std::move(points), make_data_array("normal", normals)};
}

void write_ply_lines(OutputStream& out, Kinds kinds, const LineArrays& arrays) {
  std::vector<Index> curves, ends;
  std::vector<std::uint8_t> kind_of_point;
  Index number = 0;
  for_each_line(kinds, [&](std::size_t kind, std::size_t line, Index first) {
    const auto size = static_cast<Index>(kinds[kind].lines.points_of(line).size());
    curves.insert(curves.end(), size, number++);
    kind_of_point.insert(kind_of_point.end(), size, static_cast<std::uint8_t>(kind));
    for (Index i = 0; i + 1 < size; ++i) ends.insert(ends.end(), {first + i, first + i + 1});
    if (kinds[kind].lines.closed[line]) ends.insert(ends.end(), {first + size - 1, first});
  });
  auto [points, normals] = line_points(kinds);
  std::vector<DataArray> columns = {std::move(normals), make_data_array("curve", 1, curves),
                                    make_data_array("kind", 1, kind_of_point)};
  columns.insert(columns.end(), arrays.begin(), arrays.end());
  const Eigen::Vector3d origin = origin_of(kinds);
  const PlyVertices vertices{points, origin, columns};
  write_ply_vertices(out, "", vertices);
  out << "element edge " << ends.size() / 2
      << "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  BinaryOutput binary(out);
  put_ply_vertices(binary, vertices);
  for (const Index end : ends) binary.put(end);
}

void write_vtp_lines(OutputStream& out, Kinds kinds, const LineArrays& arrays) {
  std::vector<Index> offsets{0}, along;
  std::vector<float> kind_of_line, closed, length;
  for_each_line(kinds, [&](std::size_t kind, std::size_t line, Index first) {
    const Polylines& lines = kinds[kind].lines;
    const auto size = static_cast<Index>(lines.points_of(line).size());
    for (Index i = 0; i < size; ++i) along.push_back(first + i);
    if (lines.closed[line]) along.push_back(first);
    offsets.push_back(static_cast<Index>(along.size()));
    kind_of_line.push_back(static_cast<float>(kind));
    closed.push_back(lines.closed[line]);
    length.push_back(static_cast<float>(length_of(lines, line)));
  });
  auto [points, normals] = line_points(kinds);
  std::vector<DataArray> of_points = {std::move(normals)};
  of_points.insert(of_points.end(), arrays.begin(), arrays.end());
  const std::vector<DataArray> of_lines = {make_data_array("kind", 1, kind_of_line),
                                           make_data_array("closed", 1, closed),
                                           make_data_array("length", 1, length)};
  write_vtp(out, {.points = points,
                  .line_offsets = offsets,
                  .line_points = along,
                  .point_arrays = of_points,
                  .cell_arrays = of_lines,
                  .origin = origin_of(kinds)});
}

void write_csv_lines(OutputStream& out, Kinds kinds, const LineArrays& arrays) {
  std::vector<DataArray> columns = {line_points(kinds).normals};
  columns.insert(columns.end(), arrays.begin(), arrays.end());
  TextOutput text(out);
  text << "kind,curve,closed,x,y,z";
  put_csv_names(text, columns);
  text << '\n';
  std::size_t number = 0;
  for_each_line(kinds, [&](std::size_t kind, std::size_t line, Index first) {
    const Polylines& lines = kinds[kind].lines;
    for (std::size_t i = 0; i < lines.points_of(line).size(); ++i) {
      text << kinds[kind].name << ',' << number << ',' << int{lines.closed[line]} << ',';
      write_position(text, ',', lines.points_of(line)[i], lines.origin);
      put_csv_row(text, columns, first + i);
      text << '\n';
    }
    ++number;
  });
}

/// The arrays of all kinds as file columns.
LineArrays line_columns(const std::filesystem::path& path, Kinds kinds) {
  return fitted_columns(path, gathered_arrays(path, kinds), point_count(kinds),
                        {"kind", "curve", "closed", "x", "y", "z", "nx", "ny", "nz", "normal"});
}

void check_point_count(const std::filesystem::path& path, Kinds kinds) {
  if (point_count(kinds) <= 0x7ffffff0) return;
  throw Error("cannot write '" + shown(path.string()) + "': the curves have too many points");
}

}  // namespace

bool is_polyline_format(const std::filesystem::path& path) {
  const std::string kind = lower_extension(path);
  return kind == ".obj" || kind == ".ply" || kind == ".vtp" || kind == ".csv";
}

void write_polylines(const std::filesystem::path& path, std::span<const NamedLines> kinds,
                     const Progress& progress) {
  if (!is_polyline_format(path)) {
    throw Error("cannot write '" + shown(path.string()) + "': '" +
                shown(path.extension().string()) +
                "' files hold no curves; write .obj, .ply, .vtp or .csv");
  }
  check_point_count(path, kinds);
  const std::string kind = lower_extension(path);
  const LineArrays arrays =
      kind == ".obj" ? gathered_arrays(path, kinds) : line_columns(path, kinds);
  write_file(
      path,
      [&](OutputStream& out) {
        if (kind == ".obj") return write_obj_lines(out, kinds);
        if (kind == ".ply") return write_ply_lines(out, kinds, arrays);
        if (kind == ".vtp") return write_vtp_lines(out, kinds, arrays);
        write_csv_lines(out, kinds, arrays);
      },
      progress);
}

void write_vtp_polylines(OutputStream& out, const std::filesystem::path& path,
                         std::span<const NamedLines> kinds) {
  check_point_count(path, kinds);
  write_vtp_lines(out, kinds, line_columns(path, kinds));
}

}  // namespace brindle
