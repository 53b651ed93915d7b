// Strokes that are wider where a value is larger, over a ball that is seen between them. Built and
// run by the tests where there is OpenGL.
#include <cstdio>

#include "brindle/shapes.h"
#include "brindle/stripe_pattern.h"
#include "brindle/styled_picture.h"

int main() {
  const brindle::Surface shell = brindle::make_surface(brindle::make_shape("torus"));
  const brindle::Surface ball = brindle::make_surface(brindle::make_shape("sphere,radius=0.3"));
  const brindle::StripePattern pattern = brindle::stripe_pattern(
      shell, brindle::projected_direction_field({0, 0, 1}, shell.normals), 12);
  std::vector<float> heights;
  for (const brindle::Vec3& p : shell.mesh.positions) heights.push_back(p.z());
  const std::vector<float> widths = brindle::rescaled(heights, -0.3f, 0.3f, 0.1f, 0.8f);
  const brindle::Strokes strokes{
      .waves = &pattern.waves, .z = pattern.solution.z, .widths = widths};
  const std::vector<brindle::StyledSurface> surfaces{
      {.mesh = shell.mesh,
       .normals = shell.normals,
       .strokes = {strokes},
       .between = brindle::BetweenStrokes::discarded},
      {.mesh = ball.mesh, .normals = ball.normals, .color = {0.8f, 0.3f, 0.2f}}};
  brindle::StyledOptions options;
  options.render.width = 320;
  options.render.height = 240;
  const brindle::Image image = brindle::render_styled(surfaces, options);
  std::printf("a picture of %d x %d pixels\n", image.width, image.height);
}
