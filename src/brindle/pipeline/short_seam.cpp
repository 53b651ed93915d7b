#include "brindle/pipeline/short_seam.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "brindle/base/compressed_rows.h"
#include "brindle/base/graph.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"

namespace brindle {
namespace {

constexpr Index kNone = std::numeric_limits<Index>::max();

/// Half-edge of a graph: an edge of a node, and the node at its other end.
struct Way {
  Index edge;
  Index to;
};

/// Half-edges by node.
using Ways = CompressedRows<Way>;

/// Builds the graph; `ends(e)` are the two nodes of edge e.
template <class Ends>
Ways ways_between(std::size_t edge_count, std::size_t items, const Ends& ends) {
  return compressed_rows<Way>(items, [&](const auto& add) {
    for (Index e = 0; e < edge_count; ++e) {
      const auto [a, b] = ends(e);
      add(a, {e, b});
      add(b, {e, a});
    }
  });
}

/// Repeated breadth-first searches. The only array by node is the mark, which stays in the cache on
/// large surfaces.
class Search {
 public:
  explicit Search(const Ways& at_node) : at_node_(at_node), found_in_(at_node.size()) {}

  /// Calls `visit(node, steps)` for nodes in the order of their distance until it returns false.
  template <class Visit>
  void run(Index start, const Visit& visit) {
    ++round_;
    found_.assign(1, {start, kNone, kNone});
    found_in_[start] = round_;
    Index steps = 0;
    std::size_t ring_end = 1;  // end of the nodes that are `steps` away
    for (std::size_t next = 0; next < found_.size(); ++next) {
      if (next == ring_end) {
        ++steps;
        ring_end = found_.size();
      }
      const Index node = found_[next].node;
      if (!visit(node, steps)) return;
      for (const Way& way : at_node_.of(node)) {
        if (found_in_[way.to] == round_) continue;
        found_in_[way.to] = round_;
        found_.push_back({way.to, way.edge, static_cast<Index>(next)});
      }
    }
  }

  /// The edges of a shortest path; empty if there is none.
  std::vector<Index> path(Index from, Index to) {
    Index place = 0;
    bool found = false;
    run(from, [&](Index node, Index) {
      found = node == to;
      if (!found) ++place;
      return !found;
    });
    std::vector<Index> edges;
    for (; found && place != 0; place = found_[place].before) {
      edges.push_back(found_[place].by_edge);
    }
    return edges;
  }

 private:
  struct Found {
    Index node;
    Index by_edge;
    Index before;  ///< index in `found_` of the predecessor
  };

  const Ways& at_node_;
  std::vector<Index> found_in_;  ///< by node: last round that reached it
  std::vector<Found> found_;     ///< in this round, by distance
  Index round_ = 0;
};

/// Nodes with an odd number of seam edges.
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

/// Another end and its distance.
struct Near {
  Index end;
  Index steps;
};

/// Finds the ends near an end.
class EndSearch {
 public:
  EndSearch(const std::vector<Index>& ends, const Ways& at_node)
      : ends_(ends), at_node_(at_node), number_(at_node.size(), kNone) {
    for (Index i = 0; i < ends.size(); ++i) number_[ends[i]] = i;
    of_thread_.resize(thread_capacity());
  }

  /// For each end in `around`, finds the others within its reach, sorted by number.
  void find(std::span<const Index> around, std::span<const Index> reach,
            std::span<std::vector<Near>> near, const Progress& progress) {
    constexpr std::size_t kEndsPerReport = 16;
    parallel_for(
        around.size(), progress,
        [&](std::size_t begin, std::size_t end) {
          std::optional<Search>& own = of_thread_.at(thread_number());
          if (!own) own.emplace(at_node_);
          for (std::size_t n = begin; n < end; ++n) {
            near[around[n]] = around_one(around[n], reach[around[n]], *own);
          }
        },
        1, kEndsPerReport);
  }

 private:
  std::vector<Near> around_one(Index i, Index reach, Search& search) const {
    std::vector<Near> near;
    search.run(ends_[i], [&](Index node, Index steps) {
      if (steps > reach) return false;
      if (number_[node] != kNone && number_[node] != i) near.push_back({number_[node], steps});
      return true;
    });
    ranges::sort(near, {}, &Near::end);
    return near;
  }

  const std::vector<Index>& ends_;
  const Ways& at_node_;
  std::vector<Index> number_;  ///< by node: number of its end
  std::vector<std::optional<Search>> of_thread_;
};

/// Pairs ends with a small sum of distances: greedily, nearest first, then by swapping partners
/// while that shortens two pairs. A swap can only help if two ends are closer than both pair
/// distances together. So each end needs the others within less than twice its own pair distance.
class Matching {
 public:
  Matching(const std::vector<Index>& ends, const Ways& at_node, const Progress& progress)
      : ends_(ends),
        partner_(ends.size(), kNone),
        way_(ends.size()),
        reach_(ends.size()),
        near_(ends.size()),
        search_(ends, at_node) {
    pair_near_ones_first(static_cast<Index>(at_node.size()), progress.part(0, 0.6));
    do {
      look_around(progress.part(0.6, 1));
    } while (swap_partners());
  }

  /// Pairs of nodes. An end that reaches no other stays unpaired.
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

  void join(Index i, Index j, Index steps) {
    partner_[i] = j;
    partner_[j] = i;
    way_[i] = way_[j] = steps;
  }

  /// Pairs ends greedily, doubling the search radius of those that are left.
  void pair_near_ones_first(Index nodes, const Progress& progress) {
    constexpr Index kFirstReach = 8;
    std::vector<Index> alone(ends_.size());
    std::iota(alone.begin(), alone.end(), Index{0});
    const auto count = static_cast<double>(ends_.size());
    for (Index reach = kFirstReach; !alone.empty() && reach / 2 < nodes; reach *= 2) {
      for (const Index i : alone) reach_[i] = reach;
      search_.find(alone, reach_, near_,
                   progress.part(1 - static_cast<double>(alone.size()) / count, 1));
      join_nearest(alone);
      std::erase_if(alone, [&](Index i) { return partner_[i] != kNone; });
    }
  }

  void join_nearest(std::span<const Index> alone) {
    std::vector<std::array<Index, 3>> candidates;
    for (const Index i : alone) {
      for (const auto& [j, steps] : near_[i]) candidates.push_back({steps, i, j});
    }
    ranges::sort(candidates.begin(), candidates.end());
    for (const auto& [steps, i, j] : candidates) {
      if (partner_[i] == kNone && partner_[j] == kNone) join(i, j, steps);
    }
  }

  void look_around(const Progress& progress) {
    std::vector<Index> shortsighted;
    for (Index i = 0; i < ends_.size(); ++i) {
      if (partner_[i] == kNone || reach_[i] + 1 >= 2 * way_[i]) continue;
      reach_[i] = 2 * way_[i] - 1;
      shortsighted.push_back(i);
    }
    search_.find(shortsighted, reach_, near_, progress);
  }

  /// Swaps the partners of two pairs where that shortens their sum.
  bool swap_partners() {
    bool swapped = false;
    for (Index i = 0; i < near_.size(); ++i) {
      for (const auto& [j, steps] : near_[i]) {
        const Index k = partner_[i], l = partner_[j];
        if (k == kNone || l == kNone || k == j) continue;
        const auto between_others = distance(k, l);
        if (!between_others || steps + *between_others >= way_[i] + way_[j]) continue;
        join(i, j, steps);
        join(k, l, *between_others);
        swapped = true;
      }
    }
    return swapped;
  }

  const std::vector<Index>& ends_;
  std::vector<Index> partner_;
  std::vector<Index> way_;    ///< steps to the partner
  std::vector<Index> reach_;  ///< radius within which all other ends are known
  std::vector<std::vector<Near>> near_;
  EndSearch search_;
};

/// 1 for edges in exactly one of the old seam and the new paths.
std::vector<std::uint8_t> difference_to_paths(std::span<const SeamEdge> edges, const Ways& at_node,
                                              const Progress& progress) {
  std::vector<std::uint8_t> difference(edges.size());
  ranges::transform(edges, difference.begin(),
                    [](const SeamEdge& edge) { return edge.in_seam ? 1 : 0; });
  const std::vector<Index> ends = ends_of(edges, at_node.size());
  Search search(at_node);
  const auto pairs = Matching(ends, at_node, progress.part(0, 0.7)).pairs();
  const Progress joining = progress.part(0.7, 1);
  constexpr std::size_t kPathsPerReport = 1;  // a path may be as long as the surface
  reported_for(
      pairs.size(), joining,
      [&](std::size_t i) {
        for (const Index e : search.path(pairs[i].first, pairs[i].second)) difference[e] ^= 1;
      },
      kPathsPerReport);
  return difference;
}

/// Connected parts of a set of edges. A part without unpaired seam ends has an even number of edges
/// at each node.
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

/// Triangles connected without crossing an edge of a part form one region. Any set of parts
/// encloses whole regions. Short seams have few regions.
struct Regions {
  std::vector<Index> of_triangle;           ///< numbered by first triangle
  std::vector<std::array<Index, 2>> sides;  ///< for every edge of a part, the regions on both sides
  Index count = 0;
};

/// Renumbers the edges of the parts by their index in `Regions::sides`.
Regions regions_between(std::span<const SeamEdge> edges, std::size_t triangle_count,
                        std::vector<std::vector<Index>>& parts) {
  std::vector<std::uint8_t> in_part(edges.size());
  for (const std::vector<Index>& part : parts) {
    for (const Index e : part) in_part[e] = 1;
  }
  MergedSets sets(triangle_count);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!in_part[e]) sets.merge(edges[e].triangles[0], edges[e].triangles[1]);
  }
  Regions regions;
  regions.of_triangle.resize(triangle_count);
  for (Index t = 0; t < triangle_count; ++t) {
    const Index first = sets.of(t);
    regions.of_triangle[t] = first == t ? regions.count++ : regions.of_triangle[first];
  }
  for (std::vector<Index>& part : parts) {
    for (Index& e : part) {
      const auto [a, b] = edges[e].triangles;
      regions.sides.push_back({regions.of_triangle[a], regions.of_triangle[b]});
      e = static_cast<Index>(regions.sides.size() - 1);
    }
  }
  return regions;
}

/// The regions on one side (1), if the edges bound a set of regions.
std::optional<std::vector<std::uint8_t>> one_side(const Ways& at_region,
                                                  const std::vector<std::uint8_t>& border) {
  constexpr std::uint8_t kUnknown = 2;
  const std::size_t count = at_region.size();
  std::vector<std::uint8_t> side(count, kUnknown);
  std::vector<Index> queue;
  for (Index start = 0; start < count; ++start) {
    if (side[start] != kUnknown) continue;
    side[start] = 0;
    queue.assign(1, start);
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const Index region = queue[next];
      for (const Way& way : at_region.of(region)) {
        const std::uint8_t wanted = side[region] ^ border[way.edge];
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

/// Flips the regions that the parts enclose: all parts at once, or by bisection down to single
/// parts. Some parts may enclose nothing.
void turn_inside(std::size_t edge_count, const Ways& at_region, Parts parts,
                 std::vector<std::uint8_t>& turned) {
  if (parts.empty()) return;
  std::vector<std::uint8_t> border(edge_count);
  for (const std::vector<Index>& part : parts) {
    for (const Index e : part) border[e] = 1;
  }
  if (const auto side = one_side(at_region, border)) {
    for (std::size_t region = 0; region < turned.size(); ++region) {
      turned[region] ^= (*side)[region];
    }
  } else if (parts.size() > 1) {
    turn_inside(edge_count, at_region, parts.first(parts.size() / 2), turned);
    turn_inside(edge_count, at_region, parts.subspan(parts.size() / 2), turned);
  }
}

/// The triangles that the parts enclose (1).
std::vector<std::uint8_t> surrounded_by(std::vector<std::vector<Index>> parts,
                                        std::span<const SeamEdge> edges,
                                        std::size_t triangle_count) {
  const Regions regions = regions_between(edges, triangle_count, parts);
  const Ways at_region =
      ways_between(regions.sides.size(), regions.count, [&](Index e) { return regions.sides[e]; });
  std::vector<std::uint8_t> of_region(regions.count);
  turn_inside(regions.sides.size(), at_region, parts, of_region);
  std::vector<std::uint8_t> turned(triangle_count);
  for (std::size_t t = 0; t < triangle_count; ++t) turned[t] = of_region[regions.of_triangle[t]];
  return turned;
}

}  // namespace

std::vector<std::uint8_t> shortening_turns(std::span<const SeamEdge> edges, std::size_t node_count,
                                           std::size_t triangle_count, const Progress& progress) {
  if (ranges::none_of(edges, &SeamEdge::in_seam)) return std::vector<std::uint8_t>(triangle_count);
  const Ways at_node =
      ways_between(edges.size(), node_count, [&](Index e) { return edges[e].nodes; });
  progress.report(0.2);
  std::vector<std::vector<Index>> parts =
      connected_parts(edges, at_node, difference_to_paths(edges, at_node, progress.part(0.2, 0.8)));
  progress.report(0.8);
  std::erase_if(parts, [&](const std::vector<Index>& part) {
    const auto in_seam = ranges::count_if(part, [&](Index e) { return edges[e].in_seam; });
    return 2 * static_cast<std::size_t>(in_seam) <= part.size();
  });
  if (parts.empty()) return std::vector<std::uint8_t>(triangle_count);
  return surrounded_by(std::move(parts), edges, triangle_count);
}

}  // namespace brindle
