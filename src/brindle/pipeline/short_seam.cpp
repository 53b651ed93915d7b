#include "brindle/pipeline/short_seam.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace brindle {
namespace {

constexpr Index kNone = std::numeric_limits<Index>::max();

/// Each end of a seam is offered so many of its nearest fellows.
constexpr std::size_t kNearest = 24;

/// The edges at every item, in compressed rows.
struct Incidence {
  std::vector<Index> offsets;
  std::vector<Index> edges;

  std::span<const Index> of(Index item) const {
    return std::span(edges).subspan(offsets[item], offsets[item + 1] - offsets[item]);
  }
};

/// `ends(edge)` are the two items of an edge.
template <class Ends>
Incidence incidence(std::span<const SeamEdge> edges, std::size_t items, const Ends& ends) {
  Incidence result;
  result.offsets.assign(items + 1, 0);
  for (const SeamEdge& edge : edges) {
    for (const Index item : ends(edge)) ++result.offsets[item + 1];
  }
  for (std::size_t i = 0; i < items; ++i) result.offsets[i + 1] += result.offsets[i];
  result.edges.resize(2 * edges.size());
  std::vector<Index> next(result.offsets.begin(), result.offsets.end() - 1);
  for (Index e = 0; e < edges.size(); ++e) {
    for (const Index item : ends(edges[e])) result.edges[next[item]++] = e;
  }
  return result;
}

std::array<Index, 2> nodes_of(const SeamEdge& edge) { return edge.nodes; }
std::array<Index, 2> triangles_of(const SeamEdge& edge) { return edge.triangles; }

Index other(const std::array<Index, 2>& ends, Index one) {
  return ends[0] == one ? ends[1] : ends[0];
}

/// Breadth-first search from one node, over and over without clearing all.
class Search {
 public:
  Search(std::span<const SeamEdge> edges, std::size_t node_count)
      : edges_(edges),
        at_node_(incidence(edges, node_count, nodes_of)),
        reached_(node_count, kNone),
        steps_(node_count),
        by_edge_(node_count) {}

  /// Calls `visit(node, steps)` for nodes in the order of their distance until it returns false.
  template <class Visit>
  void run(Index start, const Visit& visit) {
    ++round_;
    queue_.assign(1, start);
    reached_[start] = round_;
    steps_[start] = 0;
    for (std::size_t next = 0; next < queue_.size(); ++next) {
      const Index node = queue_[next];
      if (!visit(node, steps_[node])) return;
      for (const Index e : at_node_.of(node)) {
        const Index to = other(edges_[e].nodes, node);
        if (reached_[to] == round_) continue;
        reached_[to] = round_;
        steps_[to] = steps_[node] + 1;
        by_edge_[to] = e;
        queue_.push_back(to);
      }
    }
  }

  /// The edges of a shortest path; empty if there is none.
  std::vector<Index> path(Index from, Index to) {
    bool found = false;
    run(from, [&](Index node, Index) { return !(found = node == to); });
    std::vector<Index> edges;
    for (Index node = to; found && node != from; node = other(edges_[edges.back()].nodes, node)) {
      edges.push_back(by_edge_[node]);
    }
    return edges;
  }

 private:
  std::span<const SeamEdge> edges_;
  Incidence at_node_;
  std::vector<Index> reached_;  ///< in which round
  std::vector<Index> steps_;
  std::vector<Index> by_edge_;
  std::vector<Index> queue_;
  Index round_ = 0;
};

/// Nodes that an odd number of the seam's edges meet in.
std::vector<Index> ends_of(std::span<const SeamEdge> edges, std::size_t node_count) {
  std::vector<std::uint8_t> odd(node_count);
  for (const SeamEdge& edge : edges) {
    if (!edge.in_seam) continue;
    odd[edge.nodes[0]] ^= 1;
    odd[edge.nodes[1]] ^= 1;
  }
  std::vector<Index> ends;
  for (Index node = 0; node < node_count; ++node) {
    if (odd[node]) ends.push_back(node);
  }
  return ends;
}

/// Pairs of ends with small sums of distances.
class Matching {
 public:
  Matching(const std::vector<Index>& ends, std::size_t node_count, Search& search)
      : ends_(ends), partner_(ends.size(), kNone), number_(node_count, kNone) {
    for (Index i = 0; i < ends.size(); ++i) number_[ends[i]] = i;
    measure(search);
    pair_near_ones_first();
    while (swap_partners()) {
    }
  }

  /// Numbers of nodes. Ends whose fellows are all too far away stay alone.
  std::vector<std::pair<Index, Index>> pairs() const {
    std::vector<std::pair<Index, Index>> result;
    for (Index i = 0; i < partner_.size(); ++i) {
      if (partner_[i] != kNone && i < partner_[i]) {
        result.emplace_back(ends_[i], ends_[partner_[i]]);
      }
    }
    return result;
  }

 private:
  void measure(Search& search) {
    near_.resize(ends_.size());
    for (Index i = 0; i < ends_.size(); ++i) {
      search.run(ends_[i], [&](Index node, Index steps) {
        if (number_[node] != kNone && number_[node] != i) near_[i].emplace(number_[node], steps);
        return near_[i].size() < kNearest;
      });
    }
  }

  std::optional<Index> distance(Index i, Index j) const {
    if (const auto found = near_[i].find(j); found != near_[i].end()) return found->second;
    if (const auto found = near_[j].find(i); found != near_[j].end()) return found->second;
    return std::nullopt;
  }

  void join(Index i, Index j) {
    partner_[i] = j;
    partner_[j] = i;
  }

  void pair_near_ones_first() {
    std::vector<std::array<Index, 3>> candidates;
    for (Index i = 0; i < near_.size(); ++i) {
      for (const auto& [j, steps] : near_[i]) candidates.push_back({steps, i, j});
    }
    std::sort(candidates.begin(), candidates.end());
    for (const auto& [steps, i, j] : candidates) {
      if (partner_[i] == kNone && partner_[j] == kNone) join(i, j);
    }
  }

  /// Lets two pairs swap partners where that shortens both paths together.
  bool swap_partners() {
    bool swapped = false;
    for (Index i = 0; i < near_.size(); ++i) {
      for (const auto& [j, steps] : near_[i]) {
        const Index k = partner_[i], l = partner_[j];
        if (k == kNone || l == kNone || k == j) continue;
        const auto between_others = distance(k, l), before_i = distance(i, k),
                   before_j = distance(j, l);
        if (!between_others || !before_i || !before_j) continue;
        if (steps + *between_others >= *before_i + *before_j) continue;
        join(i, j);
        join(k, l);
        swapped = true;
      }
    }
    return swapped;
  }

  const std::vector<Index>& ends_;
  std::vector<Index> partner_;
  std::vector<Index> number_;  ///< of every node among the ends
  std::vector<std::map<Index, Index>> near_;
};

/// 1 for edges that are in the old seam or on the new paths, but not on both.
std::vector<std::uint8_t> difference_to_paths(std::span<const SeamEdge> edges,
                                              std::size_t node_count) {
  std::vector<std::uint8_t> difference;
  for (const SeamEdge& edge : edges) difference.push_back(edge.in_seam);
  Search search(edges, node_count);
  const std::vector<Index> ends = ends_of(edges, node_count);
  for (const auto& [from, to] : Matching(ends, node_count, search).pairs()) {
    for (const Index e : search.path(from, to)) difference[e] ^= 1;
  }
  return difference;
}

/// The connected parts of a set of edges. Every part that no end of a seam is left alone in has an
/// even number of edges at each node.
std::vector<std::vector<Index>> connected_parts(std::span<const SeamEdge> edges,
                                                std::size_t node_count,
                                                const std::vector<std::uint8_t>& chosen) {
  const Incidence at_node = incidence(edges, node_count, nodes_of);
  std::vector<std::uint8_t> left = chosen;
  std::vector<std::vector<Index>> parts;
  for (Index start = 0; start < edges.size(); ++start) {
    if (!left[start]) continue;
    left[start] = 0;
    std::vector<Index> part{start};
    for (std::size_t next = 0; next < part.size(); ++next) {
      for (const Index node : edges[part[next]].nodes) {
        for (const Index e : at_node.of(node)) {
          if (!left[e]) continue;
          left[e] = 0;
          part.push_back(e);
        }
      }
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

/// The triangles on one side of a set of edges (1), if the set is the border between two sides.
std::optional<std::vector<std::uint8_t>> one_side(std::span<const SeamEdge> edges,
                                                  const Incidence& at_triangle,
                                                  const std::vector<std::uint8_t>& border) {
  constexpr std::uint8_t kUnknown = 2;
  const std::size_t count = at_triangle.offsets.size() - 1;
  std::vector<std::uint8_t> side(count, kUnknown);
  std::vector<Index> queue;
  for (Index start = 0; start < count; ++start) {
    if (side[start] != kUnknown) continue;
    side[start] = 0;
    queue.assign(1, start);
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const Index t = queue[next];
      for (const Index e : at_triangle.of(t)) {
        const Index to = other(edges[e].triangles, t);
        const std::uint8_t wanted = side[t] ^ border[e];
        if (side[to] == kUnknown) {
          side[to] = wanted;
          queue.push_back(to);
        } else if (side[to] != wanted) {
          return std::nullopt;
        }
      }
    }
  }
  return side;
}

using Parts = std::span<const std::vector<Index>>;

/// Turns the triangles that the parts surround: all parts at once, or else in halves down to single
/// parts, of which some surround nothing.
void turn_inside(std::span<const SeamEdge> edges, const Incidence& at_triangle, Parts parts,
                 std::vector<std::uint8_t>& turned) {
  if (parts.empty()) return;
  std::vector<std::uint8_t> border(edges.size());
  for (const std::vector<Index>& part : parts) {
    for (const Index e : part) border[e] = 1;
  }
  if (const auto side = one_side(edges, at_triangle, border)) {
    for (std::size_t t = 0; t < turned.size(); ++t) turned[t] ^= (*side)[t];
  } else if (parts.size() > 1) {
    turn_inside(edges, at_triangle, parts.first(parts.size() / 2), turned);
    turn_inside(edges, at_triangle, parts.subspan(parts.size() / 2), turned);
  }
}

}  // namespace

std::vector<std::uint8_t> shortening_turns(std::span<const SeamEdge> edges, std::size_t node_count,
                                           std::size_t triangle_count) {
  std::vector<std::vector<Index>> parts =
      connected_parts(edges, node_count, difference_to_paths(edges, node_count));
  std::erase_if(parts, [&](const std::vector<Index>& part) {
    const auto in_seam = std::ranges::count_if(part, [&](Index e) { return edges[e].in_seam; });
    return 2 * static_cast<std::size_t>(in_seam) <= part.size();
  });
  std::vector<std::uint8_t> turned(triangle_count);
  turn_inside(edges, incidence(edges, triangle_count, triangles_of), parts, turned);
  return turned;
}

}  // namespace brindle
