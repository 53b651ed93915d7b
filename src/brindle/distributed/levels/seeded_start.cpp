#include "brindle/distributed/levels/seeded_start.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

#include "brindle/base/random.h"

namespace brindle {
namespace {

/// Nodes in a cell, on average: at least so many, and so many that there are no more cells than
/// this.
constexpr std::size_t kSmallestCell = 16;
constexpr std::size_t kMostCells = 16384;

/// Seeds are few, and whatever is left to smooth in their graph all ranks would smooth in other
/// ways.
constexpr int kSeedCycles = 20;

constexpr std::uint64_t kNoSeed = std::numeric_limits<std::uint64_t>::max();

/// Numbers that follow each other are neighbours on many surfaces; seeds must not be.
std::uint64_t scattered(std::uint64_t id) { return mixed_bits(id); }

/// A number, or its conjugate, times a factor: z_node = factor z_seed or factor conj(z_seed).
struct Led {
  std::uint64_t seed = kNoSeed;
  Complex factor = 1;
  std::uint32_t reflects = 0;
};

Complex led(const Led& way, const Complex& z) {
  return way.factor * (way.reflects != 0 ? std::conj(z) : z);
}

/// The way to a node over an edge from a neighbour, whose way is known.
Led over_edge(const Led& neighbor, const Complex& coupling, bool reflecting) {
  const float length = std::abs(coupling);
  if (length == 0) return {neighbor.seed, neighbor.factor, neighbor.reflects};
  const Complex turn = coupling / length;
  if (!reflecting) return {neighbor.seed, turn * neighbor.factor, neighbor.reflects};
  return {neighbor.seed, turn * std::conj(neighbor.factor), 1 - neighbor.reflects};
}

/// Leads all nodes to seeds, round by round on all ranks: what a node becomes follows from what its
/// neighbours were before the round, whichever ranks have them.
class SeedWays {
 public:
  SeedWays(Communicator& ranks, const RankGraph& graph, const PhaseGraph& couplings,
           std::span<const std::uint64_t> ids)
      : ranks_(ranks), graph_(graph), couplings_(couplings), ids_(ids.begin(), ids.end()) {
    ids_.resize(graph.node_count());
    exchange(ranks, graph.halo, std::span(ids_));
    ways_.resize(graph.node_count());
  }

  std::vector<Led> find(std::size_t nodes_of_all) {
    const std::size_t cell = std::max(kSmallestCell, nodes_of_all / kMostCells + 1);
    for (Index v = 0; v < graph_.own; ++v) {
      if (scattered(ids_[v]) % cell == 0) ways_[v].seed = ids_[v];
    }
    do {
      exchange(ranks_, graph_.halo, std::span(ways_));
      while (ranks_.any(spread())) exchange(ranks_, graph_.halo, std::span(ways_));
    } while (ranks_.any(add_seeds()));
    return std::move(ways_);
  }

 private:
  /// Returns whether a node has found its way.
  bool spread() {
    std::vector<std::pair<Index, Led>> found;
    for (Index v = 0; v < graph_.own; ++v) {
      if (ways_[v].seed != kNoSeed) continue;
      const Index best = best_edge(v);
      if (best == kNone) continue;
      found.emplace_back(v, over_edge(ways_[graph_.adjacency->neighbors[best]],
                                      couplings_.coupling[best], couplings_.reflecting[best] != 0));
    }
    for (const auto& [v, way] : found) ways_[v] = way;
    return !found.empty();
  }

  /// To the neighbour of the lowest seed, and of these the one with the lowest number.
  Index best_edge(Index v) const {
    const Adjacency& adjacency = *graph_.adjacency;
    Index best = kNone;
    const auto key = [&](Index edge) {
      const Index other = adjacency.neighbors[edge];
      return std::pair(ways_[other].seed, ids_[other]);
    };
    for (Index edge = adjacency.offsets[v]; edge < adjacency.offsets[v + 1]; ++edge) {
      if (key(edge).first == kNoSeed) continue;
      if (best == kNone || key(edge) < key(best)) best = edge;
    }
    return best;
  }

  /// Where parts of the graph have none: at nodes whose numbers are lower than their neighbours'.
  bool add_seeds() {
    bool added = false;
    for (Index v = 0; v < graph_.own; ++v) {
      if (ways_[v].seed != kNoSeed) continue;
      const auto is_lower = [&](Index other) { return ids_[v] < ids_[other]; };
      if (!std::ranges::all_of(graph_.adjacency->of(v), is_lower)) continue;
      ways_[v].seed = ids_[v];
      added = true;
    }
    return added;
  }

  static constexpr Index kNone = std::numeric_limits<Index>::max();

  Communicator& ranks_;
  const RankGraph& graph_;
  const PhaseGraph& couplings_;
  std::vector<std::uint64_t> ids_;
  std::vector<Led> ways_;  ///< of own nodes and ghosts
};

/// Sums of many small numbers that are the same in whatever order they are made.
struct ExactSum {
  std::int64_t real = 0, imag = 0;

  void add(const Complex& z) {
    real += std::llround(kScale * static_cast<double>(z.real()));
    imag += std::llround(kScale * static_cast<double>(z.imag()));
  }
  void add(const ExactSum& other) {
    real += other.real;
    imag += other.imag;
  }
  Complex value() const {
    return {static_cast<float>(static_cast<double>(real) / kScale),
            static_cast<float>(static_cast<double>(imag) / kScale)};
  }

  static constexpr double kScale = 1 << 24;
};

/// What a rank adds to an edge of the coarse graph, from the seed with the higher number to the
/// other one; of a seed's anchor if both are the same.
struct CoarseTerm {
  std::uint64_t low, high;
  std::uint64_t reflecting;
  ExactSum sum;

  auto key() const { return std::tie(low, high, reflecting); }
};

using CoarseSums = std::map<std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>, ExactSum>;

/// What draws a seed, of what draws a node of its cell.
Led pulled_back(const Led& way, const Led& target) {
  const Complex turned = std::conj(way.factor) * target.factor;
  if (way.reflects == 0) return {target.seed, turned, target.reflects};
  return {target.seed, std::conj(turned), 1 - target.reflects};
}

/// A neighbour's phase times a coupling, by the neighbour's seed; with the coupling's length.
Led drawn_by(const Led& neighbor, const Complex& coupling, bool reflecting) {
  if (!reflecting) return {neighbor.seed, coupling * neighbor.factor, neighbor.reflects};
  return {neighbor.seed, coupling * std::conj(neighbor.factor), 1 - neighbor.reflects};
}

std::vector<CoarseTerm> own_terms(const RankGraph& graph, const PhaseGraph& couplings,
                                  std::span<const Led> ways) {
  CoarseSums sums;
  const Adjacency& adjacency = *graph.adjacency;
  for (Index v = 0; v < graph.own; ++v) {
    const std::uint64_t seed = ways[v].seed;
    if (adjacency.of(v).empty()) continue;
    // So that every seed is known on rank 0, with or without anchors and neighbours.
    ExactSum& anchor = sums[{seed, seed, 0}];
    if (!couplings.anchor.empty()) {
      const Complex turned = std::conj(ways[v].factor) * couplings.anchor[v];
      anchor.add(ways[v].reflects != 0 ? std::conj(turned) : turned);
    }
    for (Index edge = adjacency.offsets[v]; edge < adjacency.offsets[v + 1]; ++edge) {
      const Led& other = ways[adjacency.neighbors[edge]];
      if (seed >= other.seed) continue;  // the other row has the same, turned round
      const Led pull = pulled_back(
          ways[v], drawn_by(other, couplings.coupling[edge], couplings.reflecting[edge] != 0));
      sums[{seed, other.seed, pull.reflects}].add(pull.factor);
    }
  }
  std::vector<CoarseTerm> terms;
  for (const auto& [key, sum] : sums) {
    terms.push_back({std::get<0>(key), std::get<1>(key), std::get<2>(key), sum});
  }
  return terms;
}

/// On rank 0: the graph of seeds, in the order of their numbers.
struct CoarseGraph {
  std::vector<std::uint64_t> seeds;
  PhaseGraph graph;
};

/// Of two seeds on a surface without sides edges may be of both sorts: the stronger sort counts.
void keep_stronger(CoarseSums& sums) {
  for (auto sum = sums.begin(); sum != sums.end();) {
    const auto next = std::next(sum);
    const auto& [low, high, reflecting] = sum->first;
    if (reflecting == 0 && next != sums.end() &&
        next->first == std::tuple(low, high, std::uint64_t{1})) {
      const bool first = std::abs(sum->second.value()) >= std::abs(next->second.value());
      sum = sums.erase(first ? next : sum);
      continue;
    }
    ++sum;
  }
}

CoarseGraph coarse_graph(const std::vector<CoarseTerm>& terms) {
  CoarseSums sums;
  for (const CoarseTerm& term : terms) sums[term.key()].add(term.sum);
  keep_stronger(sums);
  CoarseGraph coarse;
  for (const auto& [key, sum] : sums) {
    if (std::get<0>(key) == std::get<1>(key)) coarse.seeds.push_back(std::get<0>(key));
  }
  const auto number = [&](std::uint64_t seed) {
    return static_cast<std::size_t>(std::ranges::lower_bound(coarse.seeds, seed) -
                                    coarse.seeds.begin());
  };
  struct Entry {
    Index other;
    Complex coupling;
    bool reflecting;
  };
  std::vector<std::vector<Entry>> rows(coarse.seeds.size());
  coarse.graph.anchor.resize(rows.size());
  for (const auto& [key, sum] : sums) {
    const std::size_t low = number(std::get<0>(key)), high = number(std::get<1>(key));
    if (low == high) {
      coarse.graph.anchor[low] = sum.value();
      continue;
    }
    const bool reflecting = std::get<2>(key) != 0;
    const Complex coupling = sum.value();
    rows[low].push_back({static_cast<Index>(high), coupling, reflecting});
    rows[high].push_back(
        {static_cast<Index>(low), reflecting ? coupling : std::conj(coupling), reflecting});
  }
  auto adjacency = std::make_shared<Adjacency>();
  for (auto& row : rows) {
    std::ranges::sort(row, {}, &Entry::other);
    for (const Entry& entry : row) {
      adjacency->neighbors.push_back(entry.other);
      coarse.graph.coupling.push_back(entry.coupling);
      coarse.graph.reflecting.push_back(entry.reflecting ? 1 : 0);
    }
    adjacency->offsets.push_back(static_cast<Index>(adjacency->neighbors.size()));
  }
  coarse.graph.adjacency = std::move(adjacency);
  return coarse;
}

struct SeedPhase {
  std::uint64_t seed;
  Complex z;
};

/// Collective. Rank 0 solves for the seeds, all hear of their phases.
std::vector<SeedPhase> seed_phases(Communicator& ranks, const std::vector<CoarseTerm>& own,
                                   Starts starts, int sweeps, int cycles, bool& is_lower) {
  const auto terms = joined<CoarseTerm>(ranks.gather(std::as_bytes(std::span(own))));
  std::vector<SeedPhase> phases;
  ranks.together([&] {
    if (ranks.rank() != 0) return;
    const CoarseGraph coarse = coarse_graph(terms);
    const LowestPhases solved =
        solve_from(starts, coarse.graph, sweeps, std::max(cycles, kSeedCycles));
    is_lower = solved.is_lower;
    for (std::size_t s = 0; s < coarse.seeds.size(); ++s) {
      phases.push_back({coarse.seeds[s], solved.z[s]});
    }
  });
  return ranks.of_first(phases);
}

}  // namespace

LowestPhases seeded_start(Communicator& ranks, const RankGraph& graph, const PhaseGraph& couplings,
                          std::span<const std::uint64_t> ids, Starts starts, int sweeps,
                          int cycles) {
  const std::size_t nodes = ranks.sum(std::size_t{graph.own});
  const std::vector<Led> ways = SeedWays(ranks, graph, couplings, ids).find(nodes);
  LowestPhases start;
  const std::vector<SeedPhase> phases =
      seed_phases(ranks, own_terms(graph, couplings, ways), starts, sweeps, cycles, start.is_lower);
  start.is_lower = ranks.any(start.is_lower);
  for (const Led& way : ways) {
    const auto found = std::ranges::lower_bound(phases, way.seed, {}, &SeedPhase::seed);
    const bool is_known = found != phases.end() && found->seed == way.seed;
    const Complex z = led(way, is_known ? found->z : Complex(1));
    const float length = std::abs(z);
    start.z.push_back(length > 0 ? z / length : Complex(1));
  }
  return start;
}

}  // namespace brindle
