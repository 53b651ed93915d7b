/// How far pictures are from what they stand for.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "brindle/normals.h"
#include "brindle/shapes.h"
#include "render/test_drawings.h"

namespace brindle::test {

/// What is hard to draw, and how it is looked at.
struct HardScene {
  std::string name;
  StripedSurface surface;
  std::vector<Vec3> normals;
  RenderOptions options;

  SurfaceDrawing drawing() const {
    SurfaceDrawing drawing{.mesh = surface.mesh, .normals = normals};
    if (surface.z.empty()) return drawing;
    drawing.waves = &surface.waves;
    drawing.z = surface.z;
    return drawing;
  }
};

inline RenderOptions scene_options(float azimuth_deg, float elevation_deg) {
  RenderOptions options;
  options.width = 160;
  options.height = 120;
  options.camera = {.azimuth_deg = azimuth_deg, .elevation_deg = elevation_deg};
  options.base_color = {1, 1, 1};
  options.stripe_color = {0, 0, 0};
  options.background_center = options.background_edge = {0.2f, 0.2f, 0.2f};
  options.shading = false;
  return options;
}

/// Stripes that become finer from 10 to 300 for the side of the square.
inline StripedSurface finer_and_finer() {
  constexpr float kFirst = 10, kLast = 300;
  StripedSurface surface = plane_wave(square(150), Vec3(0.8f, 0.6f, 0), kFirst);
  for (std::size_t v = 0; v < surface.z.size(); ++v) {
    const float along = surface.mesh.positions[v].dot(surface.waves.directions[v]) / 1.4f;
    surface.waves.frequencies[v] = kFirst + (kLast - kFirst) * along;
    const float turns = 1.4f * along * (kFirst + (kLast - kFirst) * along / 2);
    surface.z[v] = std::polar(1.0f, kTurn * (turns - std::round(turns)));
  }
  return surface;
}

inline StripedSurface plain(Mesh mesh) { return {std::move(mesh), {}, {}}; }

inline std::vector<HardScene> hard_scenes() {
  std::vector<HardScene> scenes;
  const auto flat = plane_wave(square(40), Vec3(0.8f, 0.6f, 0), 25);
  scenes.push_back({"stripes at grazing angles", flat,
                    std::vector<Vec3>(flat.mesh.vertex_count(), Vec3::UnitZ()),
                    scene_options(20, 84)});
  const auto finer = finer_and_finer();
  scenes.push_back({"stripes finer than a pixel", finer,
                    std::vector<Vec3>(finer.mesh.vertex_count(), Vec3::UnitZ()),
                    scene_options(0, 0)});
  const Mesh trefoil = make_shape("trefoil");
  scenes.push_back({"silhouettes", plain(trefoil), vertex_normals(trefoil), scene_options(30, 20)});
  scenes.push_back({"creases", plain(make_shape("box")), {}, scene_options(30, 25)});
  scenes.back().options.shading = true;
  return scenes;
}

/// The mean light of every `factor` x `factor` pixels.
inline Image smaller(const Image& image, int factor) {
  Image result(image.width / factor, image.height / factor);
  const auto level = [](double light) {
    const double srgb =
        light < 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * srgb));
  };
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      Eigen::Vector4f sum = Eigen::Vector4f::Zero();
      for (int j = 0; j < factor; ++j) {
        for (int i = 0; i < factor; ++i) {
          sum += premultiplied_light(image.at(factor * x + i, factor * y + j));
        }
      }
      sum /= static_cast<float>(factor * factor);
      result.at(x, y) = {level(sum[0]), level(sum[1]), level(sum[2]), 255};
    }
  }
  return result;
}

/// In squares of levels of 255.
inline double mean_squared_error(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t p = 0; p < a.pixels.size(); ++p) {
    const auto square_of = [](int difference) { return difference * difference; };
    sum += square_of(a.pixels[p].red - b.pixels[p].red) +
           square_of(a.pixels[p].green - b.pixels[p].green) +
           square_of(a.pixels[p].blue - b.pixels[p].blue);
  }
  return sum / (3.0 * static_cast<double>(a.pixels.size()));
}

}  // namespace brindle::test
