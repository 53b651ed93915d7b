#include "brindle/geometry/edge_lengths.h"

#include <cmath>
#include <sstream>

#include "brindle/base/parallel.h"
#include "brindle/error.h"

namespace brindle {

EdgeLengths edge_lengths(std::span<const Vec3> positions, const Adjacency& neighborhood) {
  const auto body = [&](std::size_t begin, std::size_t end) {
    EdgeLengths lengths;
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      const Eigen::Vector3d from = positions[v].cast<double>();
      for (const Index neighbor : neighborhood.of(v)) {
        lengths.sum += (positions[neighbor].cast<double>() - from).norm();
        ++lengths.count;
      }
    }
    return lengths;
  };
  return parallel_sum<EdgeLengths>(neighborhood.node_count(), body);
}

void check_edge_lengths(const EdgeLengths& lengths) {
  if (!(lengths.sum > 0)) return;
  const double mean = lengths.sum / static_cast<double>(lengths.count);
  if (mean >= kShortestEdges && mean <= kLongestEdges) return;
  std::ostringstream text;
  text.precision(2);
  text << "surface: neighbours are " << mean << " units apart on average, too "
       << (mean < 1 ? "near" : "far") << " for numbers of single precision, which need "
       << kShortestEdges << " to " << kLongestEdges
       << "; give coordinates in other units, such as multiplied by 1e"
       << -static_cast<int>(std::floor(std::log10(mean)));
  throw Error(text.str());
}

}  // namespace brindle
