/// Triangles of many ranks, put together on one of them as the whole has them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace brindle {

/// Vectors that can be sent.
using SentVector = std::array<float, 3>;

inline SentVector floats_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
inline Vec3 vector_of(const SentVector& v) { return {v[0], v[1], v[2]}; }

struct SentCorner {
  std::uint64_t id;
  SentVector position, normal;
};

struct SentTriangle {
  std::uint64_t number;  ///< in the whole; 0 where triangles have none
  std::array<SentCorner, 3> corners;
};

/// Own triangles, by their numbers on this rank, with these normals of all vertices.
std::vector<SentTriangle> sent_triangles(const RankSurface& surface, std::span<const Index> own,
                                         std::span<const Vec3> normals);

/// A part of the whole, in its order.
struct PartOfWhole {
  Surface surface;
  std::vector<std::uint64_t> ids;  ///< of its vertices in the whole, ascending
};

/// `triangles` are those of all ranks, rank by rank; the part has them in the order of their
/// numbers. Of vertices that no triangle uses it has those with `other_ids`, at the origin.
PartOfWhole part_of(std::vector<SentTriangle> triangles, const Eigen::Vector3d& origin,
                    std::span<const std::uint64_t> other_ids = {});

}  // namespace brindle
