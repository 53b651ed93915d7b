/// Components wound alike: triangles that normals turn, so that neighbours agree.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "brindle/creases.h"
#include "brindle/geometry/topology.h"
#include "brindle/mesh.h"

namespace brindle {

/// Two triangles on the two sides of a crease, which share no vertex numbers there.
struct CreaseNeighbors {
  Index first;
  Index second;
  bool against;  ///< of opposite winding
};

std::vector<CreaseNeighbors> triangles_over_creases(const Mesh& mesh, const VertexTriangles& around,
                                                    const Creases& creases);

/// 1 for triangles to turn so that all of their component are wound alike: outwards if it is
/// closed, else as most are. Triangles are connected by edges of exactly two triangles, and by
/// `links`. Components that are wound alike stay, and so do those that cannot be (Möbius strip).
/// Empty if nothing is to turn.
std::vector<std::uint8_t> triangles_to_turn(const Mesh& mesh, const VertexTriangles& around,
                                            std::span<const CreaseNeighbors> links = {});

}  // namespace brindle
