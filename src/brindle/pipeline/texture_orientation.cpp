#include "brindle/pipeline/texture_orientation.h"

#include <algorithm>
#include <bit>
#include <memory>
#include <utility>
#include <vector>

#include "brindle/base/compressed_rows.h"
#include "brindle/base/graph.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/pipeline/short_seam.h"
#include "brindle/solver.h"

namespace brindle {
namespace {

constexpr EdgeAgreement kUAlike = 1;
constexpr EdgeAgreement kVAlike = 2;
constexpr EdgeAgreement kNoAgreement = 4;  ///< a triangle without orientation

/// Agreement of two neighbouring triangles. 1: their waves point the same way; -1: one has to be
/// flipped; 0: flipping does not help.
struct TriangleLink {
  Index neighbor;
  float coupling;
};

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

/// Triangles to flip (1) so that as many neighbours as possible agree. `links` stores each link in
/// the rows of both triangles. Large meshes are solved in blocks first, then triangle by triangle
/// around the remaining seams. Throws Cancelled if `progress` asks for it.
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

/// A seam is recomputed when it exceeds its shortest length by this factor plus a few edges.
constexpr double kTooLong = 1.2;
constexpr std::size_t kFewEdges = 16;

constexpr CornerSigns kSignsOfU = 7;

bool is_unoriented(CornerSigns signs) { return (signs & kUnoriented) != 0; }

CompressedRows<Index> edges_by_triangle(std::size_t triangles, std::span<const SharedEdge> edges) {
  return compressed_rows<Index>(triangles, [&](const auto& add) {
    for (Index e = 0; e < edges.size(); ++e) {
      for (const Index corner : edges[e].from) add(corner / 3, e);
    }
  });
}

/// Links between triangles that have an orientation, in the rows of both.
CompressedRows<TriangleLink> links_of(std::size_t triangle_count, std::span<const SharedEdge> edges,
                                      std::span<const EdgeAgreement> agreement) {
  return compressed_rows<TriangleLink>(triangle_count, [&](const auto& add) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const Index a = edges[e].from[0] / 3, b = edges[e].from[1] / 3;
      if (a == b || agreement[e] == kNoAgreement) continue;
      const float u = agreement[e] & kUAlike ? 1.0f : -1.0f;
      const float v = agreement[e] & kVAlike ? 1.0f : -1.0f;
      add(a, {b, 0.5f * (u + v)});
      add(b, {a, 0.5f * (u + v)});
    }
  });
}

/// The seam node of every vertex. A seam costs nothing along the boundary and around triangles
/// without orientation, so their vertices share a node.
std::vector<Index> seam_nodes(std::span<const Triangle> triangles,
                              std::span<const CornerSigns> signs,
                              std::span<const SharedEdge> edges) {
  Index count = 0;
  for (const Triangle& t : triangles) count = std::max({count, t[0] + 1, t[1] + 1, t[2] + 1});
  std::vector<std::uint8_t> shared(3 * triangles.size());
  for (const SharedEdge& edge : edges) {
    for (int i = 0; i < 2; ++i) {
      const Index t = edge.from[i] / 3;
      const Index c = edge.from[i] % 3;
      shared[edge.to[i] % 3 == (c + 1) % 3 ? 3 * t + c : edge.to[i]] = 1;
    }
  }
  MergedSets sets(count);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (!is_unoriented(signs[t]) && shared[3 * t + c]) continue;
      sets.merge(triangles[t][c], triangles[t][(c + 1) % 3]);
    }
  }
  std::vector<Index> nodes(count);
  for (Index v = 0; v < count; ++v) nodes[v] = sets.of(v);
  return nodes;
}

/// The edges between triangles with orientation.
std::vector<SeamEdge> seam_edges(std::span<const Triangle> triangles,
                                 std::span<const SharedEdge> edges,
                                 std::span<const EdgeAgreement> agreement,
                                 const std::vector<Index>& nodes) {
  const auto node_at = [&](Index corner) { return nodes[triangles[corner / 3][corner % 3]]; };
  std::vector<SeamEdge> result;
  result.reserve(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (agreement[e] == kNoAgreement) continue;
    const SharedEdge& edge = edges[e];
    result.push_back({{node_at(edge.from[0]), node_at(edge.to[0])},
                      {edge.from[0] / 3, edge.from[1] / 3},
                      agreement[e] == 0});
  }
  return result;
}

/// Agreement of all shared edges, from the corner signs.
void agreements(std::span<const CornerSigns> signs, std::span<const SharedEdge> edges,
                std::vector<EdgeAgreement>& result) {
  result.resize(edges.size());
  parallel_for(edges.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const auto [a, b] = edges[e].from;
      const CornerSigns of_a = signs[a / 3], of_b = signs[b / 3];
      const bool u = turns_u(of_a, a % 3) == turns_u(of_b, b % 3);
      const bool v = turns_v(of_a, a % 3) == turns_v(of_b, b % 3);
      const int alike = (u ? kUAlike : 0) | (v ? kVAlike : 0);
      result[e] = static_cast<EdgeAgreement>(
          is_unoriented(of_a) || is_unoriented(of_b) ? kNoAgreement : alike);
    }
  });
}

/// Counts the seams; skips edges of triangles without orientation.
TextureSeams texture_seams(std::span<const CornerSigns> signs,
                           std::span<const EdgeAgreement> agreement) {
  TextureSeams seams;
  for (const CornerSigns of_triangle : signs) {
    seams.unoriented_triangles += is_unoriented(of_triangle);
  }
  for (const EdgeAgreement alike : agreement) {
    seams.turned += alike == 0;
    seams.mirrored += alike == kUAlike || alike == kVAlike;
  }
  return seams;
}

/// Flips that shorten the seam of these signs and their agreement.
std::vector<std::uint8_t> seam_turns(std::span<const Triangle> triangles,
                                     std::span<const CornerSigns> signs,
                                     std::span<const SharedEdge> edges,
                                     std::span<const EdgeAgreement> agreement,
                                     const Progress& progress = {}) {
  progress.report(0);
  const std::vector<Index> nodes = seam_nodes(triangles, signs, edges);
  progress.report(0.3);
  const std::vector<SeamEdge> between = seam_edges(triangles, edges, agreement, nodes);
  progress.report(0.4);
  return shortening_turns(between, nodes.size(), triangles.size(), progress.part(0.4, 1));
}

/// Triangles to flip (1; U and V together) for a short seam; the seam is empty if the field is
/// orientable. Triangles are nodes of a phase graph with phases +i (keep) and -i (flip) whose
/// energy counts seam edges. The multilevel solver's seam is then replaced by shortest paths
/// (`shortening_turns`). Of two opposite solutions, each connected component takes the one that
/// keeps most triangles. `edges` are shared by `triangles`.
std::vector<std::uint8_t> orienting_turns(std::span<const Triangle> triangles,
                                          std::vector<CornerSigns> signs,
                                          std::span<const SharedEdge> edges,
                                          std::vector<EdgeAgreement> agreement,
                                          const Progress& progress) {
  JobStages stages(progress, {{"orientation", 4}, {"seams", 2}});
  std::vector<std::uint8_t> turned =
      agreeing_turns(links_of(triangles.size(), edges, agreement), stages.begin("orientation"));
  const Progress shortening = stages.begin("seams");
  turn_signs(turned, signs);
  agreements(signs, edges, agreement);
  shortening.report(0.1);
  const auto shorter = seam_turns(triangles, signs, edges, agreement, shortening.part(0.1, 1));
  for (std::size_t t = 0; t < turned.size(); ++t) turned[t] ^= shorter[t];
  return turned;
}

}  // namespace

TextureOrientation::TextureOrientation(std::span<const Triangle> triangles)
    : triangles_(triangles),
      edges_(shared_edges(triangles)),
      turned_(triangles.size()),
      shown_(triangles.size()) {}

void TextureOrientation::archive(Archive& archive, std::size_t vertices) {
  archive.list_of_or_none(vertices, last_directions_);
  archive.list_of_or_none(triangles_.size(), signs_);
  archive.list_of(triangles_.size(), shown_);
  std::array<std::uint64_t, 4> counts = {seams_.turned, seams_.mirrored,
                                         seams_.unoriented_triangles, shortest_};
  archive(counts);
  const auto to_size = [&](std::size_t n) { return static_cast<std::size_t>(counts[n]); };
  seams_ = {to_size(0), to_size(1), to_size(2)};
  shortest_ = to_size(3);
  if (!last_directions_.empty() && signs_.size() != triangles_.size()) Archive::fail();
}

FrameOrientation TextureOrientation::follow(std::span<const Vec3> u, std::span<const Vec3> v,
                                            bool as_given, const Progress& progress) {
  last_shown_ = shown_;
  const TextureSeams last_seams = seams_;
  const std::size_t last_shortest = shortest_;
  std::swap(signs_, last_signs_);
  try {
    corner_signs(triangles_, u, v, signs_);
    const FrameOrientation orientation = orient(u, as_given, progress);
    last_directions_.assign(u.begin(), u.end());
    return orientation;
  } catch (...) {
    std::swap(signs_, last_signs_);
    std::swap(shown_, last_shown_);
    seams_ = last_seams;
    shortest_ = last_shortest;
    throw;
  }
}

FrameOrientation TextureOrientation::orient(std::span<const Vec3> u, bool as_given,
                                            const Progress& progress) {
  const bool is_first = last_directions_.empty();
  flipped_.resize(u.size());
  if (!is_first) {
    const auto turns_round = [](const Vec3& a, const Vec3& b) -> std::uint8_t {
      return a.dot(b) < 0;
    };
    ranges::transform(u, last_directions_, flipped_.begin(), turns_round);
    const bool flips = !as_given && ranges::count(flipped_, 0) != std::ssize(flipped_);
    if (!flips && signs_ == last_signs_) return FrameOrientation::kept;
  }
  agreements(signs_, edges_, agreement_);
  FrameOrientation result = FrameOrientation::afresh;
  if (as_given) {
    ranges::fill(turned_, std::uint8_t{0});
    if (!is_first) result = FrameOrientation::continued;
  } else if (is_first) {
    turned_ = orienting_turns(triangles_, signs_, edges_, agreement_, progress);
  } else {
    result = FrameOrientation::continued;
    follow_neighbors(continue_last());
  }
  show();
  if (result == FrameOrientation::continued && !as_given && shorten()) {
    result = FrameOrientation::shortened;
  }
  return result;
}

/// Keeps the orientation of all triangles that had one. Returns those that have one only now.
std::vector<Index> TextureOrientation::continue_last() {
  parallel_for(triangles_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      unsigned ran = shown_[t];
      for (unsigned m = 0; m < 3; ++m) ran ^= unsigned{flipped_[triangles_[t][m]]} << m;
      turned_[t] = std::popcount((ran ^ signs_[t]) & kSignsOfU) >= 2;
    }
  });
  std::vector<Index> undecided;
  for (Index t = 0; t < triangles_.size(); ++t) {
    if (is_unoriented(signs_[t])) {
      turned_[t] = 0;
    } else if (is_unoriented(last_signs_[t])) {
      undecided.push_back(t);
    }
  }
  return undecided;
}

/// Orients triangles like the majority of their decided neighbours, working outwards.
void TextureOrientation::follow_neighbors(std::vector<Index> undecided) {
  if (undecided.empty()) return;
  if (edges_of_.size() == 0) edges_of_ = edges_by_triangle(triangles_.size(), edges_);
  std::vector<std::uint8_t> decided(signs_.size());
  ranges::transform(signs_, decided.begin(), [](CornerSigns s) { return !is_unoriented(s); });
  for (const Index t : undecided) decided[t] = 0;
  while (!undecided.empty()) {
    std::vector<Index> left;
    for (const Index t : undecided) {
      if (follow_neighbors_of(t, decided)) {
        decided[t] = 1;
      } else {
        left.push_back(t);
      }
    }
    if (left.size() == undecided.size()) {  // a component without orientation so far: keep
      turned_[left[0]] = 0;
      decided[left[0]] = 1;
      left.erase(left.begin());
    }
    undecided = std::move(left);
  }
}

bool TextureOrientation::follow_neighbors_of(Index triangle,
                                             std::span<const std::uint8_t> decided) {
  int votes = 0;
  bool asked = false;
  for (const Index e : edges_of_.of(triangle)) {
    const EdgeAgreement alike = agreement_[e];
    const auto& [a, b] = edges_[e].from;
    const Index neighbor = a / 3 == triangle ? b / 3 : a / 3;
    if (alike == kNoAgreement || !decided[neighbor]) continue;
    asked = true;
    const int both = (alike & kUAlike ? 1 : -1) + (alike & kVAlike ? 1 : -1);
    votes += turned_[neighbor] ? -both : both;
  }
  turned_[triangle] = votes < 0;
  return asked;
}

/// Recomputes the seam if it has grown too long. Returns whether it did.
bool TextureOrientation::shorten() {
  shortest_ = std::min(shortest_, seams_.turned);
  const auto allowed = static_cast<std::size_t>(kTooLong * static_cast<double>(shortest_));
  if (seams_.turned <= allowed + kFewEdges) return false;
  const auto turns = seam_turns(triangles_, shown_, edges_, agreement_);
  for (std::size_t t = 0; t < turned_.size(); ++t) turned_[t] ^= turns[t];
  show();
  shortest_ = seams_.turned;
  return true;
}

/// Updates everything that depends on signs and flips.
void TextureOrientation::show() {
  shown_ = signs_;
  turn_signs(turned_, shown_);
  agreements(shown_, edges_, agreement_);
  seams_ = texture_seams(shown_, agreement_);
  if (last_directions_.empty()) shortest_ = seams_.turned;
}

}  // namespace brindle
