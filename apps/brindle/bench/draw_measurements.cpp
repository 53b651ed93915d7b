#include "bench/draw_measurements.h"

#include <epoxy/gl.h>

#include "bench/changing_input.h"
#include "brindle/base/stopwatch.h"
#include "brindle/camera.h"
#include "brindle/headless_context.h"
#include "brindle/render/surfaces/tiled_picture.h"
#include "brindle/render/surfaces/visible_triangles.h"
#include "brindle/renderer.h"
#include "brindle/stripe_animator.h"

namespace brindle::tool {
namespace {

/// Changes the camera too little to be seen, but enough to redraw the picture.
constexpr float kTurn = 0.01f;  // degrees

/// The first pass alone.
Spread visible_time(const DrawnSurface& drawn, RenderOptions options, PictureQuality quality,
                    const Repetitions& repetitions) {
  VisibleTriangles visible;
  VisibleSamples samples;
  options.quality = quality;
  CameraView view = options.camera;
  const int side = shading_side(options);
  const Eigen::Vector2i size(side * options.width, side * options.height);
  return spread_of(samples_of(repetitions, [&] {
    view.azimuth_deg += kTurn;
    const Camera camera =
        framed_camera(drawn.surface.points(), view, options.width, options.height);
    Stopwatch watch;
    visible.draw(samples, std::span(&drawn, 1), camera, {{1, 1, 0, 0}, size}, size, options);
    glFinish();
    return watch.lap();
  }));
}

}  // namespace

Spread picture_time(const Renderer& renderer, RenderOptions options, PictureQuality quality,
                    const Repetitions& repetitions) {
  options.quality = quality;
  // The very first picture waits for the driver's shader compiler, which could use up the time
  // budget.
  RenderOptions small = options;
  small.width = small.height = 16;
  renderer.draw(small);
  return spread_of(samples_of(repetitions, [&] {
    options.camera.azimuth_deg += kTurn;
    Stopwatch watch;
    renderer.draw(options);
    return watch.lap();
  }));
}

DrawMetrics measure_draw(const Subject& subject, int width, int height,
                         const Repetitions& repetitions, const Progress& progress) {
  progress.report("pictures", 0);
  const std::vector<ChangingInput> inputs = changing_inputs(subject);
  StripeAnimator animator(subject.surface.neighborhood);
  const FrameResult frame = animator.frame(inputs[0].frame(0));
  const SurfaceDrawing drawing{.mesh = subject.surface.mesh,
                               .normals = subject.surface.normals,
                               .waves = &subject.fields[0],
                               .z = frame.z};
  const HeadlessContext context;
  Renderer renderer;
  renderer.upload(drawing);
  RenderOptions options;
  options.width = width;
  options.height = height;
  DrawMetrics metrics{width, height, {}, {}, {}, {}};
  metrics.interactive = picture_time(renderer, options, PictureQuality::interactive, repetitions);
  metrics.final = picture_time(renderer, options, PictureQuality::final, repetitions);
  DrawnSurface drawn;
  drawn.surface.upload(drawing);
  metrics.visible = visible_time(drawn, options, PictureQuality::interactive, repetitions);
  metrics.visible_final = visible_time(drawn, options, PictureQuality::final, repetitions);
  context.check_errors("measuring pictures");
  return metrics;
}

}  // namespace brindle::tool
