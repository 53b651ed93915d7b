#include <cstdio>
#include <vector>

#include <brindle/brindle.h>

int main() try {
  const std::vector<double> points = {0, 0, 0, 1, 0, 0, 1, 1, 0.2, 0, 1, 0};  // x, y, z per vertex
  const std::vector<int> triangles = {0, 1, 2, 0, 2, 3};
  const brindle::Mesh mesh = brindle::subdivide(brindle::make_mesh({points, 3}, {triangles, 3}), 5);
  const brindle::Surface surface = brindle::make_surface(mesh);
  const brindle::DirectionField field = brindle::smooth_direction_field(surface);
  const auto pattern = brindle::stripe_pattern(surface, field, 12);  // 12 stripes per unit length
  const brindle::StripeCurves curves = brindle::stripe_curves(surface, pattern);
  std::printf("%zu curves; the first one:\n", curves.lines.count());
  for (const brindle::Vec3& p : curves.lines.points_of(0))
    std::printf("%.9g %.9g %.9g\n", p.x(), p.y(), p.z());
} catch (const brindle::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());  // what is wrong, and what to do about it
  return 1;
}
