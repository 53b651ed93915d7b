// Stripes on the GPU inside an OpenGL application: buffers in, a buffer out. Built and run by the
// tests.
#include <cmath>
#include <cstdio>
#include <vector>

#include <epoxy/gl.h>

#include "brindle/direction_field.h"
#include "brindle/gpu_animator.h"
#include "brindle/headless_context.h"
#include "brindle/shapes.h"
#include "brindle/surface.h"

template <class Item>
void copy(const std::vector<Item>& items, GLuint buffer) {
  glNamedBufferData(buffer, static_cast<GLsizeiptr>(items.size() * sizeof(Item)), items.data(),
                    GL_DYNAMIC_DRAW);
}

int main() {
  const brindle::HeadlessContext context;  // your window's context, in your program
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("torus"));
  const std::vector<float> frequencies(surface.mesh.vertex_count(),
                                       20 / bounding_box(surface.mesh).diagonal());
  GLuint buffers[3];  // that your program has anyway
  glCreateBuffers(3, buffers);

  const auto kernels = brindle::make_gpu_kernels();  // once a context
  brindle::GpuAnimator animator(kernels, surface.neighborhood);
  animator.measure_frames(true);
  for (int number = 0; number < 5; ++number) {
    const float angle = 0.02f * static_cast<float>(number);  // or a shader of yours writes them
    copy(surface.mesh.positions, buffers[0]);
    copy(brindle::projected_direction_field({std::cos(angle), std::sin(angle), 0.3f},
                                            surface.normals),
         buffers[1]);
    copy(frequencies, buffers[2]);
    animator.frame(brindle::WaveBuffers{buffers[0], buffers[1], buffers[2]});
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 4, animator.phases());  // and draw
    if (const auto& measured = animator.measured()) {
      std::printf("frame %d: energy %.4f\n", measured->frame, measured->energy);
    }
  }
  glDeleteBuffers(3, buffers);
  context.check_errors("the example");
}
