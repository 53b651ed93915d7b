#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/error.h"
#include "brindle/surface.h"
#include "brindle/windings.h"
#include "job.h"
#include "pattern_data.h"

namespace brindle::python {
namespace {

py::list loops_of(const SurfaceData& data) {
  py::list result;
  for (SurfaceLoop& loop : without_lock([&] { return surface_loops(data.surface); })) {
    const auto count = static_cast<py::ssize_t>(loop.vertices.size());
    result.append(py::make_tuple(loop.name, loop.boundary,
                                 owned<std::int32_t>(std::move(loop.vertices), {count}),
                                 loop.length, loop.component));
  }
  return result;
}

py::dict windings_of(const StripesData& data) {
  const Surface& surface = data.surface->surface;
  const auto [loops, numbers] = without_lock([&] {
    std::vector<SurfaceLoop> found = surface_loops(surface);
    std::vector<Winding> counted = windings(surface, found, data.pattern);
    return std::pair(std::move(found), std::move(counted));
  });
  py::dict result;
  for (std::size_t i = 0; i < loops.size(); ++i) result[py::str(loops[i].name)] = numbers[i];
  return result;
}

py::tuple waves_round_loop(const SurfaceData& data, py::handle reference, const std::string& loop,
                           int periods) {
  const RowsIn<Vec3> rows(reference, data.surface.mesh, "reference");
  const DirectionField directions(rows.rows().begin(), rows.rows().end());
  WaveSet waves = without_lock([&] {
    return waves_round(data.surface, directions, {loop, periods});
  });
  return py::make_tuple(owned(std::move(waves.directions)), owned(std::move(waves.frequencies)));
}

}  // namespace

void bind_loops(py::module_& module) {
  module.def("loops", loops_of, py::arg("surface"));
  module.def("windings", windings_of, py::arg("stripes"));
  module.def("waves_around", waves_round_loop, py::arg("surface"), py::arg("reference"),
             py::arg("loop"), py::arg("periods"));
}

}  // namespace brindle::python
