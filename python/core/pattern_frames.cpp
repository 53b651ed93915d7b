#include "brindle/pattern_frames.h"

#include <atomic>
#include <cmath>
#include <limits>
#include <memory>

#include "arrays.h"
#include "brindle/error.h"
#include "brindle/waves/parsed_words.h"
#include "frame_waves.h"
#include "job.h"
#include "pattern_data.h"

namespace brindle::python {
namespace {

// One frame at a time; concurrent calls are rejected.
struct PatternFramesData {
  SurfacePointer surface;
  PatternFrames frames;
  std::atomic<bool> busy{false};

  explicit PatternFramesData(SurfacePointer on)
      : surface(std::move(on)),
        frames(without_lock([&] { return PatternFrames(surface->surface); })) {}
};

// A frame as an animator had it and gave it. The arrays must stay.
struct ShownFrame {
  FrameIn in;
  std::vector<Complex> z;
  FrameResult result;

  ShownFrame(PatternFramesData& data, py::handle phases, py::handle directions,
             py::handle frequencies, py::handle positions, py::handle normals = py::none())
      : in(
            data.surface->surface, [&](auto places) { return data.frames.normals(places); },
            MovedNormals::left_out, directions, frequencies, positions, normals),
        z(phases_of(phases, data.surface->surface.mesh, "phases")) {
    result.z = z;
  }
};

// `out` if given, else a new array.
py::array_t<float> float_array(py::handle out, std::size_t rows, std::size_t columns) {
  const auto size = [](std::size_t count) { return static_cast<py::ssize_t>(count); };
  if (out.is_none()) return py::array_t<float>({size(rows), size(columns)});
  if (!py::isinstance<py::array_t<float, py::array::c_style>>(out)) {
    throw py::type_error("out: expected a packed array of float32");
  }
  auto array = py::reinterpret_borrow<py::array_t<float>>(out);
  if (array.ndim() != 2 || array.shape(0) != size(rows) || array.shape(1) != size(columns) ||
      !array.writeable()) {
    throw Error("out: expected an array (" + std::to_string(rows) + ", " + std::to_string(columns) +
                ") that can be written to");
  }
  return array;
}

py::array vertices_of(PatternFramesData& data, py::handle phases, py::handle directions,
                      py::handle frequencies, py::handle positions, py::handle normals,
                      py::handle out) {
  const OneAtATime alone(data.busy, "this object");
  const ShownFrame frame(data, phases, directions, frequencies, positions, normals);
  const std::size_t count = data.surface->surface.mesh.vertex_count();
  py::array_t<float> array = float_array(out, count, 12);
  // A PatternVertex is twelve floats, and has the alignment of float.
  const std::span vertices(reinterpret_cast<PatternVertex*>(array.mutable_data()), count);
  without_lock([&] { data.frames.fill(frame.in.input(), frame.result, vertices); });
  return array;
}

py::array corner_phases_of(PatternFramesData& data, py::handle phases, py::handle directions,
                           py::handle frequencies, py::handle positions,
                           const std::string& phase_shift, py::handle out) {
  const OneAtATime alone(data.busy, "this object");
  const auto kind = parse_phase_shift_kind(phase_shift);
  if (!kind) throw Error("phase_shift: '" + phase_shift + "' is none");
  const ShownFrame frame(data, phases, directions, frequencies, positions);
  py::array_t<float> array = float_array(out, data.surface->surface.mesh.triangle_count(), 3);
  float* next = array.mutable_data();
  without_lock([&] {
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    for (const CornerPhases& corners : data.frames.corners(frame.in.input(), frame.result, *kind)) {
      for (const float phase : corners.phase) *next++ = is_lifted(corners.kind) ? phase : kNone;
    }
  });
  return array;
}

py::array normals_of(PatternFramesData& data, py::handle positions) {
  const OneAtATime alone(data.busy, "this object");
  const RowsIn<Vec3> positions_in(positions, data.surface->surface.mesh, "positions");
  return owned(without_lock([&] {
    const std::span<const Vec3> normals = data.frames.normals(positions_in.rows());
    return std::vector<Vec3>(normals.begin(), normals.end());
  }));
}

// Kinds stay 0: shaders compute them from the corners.
py::array triangles_of(const PatternFramesData& data) {
  std::vector<std::uint32_t> numbers;
  for (const Triangle& t : data.surface->surface.mesh.triangles) {
    numbers.insert(numbers.end(), {t[0], t[1], t[2], 0});
  }
  const auto rows = static_cast<py::ssize_t>(numbers.size() / 4);
  return owned<std::uint32_t>(std::move(numbers), {rows, 4});
}

}  // namespace

void bind_pattern_frames(py::module_& module) {
  py::class_<PatternFramesData>(module, "PatternFrames")
      .def(py::init<SurfacePointer>(), py::arg("surface").none(false))
      .def("normals", normals_of, py::arg("positions"))
      .def("triangles", triangles_of)
      .def("vertices", vertices_of, py::arg("phases"), py::arg("directions"),
           py::arg("frequencies"), py::arg("positions"), py::arg("normals"), py::arg("out"))
      .def("corner_phases", corner_phases_of, py::arg("phases"), py::arg("directions"),
           py::arg("frequencies"), py::arg("positions"), py::arg("phase_shift"), py::arg("out"));
}

}  // namespace brindle::python
