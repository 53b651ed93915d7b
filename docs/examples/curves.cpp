// Stripes as curves, for plotters and other programs. Built and run by the tests.
#include <cstdio>
#include <vector>

#include "brindle/files.h"
#include "brindle/frequency_field.h"
#include "brindle/pattern/stripe_curves.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_pattern.h"

int main() {
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("torus"));
  const brindle::Mesh& mesh = surface.mesh;
  const brindle::StripePattern pattern = brindle::stripe_pattern(
      surface, {mesh.positions, brindle::smooth_direction_field(surface),
                brindle::constant_frequency_field(10, mesh.vertex_count())});
  const brindle::MeshEdges edges = brindle::mesh_edges(mesh, *surface.neighborhood);
  const brindle::LiftedWaves waves(
      {mesh, edges, surface.normals, pattern.waves, pattern.solution.z});
  const brindle::StripeCurves curves = brindle::stripe_curves(waves);
  std::printf("%zu curves of %zu points\n", curves.lines.count(), curves.lines.points.size());
  brindle::write_polylines("curves.vtp", std::vector<brindle::NamedLines>{{"u", curves.lines}});
}
