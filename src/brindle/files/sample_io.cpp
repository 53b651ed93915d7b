#include <array>
#include <numeric>
#include <string>
#include <vector>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/binary_output.h"
#include "brindle/files/ply_positions.h"
#include "brindle/files/text/text_positions.h"
#include "brindle/files/vtk/vtp_file.h"
#include "brindle/files/vtk/vtp_rows.h"
#include "brindle/files/written_arrays.h"
#include "brindle/local_positions.h"

namespace brindle {
namespace {

/// The vectors and numbers of a sample, in the order of all files. The triangle's number stands
/// apart, and arrays come after it.
constexpr std::array<const char*, 17> kColumns = {"x",
                                                  "y",
                                                  "z",
                                                  "nx",
                                                  "ny",
                                                  "nz",
                                                  "direction_u_x",
                                                  "direction_u_y",
                                                  "direction_u_z",
                                                  "direction_v_x",
                                                  "direction_v_y",
                                                  "direction_v_z",
                                                  "spacing_u",
                                                  "spacing_v",
                                                  "barycentric_x",
                                                  "barycentric_y",
                                                  "barycentric_z"};
constexpr std::size_t kNumbers = kColumns.size();

std::array<float, kNumbers> numbers_of(const Sample& s) {
  return {s.position[0],    s.position[1],    s.position[2],    s.normal[0],      s.normal[1],
          s.normal[2],      s.direction_u[0], s.direction_u[1], s.direction_u[2], s.direction_v[0],
          s.direction_v[1], s.direction_v[2], s.spacing_u,      s.spacing_v,      s.barycentric[0],
          s.barycentric[1], s.barycentric[2]};
}

void write_csv(OutputStream& out, std::span<const Sample> samples, const Eigen::Vector3d& origin,
               std::span<const DataArray> arrays) {
  TextOutput text(out);
  for (std::size_t i = 0; i < kNumbers; ++i) text << kColumns[i] << ',';
  text << "triangle";
  for (const DataArray& array : arrays) {
    for (const std::string& name : column_names(array)) text << ',' << csv_name(name);
  }
  text << '\n';
  for (std::size_t row = 0; row < samples.size(); ++row) {
    const Sample& sample = samples[row];
    const std::array<float, kNumbers> numbers = numbers_of(sample);
    const Eigen::Vector3d place = placed(sample.position, origin);
    for (std::size_t i = 0; i < kNumbers; ++i) {
      if (i < 3 && !origin.isZero(0)) {
        text << place[static_cast<Eigen::Index>(i)] << ',';
      } else {
        text << numbers[i] << ',';
      }
    }
    text << sample.triangle;
    for (const DataArray& array : arrays) put_csv_row(text, array, row);
    text << '\n';
  }
}

void write_ply(OutputStream& out, std::span<const Sample> samples, const Eigen::Vector3d& origin,
               std::span<const DataArray> arrays) {
  out << "ply\nformat binary_little_endian 1.0\ncomment written by brindle\nelement vertex "
      << samples.size() << '\n'
      << position_properties(origin);
  for (std::size_t i = 3; i < kNumbers; ++i) out << "property float " << kColumns[i] << '\n';
  out << "property uint triangle\n";
  for (const DataArray& array : arrays) put_ply_properties(out, array);
  out << "end_header\n";
  BinaryOutput binary(out);
  for (std::size_t row = 0; row < samples.size(); ++row) {
    const Sample& sample = samples[row];
    put_position(binary, sample.position, origin);
    binary.put(numbers_of(sample).data() + 3, kNumbers - 3);
    binary.put(sample.triangle);
    for (const DataArray& array : arrays) put_ply_row(binary, array, row);
  }
}

template <class Value>
DataArray sample_numbers(const char* name, std::span<const Sample> samples, const Value& value) {
  std::vector<decltype(value(Sample()))> result;
  for (const Sample& sample : samples) result.push_back(value(sample));
  return make_data_array(name, 1, result);
}

DataArray sample_vectors(const char* name, std::span<const Sample> samples, Vec3 Sample::*member) {
  std::vector<Vec3> result;
  for (const Sample& sample : samples) result.push_back(sample.*member);
  return make_data_array(name, result);
}

void write_points(OutputStream& out, std::span<const Sample> samples, const Eigen::Vector3d& origin,
                  std::span<const DataArray> more) {
  std::vector<Vec3> points;
  for (const Sample& sample : samples) points.push_back(sample.position);
  std::vector<Index> cells(samples.size());
  std::iota(cells.begin(), cells.end(), Index{0});
  std::vector<DataArray> arrays = {
      sample_vectors("normal", samples, &Sample::normal),
      sample_vectors("direction_u", samples, &Sample::direction_u),
      sample_vectors("direction_v", samples, &Sample::direction_v),
      sample_numbers("spacing_u", samples, [](const Sample& s) { return s.spacing_u; }),
      sample_numbers("spacing_v", samples, [](const Sample& s) { return s.spacing_v; }),
      sample_vectors("barycentric", samples, &Sample::barycentric),
      sample_numbers("triangle", samples, [](const Sample& s) { return s.triangle; })};
  arrays.insert(arrays.end(), more.begin(), more.end());
  write_vtp(out,
            {.points = points, .single_points = cells, .point_arrays = arrays, .origin = origin});
}

std::vector<std::string> own_columns() {
  std::vector<std::string> names(kColumns.begin(), kColumns.end());
  names.insert(names.end(), {"triangle", "normal", "direction_u", "direction_v", "barycentric"});
  return names;
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
  const std::vector<DataArray> columns =
      fitted_columns(path, arrays, samples.size(), own_columns());
  write_file(
      path,
      [&](OutputStream& out) {
        if (kind == ".csv") return write_csv(out, samples, origin, columns);
        if (kind == ".ply") return write_ply(out, samples, origin, columns);
        write_points(out, samples, origin, columns);
      },
      progress);
}

void write_vtp_samples(OutputStream& out, const std::filesystem::path& path,
                       std::span<const Sample> samples, const Eigen::Vector3d& origin,
                       std::span<const DataArray> arrays) {
  write_points(out, samples, origin, fitted_columns(path, arrays, samples.size(), own_columns()));
}

}  // namespace brindle
