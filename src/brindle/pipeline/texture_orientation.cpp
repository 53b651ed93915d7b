#include "brindle/pipeline/texture_orientation.h"

#include <algorithm>
#include <vector>

#include "brindle/base/compressed_rows.h"
#include "brindle/base/graph.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/pipeline/agreeing_turns.h"
#include "brindle/pipeline/short_seam.h"

namespace brindle {
namespace {

std::vector<std::uint8_t> which_are_oriented(const TextureWaves& waves) {
  std::vector<std::uint8_t> oriented(waves.triangle_count());
  parallel_for(oriented.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) oriented[t] = is_oriented(waves, t);
  });
  return oriented;
}

/// In the rows of both triangles of every edge that both sides of agree at all.
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

void turn(TextureWaves& waves, std::span<const std::uint8_t> turned) {
  parallel_for(waves.triangle_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      if (!turned[t]) continue;
      turn_round(waves.u[t]);
      turn_round(waves.v[t]);
    }
  });
}

/// For every vertex the node that stands for it. A seam costs nothing along the border and around
/// triangles without orientation: their vertices are one node.
std::vector<Index> seam_nodes(std::span<const Triangle> triangles,
                              std::span<const std::uint8_t> oriented,
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
      if (oriented[t] && shared[3 * t + c]) continue;
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

}  // namespace

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
      result[e] = static_cast<EdgeAgreement>((of_a | of_b) & kUnoriented ? kNoAgreement : alike);
    }
  });
}

std::vector<EdgeAgreement> agreements(const TextureWaves& waves,
                                      std::span<const SharedEdge> edges) {
  const std::vector<std::uint8_t> oriented = which_are_oriented(waves);
  std::vector<EdgeAgreement> result(edges.size(), kNoAgreement);
  parallel_for(edges.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const auto a = edges[e].from[0], b = edges[e].from[1];
      if (!oriented[a / 3] || !oriented[b / 3]) continue;
      const auto alike = [&](const std::vector<CornerWaves>& corners) {
        return corners[a / 3][a % 3].wave.direction.dot(corners[b / 3][b % 3].wave.direction) > 0;
      };
      result[e] = static_cast<EdgeAgreement>((alike(waves.u) ? kUAlike : 0) |
                                             (alike(waves.v) ? kVAlike : 0));
    }
  });
  return result;
}

void turn_agreements(std::span<const std::uint8_t> turned, std::span<const SharedEdge> edges,
                     std::span<EdgeAgreement> agreement) {
  parallel_for(edges.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      if (agreement[e] == kNoAgreement) continue;
      if (turned[edges[e].from[0] / 3] == turned[edges[e].from[1] / 3]) continue;
      agreement[e] ^= kUAlike | kVAlike;
    }
  });
}

std::vector<std::uint8_t> oriented_triangles(std::span<const CornerSigns> signs) {
  std::vector<std::uint8_t> oriented(signs.size());
  ranges::transform(signs, oriented.begin(), [](CornerSigns s) {
    return static_cast<std::uint8_t>((s & kUnoriented) == 0);
  });
  return oriented;
}

TextureSeams texture_seams(std::span<const std::uint8_t> oriented,
                           std::span<const EdgeAgreement> agreement) {
  TextureSeams seams;
  for (const std::uint8_t is : oriented) seams.unoriented_triangles += is == 0;
  for (const EdgeAgreement alike : agreement) {
    seams.turned += alike == 0;
    seams.mirrored += alike == kUAlike || alike == kVAlike;
  }
  return seams;
}

TextureSeams texture_seams(const TextureWaves& waves, std::span<const SharedEdge> edges) {
  return texture_seams(which_are_oriented(waves), agreements(waves, edges));
}

std::vector<std::uint8_t> shortening_turns(std::span<const Triangle> triangles,
                                           std::span<const std::uint8_t> oriented,
                                           std::span<const SharedEdge> edges,
                                           std::span<const EdgeAgreement> agreement,
                                           const Progress& progress) {
  progress.report(0);
  const std::vector<Index> nodes = seam_nodes(triangles, oriented, edges);
  progress.report(0.3);
  const std::vector<SeamEdge> between = seam_edges(triangles, edges, agreement, nodes);
  progress.report(0.4);
  return shortening_turns(between, nodes.size(), triangles.size(), progress.part(0.4, 1));
}

std::vector<std::uint8_t> orienting_turns(std::span<const Triangle> triangles,
                                          std::span<const std::uint8_t> oriented,
                                          std::span<const SharedEdge> edges,
                                          std::span<const EdgeAgreement> agreement,
                                          const Progress& progress) {
  JobStages stages(progress, {{"orientation", 4}, {"seams", 2}});
  std::vector<std::uint8_t> turned =
      agreeing_turns(links_of(triangles.size(), edges, agreement), stages.begin("orientation"));
  const Progress shortening = stages.begin("seams");
  std::vector<EdgeAgreement> after(agreement.begin(), agreement.end());
  turn_agreements(turned, edges, after);
  shortening.report(0.1);
  const auto shorter = shortening_turns(triangles, oriented, edges, after, shortening.part(0.1, 1));
  for (std::size_t t = 0; t < turned.size(); ++t) turned[t] ^= shorter[t];
  return turned;
}

void orient_triangles(TextureWaves& waves, std::span<const Triangle> triangles,
                      std::span<const SharedEdge> edges, const Progress& progress) {
  turn(waves, orienting_turns(triangles, which_are_oriented(waves), edges, agreements(waves, edges),
                              progress));
}

}  // namespace brindle
