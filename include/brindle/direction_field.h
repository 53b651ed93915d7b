/// Direction fields: one tangent vector per vertex that says where a vertex's wave runs.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "brindle/curvature.h"
#include "brindle/export.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// One direction per vertex: a unit tangent vector, meant up to sign (d ~ -d), or zero for
/// "no wave here".
using DirectionField = std::vector<Vec3>;

/// `vector` projected into the tangent plane and made a unit vector; zero if it is zero, not finite
/// or (nearly) parallel to the unit normal, or if there is no normal (zero).
Vec3 tangent_direction(const Vec3& vector, const Vec3& normal);

/// Projects every vector into the tangent plane of its vertex and makes it a unit vector. Vectors
/// that are zero, not finite or (nearly) parallel to the normal become zero.
/// `vectors` and `normals` have one entry per vertex.
DirectionField tangent_directions(std::span<const Vec3> vectors, std::span<const Vec3> normals);

/// The global vector `axis` (any length but zero) projected into every tangent plane.
/// Throws Error if `axis` is zero or not finite.
DirectionField projected_direction_field(const Vec3& axis, std::span<const Vec3> normals);

enum class CurvatureDirection { maximum, minimum };

/// The principal direction of larger (maximum) or smaller absolute curvature.
DirectionField curvature_direction_field(std::span<const PrincipalCurvature> curvatures,
                                         CurvatureDirection direction);

/// Turns every direction by `radians` about its vertex's normal, counter-clockwise seen from its
/// tip.
DirectionField rotated(std::span<const Vec3> directions, std::span<const Vec3> normals,
                       float radians);

/// What a field file holds: one row per vertex.
struct FieldFile {
  std::vector<Vec3> vectors;
  std::vector<float> frequencies;    ///< stripes per unit length; empty if the file has 3 columns
  std::vector<float> frequencies_v;  ///< of the crossing stripes; empty below 5 columns
};

/// Reads a CSV file (`read_csv`) of 3 columns x,y,z, 4 with the frequency, or 5 with the frequency
/// of the stripes that cross the others where a texture is laid along both. `nan` is a value: no
/// wave here. Of vectors the direction alone counts, however long or short they are.
///
/// A row stands for a vertex of the mesh or, if there are as many rows as entries in
/// `vertex_of_row`, for a vertex of the mesh's file (`LoadedMesh`). Of the rows of one vertex the
/// mean of their directions counts, up to sign, and the mean of their frequencies.
/// Throws Error naming the file, the line and the remedy if the file cannot be read, a row has
/// another number of columns or a word in it, a frequency is not above zero, or the number of rows
/// is neither of both.
FieldFile read_field_csv(const std::filesystem::path& path, std::size_t vertex_count,
                         std::span<const Index> vertex_of_row = {});

}  // namespace brindle
