// A vase in one spiral, for whoever prints or knits it. Built and run by the tests.
#include <cstdio>
#include <vector>

#include "brindle/brindle.h"

int main() {
  const brindle::Surface vase = brindle::make_surface(brindle::make_shape("tube,bend=0,bulge=0.4"));
  const auto curvatures =
      brindle::principal_curvatures(vase.mesh.positions, vase.normals, *vase.neighborhood);
  const brindle::StripePattern rings = brindle::stripe_pattern(
      vase, curvature_direction_field(curvatures, brindle::CurvatureDirection::minimum), 20);
  const std::vector<brindle::WantedWinding> one = {{"", 1}};
  const brindle::WoundPattern spiral = brindle::wind(vase, rings, one);
  const brindle::StripeCurves curves = brindle::stripe_curves(vase, spiral.pattern);
  const auto measures = brindle::measure_curves(vase, spiral.pattern, curves, 0.02);
  std::printf("%zu curve, %.2f long, covers %.0f %%; turned by %.2f degrees at most\n",
              curves.lines.count(), measures.lengths.longest, 100 * *measures.coverage,
              spiral.largest_turn_deg);
}
