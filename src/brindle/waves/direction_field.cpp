#include "brindle/direction_field.h"

#include <cmath>
#include <string>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/files/csv_file.h"

namespace brindle {
namespace {

/// A vector closer to the normal than this (as a sine) has no direction in the tangent plane.
constexpr float kParallelToNormal = 1e-4f;

void append_row(FieldFile& field, std::span<const float> row, const std::string& where) {
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
  if (!(length > 0) || !std::isfinite(length) || normal.isZero(0)) return Vec3::Zero();
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
  FieldFile field;
  const CsvKind kind{"field", "x,y,z or x,y,z,frequency"};
  read_csv(path, kind, [&](std::size_t line, std::span<const float> row) {
    if (field.vectors.size() == vertex_count) {
      throw Error(at_line(path, line) + "more rows than the mesh has vertices (" +
                  std::to_string(vertex_count) + "); give one row per vertex");
    }
    append_row(field, row, at_line(path, line));
  });
  if (field.vectors.size() != vertex_count) {
    throw Error("'" + path.string() + "' has " + std::to_string(field.vectors.size()) +
                " rows, but the mesh has " + std::to_string(vertex_count) +
                " vertices; give one row per vertex");
  }
  return field;
}

}  // namespace brindle
