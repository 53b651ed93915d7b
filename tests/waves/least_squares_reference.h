/// The least squares of a frequency that yields, written down once more and solved another way.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include "brindle/mesh.h"
#include "brindle/phase_graph.h"

namespace brindle::testing_support {

/// x'Ax - 2 b'x + c for relative frequencies x = g / f, in double precision.
struct LeastSquares {
  Eigen::SparseMatrix<double> matrix;
  Eigen::VectorXd right;
  double constant = 0;

  double energy(const Eigen::VectorXd& x) const {
    return x.dot(matrix * x) - 2 * right.dot(x) + constant;
  }
};

/// Circulation of f x d around a triangle, edge by edge.
inline Eigen::Vector3d circulation_of(const std::array<Eigen::Vector3d, 3>& p,
                                      std::array<Eigen::Vector3d, 3> d, const Eigen::Vector3d& f) {
  const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
  const bool odd = (d[0].dot(d[1]) < 0) != ((d[1].dot(d[2]) < 0) != (d[2].dot(d[0]) < 0));
  if (odd) return Eigen::Vector3d::Zero();
  for (int m = 1; m < 3; ++m) {
    if (d[0].dot(d[m]) < 0) d[m] = -d[m];
  }
  Eigen::Vector3d c = Eigen::Vector3d::Zero();
  for (int m = 0; m < 3; ++m) {
    const int n = (m + 1) % 3;
    const Eigen::Vector3d edge = p[n] - p[m];
    for (const int k : {m, n}) {
      c[k] += 0.5 * f[k] * edge.dot((d[k] - d[k].dot(normal) * normal).normalized());
    }
  }
  return c;
}

/// `weights` is empty or has one per triangle.
inline LeastSquares least_squares(const Mesh& mesh, const WaveSet& waves,
                                  std::span<const double> weights = {}) {
  const auto count = static_cast<Eigen::Index>(mesh.vertex_count());
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(count);
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double area = 0, square = 0;
  std::vector<Eigen::Triplet<double>> entries;
  const auto at = [&](Index v) { return mesh.positions[v].cast<double>().eval(); };
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    const Triangle& t = mesh.triangles[n];
    const double weight = weights.empty() ? 1 : weights[n];
    const std::array<Eigen::Vector3d, 3> p = {at(t[0]), at(t[1]), at(t[2])};
    std::array<Eigen::Vector3d, 3> d;
    Eigen::Vector3d f;
    for (int m = 0; m < 3; ++m) {
      d[m] = waves.directions[t[m]].cast<double>();
      f[m] = static_cast<double>(waves.frequencies[t[m]]);
    }
    if (d[0].isZero(0) || d[1].isZero(0) || d[2].isZero(0)) continue;
    const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
    const double a = normal.norm() / 2;
    const Eigen::Vector3d c = circulation_of(p, d, f);
    Eigen::Matrix3d gradients;  // of the corners' hat functions, in columns
    for (int m = 0; m < 3; ++m) {
      gradients.col(m) = normal.cross(p[(m + 2) % 3] - p[(m + 1) % 3]) / normal.squaredNorm();
    }
    const Eigen::Matrix3d terms = weight * c * c.transpose() / a + 0.03 * a * f.asDiagonal() *
                                                                       gradients.transpose() *
                                                                       gradients * f.asDiagonal();
    for (int m = 0; m < 3; ++m) {
      for (int k = 0; k < 3; ++k) entries.emplace_back(t[m], t[k], terms(m, k));
      mass[t[m]] += a / 3;
    }
    const Eigen::Vector3d middle = (p[0] + p[1] + p[2]) / 3;
    area += a;
    centre += a * middle;
    square += a * middle.squaredNorm();
  }
  const double mu = 1 / (square / area - (centre / area).squaredNorm());
  LeastSquares result;
  result.right = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double f = static_cast<double>(waves.frequencies[static_cast<std::size_t>(i)]);
    result.right[i] = mu * mass[i] * f * f;
    // Vertices without a triangle keep their frequency.
    entries.emplace_back(i, i, mass[i] > 0 ? result.right[i] : 1);
    if (mass[i] == 0) result.right[i] = 1;
  }
  result.constant = result.right.sum();
  result.matrix.resize(count, count);
  result.matrix.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// The minimum between the bounds: factorised anew until the same variables stay at their bounds.
inline Eigen::VectorXd bounded_minimum(const LeastSquares& problem, const Eigen::VectorXd& lower,
                                       const Eigen::VectorXd& upper) {
  const Eigen::Index count = lower.size();
  Eigen::VectorXd x = Eigen::VectorXd::Ones(count);
  std::vector<int> held(static_cast<std::size_t>(count));  // -1, 1: at a bound
  for (int round = 0; round < 100; ++round) {
    Eigen::VectorXd fixed = Eigen::VectorXd::Zero(count), is_free = Eigen::VectorXd::Ones(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const int h = held[static_cast<std::size_t>(i)];
      if (h == 0) continue;
      fixed[i] = h < 0 ? lower[i] : upper[i];
      is_free[i] = 0;
    }
    Eigen::SparseMatrix<double> matrix =
        is_free.asDiagonal() * problem.matrix * is_free.asDiagonal();
    const Eigen::VectorXd pinned = Eigen::VectorXd::Ones(count) - is_free;
    matrix += Eigen::SparseMatrix<double>(pinned.asDiagonal());
    const Eigen::VectorXd right =
        is_free.cwiseProduct(problem.right - problem.matrix * fixed) + fixed;
    x = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
    const Eigen::VectorXd slope = problem.matrix * x - problem.right;
    std::vector<int> next = held;
    for (Eigen::Index i = 0; i < count; ++i) {
      int& h = next[static_cast<std::size_t>(i)];
      if (h == 0) {
        h = x[i] < lower[i] - 1e-9 ? -1 : x[i] > upper[i] + 1e-9 ? 1 : 0;
      } else if (h * slope[i] > 0) {
        h = 0;
      }
    }
    if (next == held) break;
    held = next;
  }
  return x.cwiseMax(lower).cwiseMin(upper);
}

}  // namespace brindle::testing_support
