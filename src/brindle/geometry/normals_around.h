/// Vertex normals from known adjacent triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "brindle/creases.h"
#include "brindle/geometry/topology.h"
#include "brindle/mesh.h"
#include "brindle/normals.h"
#include "brindle/progress.h"

namespace brindle {

/// Edges that bend by more than 40 degrees are creases: they are not rounded, and outlines run
/// along them.
inline constexpr float kCosineOfCrease = 0.766f;

/// The corner of a triangle at a vertex.
inline int corner_of(const Triangle& triangle, Index vertex) {
  return triangle[0] == vertex ? 0 : triangle[1] == vertex ? 1 : 2;
}

/// As `vertex_normals` of normals.h, with the result of `vertex_triangles`.
std::vector<Vec3> vertex_normals(const Mesh& mesh, const VertexTriangles& around,
                                 const Progress& progress = {});

/// A triangle's normal and angles, for the normals at its corners.
struct TriangleAngles {
  Vec3 normal;
  std::array<float, 3> angle;  ///< radians; zero without an area
};

/// One unit normal per vertex into `normals`, with the scratch array `angles`. Resizes both;
/// allocates nothing if their capacity suffices. Triangles with a 1 in `turned`, if there are any,
/// count as wound the other way. Returns whether some around a vertex are wound against each other.
bool fill_vertex_normals(const Mesh& mesh, const VertexTriangles& around,
                         std::span<const std::uint8_t> turned, std::vector<TriangleAngles>& angles,
                         std::vector<Vec3>& normals, const Progress& progress = {});

// Components wound alike: triangles that normals turn, so that neighbours agree.

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
