#include "brindle/pipeline/fields/followed_field.h"

#include <algorithm>
#include <cmath>

#include "brindle/base/standard.h"

namespace brindle {
namespace {

/// How strongly the last field holds while it is smoothed, in multiples of what all neighbours
/// pull. A field is smoothed over 1 / sqrt(screening) edges: about half of what a surface of so
/// many vertices is across, and at least ten.
float screening_of(std::size_t vertices) {
  return std::min(0.01f, 5 / static_cast<float>(std::max<std::size_t>(vertices, 1)));
}

/// The last field holds so many times as strongly as what is measured anew, so that its noise is
/// that of several steps.
constexpr float kHold = 3;

float degree_of(const PhaseGraph& graph, Index node) {
  return static_cast<float>(graph.adjacency->of(node).size());
}

Complex unit_of(const Complex& u) {
  const float length = std::abs(u);
  return length > 0 ? u / length : Complex(0);
}

/// Where nothing is known, what is found from scratch.
std::vector<Complex> filled(const PhaseGraph& graph, std::span<const Complex> last,
                            std::span<const Complex> found) {
  std::vector<Complex> start(last.begin(), last.end());
  for (Index i = 0; i < graph.node_count(); ++i) {
    if (start[i] == Complex(0)) start[i] = found[i];
  }
  return start;
}

/// How strongly the last field holds at a node.
float hold_of(const PhaseGraph& graph, const LastValues& last, Index node, float weight) {
  const float noisy = last.noisy.empty() ? 0 : last.noisy[node];
  return last.confidence[node] * (weight * degree_of(graph, node) + kHold * noisy);
}

}  // namespace

std::vector<float> anchor_strengths(const PhaseGraph& graph) {
  std::vector<float> strengths(graph.anchor.size());
  ranges::transform(graph.anchor, strengths.begin(),
                    [](const Complex& pull) { return std::abs(pull); });
  return strengths;
}

std::vector<Complex> follow_last(PhaseGraph& graph, const LastValues& last, std::size_t vertices,
                                 const std::function<std::vector<Complex>()>& fill,
                                 const ScreenedOptions& screened) {
  const std::size_t count = graph.node_count();
  const std::vector<Complex> others =
      graph.anchor.empty() ? std::vector<Complex>(count) : graph.anchor;
  const float screening = screening_of(vertices);
  std::vector<float> screenings(count);
  graph.anchor.assign(count, Complex(0));
  double known = 0, unknown = 0;
  for (Index i = 0; i < count; ++i) {
    const float hold = last.u[i] == Complex(0) ? 0 : hold_of(graph, last, i, screening);
    graph.anchor[i] = others[i] + hold * last.u[i];
    screenings[i] = std::abs(others[i]) + hold;
    if (!graph.adjacency->of(i).empty()) ++(hold > 0 ? known : unknown);
  }
  if (screened.total) {
    known = screened.total(known);
    unknown = screened.total(unknown);
  }
  std::vector<Complex> start = unknown > 0 ? filled(graph, last.u, fill()) : last.u;
  if (known == 0) return start;  // nothing to go on from
  const std::vector<Complex> smooth = smooth_screened(graph, screenings, start, screened);
  for (Index i = 0; i < count; ++i) {
    const Complex unit = unit_of(smooth[i]);
    if (unit != Complex(0)) start[i] = unit;
    if (last.u[i] == Complex(0)) {
      graph.anchor[i] = others[i];
    } else {
      graph.anchor[i] = others[i] + hold_of(graph, last, i, last.weight) * start[i];
    }
  }
  return start;
}

}  // namespace brindle
