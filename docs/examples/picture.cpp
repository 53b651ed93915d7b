// From a built-in shape to a picture, as `./dev demo` shows it. Built and run by the tests where
// there is OpenGL; the file's name may be given.
#include <cstdio>
#include <numbers>

#include "brindle/brindle.h"
#include "brindle/image.h"
#include "brindle/renderer.h"

int main(int argc, char** argv) try {
  const char* file = argc > 1 ? argv[1] : "picture.png";
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("trefoil"));
  const brindle::DirectionField bends = brindle::curvature_direction_field(
      brindle::principal_curvatures(surface.mesh.positions, surface.normals, *surface.neighborhood),
      brindle::CurvatureDirection::maximum);
  const brindle::DirectionField field =
      brindle::rotated(bends, surface.normals, 35 * std::numbers::pi_v<float> / 180);
  const float diagonal = brindle::bounding_box(surface.mesh).diagonal();
  const brindle::StripePattern pattern =
      brindle::stripe_pattern(surface, field, brindle::frequency_of_stripes(40, diagonal));
  brindle::RenderOptions options;
  options.camera = {.azimuth_deg = 20, .elevation_deg = 40};
  const brindle::Image image = brindle::render_picture({.mesh = surface.mesh,
                                                        .normals = surface.normals,
                                                        .waves = &pattern.waves,
                                                        .z = pattern.solution.z},
                                                       options);
  brindle::write_png(file, image);
  std::printf("%zu vertices, %zu branches\n", surface.mesh.vertex_count(),
              pattern.quality.branches);
} catch (const brindle::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
