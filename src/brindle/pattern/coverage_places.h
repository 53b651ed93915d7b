/// Where on a surface `measure_coverage` looks for lines.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "brindle/curve_measures.h"
#include "brindle/mesh.h"

namespace brindle {

/// On a whole surface.
inline constexpr std::size_t kCoveragePlaces = 100'000;

/// Of all triangles together, zero without any.
double area_of(const Mesh& mesh);

/// Which part of a surface's area a mesh has, if areas are counted one after the other.
struct AreaShare {
  double before = 0, behind = 0;  ///< behind the mesh is what it has and what was before
  double all = 0;
};

/// Those of the places that are in this share, in units of length about the mesh's origin.
std::vector<Eigen::Vector3d> coverage_places(const Mesh& mesh, const AreaShare& share);

/// As of a mesh, of which these are all places.
CurveCoverage measure_coverage(std::span<const Eigen::Vector3d> places, const Polylines& lines,
                               double width, const Progress& progress = {});

}  // namespace brindle
