#include "brindle/waves/direction_field.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <string>

#include <Eigen/Geometry>

#include "brindle/base/error.h"
#include "brindle/base/parallel.h"

namespace brindle {
namespace {

/// A vector closer to the normal than this (as a sine) has no direction in the tangent plane.
constexpr float kParallelToNormal = 1e-4f;

std::string at_line(const std::filesystem::path& path, std::size_t line) {
  return "'" + path.string() + "', line " + std::to_string(line) + ": ";
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The row's numbers, or nothing if one of its cells is not a number.
std::optional<std::vector<float>> parse_row(std::string_view row) {
  std::vector<float> values;
  while (true) {
    const auto comma = row.find(',');
    std::string_view cell = trimmed(row.substr(0, comma));
    if (cell.starts_with('+')) cell.remove_prefix(1);
    float value = 0;
    const auto [end, failure] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (failure != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
    values.push_back(value);
    if (comma == std::string_view::npos) return values;
    row.remove_prefix(comma + 1);
  }
}

void append_row(FieldFile& field, const std::vector<float>& row, const std::string& where) {
  if (row.size() < 3 || row.size() > 5) {
    throw Error(where + std::to_string(row.size()) +
                " columns; a row must have 3 (x,y,z), 4 (x,y,z,frequency) or 5 "
                "(x,y,z,frequency,frequency_v)");
  }
  const std::size_t columns =
      3 + (field.frequencies.empty() ? 0 : 1) + (field.frequencies_v.empty() ? 0 : 1);
  if (!field.vectors.empty() && row.size() != columns) {
    throw Error(where + std::to_string(row.size()) + " columns where the rows before have " +
                std::to_string(columns) + "; give all rows the same number");
  }
  for (std::size_t column = 3; column < row.size(); ++column) {
    if (!(row[column] > 0) || !std::isfinite(row[column])) {
      throw Error(where + "the frequency must be a finite number above zero");
    }
  }
  field.vectors.emplace_back(row[0], row[1], row[2]);
  if (row.size() > 3) field.frequencies.push_back(row[3]);
  if (row.size() > 4) field.frequencies_v.push_back(row[4]);
}

}  // namespace

Vec3 tangent_direction(const Vec3& vector, const Vec3& normal) {
  const float length = vector.norm();
  if (!(length > 0) || !std::isfinite(length)) return Vec3::Zero();
  const Vec3 unit = vector / length;
  const Vec3 tangent = unit - unit.dot(normal) * normal;
  const float sine = tangent.norm();
  if (!(sine > kParallelToNormal)) return Vec3::Zero();
  return tangent / sine;
}

DirectionField tangent_directions(std::span<const Vec3> vectors, std::span<const Vec3> normals) {
  DirectionField directions(vectors.size());
  parallel_for(vectors.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      directions[i] = tangent_direction(vectors[i], normals[i]);
    }
  });
  return directions;
}

DirectionField projected_direction_field(const Vec3& axis, std::span<const Vec3> normals) {
  if (!axis.allFinite() || axis.isZero(0)) {
    throw Error("the direction must be a finite vector other than 0,0,0");
  }
  return tangent_directions(std::vector<Vec3>(normals.size(), axis), normals);
}

DirectionField curvature_direction_field(std::span<const PrincipalCurvature> curvatures,
                                         CurvatureDirection direction) {
  DirectionField directions(curvatures.size());
  for (std::size_t i = 0; i < curvatures.size(); ++i) {
    directions[i] = direction == CurvatureDirection::maximum ? curvatures[i].maximum_direction
                                                             : curvatures[i].minimum_direction;
  }
  return directions;
}

DirectionField rotated(std::span<const Vec3> directions, std::span<const Vec3> normals,
                       float radians) {
  const float cosine = std::cos(radians), sine = std::sin(radians);
  DirectionField turned(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    turned[i] = cosine * directions[i] + sine * normals[i].cross(directions[i]);
  }
  return turned;
}

FieldFile read_field_csv(const std::filesystem::path& path, std::size_t vertex_count) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw Error("cannot read field '" + path.string() + "': it is a folder; name a CSV file");
  }
  std::ifstream in(path);
  if (!in) throw Error("cannot open field '" + path.string() + "'; check the path");
  FieldFile field;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    const std::string_view row = trimmed(line);
    if (row.empty() || row.front() == '#') continue;
    const auto values = parse_row(row);
    if (values) {
      if (field.vectors.size() == vertex_count) {
        throw Error(at_line(path, number) + "more rows than the mesh has vertices (" +
                    std::to_string(vertex_count) + "); give one row per vertex");
      }
      append_row(field, *values, at_line(path, number));
    } else if (number > 1 || row.find_first_of("0123456789") != std::string_view::npos) {
      throw Error(at_line(path, number) + "'" + std::string(row.substr(0, 60)) +
                  "' is not a row of numbers; write x,y,z or x,y,z,frequency");
    }
  }
  if (field.vectors.size() != vertex_count) {
    throw Error("'" + path.string() + "' has " + std::to_string(field.vectors.size()) +
                " rows, but the mesh has " + std::to_string(vertex_count) +
                " vertices; give one row per vertex");
  }
  return field;
}

}  // namespace brindle
