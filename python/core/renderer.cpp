// Pictures, for builds with OpenGL.
#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/error.h"
#include "brindle/mesh.h"
#include "brindle/normals.h"
#include "brindle/quality.h"
#include "brindle/recipe/refusals.h"
#include "brindle/render/parsed_words.h"
#include "brindle/splats.h"
#include "job.h"
#include "pattern_data.h"
#include "pictures.h"
#include "words.h"

namespace brindle::python {
namespace {

constexpr float kLargestAngleErrorDeg = 30;  // end of the angle_error scale, as in the tool

py::array array_of(Image&& image) {
  const py::ssize_t height = image.height, width = image.width;
  return owned<std::uint8_t>(std::move(image.pixels), {height, width, 4});
}

Image image_of(py::handle array) {
  if (!py::isinstance<py::array_t<std::uint8_t>>(array)) {
    throw py::type_error("image: expected an array of uint8");
  }
  refuse_masked(array, "image");
  const py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast> pixels(
      py::reinterpret_borrow<py::object>(array));
  if (pixels.ndim() != 3 || (pixels.shape(2) != 3 && pixels.shape(2) != 4)) {
    throw Error("image: expected rows of pixels of 3 or 4 channels");
  }
  check_image_size(pixels.shape(1), pixels.shape(0));
  Image image(static_cast<int>(pixels.shape(1)), static_cast<int>(pixels.shape(0)));
  const auto channels = static_cast<std::size_t>(pixels.shape(2));
  const std::uint8_t* from = pixels.data();
  for (Pixel& pixel : image.pixels) {
    pixel = {from[0], from[1], from[2], channels == 4 ? from[3] : std::uint8_t{255}};
    from += channels;
  }
  return image;
}

}  // namespace

TextureTile tile_of(py::handle tile) {
  if (!py::isinstance<py::str>(tile)) return image_of(tile);
  const auto name = py::cast<std::string>(tile);
  const auto built_in = parse_built_in_tile(name);
  if (!built_in) {
    throw Error("tile: '" + name + "' is none of " + std::string(built_in_tile_names()));
  }
  return *built_in;
}

std::optional<BrokenTiles> broken_tiles_of(const TextureData& texture, const TextureTile& tile,
                                           std::optional<bool> whole) {
  if (!whole.value_or(has_own_shape(tile))) return std::nullopt;
  return broken_tiles(texture.surface->surface.mesh.triangles, texture.waves, tile_motifs(tile));
}

namespace {

Overlay overlay_of(const std::string& view, const StripesData& data) {
  const Mesh& mesh = data.surface->surface.mesh;
  if (view == "branches") return branch_overlay(mesh, data.pattern.corners);
  if (view == "angle_error") {
    return error_overlay(angle_errors_deg(mesh, data.pattern.waves, data.pattern.corners),
                         kLargestAngleErrorDeg);
  }
  return {};
}

// Throws Error if the picture would show nothing of the mesh.
RenderOptions options_of(const Picture& picture, const Mesh& mesh) {
  const RenderOptions options = options_relative_to(mesh.origin, picture);
  check_slice_leaves_something(mesh, options);
  return picture.view == "stripes" ? options : with_faint_stripes(options);
}

Image picture_of_points(const SurfaceData& data, const StripesData* stripes,
                        const RenderOptions& options, const Progress& progress) {
  const Surface& surface = data.surface;
  const std::vector<float> radii = splat_radii(surface.mesh.positions, *surface.neighborhood);
  SplatDrawing drawing{
      .positions = surface.mesh.positions, .normals = surface.normals, .radii = radii};
  if (stripes != nullptr) {
    drawing.waves = &stripes->pattern.waves;
    drawing.z = stripes->pattern.solution.z;
  }
  return render_splats(drawing, options, progress);
}

py::array render_stripes(const SurfaceData& surface, const StripesData* stripes,
                         const Picture& picture) {
  if (surface.is_points()) {
    saying_in_pythons_words([&] { brindle::check_view_of_points(picture.view == "stripes"); });
  }
  use_unforkable(UnforkableWork::pictures);
  return array_of(until_interrupted([&](const Progress& progress) {
    const RenderOptions options = options_of(picture, surface.surface.mesh);
    if (surface.is_points()) return picture_of_points(surface, stripes, options, progress);
    SurfaceDrawing drawing{.mesh = surface.surface.mesh, .normals = surface.surface.normals};
    if (stripes == nullptr) return render_picture(drawing, options, progress);
    const Overlay overlay = overlay_of(picture.view, *stripes);
    drawing.waves = &stripes->pattern.waves;
    drawing.z = stripes->pattern.solution.z;
    drawing.triangle_colors = overlay.triangle_colors;
    drawing.marks = overlay.marks;
    return render_picture(drawing, options, progress);
  }));
}

// Throws Error for tiles without the symmetry of crosses.
void check_crosses(py::handle tile, const Picture& picture) {
  saying_in_pythons_words([&] {
    brindle::check_view_of_crosses(picture.view == "stripes");
    if (py::isinstance<py::str>(tile)) brindle::check_tile_of_crosses(py::cast<std::string>(tile));
  });
}

// 1 in triangles that a broken motif covers, or None.
py::object triangles_with_broken_tiles(const TextureData& texture, py::handle tile,
                                       std::optional<bool> whole) {
  const TextureTile chosen = tile_of(tile);
  const auto broken = without_lock([&] { return broken_tiles_of(texture, chosen, whole); });
  if (!broken) return py::none();
  std::vector<std::uint8_t> flags(texture.surface->surface.mesh.triangle_count());
  for (std::size_t t = 0; t < flags.size(); ++t) flags[t] = broken->touches(t);
  const auto count = static_cast<py::ssize_t>(flags.size());
  return owned<std::uint8_t>(std::move(flags), {count});
}

/// The image, and lines of warnings.
py::tuple render_texture(const TextureData& texture, py::handle tile, std::optional<bool> whole,
                         const Picture& picture) {
  const TextureTile chosen = tile_of(tile);
  if (texture.is_cross()) check_crosses(tile, picture);
  use_unforkable(UnforkableWork::pictures);
  std::string warnings;
  py::array image = array_of(until_interrupted([&](const Progress& progress) {
    SurfaceDrawing drawing{.mesh = texture.surface->surface.mesh,
                           .normals = texture.surface->surface.normals};
    drawing.texture_waves = &texture.waves;
    drawing.texture_tile = &chosen;
    const std::optional<BrokenTiles> broken = broken_tiles_of(texture, chosen, whole);
    if (broken) {
      drawing.broken_tiles = &*broken;
      warnings = brindle::tile_warning(*broken, drawing.mesh.triangle_count());
    }
    const Overlay overlay = texture.is_cross() ? Overlay() : overlay_of(picture.view, *texture.u);
    if (!texture.is_cross()) {
      drawing.waves = &texture.u->pattern.waves;
      drawing.z = texture.u->pattern.solution.z;
      drawing.triangle_colors = overlay.triangle_colors;
      drawing.marks = overlay.marks;
    }
    return render_picture(drawing, options_of(picture, drawing.mesh), progress);
  }));
  return py::make_tuple(image, warnings);
}

// With a single-coloured mesh on the surface: tubes along curves, discs at samples.
py::array render_ornament(const SurfaceData& data, const SurfaceData& ornament,
                          const std::string& color, const Picture& picture) {
  use_unforkable(UnforkableWork::pictures);
  const Color own = line_color(picture, color);
  return array_of(until_interrupted([&](const Progress& progress) {
    Mesh mesh = data.surface.mesh;
    std::vector<Vec3> normals = data.surface.normals;
    std::vector<TriangleColor> colors(mesh.triangle_count());
    const std::vector<Vec3> of_ornament = vertex_normals(ornament.surface.mesh);
    append(ornament.surface.mesh, mesh);
    normals.insert(normals.end(), of_ornament.begin(), of_ornament.end());
    colors.resize(mesh.triangle_count(), {own, 1});
    return render_picture({.mesh = mesh, .normals = normals, .triangle_colors = colors},
                          options_of(picture, mesh), progress);
  }));
}

}  // namespace

void bind_renderer(py::module_& module) {
  bind_relief(module);
  module.def("render", render_stripes, py::arg("surface"), py::arg("stripes").none(true),
             py::arg("picture"));
  module.def("render_texture", render_texture, py::arg("texture"), py::arg("tile"),
             py::arg("whole").none(true), py::arg("picture"));
  module.def("triangles_with_broken_tiles", triangles_with_broken_tiles, py::arg("texture"),
             py::arg("tile"), py::arg("whole").none(true));
  module.def("render_ornament", render_ornament, py::arg("surface"), py::arg("ornament"),
             py::arg("color"), py::arg("picture"));
  module.def(
      "write_png",
      [](const std::string& path, py::handle pixels) {
        const Image image = image_of(pixels);
        until_interrupted([&](const Progress& progress) { write_png(path, image, progress); });
      },
      py::arg("path"), py::arg("image"));
  module.def(
      "png_of", [](py::handle pixels) { return py::bytes(png_of(image_of(pixels))); },
      py::arg("image"));
  module.def(
      "read_png", [](const std::string& path) { return array_of(read_png(path)); },
      py::arg("path"));
  module.def(
      "tile_png",
      [](py::handle tile, const Picture& picture, bool of_crosses) {
        constexpr int kSide = 512;
        const TextureTile chosen = tile_of(tile);
        if (of_crosses) check_crosses(tile, picture);
        return py::bytes(png_of(
            tile_picture(chosen, kSide, picture.options.stripe_color, picture.options.base_color)));
      },
      py::arg("tile"), py::arg("picture"), py::arg("of_crosses"));
}

}  // namespace brindle::python
