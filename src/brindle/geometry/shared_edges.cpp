#include "brindle/geometry/shared_edges.h"

#include <algorithm>
#include <limits>

#include "brindle/error.h"

namespace brindle {
namespace {

/// A side of a triangle, told by the corners at its vertices of lower and higher number.
struct SortedSide {
  Index low, high;
  Index corner_of_low, corner_of_high;

  bool operator<(const SortedSide& other) const {
    if (low != other.low) return low < other.low;
    if (high != other.high) return high < other.high;
    return corner_of_low / 3 < other.corner_of_low / 3;
  }
};

}  // namespace

std::vector<SharedEdge> shared_edges(std::span<const Triangle> triangles) {
  if (triangles.size() > std::numeric_limits<Index>::max() / 3) {
    throw Error("the mesh has too many triangles; take a smaller one");
  }
  std::vector<SortedSide> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (Index c = 0; c < 3; ++c) {
      const Index next = (c + 1) % 3;
      const auto first = static_cast<Index>(3 * t);
      SortedSide side{triangles[t][c], triangles[t][next], first + c, first + next};
      if (side.low > side.high) {
        side = {side.high, side.low, side.corner_of_high, side.corner_of_low};
      }
      sides.push_back(side);
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<SharedEdge> edges;
  edges.reserve(sides.size() / 2);
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const SortedSide& a = sides[i - 1];
    const SortedSide& b = sides[i];
    if (a.low != b.low || a.high != b.high) continue;
    edges.push_back({{a.corner_of_low, b.corner_of_low}, {a.corner_of_high, b.corner_of_high}});
  }
  return edges;
}

}  // namespace brindle
