/// A surface whose triangles are split until a texture's height is linear in each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/relief.h"

namespace brindle {

/// The welded surface below a relief: one vertex per place, texture and normals by corner.
struct ReliefBase {
  Mesh mesh;
  std::vector<std::array<Eigen::Vector2f, 3>> uv;
  std::vector<std::array<Vec3, 3>> normals;      ///< of the corners, unit length
  std::vector<Index> original;                   ///< triangle of the surface
  std::vector<std::array<Vec3, 3>> in_original;  ///< barycentric coordinates of the corners there
  std::vector<std::uint8_t> textured;            ///< 0: the height is 0
  std::size_t filled_holes = 0;
};

/// Welds seams and creases of the textured mesh, winds triangles alike and outwards, and fills
/// holes up to a perimeter. Throws Error as `make_relief` does.
ReliefBase relief_base(const Surface& surface, const TexturedMesh& textured,
                       const std::vector<std::uint8_t>& only, float fill_holes);

/// The refined surface, which has the shape of its base.
struct RefinedRelief {
  std::vector<Vec3> positions;
  std::vector<Vec3> directions;  ///< displacement for height 1: the normal, longer on creases
  std::vector<float> heights;    ///< from 0 to 1
  std::vector<Triangle> triangles;
  std::vector<Index> base;  ///< triangle of the base
};

/// Accuracy of the refinement.
struct RefinementLimits {
  float error = 0;       ///< of heights from 0 to 1
  float shortest = 0;    ///< edges up to this length are not split
  bool outline = false;  ///< also split edges where the height is exactly 1/2
};

/// Splits edges until the height along them, and then in triangles, is linear within the error.
/// Edges are split where the error is largest, so that the kinks of a texture become edges. Throws
/// Error for more than 30 million triangles, and Cancelled.
RefinedRelief refined_relief(const ReliefBase& base, const ReliefTexture& texture,
                             const RefinementLimits& limits, const Progress& progress);

}  // namespace brindle
