#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/point_output.h"
#include "brindle/files/vtk/vtp_file.h"
#include "brindle/files/written_arrays.h"

namespace brindle {
namespace {

/// The samples' own columns of a file, in their order.
struct SampleTable {
  std::vector<Vec3> points;
  std::vector<DataArray> arrays;
};

template <class Value>
DataArray sample_array(const char* name, std::span<const Sample> samples, Value Sample::*member) {
  std::vector<Value> values;
  values.reserve(samples.size());
  for (const Sample& sample : samples) values.push_back(sample.*member);
  if constexpr (std::is_arithmetic_v<Value>) {
    return make_data_array(name, 1, values);
  } else {
    return make_data_array(name, values);
  }
}

SampleTable table_of(std::span<const Sample> samples, std::span<const DataArray> more) {
  SampleTable table;
  for (const Sample& sample : samples) table.points.push_back(sample.position);
  table.arrays = {sample_array("normal", samples, &Sample::normal),
                  sample_array("direction_u", samples, &Sample::direction_u),
                  sample_array("direction_v", samples, &Sample::direction_v),
                  sample_array("spacing_u", samples, &Sample::spacing_u),
                  sample_array("spacing_v", samples, &Sample::spacing_v),
                  sample_array("barycentric", samples, &Sample::barycentric),
                  sample_array("triangle", samples, &Sample::triangle)};
  table.arrays.insert(table.arrays.end(), more.begin(), more.end());
  return table;
}

/// Reserved names of columns.
std::vector<std::string> own_columns() {
  std::vector<std::string> names = {"x", "y", "z", "nx", "ny", "nz"};
  for (const DataArray& array : table_of({}, {}).arrays) {
    names.push_back(array.name);
    if (is_normal(array)) continue;
    for (std::string& column : column_names(array)) names.push_back(std::move(column));
  }
  return names;
}

void write_sample_csv(OutputStream& out, const SampleTable& table, const Eigen::Vector3d& origin) {
  TextOutput text(out);
  text << "x,y,z";
  put_csv_names(text, table.arrays);
  text << '\n';
  for (std::size_t row = 0; row < table.points.size(); ++row) {
    write_position(text, ',', table.points[row], origin);
    put_csv_row(text, table.arrays, row);
    text << '\n';
  }
}

void write_sample_vtp(OutputStream& out, const SampleTable& table, const Eigen::Vector3d& origin) {
  std::vector<Index> cells(table.points.size());
  std::iota(cells.begin(), cells.end(), Index{0});
  write_vtp(out, {.points = table.points,
                  .single_points = cells,
                  .point_arrays = table.arrays,
                  .origin = origin});
}

}  // namespace

bool is_sample_format(const std::filesystem::path& path) {
  const std::string kind = lower_extension(path);
  return kind == ".csv" || kind == ".ply" || kind == ".vtp";
}

void write_samples(const std::filesystem::path& path, std::span<const Sample> samples,
                   const Eigen::Vector3d& origin, std::span<const DataArray> arrays,
                   const Progress& progress) {
  const std::string kind = lower_extension(path);
  if (!is_sample_format(path)) {
    throw Error("cannot write '" + shown(path.string()) + "': '" +
                shown(path.extension().string()) +
                "' files hold no samples; write .csv, .ply or .vtp");
  }
  const SampleTable table =
      table_of(samples, fitted_columns(path, arrays, samples.size(), own_columns()));
  write_file(
      path,
      [&](OutputStream& out) {
        if (kind == ".csv") return write_sample_csv(out, table, origin);
        if (kind == ".vtp") return write_sample_vtp(out, table, origin);
        const PlyVertices vertices{table.points, origin, table.arrays};
        write_ply_vertices(out, "", vertices);
        out << "end_header\n";
        BinaryOutput binary(out);
        put_ply_vertices(binary, vertices);
      },
      progress);
}

void write_vtp_samples(OutputStream& out, const std::filesystem::path& path,
                       std::span<const Sample> samples, const Eigen::Vector3d& origin,
                       std::span<const DataArray> arrays) {
  write_sample_vtp(
      out, table_of(samples, fitted_columns(path, arrays, samples.size(), own_columns())), origin);
}

}  // namespace brindle
