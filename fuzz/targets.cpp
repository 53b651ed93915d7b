#include "targets.h"

#include <algorithm>
#include <functional>

#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/vtk/pvtp_file.h"
#include "fuzzed_pattern.h"
#include "promises.h"
#include "scratch.h"
#ifdef BRINDLE_FUZZ_SESSIONS
#include "fuzzed_session.h"
#endif

namespace brindle::fuzz {
namespace {

void check_arrays(const DataArrays& arrays, std::size_t points, std::size_t cells) {
  for (const DataArray& array : arrays.points) {
    promise(array.rows() == points, "an array has a row for each vertex");
  }
  for (const DataArray& array : arrays.cells) {
    promise(array.rows() == cells, "an array has a row for each triangle");
  }
}

void promise_mesh(const Mesh& mesh) {
  for (const Triangle& triangle : mesh.triangles) {
    for (const Index corner : triangle) {
      promise(corner < mesh.vertex_count(), "corners are vertices");
      promise(mesh.positions[corner].allFinite(), "corners of triangles are finite");
    }
    promise(triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0],
            "triangles have three corners");
  }
  promise(mesh.triangle_count() > 0, "a mesh has triangles");
}

void read_a_mesh(const Target& target, std::span<const std::uint8_t> bytes) {
  const auto path = scratch_file("input." + std::string(target.name), bytes);
  const bool points_alone = is_point_file(path);
  if (points_alone) {
    const LoadedPoints points = read_points(path);
    check_arrays({points.arrays, {}}, points.cloud.positions.size(), 0);
    return;
  }
  const LoadedMesh loaded = read_mesh(path);
  promise_mesh(loaded.mesh);
  check_arrays(loaded.arrays, loaded.mesh.vertex_count(), loaded.mesh.triangle_count());
  for (const Index vertex : loaded.vertex_of_row) {
    promise(vertex < loaded.mesh.vertex_count(), "rows are of vertices");
  }
  const auto again = scratch_path("again.vtp");
  write_mesh(again, loaded.mesh, loaded.arrays.points, loaded.arrays.cells);
  const LoadedMesh copy = read_mesh(again);
  promise(copy.mesh.triangle_count() == loaded.mesh.triangle_count(),
          "what was read can be written and read again");
}

void read_csv_points(const Target&, std::span<const std::uint8_t> bytes) {
  const LoadedPoints points = read_points(scratch_file("input.csv", bytes));
  promise(!points.cloud.positions.empty(), "there are points");
  check_arrays({points.arrays, {}}, points.cloud.positions.size(), 0);
}

void read_a_field(const Target&, std::span<const std::uint8_t> bytes) {
  const FieldFile field = read_field_csv(scratch_file("field.csv", bytes), 4);
  promise(field.vectors.size() == 4, "a vector for each vertex");
  promise(field.frequencies.empty() || field.frequencies.size() == 4,
          "a frequency for each vertex");
  for (const float frequency : field.frequencies) {
    promise(!(frequency <= 0), "frequencies are above zero");
  }
}

void read_some_strokes(const Target&, std::span<const std::uint8_t> bytes) {
  const auto path = scratch_file("strokes.json", bytes);
  const std::vector<FieldStroke> strokes = read_strokes(path);
  promise(!strokes.empty(), "there are strokes");
  const auto again = scratch_path("again.json");
  write_strokes(again, strokes);
  promise(read_strokes(again).size() == strokes.size(), "strokes are read again");
}

void read_a_collection(const Target& target, std::span<const std::uint8_t> bytes) {
  const auto path = scratch_file("input." + std::string(target.name), bytes);
  if (target.name == "pvtp") {
    promise(!read_pvtp(path).pieces.empty(), "a list names a piece");
    return;
  }
  const auto files = target.name == "pvd" ? read_pvd(path) : read_file_series(path);
  promise(!files.empty(), "a series lists a file");
  promise(std::ranges::is_sorted(files, std::less(), &TimedFile::time), "times ascend");
}

template <void (*feed)(std::span<const std::uint8_t>)>
void pass_on(const Target&, std::span<const std::uint8_t> bytes) {
  feed(bytes);
}

constexpr Target kTargets[] = {{"ply", read_a_mesh},
                               {"obj", read_a_mesh},
                               {"stl", read_a_mesh},
                               {"off", read_a_mesh},
                               {"gltf", read_a_mesh},
                               {"glb", read_a_mesh},
                               {"vtp", read_a_mesh},
                               {"vtu", read_a_mesh},
                               {"vtk", read_a_mesh},
                               {"pvd", read_a_collection},
                               {"series", read_a_collection},
                               {"pvtp", read_a_collection},
                               {"csv", read_csv_points},
                               {"field", read_a_field},
                               {"strokes", read_some_strokes},
#ifdef BRINDLE_FUZZ_SESSIONS
                               {"session", pass_on<run_session>},
                               {"commands", pass_on<run_commands>},
                               {"operations", pass_on<run_operations>},
#endif
                               {"pattern", pass_on<run_pattern>}};

}  // namespace

void promise(bool kept, const char* what) {
  if (!kept) throw BrokenPromise{what};
}

std::span<const Target> targets() { return kTargets; }

const Target* find_target(std::string_view name) {
  const auto* found = std::ranges::find(kTargets, name, &Target::name);
  return found == std::end(kTargets) ? nullptr : found;
}

bool run(const Target& target, std::span<const std::uint8_t> bytes) {
  try {
    target.run(target, bytes);
    return true;
  } catch (const Error& error) {
    promise(std::string_view(error.what()).size() > 3, "an error says what is wrong");
    return false;
  }
}

}  // namespace brindle::fuzz
