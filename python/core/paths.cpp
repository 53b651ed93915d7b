#include <array>
#include <cstdint>
#include <memory>
#include <optional>
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

std::shared_ptr<ToolPaths> make_paths(const CurvesData& curves, const std::string& order,
                                      const py::dict& options) {
  const GivenOptions given(options);
  ToolPathOptions wanted;
  wanted.order = static_cast<PathOrder>(choice("--order", order));
  given("--width", wanted.width);
  given("--connect", wanted.connect);
  given("--least-radius", wanted.least_radius);
  given("--least-length", wanted.least_length);
  given("--cut-length", wanted.cut_length);
  return until_interrupted([&](const Progress& progress) {
    return std::make_shared<ToolPaths>(
        tool_paths(curves.surface->surface.mesh, curves.curves.lines, wanted, progress));
  });
}

Machine machine_of(const py::dict& options) {
  const GivenOptions given(options);
  Machine machine;
  bool is_plain = false;
  std::optional<std::array<double, 3>> place;
  given("--plain", is_plain);
  given("--axes", machine.axes);
  given("--scale", machine.unit);
  given("--place", place);
  given("--thickness", machine.thickness);
  given("--filament", machine.filament);
  given("--speed", machine.speed);
  given("--travel-speed", machine.travel_speed);
  given("--lift", machine.lift);
  if (is_plain) machine.dialect = GcodeDialect::plain;
  if (place) machine.place = Eigen::Vector3d(place->data());
  return machine;
}

py::dict path_metrics(const ToolPaths& paths) {
  const ToolPathMetrics& metrics = paths.metrics;
  py::dict result;
  result["paths"] = paths.lines.count();
  result["curves"] = metrics.curves;
  result["bends_cut"] = metrics.bends_cut;
  result["left_out"] = metrics.left_out;
  result["joins"] = metrics.joins;
  result["length"] = metrics.length;
  result["joined_length"] = metrics.joined_length;
  result["travel"] = metrics.travel;
  result["travel_nearest"] = metrics.travel_nearest;
  result["least_radius"] = metrics.least_radius;
  result["width"] = paths.width;
  return result;
}

py::dict path_columns(const ToolPaths& paths) {
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
  py::class_<ToolPaths, std::shared_ptr<ToolPaths>>(module, "Paths")
      .def("metrics", path_metrics)
      .def("columns", path_columns)
      .def(
          "write",
          [](const ToolPaths& paths, const std::string& path, const py::dict& machine) {
            const Machine wanted = machine_of(machine);
            until_interrupted([&](const Progress& progress) {
              write_tool_paths(path, paths, wanted, progress);
              return 0;
            });
          },
          py::arg("path"), py::arg("machine"));
  module.def("tool_paths", make_paths, py::arg("curves"), py::arg("order"), py::arg("options"));
}

}  // namespace brindle::python
