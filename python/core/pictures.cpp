#include "pictures.h"

#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/error.h"
#include "brindle/render/parsed_words.h"
#include "brindle/render/slice_refusal.h"
#include "job.h"
#include "pattern_data.h"
#include "words.h"

namespace brindle::python {
namespace {

UpAxis up_axis(const std::string& name) {
  if (const auto up = parse_up_axis(name)) return *up;
  throw Error("up: '" + name + "' is none of x, y, z, -x, -y, -z");
}

Color color_of(const std::string& text) {
  const auto color = parse_color(text);
  if (!color)
    throw Error("colors: '" + text + "' is no colour; give one like '#1c325a' or 'steelblue'");
  return *color;
}

void set_view(Picture& picture, const std::string& view) {
  if (view != "stripes" && view != "branches" && view != "angle_error") {
    throw Error("view: '" + view + "' is none of stripes, branches, angle_error");
  }
  picture.view = view;
}

void set_camera(Picture& picture, float azimuth, float elevation, float zoom,
                const std::string& up) {
  if (!(elevation >= -90 && elevation <= 90) || !std::isfinite(azimuth)) {
    throw Error("camera: give azimuth and elevation in degrees, elevation from -90 to 90");
  }
  if (!(zoom >= 0.01f && zoom <= 10000)) throw Error("camera: give a zoom from 0.01 to 10000");
  picture.options.camera = {azimuth, elevation, zoom, up_axis(up)};
}

void set_side(Picture& picture, const std::string& text, const std::string& up) {
  const auto view = parse_camera_view(text, up_axis(up));
  if (!view)
    throw Error("camera: expected " + std::string(kCameraViewForm) + "; got '" + text + "'");
  picture.options.camera = *view;
}

void set_projection(Picture& picture, const std::string& word) {
  if (word != "perspective" && word != "orthographic") {
    throw Error("projection: '" + word + "' is none of perspective, orthographic");
  }
  picture.options.camera.projection =
      word == "perspective" ? Projection::perspective : Projection::orthographic;
}

void set_light_from(Picture& picture, float azimuth, float elevation) {
  if (!(elevation >= -90 && elevation <= 90) || !std::isfinite(azimuth)) {
    throw Error("light_from: give azimuth and elevation in degrees, elevation from -90 to 90");
  }
  picture.options.light_from = {azimuth, elevation};
}

void set_slice(Picture& picture, const std::string& text) {
  picture.slice = parse_slice(text);
  if (picture.slice) return;
  throw Error(
      "slice: expected 'AXIS=PLACE' such as 'x=0.2', 'z=50%' or '-z=50%', or "
      "'X,Y,Z,NX,NY,NZ', got '" +
      text + "'");
}

void set_size(Picture& picture, int width, int height) {
  check_image_size(width, height);
  picture.options.width = width;
  picture.options.height = height;
}

void set_colors(Picture& picture, const std::vector<std::string>& colors) {
  if (colors.size() < 2 || colors.size() > 3) {
    throw Error("colors: give those of stripes, surface and, if you like, background");
  }
  picture.options.stripe_color = color_of(colors[0]);
  picture.own_colors = true;
  picture.options.base_color = color_of(colors[1]);
  if (colors.size() == 3) {
    picture.options.background_center = picture.options.background_edge = color_of(colors[2]);
  }
}

void set_stripe_width(Picture& picture, float width) {
  if (!(width >= 0 && width <= 1)) throw Error("stripe_width: give a share of the period, 0 to 1");
  picture.options.stripe_width = width;
}

}  // namespace

RenderOptions options_relative_to(const Eigen::Vector3d& origin, const Picture& picture) {
  RenderOptions options = picture.options;
  options.camera.slice = picture.slice;
  if (picture.slice && !picture.slice->in_shares) options.camera.slice->point -= origin;
  return options;
}

void check_slice_leaves_something(const Mesh& mesh, const RenderOptions& options) {
  saying_in_pythons_words([&] { check_slice(mesh, options); });
}

Color line_color(const Picture& picture, const std::string& standard) {
  return picture.own_colors ? picture.options.stripe_color : color_of(standard);
}

void bind_pictures(py::module_& module) {
  py::class_<Picture>(module, "Picture")
      .def(py::init<>())
      .def("set_camera", set_camera, py::arg("azimuth"), py::arg("elevation"), py::arg("zoom"),
           py::arg("up"))
      .def("set_side", set_side, py::arg("side"), py::arg("up"))
      .def("set_projection", set_projection, py::arg("projection"))
      .def("set_light_from", set_light_from, py::arg("azimuth"), py::arg("elevation"))
      .def("set_slice", set_slice, py::arg("slice"))
      .def("set_size", set_size, py::arg("width"), py::arg("height"))
      .def("set_colors", set_colors, py::arg("colors"))
      .def("set_view", set_view, py::arg("view"))
      .def("set_stripe_width", set_stripe_width, py::arg("width"))
      .def(
          "set_light",
          [](Picture& picture, bool shading, bool transparent) {
            picture.options.shading = shading;
            picture.options.transparent = transparent;
          },
          py::arg("shading"), py::arg("transparent"));
#ifdef BRINDLE_HAS_GL
  module.attr("has_opengl") = true;
  bind_renderer(module);
#else
  module.attr("has_opengl") = false;
  for (const char* name : {"render", "render_texture", "triangles_with_broken_tiles",
                           "render_ornament", "write_png", "read_png", "png_of", "tile_png"}) {
    module.def(name, [](const py::args&, const py::kwargs&) {
      throw Error("this build draws no pictures; configure with -DBRINDLE_GL=ON to have them");
    });
  }
#endif
}

}  // namespace brindle::python
