#include "brindle/geometry/measures.h"

#include <cmath>

#include "brindle/base/parallel.h"
#include "brindle/base/text.h"
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
  throw Error(formatted(
      "surface: neighbours are %.2g units apart on average, too %s for numbers of single "
      "precision, "
      "which need %.2g to %.2g; give coordinates in other units, such as multiplied by 1e%d",
      mean, mean < 1 ? "near" : "far", kShortestEdges, kLongestEdges,
      -static_cast<int>(std::floor(std::log10(mean)))));
}

}  // namespace brindle
