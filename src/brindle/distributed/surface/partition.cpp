#include "brindle/distributed/surface/partition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "brindle/base/parallel.h"

namespace brindle {
namespace {

constexpr int kBits = 16;

std::array<std::uint32_t, 3> cell_of(const Vec3& p, const BoundingBox& box, float scale) {
  std::array<std::uint32_t, 3> cell;
  for (int k = 0; k < 3; ++k) {
    const float place = (p[k] - box.lower[k]) * scale;
    constexpr float kLast = (1 << kBits) - 1;
    cell[static_cast<std::size_t>(k)] =
        static_cast<std::uint32_t>(std::clamp(std::floor(place), 0.0f, kLast));
  }
  return cell;
}

}  // namespace

std::uint64_t hilbert_place(std::array<std::uint32_t, 3> x) {
  constexpr std::uint32_t kTop = 1u << (kBits - 1);
  for (std::uint32_t q = kTop; q > 1; q >>= 1) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (x[i] & q) {
        x[0] ^= q - 1;
      } else {
        const std::uint32_t t = (x[0] ^ x[i]) & (q - 1);
        x[0] ^= t;
        x[i] ^= t;
      }
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t turned = 0;
  for (std::uint32_t q = kTop; q > 1; q >>= 1) {
    if (x[2] & q) turned ^= q - 1;
  }
  for (std::uint32_t& axis : x) axis ^= turned;
  std::uint64_t place = 0;
  for (int bit = kBits; bit-- > 0;) {
    for (const std::uint32_t axis : x) place = place << 1 | (axis >> bit & 1u);
  }
  return place;
}

std::vector<int> partition_by_curve(const Mesh& mesh, int parts) {
  const std::size_t count = mesh.triangle_count();
  const BoundingBox box = bounding_box(mesh);
  const float widest = (box.upper - box.lower).maxCoeff();
  const float scale = widest > 0 ? static_cast<float>(1 << kBits) / widest : 0;
  std::vector<std::pair<std::uint64_t, Index>> places(count);
  parallel_for(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      const Vec3 center = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
      places[t] = {hilbert_place(cell_of(center, box, scale)), static_cast<Index>(t)};
    }
  });
  std::ranges::sort(places);
  std::vector<int> rank(count);
  for (std::size_t n = 0; n < count; ++n) {
    rank[places[n].second] = static_cast<int>(n * static_cast<std::size_t>(parts) / count);
  }
  return rank;
}

SurfacePiece piece_of(const Mesh& mesh, std::span<const int> rank_of_triangle, int rank) {
  std::vector<std::uint8_t> used(mesh.vertex_count()), wanted(mesh.vertex_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (const Index v : mesh.triangles[t]) {
      used[v] = 1;
      if (rank_of_triangle[t] == rank) wanted[v] = 1;
    }
  }
  SurfacePiece piece;
  piece.mesh.origin = mesh.origin;
  std::vector<Index> number(mesh.vertex_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!wanted[v] && (used[v] || rank != 0)) continue;
    number[v] = static_cast<Index>(piece.vertex_ids.size());
    piece.vertex_ids.push_back(v);
    piece.mesh.positions.push_back(mesh.positions[v]);
  }
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (rank_of_triangle[t] != rank) continue;
    const auto& [a, b, c] = mesh.triangles[t];
    piece.mesh.triangles.push_back({number[a], number[b], number[c]});
    piece.triangle_ids.push_back(t);
  }
  return piece;
}

}  // namespace brindle
