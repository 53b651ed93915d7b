#include "brindle/pipeline/short_seam.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "brindle/base/compressed_rows.h"
#include "brindle/base/parallel.h"
#include "brindle/base/ranges.h"

namespace brindle {
namespace {

constexpr Index kNone = std::numeric_limits<Index>::max();

/// Each end of a seam is offered so many of its nearest fellows.
constexpr std::size_t kNearest = 24;

/// An edge at an item, and the item at its other end.
struct Way {
  Index edge;
  Index to;
};

/// The ways from every item.
using Ways = CompressedRows<Way>;

/// `ends(edge)` are the two items of an edge.
template <class Ends>
Ways ways_between(std::span<const SeamEdge> edges, std::size_t items, const Ends& ends) {
  return compressed_rows<Way>(items, [&](const auto& add) {
    for (Index e = 0; e < edges.size(); ++e) {
      const auto [a, b] = ends(edges[e]);
      add(a, {e, b});
      add(b, {e, a});
    }
  });
}

std::array<Index, 2> nodes_of(const SeamEdge& edge) { return edge.nodes; }
std::array<Index, 2> triangles_of(const SeamEdge& edge) { return edge.triangles; }

/// Breadth-first search from one node, over and over without clearing all.
class Search {
 public:
  explicit Search(const Ways& at_node) : at_node_(at_node), found_(at_node.size()) {}

  /// Calls `visit(node, steps)` for nodes in the order of their distance until it returns false.
  template <class Visit>
  void run(Index start, const Visit& visit) {
    ++round_;
    queue_.assign(1, start);
    found_[start] = {round_, 0, kNone, kNone};
    for (std::size_t next = 0; next < queue_.size(); ++next) {
      const Index node = queue_[next];
      const Index steps = found_[node].steps;
      if (!visit(node, steps)) return;
      for (const Way& way : at_node_.of(node)) {
        if (found_[way.to].round == round_) continue;
        found_[way.to] = {round_, steps + 1, way.edge, node};
        queue_.push_back(way.to);
      }
    }
  }

  /// The edges of a shortest path; empty if there is none.
  std::vector<Index> path(Index from, Index to) {
    bool found = false;
    run(from, [&](Index node, Index) { return !(found = node == to); });
    std::vector<Index> edges;
    for (Index node = to; found && node != from; node = found_[node].before) {
      edges.push_back(found_[node].by_edge);
    }
    return edges;
  }

 private:
  struct Found {
    Index round = kNone;  ///< the last one that came here
    Index steps = 0;
    Index by_edge = kNone;
    Index before = kNone;
  };

  const Ways& at_node_;
  std::vector<Found> found_;
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

/// An end's fellow and how far it is.
struct Near {
  Index end;
  Index steps;
};

/// Of every end its kNearest nearest fellows, in ascending order of their numbers.
std::vector<std::vector<Near>> nearest_ends(const std::vector<Index>& ends, const Ways& at_node,
                                            const Progress& progress) {
  std::vector<Index> number(at_node.size(), kNone);
  for (Index i = 0; i < ends.size(); ++i) number[ends[i]] = i;
  std::vector<std::vector<Near>> near(ends.size());
  // Where there are few ends, each is far from the next: the search goes over all nodes.
  constexpr std::size_t kFew = 2 * kNearest;
  const bool few = ends.size() < kFew;
  const std::size_t ends_per_task = few ? 1 : 16, ends_per_report = few ? 2 : 256;
  const auto search_from = [&](std::size_t begin, std::size_t end) {
    Search search(at_node);
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      search.run(ends[i], [&](Index node, Index steps) {
        if (number[node] != kNone && number[node] != i) near[i].push_back({number[node], steps});
        return near[i].size() < kNearest;
      });
      ranges::sort(near[i], {}, &Near::end);
    }
  };
  parallel_for(ends.size(), progress, search_from, ends_per_task, ends_per_report);
  return near;
}

/// Pairs of ends with small sums of distances.
class Matching {
 public:
  Matching(const std::vector<Index>& ends, const Ways& at_node, const Progress& progress)
      : ends_(ends), partner_(ends.size(), kNone), near_(nearest_ends(ends, at_node, progress)) {
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
  std::optional<Index> distance_from(Index i, Index j) const {
    const auto found = ranges::lower_bound(near_[i], j, {}, &Near::end);
    if (found == near_[i].end() || found->end != j) return std::nullopt;
    return found->steps;
  }

  std::optional<Index> distance(Index i, Index j) const {
    const auto steps = distance_from(i, j);
    return steps ? steps : distance_from(j, i);
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
    ranges::sort(candidates.begin(), candidates.end());
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
  std::vector<std::vector<Near>> near_;
};

/// 1 for edges that are in the old seam or on the new paths, but not on both.
std::vector<std::uint8_t> difference_to_paths(std::span<const SeamEdge> edges, const Ways& at_node,
                                              const Progress& progress) {
  std::vector<std::uint8_t> difference(edges.size());
  ranges::transform(edges, difference.begin(),
                    [](const SeamEdge& edge) { return edge.in_seam ? 1 : 0; });
  const std::vector<Index> ends = ends_of(edges, at_node.size());
  Search search(at_node);
  const auto pairs = Matching(ends, at_node, progress.part(0, 0.7)).pairs();
  const Progress joining = progress.part(0.7, 1);
  constexpr std::size_t kPathsPerReport = 1;  // each may be as long as the surface is
  reported_for(
      pairs.size(), joining,
      [&](std::size_t i) {
        for (const Index e : search.path(pairs[i].first, pairs[i].second)) difference[e] ^= 1;
      },
      kPathsPerReport);
  return difference;
}

/// The connected parts of a set of edges. Every part that no end of a seam is left alone in has an
/// even number of edges at each node.
std::vector<std::vector<Index>> connected_parts(std::span<const SeamEdge> edges,
                                                const Ways& at_node,
                                                const std::vector<std::uint8_t>& chosen) {
  std::vector<std::uint8_t> left = chosen;
  std::vector<std::vector<Index>> parts;
  for (Index start = 0; start < edges.size(); ++start) {
    if (!left[start]) continue;
    left[start] = 0;
    std::vector<Index> part{start};
    for (std::size_t next = 0; next < part.size(); ++next) {
      for (const Index node : edges[part[next]].nodes) {
        for (const Way& way : at_node.of(node)) {
          if (!left[way.edge]) continue;
          left[way.edge] = 0;
          part.push_back(way.edge);
        }
      }
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

/// The triangles on one side of a set of edges (1), if the set is the border between two sides.
std::optional<std::vector<std::uint8_t>> one_side(const Ways& at_triangle,
                                                  const std::vector<std::uint8_t>& border) {
  constexpr std::uint8_t kUnknown = 2;
  const std::size_t count = at_triangle.size();
  std::vector<std::uint8_t> side(count, kUnknown);
  std::vector<Index> queue;
  for (Index start = 0; start < count; ++start) {
    if (side[start] != kUnknown) continue;
    side[start] = 0;
    queue.assign(1, start);
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const Index t = queue[next];
      for (const Way& way : at_triangle.of(t)) {
        const std::uint8_t wanted = side[t] ^ border[way.edge];
        if (side[way.to] == kUnknown) {
          side[way.to] = wanted;
          queue.push_back(way.to);
        } else if (side[way.to] != wanted) {
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
void turn_inside(std::size_t edge_count, const Ways& at_triangle, Parts parts,
                 std::vector<std::uint8_t>& turned) {
  if (parts.empty()) return;
  std::vector<std::uint8_t> border(edge_count);
  for (const std::vector<Index>& part : parts) {
    for (const Index e : part) border[e] = 1;
  }
  if (const auto side = one_side(at_triangle, border)) {
    for (std::size_t t = 0; t < turned.size(); ++t) turned[t] ^= (*side)[t];
  } else if (parts.size() > 1) {
    turn_inside(edge_count, at_triangle, parts.first(parts.size() / 2), turned);
    turn_inside(edge_count, at_triangle, parts.subspan(parts.size() / 2), turned);
  }
}

}  // namespace

std::vector<std::uint8_t> shortening_turns(std::span<const SeamEdge> edges, std::size_t node_count,
                                           std::size_t triangle_count, const Progress& progress) {
  std::vector<std::uint8_t> turned(triangle_count);
  if (ranges::none_of(edges, &SeamEdge::in_seam)) return turned;
  const Ways at_node = ways_between(edges, node_count, nodes_of);
  std::vector<std::vector<Index>> parts =
      connected_parts(edges, at_node, difference_to_paths(edges, at_node, progress.part(0.2, 0.7)));
  progress.report(0.8);
  std::erase_if(parts, [&](const std::vector<Index>& part) {
    const auto in_seam = ranges::count_if(part, [&](Index e) { return edges[e].in_seam; });
    return 2 * static_cast<std::size_t>(in_seam) <= part.size();
  });
  if (!parts.empty()) {
    const Ways at_triangle = ways_between(edges, triangle_count, triangles_of);
    progress.report(0.9);
    turn_inside(edges.size(), at_triangle, parts, turned);
  }
  return turned;
}

}  // namespace brindle
