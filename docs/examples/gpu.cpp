// Stripes on the GPU inside an OpenGL application: buffers in, a buffer out. Built and run by the
// tests.
#include <cstdio>

#include <epoxy/gl.h>

#include "brindle/gl/headless_context.h"
#include "brindle/gpu/gpu_animator.h"
#include "brindle/pipeline/scene.h"
#include "brindle/surface/shapes.h"

template <class Item>
void copy(const std::vector<Item>& items, GLuint buffer) {
  glNamedBufferData(buffer, static_cast<GLsizeiptr>(items.size() * sizeof(Item)), items.data(),
                    GL_DYNAMIC_DRAW);
}

int main() {
  const brindle::HeadlessContext context;  // your window's context, in your program
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("torus"));
  const float frequency = 20 / bounding_box(surface.mesh).diagonal();
  brindle::Scene scene(surface, {.kind = brindle::SceneKind::vortices, .frequency = frequency});
  GLuint buffers[3];  // that your program has anyway
  glCreateBuffers(3, buffers);

  const auto kernels = std::make_shared<const brindle::GpuKernels>();  // once a context
  brindle::GpuAnimator animator(kernels, surface.neighborhood);
  animator.measure_frames(true);
  for (int number = 0; number < 5; ++number) {
    const brindle::WaveSet& waves = scene.frame(number).waves;  // or a shader of yours writes them
    copy(waves.positions, buffers[0]);
    copy(waves.directions, buffers[1]);
    copy(waves.frequencies, buffers[2]);
    animator.frame(brindle::WaveBuffers{buffers[0], buffers[1], buffers[2]});
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 4, animator.phases());  // and draw
    if (const auto& measured = animator.measured()) {
      std::printf("frame %d: energy %.4f\n", measured->frame, measured->energy);
    }
  }
  glDeleteBuffers(3, buffers);
  context.check_errors("the example");
}
