#include "brindle/phases/screened.h"

#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "brindle/base/parallel.h"
#include "brindle/shapes.h"
#include "brindle/surface.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {
namespace {

struct Problem {
  PhaseGraph graph;
  std::vector<float> screening;
  std::vector<Complex> start;
};

/// A direction graph with data at every third vertex.
Problem problem_on(const char* shape) {
  const Surface surface = make_surface(make_shape(shape));
  Problem problem{build_direction_graph(surface.neighborhood, surface.normals, 2), {}, {}};
  for (Index i = 0; i < problem.graph.node_count(); ++i) {
    const float screening = i % 3 == 0 ? 0.5f : 0.0f;
    problem.screening.push_back(screening);
    problem.graph.anchor.push_back(screening * std::polar(1.0f, 0.1f * static_cast<float>(i)));
    problem.start.push_back(std::polar(1.0f, 0.3f * static_cast<float>(i)));
  }
  return problem;
}

/// The minimum by a dense factorisation in real and imaginary parts.
Eigen::VectorXd dense_minimum(const Problem& problem) {
  const auto count = static_cast<Eigen::Index>(problem.graph.node_count());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * count, 2 * count);
  Eigen::VectorXd right(2 * count);
  const Adjacency& adjacency = *problem.graph.adjacency;
  for (Index i = 0; i < problem.graph.node_count(); ++i) {
    const Eigen::Index re = 2 * static_cast<Eigen::Index>(i), im = re + 1;
    double diagonal = static_cast<double>(problem.screening[i]);
    for (Index e = adjacency.offsets[i]; e < adjacency.offsets[i + 1]; ++e) {
      const Eigen::Index other = 2 * static_cast<Eigen::Index>(adjacency.neighbors[e]);
      const std::complex<double> a = problem.graph.coupling[e];
      const double sign = problem.graph.reflecting[e] ? -1 : 1;
      diagonal += std::abs(a);
      matrix(re, other) -= a.real();
      matrix(re, other + 1) += sign * a.imag();
      matrix(im, other) -= a.imag();
      matrix(im, other + 1) -= sign * a.real();
    }
    matrix(re, re) += diagonal;
    matrix(im, im) += diagonal;
    right[re] = static_cast<double>(problem.graph.anchor[i].real());
    right[im] = static_cast<double>(problem.graph.anchor[i].imag());
  }
  return matrix.ldlt().solve(right);
}

TEST(Screened, IsTheMinimumOfItsEnergy) {
  // The strip has reflecting edges.
  for (const char* shape : {"sphere,resolution=5", "mobius,resolution=6"}) {
    const Problem problem = problem_on(shape);
    ScreenedOptions options;
    options.tolerance = 1e-6f;
    options.max_iterations = 1000;
    const auto u = smooth_screened(problem.graph, problem.screening, problem.start, options);
    const Eigen::VectorXd expected = dense_minimum(problem);
    for (std::size_t i = 0; i < u.size(); ++i) {
      const auto k = 2 * static_cast<Eigen::Index>(i);
      EXPECT_NEAR(u[i].real(), expected[k], 1e-4) << shape << i;
      EXPECT_NEAR(u[i].imag(), expected[k + 1], 1e-4) << shape << i;
    }
  }
}

TEST(Screened, StaysWhereEverythingAgrees) {
  const Surface plane = make_surface(make_shape("plane,resolution=12"));
  PhaseGraph graph = build_direction_graph(plane.neighborhood, plane.normals, 2);
  const std::vector<Complex> u(graph.node_count(), std::polar(1.0f, 0.7f));
  const std::vector<float> screening(graph.node_count(), 0.1f);
  for (const Complex& value : u) graph.anchor.push_back(0.1f * value);
  const auto found = smooth_screened(graph, screening, u);
  for (std::size_t i = 0; i < u.size(); ++i) EXPECT_LT(std::abs(found[i] - u[i]), 1e-5f);
}

TEST(Screened, FillsInWhatIsNotKnown) {
  const Surface plane = make_surface(make_shape("plane,resolution=12"));
  PhaseGraph graph = build_direction_graph(plane.neighborhood, plane.normals, 2);
  std::vector<float> screening(graph.node_count(), 0);
  graph.anchor.resize(graph.node_count());
  screening[7] = 1;
  graph.anchor[7] = Complex(0, 1);
  const std::vector<Complex> start(graph.node_count());
  for (const Complex& u : smooth_screened(graph, screening, start)) {
    EXPECT_LT(std::abs(u - Complex(0, 1)), 0.01f);
  }
}

TEST(Screened, IsTheSameForEveryNumberOfThreads) {
  const Problem problem = problem_on("sphere,resolution=30");
  const ThreadLimit one(1);
  const auto alone = smooth_screened(problem.graph, problem.screening, problem.start);
  const ThreadLimit two(2);
  EXPECT_EQ(smooth_screened(problem.graph, problem.screening, problem.start), alone);
}

TEST(Screened, GraphsWithoutEdgesOrDataComeToAnEnd) {
  PhaseGraph graph;
  Adjacency adjacency;
  adjacency.offsets = {0, 0, 0};
  graph.adjacency = std::make_shared<const Adjacency>(adjacency);
  const std::vector<float> screening{1, 0};
  graph.anchor = {Complex(0, 2), Complex(0)};
  const auto u = smooth_screened(graph, screening, {Complex(1), Complex(1)});
  EXPECT_LT(std::abs(u[0] - Complex(0, 2)), 1e-6f);
  EXPECT_EQ(u[1], Complex(1));
}

}  // namespace
}  // namespace brindle
