#include "pictures.h"

#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/error.h"
#include "brindle/line_drawing.h"
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
  picture.options.base_color = color_of(colors[1]);
  if (colors.size() == 3) {
    picture.options.background_center = picture.options.background_edge = color_of(colors[2]);
  }
}

void set_stripe_width(Picture& picture, float width) {
  if (!(width >= 0 && width <= 1)) throw Error("stripe_width: give a share of the period, 0 to 1");
  picture.options.stripe_width = width;
}

// A drawing without hidden lines: each pen has lists of lines, by points and offsets.
struct HeldLines {
  Polylines lines;
  std::string name;
  Color color;
};

HeldLines pen_lines(const std::string& name, const std::string& color, py::handle points,
                    py::handle offsets, py::handle closed) {
  HeldLines pen{{}, name, color_of(color)};
  pen.lines.points = vectors_of(table_of(points, "points").view, "points");
  const std::vector<float> marks = numbers_of(table_of(closed, "closed").view, "closed");
  const py::array_t<Index, py::array::c_style | py::array::forcecast> rows(
      py::reinterpret_borrow<py::object>(offsets));
  pen.lines.offsets.assign(rows.data(), rows.data() + rows.size());
  for (const float mark : marks) pen.lines.closed.push_back(mark != 0 ? 1 : 0);
  if (pen.lines.offsets.size() != marks.size() + 1 ||
      pen.lines.offsets.back() != pen.lines.points.size()) {
    throw Error("lines: offsets and points do not belong together");
  }
  return pen;
}

void draw_lines(const std::string& path, const SurfaceData& data,
                const std::vector<HeldLines>& pens, const Picture& picture) {
  if (path.ends_with(".pdf")) {
    throw Error("cannot draw '" + path +
                "': a drawing is an .svg here; brindle curves writes .pdf");
  }
  const Surface& surface = data.surface;
  const RenderOptions options = options_relative_to(surface.mesh.origin, picture);
  check_slice_leaves_something(surface.mesh, options);
  std::vector<PenLines> lines;
  for (const HeldLines& pen : pens) lines.push_back({pen.name, pen.color, pen.lines});
  until_interrupted([&](const Progress& progress) {
    const std::vector<Pen> drawn =
        line_drawing(surface.mesh, surface.normals, lines, options.camera, options.width,
                     options.height, progress.part(0, 0.8));
    write_svg(path, options.width, options.height, drawn, progress.part(0.8, 1));
  });
}

Ornament ornament(py::handle vertices, py::handle triangles, const std::string& color) {
  const Table positions = table_of(vertices, "vertices");
  const Table corners = table_of(triangles, "triangles");
  Ornament made{make_mesh(positions.view, corners.view, BadTriangles::kept), color_of(color)};
  return made;
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
      .def_property(
          "transparent", [](const Picture& picture) { return picture.options.transparent; },
          [](Picture& picture, bool value) { picture.options.transparent = value; })
      .def_property(
          "shading", [](const Picture& picture) { return picture.options.shading; },
          [](Picture& picture, bool value) { picture.options.shading = value; });
  py::class_<HeldLines>(module, "PenLines")
      .def(py::init(&pen_lines), py::arg("name"), py::arg("color"), py::arg("points"),
           py::arg("offsets"), py::arg("closed"));
  py::class_<Ornament>(module, "Ornament")
      .def(py::init(&ornament), py::arg("vertices"), py::arg("triangles"), py::arg("color"));
  module.def("draw_lines", draw_lines, py::arg("path"), py::arg("surface"), py::arg("pens"),
             py::arg("picture"));
  bind_renderer(module);
}

}  // namespace brindle::python
