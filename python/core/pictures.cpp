#include "pictures.h"

#include <tuple>
#include <utility>

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

Color color_of(const std::string& text) {
  if (const auto color = parse_color(text)) return *color;
  throw Error("colors: '" + text + "' is no colour; give one like '#1c325a' or 'steelblue'");
}

// What `parse` makes of a text that was given.
template <class Parse>
auto parsed(const GivenOptions& given, const char* option, const Parse& parse,
            const std::string& form) {
  std::string text;
  given(option, text);
  auto result = text.empty() ? decltype(parse(text))() : parse(text);
  if (result || text.empty()) return result;
  throw Error(
      in_pythons_words(std::string(option) + ": expected " + form + ", got '" + text + "'"));
}

void set_colors(Picture& picture, const std::vector<std::string>& colors) {
  if (colors.empty()) return;
  if (colors.size() == 1 || colors.size() > 3) {
    throw Error("colors: give those of stripes, surface and, if you like, background");
  }
  picture.own_colors = true;
  picture.options.stripe_color = color_of(colors[0]);
  picture.options.base_color = color_of(colors[1]);
  if (colors.size() == 3) {
    picture.options.background_center = picture.options.background_edge = color_of(colors[2]);
  }
}

// Words and numbers that are rows of options were checked in Python.
Picture picture_of(const py::dict& options) {
  const GivenOptions given(options);
  Picture picture;
  RenderOptions& made = picture.options;
  std::pair<int, int> size(made.width, made.height);
  given("--size", size);
  check_image_size(size.first, size.second);
  std::tie(made.width, made.height) = size;
  UpAxis up = UpAxis::y;
  given("--up", up, parse_up_axis);
  const auto camera = parsed(
      given, "--camera", [&](const std::string& text) { return parse_camera_view(text, up); },
      kCameraViewForm);
  if (camera) made.camera = *camera;
  std::string projection;
  given("--projection", projection);
  if (projection == "orthographic") made.camera.projection = Projection::orthographic;
  picture.slice = parsed(given, "--slice", parse_slice,
                         "'AXIS=PLACE' such as 'x=0.2', 'z=50%' or '-z=50%', or 'X,Y,Z,NX,NY,NZ'");
  const auto light = parsed(given, "--light-from", parse_light_direction,
                            "azimuth and elevation in degrees, elevation from -90 to 90");
  if (light) made.light_from = *light;
  std::vector<std::string> colors;
  given("--colors", colors);
  set_colors(picture, colors);
  given("--view", picture.view);
  given("--stripe-width", made.stripe_width);
  given("--transparent", made.transparent);
  given("--shading", made.shading);
  return picture;
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
  py::class_<Picture>(module, "Picture").def(py::init(&picture_of), py::arg("options"));
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
