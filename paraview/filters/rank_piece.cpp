#include "rank_piece.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "vtk_arrays.h"

namespace brindle::paraview {
namespace {

double area_of(const Mesh& mesh, const Triangle& triangle) {
  const auto corner = [&](std::size_t k) -> Eigen::Vector3d {
    return mesh.positions[triangle[k]].cast<double>();
  };
  return (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
}

/// The entries of d d^T / |d|, column by column.
constexpr std::size_t kTensor = 9;

Eigen::Vector3d vector_at(std::span<const double> row) {
  return {row[0], row[1], row.size() > 2 ? row[2] : 0};
}

std::vector<double> tensors_of(std::span<const double> vectors, std::size_t columns) {
  std::vector<double> tensors;
  for (std::size_t at = 0; at < vectors.size(); at += columns) {
    const Eigen::Vector3d axis = vector_at(vectors.subspan(at, columns));
    const Eigen::Matrix3d tensor = axis * axis.stableNormalized().transpose();
    tensors.insert(tensors.end(), tensor.data(), tensor.data() + tensor.size());
  }
  return tensors;
}

/// Reference directions that align the axes around every vertex.
std::vector<Eigen::Vector3d> sides_of(std::span<const double> tensors) {
  std::vector<Eigen::Vector3d> sides;
  for (std::size_t at = 0; at < tensors.size(); at += kTensor) {
    const Eigen::Matrix3d tensor = Eigen::Map<const Eigen::Matrix3d>(&tensors[at]);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved(tensor);
    sides.push_back(solved.eigenvectors().col(2));
  }
  return sides;
}

}  // namespace

RankPiece::RankPiece(const Ranks& ranks, const SurfacePiece& piece)
    : ranks_(ranks),
      ghosts_(piece.ghost_triangles),
      surface_(piece, ranks.communicator()),
      owners_(ranks, piece.vertex_ids, surface_.is_own()) {
  for (Index v = 0; v < piece.mesh.vertex_count(); ++v) sources_.push_back({ranks.rank(), v});
  owners_.from_owners(std::span(sources_));
}

bool RankPiece::is_shared_like(const RankPiece& other) const {
  return sources_ == other.sources_ && ghosts_ == other.ghosts_;
}

DataArray RankPiece::cells_to_points(const Mesh& mesh, const DataArray& rows) const {
  const auto columns = static_cast<std::size_t>(rows.components);
  const std::vector<double> numbers = doubles_of(rows);
  const auto means = [&](std::span<const double> cells, std::size_t width, const Sign& sign) {
    return means_of(mesh, cells, width, sign);
  };
  const auto as_it_is = [](std::size_t, Index) { return 1.0; };
  DataArray points = make_data_array(rows.name, rows.components, means(numbers, columns, as_it_is));
  if (!may_be_axes(rows)) return points;
  const std::vector<double> tensors = means(tensors_of(numbers, columns), kTensor, as_it_is);
  const std::vector<Eigen::Vector3d> sides = sides_of(tensors);
  const std::vector<double> axes = means(numbers, columns, [&](std::size_t t, Index v) {
    const Eigen::Vector3d axis = vector_at(std::span(numbers).subspan(t * columns, columns));
    return axis.dot(sides[v]) < 0 ? -1.0 : 1.0;
  });
  points.axis_bytes = make_data_array(rows.name, rows.components, axes).bytes;
  return points;
}

std::vector<double> RankPiece::means_of(const Mesh& mesh, std::span<const double> rows,
                                        std::size_t columns, const Sign& sign) const {
  // A weight and the weighted sums.
  std::vector<std::vector<double>> sums(columns + 1, std::vector<double>(mesh.vertex_count()));
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto row = rows.subspan(t * columns, columns);
    const bool counts = std::ranges::all_of(row, [](double x) { return std::isfinite(x); });
    if (ghosts_[t] != 0 || !counts) continue;
    const double area = area_of(mesh, mesh.triangles[t]);
    for (const Index v : mesh.triangles[t]) {
      sums[columns][v] += area;
      const double share = area * sign(t, v);
      for (std::size_t c = 0; c < columns; ++c) sums[c][v] += share * row[c];
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
