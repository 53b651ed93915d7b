#include <cstdio>

#include <epoxy/gl.h>

#include "benchmarks.h"
#include "brindle/base/stopwatch.h"
#include "brindle/camera.h"
#include "brindle/error.h"
#include "brindle/render/surfaces/tiled_picture.h"
#include "brindle/render/surfaces/visible_triangles.h"

namespace brindle::bench {
namespace {

/// Too little to be seen, but enough to redraw the picture.
constexpr float kTurn = 0.01f;  // degrees

RenderOptions options_of(PictureQuality quality) {
  RenderOptions options;
  options.width = 1280;
  options.height = 720;
  options.quality = quality;
  return options;
}

SurfaceDrawing drawing_of(const Subject& subject, std::span<const Complex> z) {
  return {.mesh = subject.surface.mesh,
          .normals = subject.surface.normals,
          .waves = &subject.fields[0],
          .z = z};
}

void run_pictures(benchmark::State& state, const Subject& subject, PictureQuality quality) {
  StripeAnimator animator(subject.surface.neighborhood);
  const HeadlessContext context;
  Renderer renderer;
  renderer.upload(drawing_of(subject, animator.frame(subject.inputs[0].frame(0)).z));
  repeat_picture(state, renderer, options_of(quality));
  context.check_errors("measuring pictures");
}

/// The first pass alone, which finds the visible triangles.
void run_visible(benchmark::State& state, const Subject& subject, PictureQuality quality) {
  StripeAnimator animator(subject.surface.neighborhood);
  const HeadlessContext context;
  DrawnSurface drawn;
  drawn.surface.upload(drawing_of(subject, animator.frame(subject.inputs[0].frame(0)).z));
  const RenderOptions options = options_of(quality);
  const int side = shading_side(options);
  const Eigen::Vector2i size(side * options.width, side * options.height);
  VisibleTriangles visible;
  VisibleSamples samples;
  CameraView view = options.camera;
  repeat(state, [&] {
    view.azimuth_deg += kTurn;
    const Camera camera =
        framed_camera(drawn.surface.points(), view, options.width, options.height);
    Stopwatch watch;
    visible.draw(samples, std::span(&drawn, 1), camera, {{1, 1, 0, 0}, size}, size, options);
    glFinish();
    return Sample{watch.lap()};
  });
  context.check_errors("measuring the first pass of pictures");
}

}  // namespace

void repeat_picture(benchmark::State& state, const Renderer& renderer, RenderOptions options) {
  repeat(state, [&] {
    options.camera.azimuth_deg += kTurn;
    Stopwatch watch;
    renderer.draw(options);
    return Sample{watch.lap()};
  });
}

void add_pictures(const Subject& subject, int threads) {
  try {
    const HeadlessContext context;
  } catch (const Error& error) {
    std::fprintf(stderr, "no pictures: %s\n", error.what());
    return;
  }
  const auto add = [&](const std::string& name, PictureQuality quality, auto run) {
    add_benchmark(name, subject, threads, [&subject, quality, run](benchmark::State& state) {
      run(state, subject, quality);
    });
  };
  add("picture_interactive", PictureQuality::interactive, run_pictures);
  add("picture_final", PictureQuality::final, run_pictures);
  add("visible_interactive", PictureQuality::interactive, run_visible);
  add("visible_final", PictureQuality::final, run_visible);
}

}  // namespace brindle::bench
