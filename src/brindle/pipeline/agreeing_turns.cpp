#include "brindle/pipeline/agreeing_turns.h"

#include <algorithm>
#include <memory>

#include "brindle/base/standard.h"
#include "brindle/solver.h"

namespace brindle {
namespace {

/// Tie-breaking anchor of a triangle: summed over a component, far below one seam edge.
constexpr float kAsItStands = 1e-7f;

/// Sets of connected triangles that are flipped together.
struct Blocks {
  std::vector<Index> of_triangle;
  std::vector<std::uint8_t> turned;  ///< by triangle: 1 if reversed relative to its block
  Index count = 0;
};

/// Grows blocks of at most `most` triangles breadth first. Each triangle is flipped to agree with
/// the one it was reached from. Triangles marked in `alone` form blocks of their own.
Blocks grow_blocks(const CompressedRows<TriangleLink>& links, std::size_t most,
                   std::span<const std::uint8_t> alone = {}) {
  constexpr Index kInNoBlock = ~Index{0};
  Blocks blocks{std::vector<Index>(links.size(), kInNoBlock),
                std::vector<std::uint8_t>(links.size()), 0};
  const auto is_alone = [&](Index t) { return !alone.empty() && alone[t] != 0; };
  std::vector<Index> members;
  for (Index start = 0; start < links.size(); ++start) {
    if (blocks.of_triangle[start] != kInNoBlock) continue;
    blocks.of_triangle[start] = blocks.count++;
    if (is_alone(start)) continue;
    members.assign(1, start);
    for (std::size_t next = 0; next < members.size() && members.size() < most; ++next) {
      const Index from = members[next];
      for (const auto& [to, coupling] : links.of(from)) {
        if (coupling == 0 || blocks.of_triangle[to] != kInNoBlock || is_alone(to)) continue;
        if (members.size() == most) break;
        blocks.of_triangle[to] = blocks.of_triangle[start];
        blocks.turned[to] = blocks.turned[from] ^ (coupling < 0 ? 1 : 0);
        members.push_back(to);
      }
    }
  }
  return blocks;
}

/// Triangles within `steps` links of an edge whose sides disagree after flipping `turned`.
std::vector<std::uint8_t> near_seams(const CompressedRows<TriangleLink>& links,
                                     std::span<const std::uint8_t> turned, int steps) {
  std::vector<std::uint8_t> near(links.size());
  std::vector<Index> reached;
  for (Index t = 0; t < links.size(); ++t) {
    near[t] = ranges::any_of(links.of(t), [&](const TriangleLink& link) {
      return turned[t] == turned[link.neighbor] ? link.coupling < 0 : link.coupling > 0;
    });
    if (near[t]) reached.push_back(t);
  }
  std::size_t next = 0;
  for (int step = 0; step < steps; ++step) {
    for (const std::size_t end = reached.size(); next < end; ++next) {
      for (const TriangleLink& link : links.of(reached[next])) {
        if (near[link.neighbor]) continue;
        near[link.neighbor] = 1;
        reached.push_back(link.neighbor);
      }
    }
  }
  return near;
}

/// Links between different blocks, in the rows of both.
CompressedRows<TriangleLink> links_between(const Blocks& blocks,
                                           const CompressedRows<TriangleLink>& links) {
  return compressed_rows<TriangleLink>(blocks.count, [&](const auto& add) {
    for (Index t = 0; t < links.size(); ++t) {
      for (const TriangleLink& link : links.of(t)) {
        const Index from = blocks.of_triangle[t], to = blocks.of_triangle[link.neighbor];
        if (from == to) continue;
        const bool alike = blocks.turned[t] == blocks.turned[link.neighbor];
        add(from, {to, alike ? link.coupling : -link.coupling});
      }
    }
  });
}

/// The graph of blocks. Phases stay on the imaginary axis, where the solver starts: +i keeps a
/// block, -i flips it.
PhaseGraph block_graph(const Blocks& blocks, CompressedRows<TriangleLink> links) {
  PhaseGraph graph;
  auto adjacency = std::make_shared<Adjacency>();
  adjacency->offsets.assign(blocks.count + 1, 0);
  for (Index b = 0; b < blocks.count; ++b) {
    const std::span<TriangleLink> row = links.of(b);
    ranges::sort(row, {}, &TriangleLink::neighbor);
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0 && row[i].neighbor == row[i - 1].neighbor) {
        graph.coupling.back() += row[i].coupling;
      } else {
        adjacency->neighbors.push_back(row[i].neighbor);
        graph.coupling.emplace_back(row[i].coupling);
      }
    }
    adjacency->offsets[b + 1] = static_cast<Index>(adjacency->neighbors.size());
  }
  graph.reflecting.assign(graph.coupling.size(), 0);
  graph.anchor.assign(blocks.count, Complex(0));
  for (std::size_t t = 0; t < blocks.turned.size(); ++t) {
    graph.anchor[blocks.of_triangle[t]] +=
        Complex(0, blocks.turned[t] ? -kAsItStands : kAsItStands);
  }
  graph.adjacency = std::move(adjacency);
  return graph;
}

/// Triangles to flip (1) so that blocks agree as well as possible.
std::vector<std::uint8_t> turns_of_blocks(const Blocks& blocks,
                                          const CompressedRows<TriangleLink>& links,
                                          const Progress& progress) {
  SolverOptions options;
  options.sweeps = 4;
  options.cycles = 4;
  const PhaseGraph graph = block_graph(blocks, links_between(blocks, links));
  progress.report(0.1);
  const PhaseSolution solution = solve_phases(graph, options, progress.part(0.1, 1));
  std::vector<std::uint8_t> turned = blocks.turned;
  for (std::size_t t = 0; t < turned.size(); ++t) {
    if (solution.z[blocks.of_triangle[t]].imag() < 0) turned[t] ^= 1;
  }
  return turned;
}

}  // namespace

std::vector<std::uint8_t> agreeing_turns(const CompressedRows<TriangleLink>& links,
                                         const Progress& progress) {
  constexpr std::size_t kFew = 100'000;
  constexpr int kStepsAround = 32;
  const std::size_t most = std::max<std::size_t>(1, (links.size() + kFew - 1) / kFew);
  std::vector<std::uint8_t> turned =
      turns_of_blocks(grow_blocks(links, most), links, progress.part(0, most > 1 ? 0.5 : 1));
  if (most == 1) return turned;
  const std::vector<std::uint8_t> near = near_seams(links, turned, kStepsAround);
  return turns_of_blocks(grow_blocks(links, links.size(), near), links, progress.part(0.5, 1));
}

}  // namespace brindle
