#include "brindle/phases/screened.h"

#include <cmath>
#include <cstdint>
#include <cstring>

#include "brindle/base/parallel.h"

namespace brindle {
namespace {

double dot(const Complex& a, const Complex& b) {
  return static_cast<double>(a.real()) * static_cast<double>(b.real()) +
         static_cast<double>(a.imag()) * static_cast<double>(b.imag());
}

/// Uses memchr, which is many times as fast as a loop over iterators.
bool any_reflects(const std::vector<std::uint8_t>& reflecting) {
  return !reflecting.empty() && std::memchr(reflecting.data(), 1, reflecting.size()) != nullptr;
}

class ScreenedSystem {
 public:
  ScreenedSystem(const PhaseGraph& graph, std::span<const float> screening,
                 const ScreenedOptions& options)
      : graph_(graph),
        diagonal_(graph.node_count()),
        inverse_(graph.node_count()),
        reflects_(any_reflects(graph.reflecting)) {
    parallel_for(nodes(), [&](std::size_t begin, std::size_t end) {
      for (Index i = static_cast<Index>(begin); i < end; ++i) {
        diagonal_[i] = screening[i] + (options.degrees.empty() ? degree(i) : options.degrees[i]);
        inverse_[i] = diagonal_[i] > 0 ? 1 / diagonal_[i] : 0;
      }
    });
  }

  std::size_t nodes() const { return graph_.node_count(); }

  /// Row i of the matrix times u.
  Complex row(Index i, std::span<const Complex> u) const {
    Complex sum = diagonal_[i] * u[i];
    const Index end = offsets()[i + 1];
    if (!reflects_) {
      for (Index e = offsets()[i]; e < end; ++e) {
        sum -= graph_.coupling[e] * u[graph_.adjacency->neighbors[e]];
      }
      return sum;
    }
    for (Index e = offsets()[i]; e < end; ++e) {
      const Complex& other = u[graph_.adjacency->neighbors[e]];
      sum -= graph_.coupling[e] * (graph_.reflecting[e] ? std::conj(other) : other);
    }
    return sum;
  }

  Complex preconditioned(Index i, const Complex& residual) const { return inverse_[i] * residual; }

  /// The sum of `of(i)` over all nodes.
  template <class Of>
  double sum(const Of& of) const {
    return parallel_sum<double>(nodes(), [&](std::size_t begin, std::size_t end) {
      double part = 0;
      for (Index i = static_cast<Index>(begin); i < end; ++i) part += of(i);
      return part;
    });
  }

 private:
  std::span<const Index> offsets() const { return graph_.adjacency->offsets; }

  float degree(Index i) const {
    float sum = 0;
    for (Index e = offsets()[i]; e < offsets()[i + 1]; ++e) sum += std::abs(graph_.coupling[e]);
    return sum;
  }

  const PhaseGraph& graph_;
  std::vector<float> diagonal_, inverse_;  ///< inverse_ is 0 where the diagonal is 0
  bool reflects_;                          ///< whether any edge is reflecting
};

template <class Change>
void for_nodes(const ScreenedSystem& system, const Change& change) {
  parallel_for(system.nodes(), [&](std::size_t begin, std::size_t end) {
    for (Index i = static_cast<Index>(begin); i < end; ++i) change(i);
  });
}

}  // namespace

std::vector<Complex> smooth_screened(const PhaseGraph& graph, std::span<const float> screening,
                                     std::vector<Complex> start, const ScreenedOptions& options) {
  const ScreenedSystem system(graph, screening, options);
  std::vector<Complex> u = std::move(start);
  std::vector<Complex> residual(u.size()), step(u.size()), image(u.size());
  const auto anchor = [&](Index i) { return graph.anchor.empty() ? Complex(0) : graph.anchor[i]; };
  for_nodes(system, [&](Index i) {
    residual[i] = anchor(i) - system.row(i, u);
    step[i] = system.preconditioned(i, residual[i]);
  });
  double error = system.sum([&](Index i) { return dot(residual[i], step[i]); });
  const double first =
      options.of_anchors
          ? system.sum([&](Index i) { return dot(anchor(i), system.preconditioned(i, anchor(i))); })
          : error;
  const double enough = first * static_cast<double>(options.tolerance * options.tolerance);
  for (int iteration = 0; iteration < options.max_iterations && error > enough; ++iteration) {
    // The number of iterations is unknown: each reports a thirtieth of the remainder.
    options.progress.report(1 - std::pow(29.0 / 30, iteration));
    const double curvature = system.sum([&](Index i) {
      image[i] = system.row(i, step);
      return dot(step[i], image[i]);
    });
    if (!(curvature > 0)) break;
    const auto length = static_cast<float>(error / curvature);
    const double next = system.sum([&](Index i) {
      u[i] += length * step[i];
      residual[i] -= length * image[i];
      return dot(residual[i], system.preconditioned(i, residual[i]));
    });
    const auto keep = static_cast<float>(next / error);
    for_nodes(system,
              [&](Index i) { step[i] = system.preconditioned(i, residual[i]) + keep * step[i]; });
    error = next;
  }
  return u;
}

}  // namespace brindle
