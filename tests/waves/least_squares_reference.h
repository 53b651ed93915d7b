/// The least squares of a frequency that yields, written down once more and solved another way.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include "brindle/mesh.h"
#include "brindle/phase_graph.h"
#include "brindle/spacing_tolerance.h"

namespace brindle::testing_support {

/// x'Ax - 2 b'x + c for logarithms of relative frequencies, x = 1 + log(g / f), in double
/// precision.
struct LeastSquares {
  Eigen::SparseMatrix<double> matrix;
  Eigen::VectorXd right;
  double constant = 0;
  Eigen::VectorXd mass;  ///< the area around every vertex

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
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(count), faith = mass;
  LeastSquares result;
  result.right = Eigen::VectorXd::Zero(count);
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
    const Eigen::Vector3d circulation = circulation_of(p, d, f);
    const double whole = circulation.sum();
    // Over the mean frequency, which grows as the mean of the logarithms does.
    const Eigen::Vector3d c = circulation - Eigen::Vector3d::Constant(whole / 3);
    Eigen::Matrix3d gradients;  // of the corners' hat functions, in columns
    for (int m = 0; m < 3; ++m) {
      gradients.col(m) = normal.cross(p[(m + 2) % 3] - p[(m + 1) % 3]) / normal.squaredNorm();
    }
    const Eigen::Matrix3d terms = weight * c * c.transpose() / a +
                                  0.01 * a * f.squaredNorm() * gradients.transpose() * gradients;
    result.constant += weight * whole * whole / a;
    for (int m = 0; m < 3; ++m) {
      for (int k = 0; k < 3; ++k) entries.emplace_back(t[m], t[k], terms(m, k));
      result.right[t[m]] -= weight * whole * c[m] / a;
      mass[t[m]] += a / 3;
      faith[t[m]] += weight * a / 3;
    }
    const Eigen::Vector3d middle = (p[0] + p[1] + p[2]) / 3;
    area += a;
    centre += a * middle;
    square += a * middle.squaredNorm();
  }
  const double mu = 0.25 / (square / area - (centre / area).squaredNorm());
  for (Eigen::Index i = 0; i < count; ++i) {
    const double f = static_cast<double>(waves.frequencies[static_cast<std::size_t>(i)]);
    // Vertices without a triangle keep their frequency.
    const double pull = mass[i] > 0 ? mu * faith[i] * f * f : 1;
    result.right[i] += pull;
    result.constant += pull;
    entries.emplace_back(i, i, pull);
  }
  result.mass = mass;
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

/// Logarithms that are less by what gives their ratios a mean of 1, found by halves.
inline Eigen::VectorXd shifted_to_mean(const LeastSquares& problem, const Eigen::VectorXd& x,
                                       const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  double low = -10, high = 10;
  Eigen::VectorXd shifted = x;
  for (int step = 0; step < 60; ++step) {
    const double by = (low + high) / 2;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      if (problem.mass[i] > 0) shifted[i] = std::clamp(x[i] - by, lower[i], upper[i]);
    }
    const double excess = problem.mass.dot(((shifted.array() - 1).exp() - 1).matrix());
    (excess > 0 ? low : high) = by;
  }
  return shifted;
}

/// The frequencies that a slack without branch_penalty leads to, in double precision.
struct LeastFrequencies {
  LeastSquares problem;
  Eigen::VectorXd most;  ///< 1 + S
  Eigen::VectorXd x;     ///< as LeastSquares has it, shifted to the mean
  double energy = 0;
  bool is_held = false;  ///< whether a bound holds any vertex

  LeastFrequencies(const Mesh& mesh, const WaveSet& waves, const Slack& slack)
      : problem(least_squares(mesh, waves)), most(problem.mass) {
    for (Eigen::Index v = 0; v < most.size(); ++v) {
      const auto i = static_cast<std::size_t>(v);
      most[v] =
          1 + static_cast<double>(slack.by_vertex.empty() ? slack.everywhere : slack.by_vertex[i]);
    }
    const Eigen::VectorXd upper = (most.array().log() + 1).matrix();
    const Eigen::VectorXd lower = (1 - most.array().log()).matrix();
    x = shifted_to_mean(problem, bounded_minimum(problem, lower, upper), lower, upper);
    energy = problem.energy(x);
    is_held = (x.array() <= lower.array()).any() || (x.array() >= upper.array()).any();
  }
};

/// Bounds hold to the last digit of a float, the mean of `ratios` is 1, and the energy is the least
/// but for what cycles leave undone: two thousandths, and where bounds hold something more, since
/// what another shift cuts off there makes curl.
inline void expect_least(const LeastFrequencies& exact, const Eigen::VectorXd& ratios) {
  EXPECT_LE(ratios.cwiseQuotient(exact.most).maxCoeff(), 1 + 1e-6);
  EXPECT_GE(ratios.cwiseProduct(exact.most).minCoeff(), 1 - 1e-6);
  EXPECT_NEAR(exact.problem.mass.dot(ratios) / exact.problem.mass.sum(), 1, 1e-4);
  const double energy = exact.problem.energy((ratios.array().log() + 1).matrix());
  EXPECT_NEAR(energy, exact.energy,
              (exact.is_held ? 0.02 : 0.002) * exact.energy + 1e-7 * exact.problem.constant);
}

}  // namespace brindle::testing_support
