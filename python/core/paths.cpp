#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/tool_paths.h"
#include "job.h"
#include "pattern_data.h"
#include "words.h"

namespace brindle::python {
namespace {

struct PathsData {
  SurfacePointer surface;
  ToolPaths paths;
};

template <class Number>
using Packed = py::array_t<Number, py::array::c_style | py::array::forcecast>;

/// Arrays of the package's own curves, which need no checks.
Polylines lines_of_arrays(const SurfaceData& surface, const Packed<float>& points,
                          const Packed<float>& normals, const Packed<std::int32_t>& offsets,
                          const Packed<bool>& closed) {
  Polylines lines;
  lines.origin = surface.surface.mesh.origin;
  const auto at = [](const Packed<float>& rows, py::ssize_t i) {
    return Vec3(rows.at(i, 0), rows.at(i, 1), rows.at(i, 2));
  };
  for (py::ssize_t line = 0; line < closed.size(); ++line) {
    for (py::ssize_t i = offsets.at(line); i < offsets.at(line + 1); ++i) {
      lines.add(at(points, i), at(normals, i));
    }
    lines.end_line(closed.at(line));
  }
  return lines;
}

std::shared_ptr<PathsData> make_paths(const SurfacePointer& surface, const Packed<float>& points,
                                      const Packed<float>& normals,
                                      const Packed<std::int32_t>& offsets,
                                      const Packed<bool>& closed, const std::string& order,
                                      const ToolPathOptions& given) {
  const Polylines lines = lines_of_arrays(*surface, points, normals, offsets, closed);
  ToolPathOptions options = given;
  options.order = static_cast<PathOrder>(choice("--order", order));
  return until_interrupted([&](const Progress& progress) {
    return std::make_shared<PathsData>(
        PathsData{surface, tool_paths(surface->surface.mesh, lines, options, progress)});
  });
}

py::dict path_metrics(const PathsData& data) {
  const ToolPathMetrics& metrics = data.paths.metrics;
  py::dict result;
  result["paths"] = data.paths.lines.count();
  result["curves"] = metrics.curves;
  result["bends_cut"] = metrics.bends_cut;
  result["left_out"] = metrics.left_out;
  result["joins"] = metrics.joins;
  result["length"] = metrics.length;
  result["joined_length"] = metrics.joined_length;
  result["travel"] = metrics.travel;
  result["travel_nearest"] = metrics.travel_nearest;
  result["least_radius"] = metrics.least_radius;
  result["width"] = data.paths.width;
  return result;
}

py::dict path_columns(const PathsData& data) {
  const ToolPaths& paths = data.paths;
  const auto copied = [](auto rows) { return owned(std::move(rows)); };
  py::dict result;
  result["points"] = copied(paths.lines.points);
  result["normals"] = copied(paths.lines.normals);
  result["directions"] = copied(paths.directions);
  result["offsets"] =
      copied(std::vector<std::int32_t>(paths.lines.offsets.begin(), paths.lines.offsets.end()));
  result["widths"] = copied(paths.widths);
  result["joins"] = copied(paths.joined);
  result["cuts"] = copied(paths.cut);
  std::vector<Eigen::Vector4f> poses = path_poses(paths);
  const auto count = static_cast<py::ssize_t>(poses.size());
  result["poses"] = owned<float>(std::move(poses), {count, 4});
  return result;
}

}  // namespace

void bind_paths(py::module_& module) {
  py::class_<ToolPathOptions>(module, "PathOptions")
      .def(py::init<>())
      .def_readwrite("width", &ToolPathOptions::width)
      .def_readwrite("connect", &ToolPathOptions::connect)
      .def_readwrite("least_radius", &ToolPathOptions::least_radius)
      .def_readwrite("least_length", &ToolPathOptions::least_length)
      .def_readwrite("cut_length", &ToolPathOptions::cut_length);
  py::class_<Machine>(module, "Machine")
      .def(py::init<>())
      .def_property(
          "extrudes", [](const Machine& m) { return m.dialect == GcodeDialect::marlin; },
          [](Machine& m, bool extrudes) {
            m.dialect = extrudes ? GcodeDialect::marlin : GcodeDialect::plain;
          })
      .def_readwrite("axes", &Machine::axes)
      .def_readwrite("unit", &Machine::unit)
      .def(
          "set_place",
          [](Machine& m, double x, double y, double z) { m.place = Eigen::Vector3d(x, y, z); },
          py::arg("x"), py::arg("y"), py::arg("z"))
      .def_readwrite("thickness", &Machine::thickness)
      .def_readwrite("filament", &Machine::filament)
      .def_readwrite("speed", &Machine::speed)
      .def_readwrite("travel_speed", &Machine::travel_speed)
      .def_readwrite("lift", &Machine::lift);
  py::class_<PathsData, std::shared_ptr<PathsData>>(module, "Paths")
      .def("metrics", path_metrics)
      .def("columns", path_columns)
      .def(
          "write",
          [](const PathsData& data, const std::string& path, const Machine& machine) {
            until_interrupted([&](const Progress& progress) {
              write_tool_paths(path, data.paths, machine, progress);
              return 0;
            });
          },
          py::arg("path"), py::arg("machine"));
  module.def("tool_paths", make_paths, py::arg("surface"), py::arg("points"), py::arg("normals"),
             py::arg("offsets"), py::arg("closed"), py::arg("order"), py::arg("options"));
}

}  // namespace brindle::python
