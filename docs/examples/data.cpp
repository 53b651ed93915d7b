// Stripes along vectors of a simulation, denser where they are longer. Built and run by the tests.
#include <cstdio>
#include <vector>

#include "brindle/array_field.h"
#include "brindle/shapes.h"
#include "brindle/stripe_pattern.h"

int main() {
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("molecule"));
  std::vector<double> numbers;  // or the arrays of a file: read_mesh(path).arrays.points
  for (const brindle::Vec3& p : surface.mesh.positions) {
    numbers.insert(numbers.end(), {-p.y(), p.x(), 0.5});
  }
  const brindle::DataArray velocity = brindle::make_data_array("velocity", 3, numbers);
  const brindle::StripePattern pattern = brindle::stripe_pattern(
      surface, {surface.mesh.positions, brindle::direction_field_of(surface, velocity),
                brindle::frequencies_by(surface, velocity, 15)});
  std::printf("energy %.4f, %zu branches\n", pattern.solution.energy, pattern.quality.branches);
}
