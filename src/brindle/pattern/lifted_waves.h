/// The waves of all vertices, lifted along mesh edges once for curves and samples.
#pragma once

#include <span>
#include <vector>

#include "brindle/creases.h"
#include "brindle/geometry/topology.h"
#include "brindle/pattern/stripe_pieces.h"
#include "brindle/progress.h"

namespace brindle {

/// A surface with one solved wave per vertex. Referenced data must outlive it.
struct WavePattern {
  const Mesh& mesh;
  const MeshEdges& edges;
  std::span<const Vec3> normals;  ///< unit normals, one per vertex
  const WaveSet& waves;
  std::span<const Complex> z;  ///< exp(i Phi), one per vertex
  PhaseShiftKind phase_shift = PhaseShiftKind::aligned;
  std::span<const CreaseEdge> creases = {};  ///< of the mesh
};

/// Waves lifted along all edges of a pattern.
class LiftedWaves {
 public:
  /// Lifts all edges. Throws Error if the sizes of the pattern's parts do not match, and Cancelled
  /// if `progress` cancels.
  explicit LiftedWaves(const WavePattern& pattern, const Progress& progress = {});

  const WavePattern& pattern() const { return pattern_; }

  /// The vertex's canonical wave.
  const CornerWave& wave(Index vertex) const { return waves_[vertex]; }
  /// `turns_after_peak` of the vertex's canonical wave; 0 if it has none.
  Turns turns(Index vertex) const { return turns_[vertex]; }
  /// The lifted edge; without peaks if an end has no wave.
  const EdgeLift& edge(Index edge) const { return edges_[edge]; }
  LiftedTriangle triangle(std::size_t t) const;

 private:
  WavePattern pattern_;
  std::vector<CornerWave> waves_;  // canonical
  std::vector<Turns> turns_;       // 0 where there is no wave
  std::vector<EdgeLift> edges_;
};

}  // namespace brindle
