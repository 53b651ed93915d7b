#include "brindle/phases/node_order.h"

#include <cstdint>

#include "brindle/base/parallel.h"

namespace brindle {

std::vector<Index> breadth_first_order(const Adjacency& adjacency, const Progress& progress) {
  const auto count = static_cast<Index>(adjacency.node_count());
  std::vector<Index> order;
  order.reserve(count);
  std::vector<std::uint8_t> seen(count);
  const auto visit = [&](Index node) {
    if (seen[node]) return;
    seen[node] = 1;
    order.push_back(node);
  };
  for (Index start = 0; start < count; ++start) {
    const std::size_t first = order.size();
    visit(start);
    for (std::size_t next = first; next < order.size(); ++next) {
      if (next % kReportSlice == 0) {
        progress.report(static_cast<double>(next) / static_cast<double>(count));
      }
      for (const Index neighbor : adjacency.of(order[next])) visit(neighbor);
    }
  }
  return order;
}

}  // namespace brindle
