#include "input/preparation.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

#include "brindle/base/array_numbers.h"
#include "brindle/base/memory.h"
#include "brindle/base/stopwatch.h"
#include "brindle/base/text.h"
#include "brindle/creases.h"
#include "brindle/error.h"
#include "brindle/local_positions.h"
#include "brindle/mesh_data.h"
#include "brindle/normals.h"
#include "brindle/points.h"
#include "brindle/shapes.h"

namespace brindle::tool {
namespace {

constexpr const char* kNeighborhood = "neighbourhood and normals";
constexpr const char* kNeighborhoodOfPoints = "neighbours and normals of points";
constexpr const char* kField = "direction field";
constexpr const char* kLids = "--lids";

std::vector<bool> marked(const std::string& file, std::size_t triangles) {
  const std::vector<DataArray> columns = read_csv_arrays(file);
  if (columns.size() != 1 || columns[0].components != 1) {
    throw Error(shown(file) + ": lids are one column of 0 and 1, and it has others");
  }
  const std::vector<double> numbers = doubles_of(columns[0].view());
  if (numbers.size() != triangles) {
    throw Error(shown(file) + ": it has " + std::to_string(numbers.size()) +
                " rows for lids, and the mesh has " + std::to_string(triangles) + " triangles");
  }
  std::vector<bool> lids;
  for (std::size_t t = 0; t < numbers.size(); ++t) {
    if (numbers[t] != 0 && numbers[t] != 1) {
      throw Error(shown(file) + ": lids are 1 and others 0; row " + std::to_string(t + 1) +
                  " is neither");
    }
    lids.push_back(numbers[t] == 1);
  }
  return lids;
}

std::vector<bool> level(const Lids& lids, const Mesh& mesh) {
  const float least = std::cos(*lids.degrees * std::numbers::pi_v<float> / 180);
  std::vector<bool> result;
  for (const Triangle& t : mesh.triangles) {
    result.push_back(std::abs(triangle_normal(mesh, t).stableNormalized().dot(lids.up)) > least);
  }
  return result;
}

/// Removes the triangles of lids. Throws Error if the file does not fit, and unless some triangles
/// are lids and some are not.
void leave_out(const Lids& lids, LoadedMesh& loaded) {
  Mesh& mesh = loaded.mesh;
  const std::vector<bool> out =
      lids.degrees ? level(lids, mesh) : marked(lids.file, mesh.triangle_count());
  std::vector<Index> kept;
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < out.size(); ++t) {
    if (out[t]) continue;
    kept.push_back(static_cast<Index>(t));
    triangles.push_back(mesh.triangles[t]);
  }
  if (kept.size() == out.size()) {
    throw Error(std::string(kLids) + ": no face is a lid; take a larger angle or leave it out");
  }
  if (kept.empty()) throw Error(std::string(kLids) + ": all faces are lids; take a smaller angle");
  mesh.triangles = std::move(triangles);
  loaded.arrays.cells = rows_of(loaded.arrays.cells, kept);
}

Mesh make_named_shape(const SurfaceOptions& options, const Progress& progress) {
  try {
    return make_shape(shape_spec(options), progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const TooLarge&) {
    throw;  // correct usage, but too little memory
  } catch (const Error& error) {
    throw CLI::ValidationError("MESH", error.what());
  }
}

/// A missing file may be the name of a shape.
void check_exists(const SurfaceOptions& options) {
  std::error_code ignored;
  if (is_shape(options) || std::filesystem::exists(options.mesh, ignored)) return;
  const std::string shape = nearest(options.mesh.substr(0, options.mesh.find(',')), shape_names());
  if (shape.empty()) return;
  throw Error(shown(options.mesh) + ": there is no such file; did you mean " +
              std::string(kShapePrefix) + shape + "?");
}

}  // namespace

std::string describe(const LoadedPoints& loaded) {
  return describe_origin(loaded.cloud.origin) + loaded.left_out + describe(loaded.repair);
}

std::string describe(const LoadedMesh& loaded) {
  return describe_origin(loaded.mesh.origin) + loaded.left_out + describe(loaded.repair);
}

LoadedPoints load_points(const SurfaceOptions& options) {
  check_exists(options);
  if (options.subdivide > 0) {
    throw CLI::ValidationError("--subdivide", "points have no triangles to split");
  }
  if (options.crease_angle) {
    throw CLI::ValidationError("--crease-angle", "points have no edges");
  }
  return is_shape(options) ? make_point_cloud(make_named_shape(options, {}).positions)
                           : file_of(options).points();
}

LoadedSurface load_mesh(const SurfaceOptions& options, const Progress& progress) {
  if (options.neighbors) {
    throw CLI::ValidationError("--neighbors",
                               "a mesh's vertices are joined by its edges; add --points to take "
                               "them as points");
  }
  if (options.rounded && options.subdivide == 0) {
    throw CLI::ValidationError("--rounded",
                               "bends triangles that are split, and none is; try --subdivide 2");
  }
  check_exists(options);
  JobStages stages(progress, {{"reading", 3}, {"subdividing", 2}});
  const Progress reading = stages.begin("reading");
  LoadedSurface loaded;
  if (is_shape(options)) {
    loaded.mesh = make_named_shape(options, reading);
  } else {
    static_cast<LoadedMesh&>(loaded) = file_of(options).mesh(reading);
  }
  if (!options.moved.isZero(0)) translate(loaded.mesh, options.moved);
  if (options.lids) leave_out(*options.lids, loaded);
  loaded.own_vertices = loaded.mesh.vertex_count();
  if (options.subdivide > 0) {
    subdivide(loaded.mesh, loaded.arrays, options.subdivide,
              options.rounded ? Midpoints::rounded : Midpoints::straight,
              stages.begin("subdividing"));
  }
  stages.finish();
  return loaded;
}

namespace {

std::string loading(const SurfaceOptions& options) { return "loading " + shown(options.mesh); }

// Adds the file name to errors.
template <class Make>
Surface of_file(const std::string& mesh, const Make& make) {
  try {
    return make();
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    throw Error(shown(mesh) + ": " + error.what());
  }
}

// Loads a surface into `result`, with the time spent.
void prepare_mesh(Preparation& result, const SurfaceOptions& options, JobListener& listener) {
  Stopwatch watch;
  LoadedSurface loaded = load_mesh(options, listener.progress());
  listener.note(describe(loaded));
  result.original_ids = original_ids_of(loaded);
  result.vertices_joined = loaded.repair.vertices_joined;
  if (!loaded.renumbered) result.partners = loaded.vertex_of_row;
  // Field files have no rows for vertices added by subdivision.
  if (options.subdivide == 0) result.vertex_of_row = std::move(loaded.vertex_of_row);
  result.load_milliseconds = watch.lap();
  listener.stage(kNeighborhood);
  result.surface = of_file(options.mesh, [&] {
    Creases creases = split_at_creases(loaded.mesh, options.crease_angle.value_or(kCreaseAngle));
    add_rows_of_copies(creases, loaded.arrays);
    return make_surface(std::move(loaded.mesh), std::move(creases), listener.progress());
  });
  add_rows_of_copies(result.surface.creases, result.original_ids);
  result.arrays = std::move(loaded.arrays);
  result.topology_milliseconds = watch.lap();
}

void prepare_points(Preparation& result, const SurfaceOptions& options, JobListener& listener) {
  Stopwatch watch;
  LoadedPoints loaded = load_points(options);
  listener.note(describe_kind(options) + describe(loaded));
  result.points = true;
  result.partners = std::move(loaded.first_at_place);
  result.vertices_joined = loaded.repair.repeated;
  result.original_ids.resize(loaded.cloud.positions.size());
  std::iota(result.original_ids.begin(), result.original_ids.end(), std::int64_t{0});
  result.arrays.points = std::move(loaded.arrays);
  result.load_milliseconds = watch.lap();
  listener.stage(kNeighborhoodOfPoints);
  const std::size_t used = loaded.cloud.used.size();
  result.surface = of_file(options.mesh, [&] {
    return make_point_surface(std::move(loaded.cloud),
                              options.neighbors.value_or(kDefaultNeighbors), listener.progress());
  });
  const auto with_normal = static_cast<std::size_t>(
      std::ranges::count_if(result.surface.normals, [](const Vec3& n) { return !n.isZero(0); }));
  if (with_normal < used) {
    listener.note(std::to_string(used - with_normal) +
                  " points whose neighbours lie on a line: kept, without a wave\n");
  }
  result.topology_milliseconds = watch.lap();
}

}  // namespace

std::vector<JobStage> preparation_stages(const SurfaceOptions& surface) {
  return {{loading(surface), 4},
          {is_points(surface) ? kNeighborhoodOfPoints : kNeighborhood, 3},
          {kField, 4}};
}

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

void check_own_arrays(const SurfaceOptions& surface, const WaveOptions& waves) {
  if (!needs_own_arrays(waves) || !is_shape(surface)) return;
  throw CLI::ValidationError("array:NAME",
                             "built-in shapes have no arrays; name a file that "
                             "does, as MESH or with --field-mesh");
}

WaveReport noted_waves(const WaveMetrics& measured, const std::string& source,
                       JobListener& listener, WaveReport metrics) {
  static_cast<WaveMetrics&>(metrics) = measured;
  check_wave_report(metrics, source);
  listener.note(warnings(metrics, source));
  return metrics;
}

Preparation prepare_surface(const SurfaceOptions& surface, JobListener& listener) {
  Preparation result;
  listener.stage(loading(surface));
  is_points(surface) ? prepare_points(result, surface, listener)
                     : prepare_mesh(result, surface, listener);
  return result;
}

namespace {

FileData data_of(const Preparation& prepared, const SurfaceOptions& surface,
                 const std::optional<Viewpoint>& viewpoint) {
  return {surface.mesh, prepared.arrays, prepared.vertex_of_row, viewpoint ? &*viewpoint : nullptr};
}

}  // namespace

/// The share of time for the field before it is turned and smoothed.
constexpr double kFieldShare = 0.7;

BaseField prepare_field(const Preparation& prepared, const SurfaceOptions& surface,
                        const WaveOptions& waves, JobListener& listener,
                        const LastDirections& last) {
  listener.stage(kField);
  const WholeSource source(prepared.surface, data_of(prepared, surface, std::nullopt),
                           waves.arrays);
  BaseField field = make_base_field(source, waves, last, listener.progress().part(0, kFieldShare));
  field.arrays = source.arrays();
  return field;
}

WaveSet waves_afresh(const Preparation& prepared, const SurfaceOptions& surface,
                     const WaveOptions& waves, const std::optional<Viewpoint>& viewpoint) {
  const WholeSource source(prepared.surface, data_of(prepared, surface, viewpoint), waves.arrays);
  return make_waves(source, waves, make_base_field(source, waves)).waves;
}

PreparedWaves prepare_waves(const Preparation& prepared, const SurfaceOptions& surface,
                            const WaveOptions& waves, BaseField field, JobListener& listener,
                            const std::optional<Viewpoint>& viewpoint) {
  const WholeSource source(prepared.surface, data_of(prepared, surface, viewpoint), waves.arrays,
                           std::move(field.arrays));
  return prepare_waves(source, waves,
                       prepared.points ? std::nullopt : std::optional(surface.subdivide),
                       std::move(field), listener);
}

PreparedWaves prepare_waves(const WaveSource& source, const WaveOptions& waves,
                            std::optional<int> subdivided, BaseField field, JobListener& listener) {
  Stopwatch watch;
  WavesOfField made =
      make_waves(source, waves, std::move(field), listener.progress().part(kFieldShare, 1));
  listener.note(made.notes);
  PreparedWaves result;
  result.waves = std::move(made.waves);
  result.frequencies_v = std::move(made.frequencies_v);
  result.turn_deg = turn_deg(waves);
  result.field_rows_nonfinite = made.field_rows_nonfinite;
  result.field_step = made.field_step;
  WaveReport known;
  known.missing = made.missing;
  known.turned_apart = made.turned_apart;
  known.measured = is_measured(waves);
  known.subdivided = subdivided;
  known.smoothing = made.smoothing;
  known.frequency_smoothing = made.frequency_smoothing;
  result.metrics =
      noted_waves(source.measure(result.waves), source_of(waves), listener, std::move(known));
  result.seen_field = std::move(made.seen_field);
  result.support = std::move(made.support);
  result.field_milliseconds = watch.lap();
  return result;
}

void take_waves(PreparedWaves waves, Preparation& prepared) {
  static_cast<FieldMetrics&>(prepared) = std::move(static_cast<FieldMetrics&>(waves));
  prepared.waves = std::move(waves.waves);
  prepared.frequencies_v = std::move(waves.frequencies_v);
}

Preparation prepare(const SurfaceOptions& surface, const WaveOptions& waves, JobListener& listener,
                    const std::optional<Viewpoint>& viewpoint,
                    const FindLastDirections& find_last) {
  check_own_arrays(surface, waves);
  Preparation result = prepare_surface(surface, listener);
  const bool smooth = is_smooth(waves);
  const LastDirections last =
      find_last && goes_on_from_last(waves) ? find_last(result) : LastDirections();
  listener.note(last.notes);
  Stopwatch watch;
  BaseField field = prepare_field(result, surface, waves, listener, last);
  if (smooth) result.kept_field = field.directions;
  PreparedWaves made = prepare_waves(result, surface, waves, std::move(field), listener, viewpoint);
  if (!smooth) result.kept_field = std::move(made.seen_field);
  made.field_milliseconds = watch.lap();
  take_waves(std::move(made), result);
  return result;
}

}  // namespace brindle::tool
