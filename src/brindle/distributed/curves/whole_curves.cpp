#include "brindle/distributed/curves/whole_curves.h"

#include <numeric>
#include <span>
#include <vector>

#include "brindle/geometry/topology.h"
#include "brindle/pattern/lifted_waves.h"
#include "brindle/pattern/stripe_curves.h"

namespace brindle {
namespace {

/// A triangle as its rank's piece has it.
struct TriangleOfPiece {
  int rank;
  Index triangle;
};

/// Collective. Those of all triangles of the whole, on rank 0.
std::vector<TriangleOfPiece> triangles_of_pieces(const RankSurface& surface,
                                                 const WholeOnFirst& whole) {
  std::vector<TriangleOfPiece> own(surface.piece_triangles);
  for (Index t = 0; t < own.size(); ++t) own[t] = {surface.ranks->rank(), t};
  return whole.of_triangles(std::span<const TriangleOfPiece>(own));
}

StripeCurves curves_of(const Surface& surface, const RankWaves& waves, PhaseShiftKind phase_shift,
                       const CurveOptions& options, const Progress& progress) {
  const MeshEdges edges = mesh_edges(surface.mesh, *surface.neighborhood);
  const WavePattern pattern = {surface.mesh, edges,   surface.normals,
                               waves.waves,  waves.z, phase_shift};
  return stripe_curves(LiftedWaves(pattern, progress.part(0, 0.2)), options, progress.part(0.2, 1));
}

}  // namespace

RankWaves whole_waves(const WholeOnFirst& whole, const PiecePattern& pattern) {
  check_pattern(pattern);
  const auto vectors = [&](const std::vector<Vec3>& of_piece) {
    const std::vector<SentVector> sent = sent_vectors(of_piece);
    return received_vectors(whole.of_vertices(std::span(sent)));
  };
  RankWaves waves;
  waves.waves.positions = vectors(pattern.waves.positions);
  waves.waves.directions = vectors(pattern.waves.directions);
  waves.waves.frequencies = whole.of_vertices(std::span(pattern.waves.frequencies));
  waves.z = whole.of_vertices(pattern.z);
  return waves;
}

WholeCurves whole_curves(const WholeOnFirst& whole, const PiecePattern& pattern,
                         const CurveOptions& options, const Progress& progress) {
  const RankSurface& surface = pattern.surface.rank_surface();
  surface.ranks->together([&] { check_curve_options(options); });
  const RankWaves waves = whole_waves(whole, pattern);
  const std::vector<TriangleOfPiece> triangles = triangles_of_pieces(surface, whole);
  WholeCurves result;
  surface.ranks->together([&] {
    if (!whole.is_first()) return;
    result.curves = curves_of(whole.surface(), waves, pattern.phase_shift, options, progress);
    for (TrianglePoint& place : result.curves.lines.places) {
      result.rank_of_point.push_back(triangles[place.triangle].rank);
      place.triangle = triangles[place.triangle].triangle;
    }
  });
  return result;
}

WholeCurves whole_curves(const PiecePattern& pattern, const CurveOptions& options,
                         const Progress& progress) {
  return whole_curves(WholeOnFirst(pattern.surface.rank_surface()), pattern, options, progress);
}

}  // namespace brindle
