#include "preparation.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/points.h"
#include "make_waves.h"

namespace brindle::tool {
namespace {

std::vector<std::int64_t> original_ids_of(const LoadedSurface& loaded) {
  std::vector<std::int64_t> ids(loaded.mesh.vertex_count(), -1);
  if (!loaded.renumbered) {
    const auto end = ids.begin() + static_cast<std::ptrdiff_t>(loaded.own_vertices);
    std::iota(ids.begin(), end, std::int64_t{0});
    return ids;
  }
  for (std::size_t row = loaded.vertex_of_row.size(); row-- > 0;) {
    ids[loaded.vertex_of_row[row]] = static_cast<std::int64_t>(row);
  }
  return ids;
}

// Loads a surface into `result`, with the time that takes.
void prepare_mesh(Preparation& result, const SurfaceOptions& options, ProgressDisplay& display) {
  Stopwatch watch;
  LoadedSurface loaded = load_mesh(options, display.progress());
  display.note(describe(loaded));
  result.original_ids = original_ids_of(loaded);
  result.vertices_joined = loaded.repair.vertices_joined;
  result.vertices_not_finite = loaded.repair.vertices_not_finite;
  if (!loaded.renumbered) result.partners = loaded.vertex_of_row;
  // A row of a field for every vertex of the file says nothing of vertices that were added.
  if (options.subdivide == 0) result.vertex_of_row = std::move(loaded.vertex_of_row);
  result.arrays = std::move(loaded.arrays);
  result.load_milliseconds = watch.lap();
  display.stage("neighbourhood and normals");
  result.surface = make_surface(std::move(loaded.mesh));
  result.topology_milliseconds = watch.lap();
}

void prepare_points(Preparation& result, const SurfaceOptions& options, ProgressDisplay& display) {
  Stopwatch watch;
  LoadedPoints loaded = load_points(options);
  display.note(describe_kind(options) + describe(loaded));
  result.points = true;
  result.partners = std::move(loaded.first_at_place);
  result.vertices_joined = loaded.repair.repeated;
  result.original_ids.resize(loaded.cloud.positions.size());
  std::iota(result.original_ids.begin(), result.original_ids.end(), std::int64_t{0});
  result.arrays.points = std::move(loaded.arrays);
  result.load_milliseconds = watch.lap();
  display.stage("neighbours and normals of points");
  const std::size_t used = loaded.cloud.used.size();
  result.surface =
      make_point_surface(std::move(loaded.cloud), options.neighbors.value_or(kDefaultNeighbors));
  const auto with_normal = static_cast<std::size_t>(
      std::ranges::count_if(result.surface.normals, [](const Vec3& n) { return !n.isZero(0); }));
  if (with_normal < used) {
    display.note(std::to_string(used - with_normal) +
                 " points whose neighbours lie on a line: kept, without a wave\n");
  }
  result.topology_milliseconds = watch.lap();
}

}  // namespace

WaveFigures noted_waves(const Surface& surface, const WaveSet& waves, const std::string& source,
                        ProgressDisplay& display, const MissingWaves& missing) {
  WaveFigures figures = measure_waves(surface, waves);
  figures.missing = missing;
  check_waves(figures, source);
  display.note(warnings(figures, source));
  return figures;
}

Preparation prepare(const SurfaceOptions& surface, const WaveOptions& waves,
                    ProgressDisplay& display) {
  if (needs_own_arrays(waves) && is_shape(surface)) {
    throw CLI::ValidationError("array:NAME",
                               "built-in shapes have no arrays; name a file that "
                               "does, as MESH or with --field-mesh");
  }
  Preparation result;
  display.stage("loading " + surface.mesh);
  is_points(surface) ? prepare_points(result, surface, display)
                     : prepare_mesh(result, surface, display);

  Stopwatch watch;
  display.stage("direction field");
  WavesAndCrossing made =
      make_waves(result.surface, waves, {surface.mesh, result.arrays, result.vertex_of_row});
  display.note(made.notes);
  result.waves = std::move(made.waves);
  result.frequencies_v = std::move(made.frequencies_v);
  result.field_rows_nonfinite = made.field_rows_nonfinite;
  result.load_milliseconds += watch.lap();
  result.figures =
      noted_waves(result.surface, result.waves, source_of(waves), display, made.missing);
  return result;
}

}  // namespace brindle::tool
