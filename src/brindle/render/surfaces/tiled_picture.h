/// Pictures of any size, drawn in parts in linear light and then developed.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "brindle/gl/shader_program.h"
#include "brindle/headless_context.h"
#include "brindle/progress.h"
#include "brindle/render/surfaces/gl_target.h"
#include "brindle/renderer.h"

namespace brindle {

/// A part of the picture, in finished pixels from the lower left.
struct Tile {
  int x, y, width, height;
};

/// Scale and offset from the tile's part of clip space to all of it.
Eigen::Vector4f tile_transform(const Tile& tile, const RenderOptions& options);

/// Sets the uniforms of picture_light.glsl.
void set_light(const ShaderProgram& program, const Camera& camera, const RenderOptions& options);

/// Sets the uniforms `shading`, `base_color`, `stripe_color` and `stripe_width`.
void set_looks(const ShaderProgram& surface, const RenderOptions& options);

/// Flips rows between OpenGL's order, bottom up, and top down.
template <class Item>
void flip_rows(std::vector<Item>& items, int width, int height) {
  for (int y = 0; y < height / 2; ++y) {
    std::swap_ranges(items.begin() + static_cast<std::ptrdiff_t>(y) * width,
                     items.begin() + static_cast<std::ptrdiff_t>(y + 1) * width,
                     items.begin() + static_cast<std::ptrdiff_t>(height - 1 - y) * width);
  }
}

/// A picture that `Drawer` draws in a context of its own. OpenGL errors begin with `job`.
template <class Drawer, class Drawing, class Options>
Image drawn_alone(const Drawing& drawing, const Options& options, const char* job,
                  const Progress& progress) {
  const HeadlessContext context;
  Drawer drawer;
  drawer.upload(drawing);
  Image image = drawer.draw(options, progress);
  context.check_errors(job);
  return image;
}

/// Evaluations along each side of a pixel at the picture's quality.
int shading_side(const RenderOptions& options);

/// Whether a picture is drawn in one tile.
bool is_one_tile(const RenderOptions& options);

/// Averages evaluations per pixel, adds the background and encodes as sRGB. Targets are reused.
class TiledPicture {
 public:
  /// Draws a tile into the bound target of premultiplied linear light, `shading_side` times as wide
  /// and high as the tile. The viewport is set.
  using DrawLight = std::function<void(const Target& target, const Tile& tile)>;

  /// Calls `draw_light` for every tile. Throws Cancelled.
  Image draw(const RenderOptions& options, const DrawLight& draw_light,
             const Progress& progress = {});

 private:
  static constexpr int kLargestSide = 4;

  const ShaderProgram& develop_program(int side);
  void develop(const Tile& tile, const RenderOptions& options);

  std::array<std::optional<ShaderProgram>, kLargestSide> develop_;  ///< created on demand
  GlVertexArray no_attributes_ = no_vertex_attributes();
  Target light_, finished_;
};

/// Throws Error for options out of range.
void check_options(const RenderOptions& options);

}  // namespace brindle
