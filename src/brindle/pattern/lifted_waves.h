/// The waves of all vertices, lifted along mesh edges once for curves and samples.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "brindle/creases.h"
#include "brindle/geometry/topology.h"
#include "brindle/mesh.h"
#include "brindle/pattern/stripe_pieces.h"
#include "brindle/polylines.h"
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

// Positions of curve segments on a mesh.

/// A point on an edge or inside a triangle, given by the vertices around it.
struct MeshPoint {
  std::array<Index, 3> vertices{};
  std::array<double, 3> weights{};   ///< not negative, sum to 1
  std::array<Index, 2> triangles{};  ///< that contain it; twice the same if there is only one
};

/// A point of a curve.
struct CurvePoint {
  Vec3 position;
  Vec3 normal;
  Vec3 forward;  ///< direction of the wave; zero inside a triangle
  float size;    ///< of its edge or triangle
  MeshPoint place;
};

CurvePoint point_in_triangle(const WavePattern& pattern, const TrianglePoint& place);

/// Adds a vertex normal with a weight, flipped to agree with `sum`: normals of unorientable
/// surfaces may point either way.
void add_normal(const WavePattern& pattern, float weight, Index vertex, Vec3& sum);

/// The ends of a segment in one triangle.
struct PlacedSegment {
  Index triangle = 0;
  std::array<double, 3> from{}, to{};  ///< barycentric coordinates
};

/// Places a segment in a triangle that contains both ends. If there is none, because points between
/// them were dropped, uses the triangle nearest to both and moves the ends into it.
PlacedSegment placed_segment(const Mesh& mesh, const MeshPoint& from, const MeshPoint& to);

}  // namespace brindle
