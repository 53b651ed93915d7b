#include <algorithm>
#include <cmath>

#include "brindle/error.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/gpu_animator.h"
#include "brindle/renderer.h"
#include "device.h"
#include "phase_graphs.h"
#include "render/fragment_probe.h"

namespace brindle {
namespace {

using test::FragmentImage;
using test::FragmentProbe;
using testing_support::kAxis;
using testing_support::wavy_surface;
using testing_support::WavySurface;

using GpuRenderingTest = test::GpuTest;

RenderOptions small_picture() {
  RenderOptions options;
  options.width = 200;
  options.height = 150;
  options.supersampling = 1;
  return options;
}

TEST_F(GpuRenderingTest, DrawsFromTheAnimatorsBufferWhatACopyWouldGive) {
  auto surface = wavy_surface("torus,resolution=80", kAxis, 20);
  GpuAnimator animator(device.solver.kernels(), surface.neighborhood);
  animator.frame(test::input_of(surface.waves));
  Renderer renderer;
  renderer.upload({.mesh = surface.mesh, .normals = surface.normals, .waves = &surface.waves});
  renderer.use_phases(animator.phases());
  for (int n = 0; n < 3; ++n) {
    for (float& f : surface.waves.frequencies) f *= 1.01f;
    animator.frame(test::input_of(surface.waves));
    renderer.update({.waves = &surface.waves});
    const Image shared = renderer.draw(small_picture());

    const std::vector<Complex> z = animator.read_phases();
    Renderer other;
    other.upload(
        {.mesh = surface.mesh, .normals = surface.normals, .waves = &surface.waves, .z = z});
    EXPECT_EQ(shared.pixels, other.draw(small_picture()).pixels) << n;
  }
}

TEST_F(GpuRenderingTest, PicturesDifferByNoMoreThanPhasesDo) {
  const auto surface = wavy_surface("torus,resolution=80", kAxis, 20);
  GpuAnimator gpu(device.solver.kernels(), surface.neighborhood);
  gpu.frame(test::input_of(surface.waves));
  StripeAnimator cpu(surface.neighborhood);
  const auto z = cpu.frame(test::input_of(surface.waves)).z;
  const std::vector<Complex> gpu_z = gpu.read_phases();

  FragmentProbe probe;
  probe.upload({.mesh = surface.mesh, .waves = &surface.waves, .z = z});
  const FragmentImage from_cpu = probe.draw(small_picture());
  probe.use_phases(gpu.phases());
  const FragmentImage from_gpu = probe.draw(small_picture());
  int pixels = 0, beyond = 0;
  for (std::size_t p = 0; p < from_cpu.z.size(); ++p) {
    if (from_cpu.triangle[p] == FragmentImage::kNoTriangle) continue;
    float largest = 0;
    for (const Index v : surface.mesh.triangles[from_cpu.triangle[p]]) {
      largest = std::max(largest, std::abs(gpu_z[v] - z[v]));
    }
    ++pixels;
    // Around a branch the corners' phases cancel and any difference grows.
    if (std::abs(from_gpu.z[p] - from_cpu.z[p]) > 2 * largest + 1e-4f) ++beyond;
  }
  EXPECT_GT(pixels, 3000);
  EXPECT_LT(beyond, pixels / 100);
}

TEST_F(GpuRenderingTest, PhasesThatAreUploadedComeFirstAgain) {
  const auto surface = wavy_surface("torus,resolution=40", kAxis, 8);
  GpuAnimator animator(device.solver.kernels(), surface.neighborhood);
  animator.frame(test::input_of(surface.waves));
  Renderer renderer;
  const std::vector<Complex> still(surface.mesh.vertex_count(), Complex(1));
  renderer.upload({.mesh = surface.mesh, .waves = &surface.waves, .z = still});
  const Image before = renderer.draw(small_picture());
  renderer.use_phases(animator.phases());
  EXPECT_NE(renderer.draw(small_picture()).pixels, before.pixels);
  renderer.update({.z = still});
  EXPECT_EQ(renderer.draw(small_picture()).pixels, before.pixels);
}

TEST_F(GpuRenderingTest, BuffersOfAnotherSizeAreErrors) {
  const auto surface = wavy_surface("torus,resolution=40", kAxis, 8);
  Renderer renderer;
  renderer.upload({.mesh = surface.mesh, .waves = &surface.waves});
  const GlBuffer three = buffer_of(std::vector<Complex>(3), "phases");
  EXPECT_THROW(renderer.use_phases(three), Error);
}

}  // namespace
}  // namespace brindle
