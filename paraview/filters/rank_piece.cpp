#include "rank_piece.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

namespace brindle::paraview {
namespace {

double area_of(const Mesh& mesh, const Triangle& triangle) {
  const auto corner = [&](std::size_t k) -> Eigen::Vector3d {
    return mesh.positions[triangle[k]].cast<double>();
  };
  return (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
}

}  // namespace

RankPiece::RankPiece(const Ranks& ranks, const Mesh& mesh, std::vector<std::uint64_t> numbers,
                     std::vector<std::uint8_t> ghost_triangles)
    : ranks_(ranks),
      ghosts_(std::move(ghost_triangles)),
      surface_({mesh, numbers, ghosts_}, ranks.communicator()),
      owners_(ranks, numbers, surface_.is_own()) {
  for (Index v = 0; v < mesh.vertex_count(); ++v) sources_.push_back({ranks.rank(), v});
  owners_.from_owners(std::span(sources_));
}

bool RankPiece::is_shared_like(const RankPiece& other) const {
  return sources_ == other.sources_ && ghosts_ == other.ghosts_;
}

std::vector<double> RankPiece::cells_to_points(const Mesh& mesh, std::span<const double> rows,
                                               std::size_t columns) const {
  // A weight and the weighted sums.
  std::vector<std::vector<double>> sums(columns + 1, std::vector<double>(mesh.vertex_count()));
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto row = rows.subspan(t * columns, columns);
    const bool counts = std::ranges::all_of(row, [](double x) { return std::isfinite(x); });
    if (ghosts_[t] != 0 || !counts) continue;
    const double area = area_of(mesh, mesh.triangles[t]);
    for (const Index v : mesh.triangles[t]) {
      sums[columns][v] += area;
      for (std::size_t c = 0; c < columns; ++c) sums[c][v] += area * row[c];
    }
  }
  for (auto& by_vertex : sums) owners_.sum(std::span(by_vertex));
  std::vector<double> means;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const double weight = sums[columns][v];
    for (std::size_t c = 0; c < columns; ++c) {
      means.push_back(weight > 0 ? sums[c][v] / weight : std::numeric_limits<double>::quiet_NaN());
    }
  }
  return means;
}

std::array<double, 2> RankPiece::extent(std::array<double, 2> own) const {
  for (const auto& [lowest, highest] : ranks_.all(own)) {
    own = {std::min(own[0], lowest), std::max(own[1], highest)};
  }
  return own;
}

}  // namespace brindle::paraview
