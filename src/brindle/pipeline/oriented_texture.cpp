#include "brindle/pipeline/oriented_texture.h"

#include <cstdint>
#include <span>
#include <vector>

#include "brindle/pattern/texture_quality.h"
#include "brindle/pipeline/texture_orientation.h"

namespace brindle {
namespace {

VertexWaves vertex_waves(const StripePattern& pattern) {
  return {pattern.waves.positions, pattern.waves.directions, pattern.waves.frequencies,
          pattern.solution.z};
}

LinearPattern linear_pattern(const StripePattern& pattern) {
  return {pattern.corners, pattern.waves.frequencies};
}

/// Waves, oriented, and seams from both patterns.
void orient(std::span<const Triangle> triangles, bool as_given, const Progress& progress,
            TexturePattern& pattern) {
  progress.report(0);
  std::vector<CornerSigns> signs;
  corner_signs(triangles, pattern.u.waves.directions, pattern.v.waves.directions, signs);
  progress.report(0.1);
  const std::vector<SharedEdge> edges = shared_edges(triangles);
  progress.report(0.3);
  const std::vector<std::uint8_t> oriented = oriented_triangles(signs);
  std::vector<EdgeAgreement> agreement;
  agreements(signs, edges, agreement);
  if (!as_given) {
    const auto turned =
        orienting_turns(triangles, oriented, edges, agreement, progress.part(0.3, 0.8));
    turn_agreements(turned, edges, agreement);
    turn_signs(turned, signs);
  }
  progress.report(0.8);
  pattern.seams = texture_seams(oriented, agreement);
  progress.report(0.9);
  set_texture_waves(triangles, signs, vertex_waves(pattern.u), vertex_waves(pattern.v),
                    pattern.waves, progress.part(0.9, 1));
}

}  // namespace

void orient_texture(const Mesh& mesh, bool as_given, const Progress& progress,
                    TexturePattern& pattern) {
  orient(mesh.triangles, as_given, progress.part(0, 0.9), pattern);
  progress.report(0.9);
  pattern.quality = measure_texture(mesh, linear_pattern(pattern.u), linear_pattern(pattern.v),
                                    progress.part(0.9, 1));
}

}  // namespace brindle
