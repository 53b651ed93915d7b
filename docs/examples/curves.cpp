// Stripes as curves, for plotters and other programs. Built and run by the tests.
#include <cstdio>
#include <vector>

#include "brindle/brindle.h"

int main() {
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("torus"));
  const brindle::StripePattern pattern =
      brindle::stripe_pattern(surface, brindle::smooth_direction_field(surface), 10);
  const brindle::StripeCurves curves = brindle::stripe_curves(surface, pattern);
  std::printf("%zu curves of %zu points\n", curves.lines.count(), curves.lines.points.size());
  brindle::write_polylines("curves.vtp", std::vector<brindle::NamedLines>{{"u", curves.lines}});
}
