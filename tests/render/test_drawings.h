/// Small surfaces with waves, for tests of pictures.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "brindle/headless_context.h"
#include "brindle/renderer.h"
#include "render/fragment_probe.h"

namespace brindle::test {

inline constexpr float kTurn = 2 * std::numbers::pi_v<float>;

struct StripedSurface {
  Mesh mesh;
  WaveSet waves;
  std::vector<Complex> z;

  SurfaceDrawing drawing() const { return {.mesh = mesh, .waves = &waves, .z = z}; }
};

/// A unit square of 2 n^2 triangles in the plane z = 0, facing +z.
inline Mesh square(int n) {
  Mesh mesh;
  const auto id = [n](int i, int j) { return static_cast<Index>(j * (n + 1) + i); };
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      mesh.positions.push_back(Vec3(static_cast<float>(i), static_cast<float>(j), 0) /
                               static_cast<float>(n));
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return mesh;
}

/// The square bent into a saddle.
inline Mesh saddle(int n) {
  Mesh mesh = square(n);
  for (Vec3& p : mesh.positions) p.z() = (p.x() - 0.5f) * (p.y() - 0.5f);
  return mesh;
}

/// A plane wave with `frequency` stripes per unit length along `direction`.
inline StripedSurface plane_wave(Mesh mesh, const Vec3& direction, float frequency) {
  StripedSurface surface{std::move(mesh), {}, {}};
  surface.waves.positions = surface.mesh.positions;
  for (const Vec3& p : surface.mesh.positions) {
    surface.waves.directions.push_back(direction);
    surface.waves.frequencies.push_back(frequency);
    surface.z.push_back(std::polar(1.0f, kTurn * frequency * direction.dot(p)));
  }
  return surface;
}

/// Random directions, frequencies up to `frequency` and phases: branches and singularities all
/// over.
inline StripedSurface random_waves(Mesh mesh, float frequency) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<float> number(-1, 1);
  StripedSurface surface = plane_wave(std::move(mesh), Vec3::UnitX(), frequency);
  for (std::size_t v = 0; v < surface.z.size(); ++v) {
    surface.waves.directions[v] = Vec3(number(engine), number(engine), 0).normalized();
    surface.waves.frequencies[v] = frequency * (0.75f + 0.25f * number(engine));
    surface.z[v] = std::polar(1.0f, kTurn * number(engine));
  }
  return surface;
}

/// Turns every other wave round, which must not change the picture.
inline StripedSurface with_flips(StripedSurface surface) {
  std::mt19937 engine(5);
  for (std::size_t v = 0; v < surface.z.size(); ++v) {
    if (engine() % 2 == 0) continue;
    surface.waves.directions[v] *= -1;
    surface.z[v] = -std::conj(surface.z[v]);
  }
  return surface;
}

/// A context, a renderer and a probe in it, made once.
struct Studio {
  HeadlessContext context;
  Renderer renderer;
  FragmentProbe probe;

  /// Current again, should another test have made a context of its own.
  static Studio& shared() {
    static Studio studio;
    studio.context.make_current();
    return studio;
  }
  Image draw(const SurfaceDrawing& drawing, const RenderOptions& options) {
    renderer.upload(drawing);
    Image image = renderer.draw(options);
    context.check_errors("drawing the test picture");
    return image;
  }
};

/// A small picture from straight ahead, without light: stripes are white on black.
inline RenderOptions plain_options(int width = 160, int height = 120) {
  RenderOptions options;
  options.width = width;
  options.height = height;
  options.camera = {.azimuth_deg = 0, .elevation_deg = 0};
  options.base_color = {0, 0, 0};
  options.stripe_color = {1, 1, 1};
  options.shading = false;
  options.transparent = true;
  options.supersampling = 1;
  return options;
}

/// Mean and range of the red light in the middle of a picture.
struct Light {
  double mean = 0, lowest = 1, highest = 0;
};

inline Light light_in_the_middle(const Image& image) {
  Light light;
  int count = 0;
  for (int y = image.height / 4; y < image.height * 3 / 4; ++y) {
    for (int x = image.width / 4; x < image.width * 3 / 4; ++x) {
      const double value = linear_light({static_cast<float>(image.at(x, y).red) / 255, 0, 0})[0];
      light.mean += value;
      light.lowest = std::min(light.lowest, value);
      light.highest = std::max(light.highest, value);
      ++count;
    }
  }
  light.mean /= count;
  return light;
}

}  // namespace brindle::test
