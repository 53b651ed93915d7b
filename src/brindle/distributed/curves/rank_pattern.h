/// A rank's triangles with a pattern, as functions of one process want them.
#pragma once

#include <cstdint>
#include <vector>

#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/distributed_pattern.h"
#include "brindle/geometry/topology.h"
#include "brindle/pattern/lifted_waves.h"

namespace brindle {

/// Vertices are numbered in the order of their numbers in the whole: which end of an edge comes
/// first is the same on all ranks, and so is all that follows from it.
struct RankTriangles {
  Mesh mesh;                       ///< own triangles
  std::vector<std::uint64_t> ids;  ///< of the vertices in the whole, ascending
  std::vector<Index> of_piece;     ///< the numbers that the vertices have in the piece
  std::vector<Vec3> normals;
  MeshEdges edges;
};

RankTriangles rank_triangles(const RankSurface& surface);

/// Waves and phases of these vertices.
struct RankWaves {
  WaveSet waves;
  std::vector<Complex> z;
};

/// Must be called by all ranks. Throws Error on all for a pattern whose parts do not match.
void check_pattern(const PiecePattern& pattern);

/// Must be called by all ranks. Throws what `check_pattern` does.
RankWaves rank_waves(const PiecePattern& pattern, const RankTriangles& triangles);

/// As `LiftedWaves` asks for it; what it is made of must outlive it.
WavePattern wave_pattern(const RankTriangles& triangles, const RankWaves& waves,
                         PhaseShiftKind phase_shift);

/// Must be called by all ranks. What other ranks have at each of the edges.
std::vector<EdgeBeyond> edges_beyond(const RankSurface& surface, const RankTriangles& triangles);

}  // namespace brindle
