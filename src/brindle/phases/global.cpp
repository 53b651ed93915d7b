#include "brindle/phases/global.h"

#ifndef BRINDLE_HAS_CHOLMOD

namespace brindle {

PhaseSolution solve_global(const PhaseGraph&, std::span<const float>, const SolverOptions&,
                           const Progress&) {
  throw Error(
      "this build of brindle has no CHOLMOD; install libsuitesparse-dev and configure with "
      "-DBRINDLE_CHOLMOD=ON, or use another solver");
}

}  // namespace brindle

#else

#include <algorithm>
#include <cmath>

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCore>

#include "brindle/base/parallel.h"
#include "brindle/base/random.h"
#include "brindle/base/stopwatch.h"
#include "brindle/phases/serial_blas.h"

namespace brindle {
namespace {

// 64-bit indices: the factor of a million vertices has more than 2^31 entries.
using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, SuiteSparse_long>;
using Vector = Eigen::VectorXd;

/// Added to the energy matrix, as a share of its mean diagonal, to make it positive definite.
constexpr double kShift = 1e-7;

/// The least shift of a node with almost no mass, as a share of its weights: above rounding errors.
constexpr double kLeastShift = 1e-11;

/// One real 2x2 block per coupling, lower triangle only: A z has [[re, -im], [im, re]], B conj(z)
/// has [[re, im], [im, -re]].
void add_coupling(std::vector<Eigen::Triplet<double, SuiteSparse_long>>& entries, Index i, Index j,
                  std::complex<double> c, bool reflecting) {
  const double sign = reflecting ? -1 : 1;
  entries.emplace_back(2 * i, 2 * j, -c.real());
  entries.emplace_back(2 * i, 2 * j + 1, sign * c.imag());
  entries.emplace_back(2 * i + 1, 2 * j, -c.imag());
  entries.emplace_back(2 * i + 1, 2 * j + 1, -sign * c.real());
}

std::vector<double> weight_sums(const PhaseGraph& graph) {
  std::vector<double> sums(graph.node_count());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    for (Index edge = graph.adjacency->offsets[i]; edge < graph.adjacency->offsets[i + 1]; ++edge) {
      // In double precision, like the matrix: rounding down could make it indefinite.
      sums[i] += std::abs(std::complex<double>(graph.coupling[edge]));
    }
  }
  return sums;
}

double mass_of(std::span<const float> mass, Index node) {
  return mass.empty() ? 1.0 : static_cast<double>(mass[node]);
}

/// The quadratic form of the energy, shifted by a multiple of the mass.
Matrix energy_matrix(const PhaseGraph& graph, std::span<const float> mass,
                     const Progress& progress) {
  const std::vector<double> weights = weight_sums(graph);
  const auto nodes = static_cast<Index>(graph.node_count());
  double total_weight = 0, total_mass = 0;
  for (Index i = 0; i < nodes; ++i) {
    total_weight += weights[i];
    total_mass += mass_of(mass, i);
  }
  const double shift = kShift * total_weight / total_mass;
  std::vector<Eigen::Triplet<double, SuiteSparse_long>> entries;
  entries.reserve(2 * nodes + 2 * graph.coupling.size());
  for (Index i = 0; i < nodes; ++i) {
    if (i % kReportSlice == 0) progress.tick();
    // Any phase solves a node without couplings.
    const double shifted =
        weights[i] + std::max(shift * mass_of(mass, i), kLeastShift * weights[i]);
    const double diagonal = weights[i] > 0 ? shifted : 1.0;
    entries.emplace_back(2 * i, 2 * i, diagonal);
    entries.emplace_back(2 * i + 1, 2 * i + 1, diagonal);
    for (Index edge = graph.adjacency->offsets[i]; edge < graph.adjacency->offsets[i + 1]; ++edge) {
      const Index j = graph.adjacency->neighbors[edge];
      if (j < i) add_coupling(entries, i, j, graph.coupling[edge], graph.reflecting[edge]);
    }
  }
  progress.tick();
  Matrix matrix(2 * nodes, 2 * nodes);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Vector mass_vector(const PhaseGraph& graph, std::span<const float> mass) {
  Vector doubled(2 * graph.node_count());
  for (Index i = 0; i < graph.node_count(); ++i) {
    doubled[2 * i] = doubled[2 * i + 1] = mass_of(mass, i);
  }
  return doubled;
}

/// A wave whose direction is reversed has -conj(z). Imaginary numbers stay, so that the start, and
/// all that follows, does not depend on the signs of directions.
Vector start_vector(const PhaseGraph& graph, std::uint32_t seed) {
  Vector x = Vector::Zero(2 * static_cast<Eigen::Index>(graph.node_count()));
  for (Index i = 0; i < graph.node_count(); ++i) x[2 * i + 1] = random_phase(i, seed).imag();
  return x;
}

std::vector<Complex> unit_numbers(const Vector& x) {
  std::vector<Complex> z(static_cast<std::size_t>(x.size() / 2));
  for (std::size_t i = 0; i < z.size(); ++i) {
    const std::complex<double> value(x[2 * i], x[2 * i + 1]);
    const double length = std::abs(value);
    z[i] = length > 0 ? Complex(value / length) : Complex(0, 1);
  }
  return z;
}

}  // namespace

PhaseSolution solve_global(const PhaseGraph& graph, std::span<const float> mass,
                           const SolverOptions& options, const Progress& progress) {
  PhaseSolution solution;
  if (graph.node_count() == 0) return solution;
  if (!mass.empty() && mass.size() != graph.node_count()) {
    throw Error("the global solver needs one mass for each of " +
                std::to_string(graph.node_count()) + " nodes, or none");
  }
  Stopwatch watch;
  // CHOLMOD cannot be cancelled during ordering and factorisation.
  JobStages stages(progress, {{"global: energy matrix", 3},
                              {"global: order", 10},
                              {"global: Cholesky factor", 40},
                              {"global: inverse iteration", 20}});
  const Matrix matrix = energy_matrix(graph, mass, stages.begin("global: energy matrix"));
  stages.begin("global: order");
  const SerialBlas one_thread;
  Eigen::CholmodDecomposition<Matrix, Eigen::Lower> factor;
  factor.cholmod().print = 0;
  factor.analyzePattern(matrix);
  stages.begin("global: Cholesky factor");
  if (factor.info() == Eigen::Success) factor.factorize(matrix);
  if (factor.info() != Eigen::Success) {
    const bool is_memory = factor.cholmod().status == CHOLMOD_OUT_OF_MEMORY;
    throw Error("the global solver could not factorise the energy matrix of " +
                std::to_string(graph.node_count()) + " nodes; " +
                (is_memory ? "free some memory, or" : "its weights are too far apart;") +
                " take another solver");
  }
  const Vector masses = mass_vector(graph, mass);
  Vector x = start_vector(graph, options.seed);
  const Progress iterating = stages.begin("global: inverse iteration");
  for (; solution.iterations < options.global_iterations; ++solution.iterations) {
    iterating.report(static_cast<double>(solution.iterations) / options.global_iterations);
    x = factor.solve(masses.cwiseProduct(x).eval()).eval();
    x /= std::sqrt(x.dot(masses.cwiseProduct(x)));
  }
  solution.z = unit_numbers(x);
  solution.solve_milliseconds = watch.lap();
  solution.energy = energy(graph, solution.z);
  stages.finish();
  return solution;
}

}  // namespace brindle

#endif
