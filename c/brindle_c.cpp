#include "brindle_c.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "brindle/brindle.h"

using namespace brindle;  // all names of C begin with brindle_

// Handles share their surface, so that they may be freed in any order.
using SharedSurface = std::shared_ptr<const Surface>;

struct brindle_surface {
  SharedSurface surface;
};

struct brindle_field {
  DirectionField directions;
};

struct brindle_pattern {
  SharedSurface surface;
  StripePattern pattern;
};

struct brindle_texture {
  SharedSurface surface;
  std::optional<TexturePattern> texture;  // none of crosses
  TexturedMesh mesh;
};

struct brindle_curves {
  StripeCurves curves;
};

struct brindle_samples {
  std::vector<Sample> samples;
};

struct brindle_animator {
  SharedSurface surface;
  StripeAnimator animator;
  WaveSet last = {};  // input of the last frame; empty before the first
  FrameResult result = {};
  std::optional<PatternFrames> frames = {};  // made when first needed
};

namespace {

// ---- Errors and arguments ----------------------------------------------------------------------

thread_local char last_error[2048] = "";

brindle_status fail(brindle_status status, const char* message) noexcept {
  std::snprintf(last_error, sizeof last_error, "%s", message);
  return status;
}

/// Runs a function's body; no exception passes.
template <class Body>
brindle_status guarded(const Body& body) noexcept {
  try {
    body();
    return BRINDLE_OK;
  } catch (const Cancelled& cancelled) {
    return fail(BRINDLE_CANCELLED, cancelled.what());
  } catch (const Error& error) {
    return fail(BRINDLE_ERROR, error.what());
  } catch (const std::bad_alloc&) {
    return fail(BRINDLE_OUT_OF_MEMORY, "memory is exhausted; use a smaller surface");
  } catch (const std::exception& error) {
    return fail(BRINDLE_INTERNAL_ERROR, error.what());
  } catch (...) {
    return fail(BRINDLE_INTERNAL_ERROR, "unknown error");
  }
}

[[noreturn]] void reject(const std::string& what) { throw Error(what); }

template <class T>
T& given(T* argument, const char* name) {
  if (argument == nullptr) reject(std::string(name) + " is NULL");
  return *argument;
}

template <class Options>
Options or_default(const Options* options, Options (*defaults)()) {
  return options != nullptr ? *options : defaults();
}

bool flag(int value, const char* name) {
  if (value != 0 && value != 1) reject(std::string(name) + " must be 0 or 1");
  return value == 1;
}

/// Makes a handle; `result` is NULL until it is complete.
template <class Handle, class Make>
brindle_status made(Handle** result, const Make& make) noexcept {
  if (result != nullptr) *result = nullptr;
  return guarded([&] {
    Handle*& handle = given(result, "the last argument");
    handle = make();
  });
}

std::filesystem::path path_of(const char* path) {
  return reinterpret_cast<const char8_t*>(&given(path, "path"));
}

Progress progress_of(const brindle_progress* progress) {
  if (progress == nullptr || progress->report == nullptr) return Progress();
  return Progress(Progress::JobCallback([heard = *progress](const ProgressReport& report) {
    return heard.report(heard.data, report.fraction, std::string(report.step).c_str()) == 0;
  }));
}

// ---- Arrays ------------------------------------------------------------------------------------

template <class Number>
brindle_array packed(const Number* data, std::size_t rows, std::size_t columns) {
  return brindle_array_of(data, static_cast<brindle_type>(number_type<Number>()), rows, columns);
}

brindle_array vectors_in(std::span<const Vec3> vectors) {
  return packed(reinterpret_cast<const float*>(vectors.data()), vectors.size(), 3);
}

brindle_array triangles_in(std::span<const Triangle> triangles) {
  return packed(reinterpret_cast<const Index*>(triangles.data()), triangles.size(), 3);
}

brindle_array phases_in(std::span<const Complex> z) {
  return packed(reinterpret_cast<const float*>(z.data()), z.size(), 2);
}

template <class Number>
brindle_array list_in(std::span<const Number> numbers) {
  return packed(numbers.data(), numbers.size(), 1);
}

/// `columns` numbers from the beginning of a member of every row.
template <class Number, class Row, class Member>
brindle_array members_in(const std::vector<Row>& rows, Member Row::*member, std::size_t columns) {
  const void* const first = rows.empty() ? nullptr : &(rows[0].*member);
  brindle_array array = packed(static_cast<const Number*>(first), rows.size(), columns);
  array.row_stride = sizeof(Row);
  return array;
}

ArrayView view_of(const brindle_array& array, std::size_t columns, const char* name) {
  if (array.type < BRINDLE_FLOAT32 || array.type > BRINDLE_UINT64) {
    reject(std::string(name) + ": the type " + std::to_string(array.type) + " is unknown");
  }
  if (array.rows > 0 && array.data == nullptr) reject(std::string(name) + ": data is NULL");
  if (array.rows > PTRDIFF_MAX / 64) reject(std::string(name) + " has too many rows");
  if (array.rows > 0 && array.columns != columns) {
    reject(std::string(name) + " has " + std::to_string(array.columns) + " columns instead of " +
           std::to_string(columns));
  }
  const auto type = static_cast<NumberType>(array.type);
  const auto size = static_cast<std::ptrdiff_t>(size_of(type));
  const std::ptrdiff_t column = array.column_stride != 0 ? array.column_stride : size;
  const std::ptrdiff_t row =
      array.row_stride != 0 ? array.row_stride : size * static_cast<std::ptrdiff_t>(columns);
  return {array.data, type, array.rows, columns, row, column};
}

/// Rows by vertex, of all vertices or of those before creases were split.
template <class Row>
std::vector<Row> by_vertex(const Surface& surface, std::vector<Row> rows, const char* name) {
  const std::size_t all = surface.mesh.vertex_count(), own = surface.own_vertex_count();
  if (rows.size() == all || rows.empty()) return rows;
  if (rows.size() != own) {
    reject(std::string(name) + " has " + std::to_string(rows.size()) + " rows for " +
           std::to_string(own) + " vertices");
  }
  add_rows_of_copies(surface.creases, rows);
  return rows;
}

std::vector<Vec3> vectors(const brindle_array& array, const char* name) {
  return vectors_of(view_of(array, 3, name), name);
}

std::vector<float> numbers(const brindle_array& array, const char* name) {
  return numbers_of(view_of(array, 1, name), name);
}

std::vector<Complex> phases(const brindle_array& array, const char* name) {
  const ArrayView both = view_of(array, 2, name);
  std::array<std::vector<float>, 2> parts;
  for (std::size_t c = 0; c < 2; ++c) {
    const std::byte* first = both.rows() > 0 ? both.address(0, c) : nullptr;
    parts[c] = numbers_of({first, both.type(), both.rows(), 1,
                           both.rows() > 1 ? both.address(1, 0) - both.address(0, 0) : 0, 0},
                          name);
  }
  std::vector<Complex> result(both.rows());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = {parts[0][i], parts[1][i]};
  return result;
}

/// One frequency per vertex.
FrequencyField frequencies_by_vertex(const Surface& surface, const brindle_array& array,
                                     const char* name) {
  std::vector<float> result = numbers(array, name);
  if (result.empty()) reject(std::string(name) + " has no rows; give one, or one per vertex");
  if (result.size() == 1) {
    return constant_frequency_field(result[0], surface.mesh.vertex_count());
  }
  return by_vertex(surface, std::move(result), name);
}

/// Sets `array` to the one with this number, or to nothing on errors.
template <class Arrays>
brindle_status selected(brindle_array* array, int which, const Arrays& arrays) noexcept {
  if (array != nullptr) *array = {};
  return guarded([&] {
    const auto all = arrays();
    if (which < 0 || which >= std::ssize(all)) {
      reject("there is no array with the number " + std::to_string(which));
    }
    given(array, "array") = all[static_cast<std::size_t>(which)];
  });
}

// ---- Options -----------------------------------------------------------------------------------

StripeOptions options_of(const Surface& surface, const brindle_stripe_options* options) {
  const brindle_stripe_options o = or_default(options, brindle_default_stripe_options);
  if (o.solver < BRINDLE_MULTILEVEL || o.solver > BRINDLE_GLOBAL) reject("solver: unknown number");
  StripeOptions result;
  result.solver.solver = static_cast<Solver>(o.solver);
  result.solver.sweeps = o.sweeps;
  result.solver.cycles = o.cycles;
  result.slack = o.slack;
  result.slack.by_vertex = by_vertex(surface, numbers(o.slacks, "slacks"), "slacks");
  result.slack.branch_penalty =
      by_vertex(surface, numbers(o.avoid_branches, "avoid_branches"), "avoid_branches");
  if (!result.slack.branch_penalty.empty() && !result.slack.relaxes()) {
    reject("avoid_branches has no effect without slack; set slack or slacks");
  }
  result.last_phases = by_vertex(surface, phases(o.last_phases, "last_phases"), "last_phases");
  result.lambda = o.lambda;
  return result;
}

Surface surface_of(Mesh mesh, const brindle_surface_options& options, const Progress& progress) {
  JobStages stages(progress, {{"creases", 1}, {"surface", 1}});
  Creases creases = split_at_creases(mesh, options.crease_angle, stages.begin("creases"));
  return make_surface(std::move(mesh), std::move(creases), stages.begin("surface"));
}

SharedSurface shared(Surface surface) {
  return std::make_shared<const Surface>(std::move(surface));
}

const Surface& surface_in(const brindle_surface* surface) {
  return *given(surface, "surface").surface;
}

WaveSet waves_along(const Surface& surface, const brindle_field* field,
                    const brindle_array& frequencies) {
  const DirectionField& directions = given(field, "field").directions;
  if (directions.size() != surface.mesh.vertex_count()) reject("the field is of another surface");
  return {surface.mesh.positions, directions,
          frequencies_by_vertex(surface, frequencies, "frequencies")};
}

/// The caller's memory, which has the layout of the library's vertices.
std::span<PatternVertex> span_of(brindle_pattern_vertex* vertices, std::size_t count) {
  static_assert(sizeof(brindle_pattern_vertex) == sizeof(PatternVertex));
  return {reinterpret_cast<PatternVertex*>(&given(vertices, "vertices")), count};
}

}  // namespace

// ---- Errors, version, threads ------------------------------------------------------------------

const char* brindle_error(void) { return last_error; }

const char* brindle_version(void) { return version(); }

brindle_status brindle_limit_threads(int threads) {
  return guarded([&] {
    static std::unique_ptr<ThreadLimit> limit;
    if (threads < 0) reject("threads must be 0 or above");
    limit.reset();
    if (threads > 0) limit = std::make_unique<ThreadLimit>(threads);
  });
}

brindle_array brindle_array_of(const void* data, brindle_type type, size_t rows, size_t columns) {
  return {data, rows, columns, 0, 0, type};
}

// ---- Surfaces ----------------------------------------------------------------------------------

brindle_surface_options brindle_default_surface_options(void) { return {180, 0}; }

brindle_status brindle_make_surface(brindle_array positions, brindle_array triangles,
                                    const brindle_surface_options* options,
                                    const brindle_progress* progress, brindle_surface** surface) {
  return made(surface, [&] {
    const auto o = or_default(options, brindle_default_surface_options);
    const ArrayView points = view_of(positions, 3, "positions");
    const ArrayView corners = view_of(triangles, 3, "triangles");
    Mesh mesh = flag(o.repair, "repair") ? make_repaired_mesh(points, corners).mesh
                                         : make_mesh(points, corners);
    if (mesh.triangles.empty()) reject("the mesh has no triangles; use brindle_make_points");
    return new brindle_surface{shared(surface_of(std::move(mesh), o, progress_of(progress)))};
  });
}

brindle_status brindle_read_surface(const char* path, const brindle_surface_options* options,
                                    const brindle_progress* progress, brindle_surface** surface) {
  return made(surface, [&] {
    const auto o = or_default(options, brindle_default_surface_options);
    JobStages stages(progress_of(progress), {{"read", 1}, {"make", 1}});
    Mesh mesh = read_mesh(path_of(path), stages.begin("read")).mesh;
    return new brindle_surface{shared(surface_of(std::move(mesh), o, stages.begin("make")))};
  });
}

brindle_status brindle_make_shape(const char* shape, const brindle_surface_options* options,
                                  const brindle_progress* progress, brindle_surface** surface) {
  return made(surface, [&] {
    const auto o = or_default(options, brindle_default_surface_options);
    JobStages stages(progress_of(progress), {{"shape", 1}, {"make", 1}});
    Mesh mesh = make_shape(&given(shape, "shape"), stages.begin("shape"));
    return new brindle_surface{shared(surface_of(std::move(mesh), o, stages.begin("make")))};
  });
}

brindle_status brindle_make_points(brindle_array positions, brindle_array normals,
                                   const brindle_progress* progress, brindle_surface** surface) {
  return made(surface, [&] {
    std::vector<Vec3> points = vectors(positions, "positions"),
                      given_normals = vectors(normals, "normals");
    if (!given_normals.empty() && given_normals.size() != points.size()) {
      reject("there are " + std::to_string(given_normals.size()) + " normals for " +
             std::to_string(points.size()) + " points");
    }
    auto cloud = make_point_cloud(std::move(points), std::move(given_normals)).cloud;
    return new brindle_surface{
        shared(make_point_surface(std::move(cloud), 8, progress_of(progress)))};
  });
}

void brindle_free_surface(brindle_surface* surface) { delete surface; }
brindle_status brindle_get_surface_array(const brindle_surface* surface,
                                         brindle_surface_array which, brindle_array* array) {
  return selected(array, which, [&] {
    const Surface& s = surface_in(surface);
    return std::array{vectors_in(s.mesh.positions), triangles_in(s.mesh.triangles),
                      vectors_in(s.normals), list_in<Index>(s.creases.copied)};
  });
}

brindle_status brindle_get_surface_origin(const brindle_surface* surface, double origin[3]) {
  return guarded([&] {
    given(origin, "origin");
    for (int c = 0; c < 3; ++c) origin[c] = surface_in(surface).mesh.origin[c];
  });
}

// ---- Fields ------------------------------------------------------------------------------------

brindle_smooth_options brindle_default_smooth_options(void) {
  const SmoothFieldOptions o;
  return {o.symmetry, o.curvature_anchor, 0, o.feature_anchor, o.normal_radius};
}

brindle_status brindle_make_smooth_field(const brindle_surface* surface,
                                         const brindle_smooth_options* options,
                                         const brindle_progress* progress, brindle_field** field) {
  return made(field, [&] {
    const auto o = or_default(options, brindle_default_smooth_options);
    SmoothFieldOptions wanted;
    wanted.symmetry = o.symmetry;
    wanted.curvature_anchor = o.curvature_anchor;
    if (flag(o.minimum_curvature, "minimum_curvature")) {
      if (o.curvature_anchor == 0) reject("minimum_curvature needs a curvature_anchor");
      wanted.curvature_direction = CurvatureDirection::minimum;
    }
    wanted.feature_anchor = o.feature_anchor;
    wanted.normal_radius = o.normal_radius;
    return new brindle_field{
        smooth_direction_field(surface_in(surface), wanted, progress_of(progress))};
  });
}

brindle_status brindle_make_vector_field(const brindle_surface* surface, double x, double y,
                                         double z, brindle_field** field) {
  return made(field, [&] {
    const Vec3 axis = Eigen::Vector3d(x, y, z).cast<float>();
    return new brindle_field{projected_direction_field(axis, surface_in(surface).normals)};
  });
}

brindle_status brindle_make_curvature_field(const brindle_surface* surface, int minimum,
                                            brindle_field** field) {
  return made(field, [&] {
    const Surface& s = surface_in(surface);
    const bool smaller = flag(minimum, "minimum");
    return new brindle_field{curvature_direction_field(
        principal_curvatures(s.mesh.positions, s.normals, *s.neighborhood),
        smaller ? CurvatureDirection::minimum : CurvatureDirection::maximum)};
  });
}

brindle_status brindle_make_array_field(const brindle_surface* surface, brindle_array array,
                                        brindle_field** field) {
  return made(field, [&] {
    const Surface& s = surface_in(surface);
    const std::vector<Vec3> all = by_vertex(s, vectors(array, "vectors"), "vectors");
    if (all.size() != s.mesh.vertex_count()) reject("vectors has no rows; give one per vertex");
    return new brindle_field{tangent_directions(all, s.normals)};
  });
}

brindle_status brindle_make_turned_field(const brindle_surface* surface, const brindle_field* field,
                                         double degrees, brindle_field** turned) {
  return made(turned, [&] {
    const Surface& s = surface_in(surface);
    const DirectionField& directions = given(field, "field").directions;
    if (directions.size() != s.mesh.vertex_count()) reject("the field is of another surface");
    if (!std::isfinite(degrees)) reject("degrees must be finite");
    return new brindle_field{
        rotated(directions, s.normals, static_cast<float>(degrees * std::numbers::pi / 180))};
  });
}

void brindle_free_field(brindle_field* field) { delete field; }
brindle_status brindle_get_field_array(const brindle_field* field, brindle_array* array) {
  return selected(array, 0,
                  [&] { return std::array{vectors_in(given(field, "field").directions)}; });
}

// ---- Patterns ----------------------------------------------------------------------------------

brindle_stripe_options brindle_default_stripe_options(void) {
  const StripeOptions o;
  return {BRINDLE_MULTILEVEL, o.solver.sweeps, o.solver.cycles, 0, {}, {}, {}, o.lambda};
}

brindle_status brindle_make_stripes(const brindle_surface* surface, const brindle_field* field,
                                    brindle_array frequencies,
                                    const brindle_stripe_options* options,
                                    const brindle_progress* progress, brindle_pattern** pattern) {
  return made(pattern, [&] {
    const Surface& s = surface_in(surface);
    auto stripes = stripe_pattern(s, waves_along(s, field, frequencies), options_of(s, options),
                                  progress_of(progress));
    return new brindle_pattern{surface->surface, std::move(stripes)};
  });
}

void brindle_free_pattern(brindle_pattern* pattern) { delete pattern; }
brindle_status brindle_get_pattern_array(const brindle_pattern* pattern,
                                         brindle_pattern_array which, brindle_array* array) {
  return selected(array, which, [&] {
    const StripePattern& p = given(pattern, "pattern").pattern;
    return std::array{phases_in(p.solution.z), vectors_in(p.waves.directions),
                      list_in<float>(p.waves.frequencies),
                      members_in<float>(p.corners, &CornerPhases::phase, 3),
                      members_in<std::uint8_t>(p.corners, &CornerPhases::kind, 1)};
  });
}

brindle_status brindle_get_metrics(const brindle_pattern* pattern, brindle_metrics* metrics) {
  if (metrics != nullptr) *metrics = {};
  return guarded([&] {
    const StripePattern& p = given(pattern, "pattern").pattern;
    const PatternQuality& q = p.quality;
    given(metrics, "metrics") = {q.branches,
                                 q.field_singularities,
                                 q.vertices_without_wave,
                                 q.angle_error_mean_deg,
                                 q.spacing_error_mean,
                                 p.solution.energy};
  });
}

// ---- Textures and crosses ----------------------------------------------------------------------

brindle_status brindle_make_texture(const brindle_surface* surface, const brindle_field* field,
                                    brindle_array frequencies, brindle_array frequencies_v,
                                    int oriented, const brindle_stripe_options* options,
                                    const brindle_progress* progress, brindle_texture** texture) {
  return made(texture, [&] {
    const Surface& s = surface_in(surface);
    TextureOptions wanted;
    wanted.stripes = options_of(s, options);
    if (!wanted.stripes.last_phases.empty()) reject("textures take no last_phases");
    wanted.oriented = flag(oriented, "oriented");
    if (frequencies_v.rows > 0) {
      wanted.frequencies_v = frequencies_by_vertex(s, frequencies_v, "frequencies_v");
    }
    JobStages stages(progress_of(progress), {{"pattern", 8}, {"mesh", 1}});
    auto solved =
        texture_pattern(s, waves_along(s, field, frequencies), wanted, stages.begin("pattern"));
    auto mesh = texture_coordinates(s, solved, stages.begin("mesh"));
    return new brindle_texture{surface->surface, std::move(solved), std::move(mesh)};
  });
}

brindle_status brindle_make_crosses(const brindle_surface* surface, const brindle_field* field,
                                    brindle_array frequencies,
                                    const brindle_stripe_options* options,
                                    const brindle_progress* progress, brindle_texture** texture) {
  return made(texture, [&] {
    const Surface& s = surface_in(surface);
    const StripeOptions wanted = options_of(s, options);
    if (!wanted.last_phases.empty()) reject("crosses take no last_phases");
    JobStages stages(progress_of(progress), {{"pattern", 8}, {"texture", 2}, {"mesh", 1}});
    const auto crosses =
        cross_pattern(s, waves_along(s, field, frequencies), wanted, stages.begin("pattern"));
    const auto tiles = cross_texture(s, crosses, wanted.phase_shift, stages.begin("texture"));
    auto mesh = texture_coordinates(tiles.surface, tiles.pattern, stages.begin("mesh"));
    return new brindle_texture{surface->surface, std::nullopt, std::move(mesh)};
  });
}

void brindle_free_texture(brindle_texture* texture) { delete texture; }
brindle_status brindle_get_texture_array(const brindle_texture* texture,
                                         brindle_texture_array which, brindle_array* array) {
  return selected(array, which, [&] {
    const TexturedMesh& m = given(texture, "texture").mesh;
    const void* const coordinates = m.coordinates.data();
    return std::array{vectors_in(m.mesh.positions), triangles_in(m.mesh.triangles),
                      packed(static_cast<const float*>(coordinates), m.coordinates.size(), 2),
                      triangles_in(m.origins), list_in<Index>(m.triangle_origins)};
  });
}

brindle_status brindle_copy_texture_pattern(const brindle_texture* texture, int v,
                                            brindle_pattern** pattern) {
  return made(pattern, [&] {
    const brindle_texture& t = given(texture, "texture");
    if (!t.texture) reject("both waves of crosses are linked; neither is a pattern of its own");
    return new brindle_pattern{t.surface, flag(v, "v") ? t.texture->v : t.texture->u};
  });
}

// ---- Curves and samples ------------------------------------------------------------------------

brindle_curve_options brindle_default_curve_options(void) { return {0, -1, 0, 0, 0}; }

brindle_status brindle_trace_curves(const brindle_pattern* pattern,
                                    const brindle_curve_options* options,
                                    const brindle_progress* progress, brindle_curves** curves) {
  return made(curves, [&] {
    const brindle_pattern& p = given(pattern, "pattern");
    const auto o = or_default(options, brindle_default_curve_options);
    CurveOptions wanted;
    wanted.join = flag(o.join, "join");
    if (o.trim != -1) wanted.trim = o.trim;
    wanted.fair = o.fair;
    if (!(o.min_length >= 0)) reject("min_length must be 0 or above");
    if (!(o.resample >= 0)) reject("resample must be 0 or above");
    auto found = stripe_curves(*p.surface, p.pattern, wanted, progress_of(progress));
    if (o.min_length > 0) found = longer_than(found, static_cast<double>(o.min_length));
    if (o.resample > 0) found.lines = resampled(found.lines, o.resample);
    return new brindle_curves{std::move(found)};
  });
}

void brindle_free_curves(brindle_curves* curves) { delete curves; }
brindle_status brindle_get_curves_array(const brindle_curves* curves, brindle_curves_array which,
                                        brindle_array* array) {
  return selected(array, which, [&] {
    const StripeCurves& c = given(curves, "curves").curves;
    const void* const ends = c.ends.data();
    return std::array{vectors_in(c.lines.points), vectors_in(c.lines.normals),
                      list_in<Index>(c.lines.offsets), list_in<std::uint8_t>(c.lines.closed),
                      packed(static_cast<const std::uint8_t*>(ends), c.ends.size(), 2)};
  });
}

brindle_status brindle_make_samples(const brindle_pattern* u, const brindle_pattern* v,
                                    const brindle_progress* progress, brindle_samples** samples) {
  return made(samples, [&] {
    const brindle_pattern &of_u = given(u, "u"), &of_v = given(v, "v");
    if (of_u.surface != of_v.surface) reject("the patterns are of different surfaces");
    return new brindle_samples{
        stripe_samples(*of_u.surface, of_u.pattern, of_v.pattern, progress_of(progress))};
  });
}

void brindle_free_samples(brindle_samples* samples) { delete samples; }
brindle_status brindle_get_samples_array(const brindle_samples* samples,
                                         brindle_samples_array which, brindle_array* array) {
  return selected(array, which, [&] {
    static_assert(offsetof(Sample, spacing_v) == offsetof(Sample, spacing_u) + sizeof(float));
    const std::vector<Sample>& all = given(samples, "samples").samples;
    return std::array{members_in<float>(all, &Sample::position, 3),
                      members_in<float>(all, &Sample::normal, 3),
                      members_in<float>(all, &Sample::direction_u, 3),
                      members_in<float>(all, &Sample::direction_v, 3),
                      members_in<float>(all, &Sample::spacing_u, 2),
                      members_in<Index>(all, &Sample::triangle, 1),
                      members_in<float>(all, &Sample::barycentric, 3)};
  });
}

// ---- Buffers and frames ------------------------------------------------------------------------

brindle_status brindle_fill_buffers(const brindle_pattern* pattern,
                                    brindle_pattern_vertex* vertices, size_t vertex_count,
                                    brindle_pattern_triangle* triangles, size_t triangle_count) {
  return guarded([&] {
    const brindle_pattern& p = given(pattern, "pattern");
    const Mesh& mesh = p.surface->mesh;
    const std::span<PatternVertex> filled = span_of(vertices, vertex_count);
    if (triangle_count > 0) given(triangles, "triangles");
    if (vertex_count != mesh.vertex_count() || triangle_count != mesh.triangle_count()) {
      reject("the pattern has " + std::to_string(mesh.vertex_count()) + " vertices and " +
             std::to_string(mesh.triangle_count()) + " triangles");
    }
    const WaveSet& waves = p.pattern.waves;
    fill_pattern_vertices({mesh.positions, p.surface->normals, waves.directions, waves.frequencies,
                           p.pattern.solution.z},
                          filled);
    for (std::size_t t = 0; t < triangle_count; ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      triangles[t] = {{a, b, c}, static_cast<std::uint32_t>(p.pattern.corners[t].kind)};
    }
  });
}

brindle_animator_options brindle_default_animator_options(void) {
  const AnimatorOptions o;
  return {0, o.lambda, o.sweeps, o.cycles, o.iterations, 0};
}

brindle_status brindle_make_animator(const brindle_surface* surface,
                                     const brindle_animator_options* options,
                                     brindle_animator** animator) {
  return made(animator, [&] {
    const Surface& s = surface_in(surface);
    const auto o = or_default(options, brindle_default_animator_options);
    AnimatorOptions wanted;
    if (flag(o.relaxation, "relaxation")) wanted.solver = FrameSolver::relaxation;
    wanted.lambda = o.lambda;
    wanted.sweeps = o.sweeps;
    wanted.cycles = o.cycles;
    wanted.iterations = o.iterations;
    wanted.slack = o.slack;
    return new brindle_animator{surface->surface, StripeAnimator(s, wanted)};
  });
}

void brindle_free_animator(brindle_animator* animator) { delete animator; }

brindle_status brindle_solve_frame(brindle_animator* animator, const brindle_frame_input* input,
                                   const brindle_progress* progress, brindle_frame_result* result) {
  if (result != nullptr) *result = {};
  return guarded([&] {
    brindle_animator& a = given(animator, "animator");
    const brindle_frame_input& in = given(input, "input");
    given(result, "result");
    WaveSet waves{
        in.positions.rows > 0 ? vectors(in.positions, "positions") : a.surface->mesh.positions,
        vectors(in.directions, "directions"),
        frequencies_by_vertex(*a.surface, in.frequencies, "frequencies")};
    a.result = a.animator.frame({waves.positions, waves.directions, waves.frequencies},
                                progress_of(progress));
    a.last = std::move(waves);
    const std::span<const float> frequencies =
        a.result.frequencies.empty() ? a.last.frequencies : a.result.frequencies;
    *result = {phases_in(a.result.z), list_in(frequencies), a.result.phase_step,
               a.result.unchanged ? 1 : 0};
  });
}

brindle_status brindle_fill_frame(brindle_animator* animator, brindle_pattern_vertex* vertices,
                                  size_t vertex_count) {
  return guarded([&] {
    brindle_animator& a = given(animator, "animator");
    const std::span<PatternVertex> filled = span_of(vertices, vertex_count);
    if (a.last.positions.empty()) reject("there is no frame yet");
    if (vertex_count != a.last.positions.size()) {
      reject("the surface has " + std::to_string(a.last.positions.size()) + " vertices");
    }
    if (!a.frames) a.frames.emplace(*a.surface);
    a.frames->fill({a.last.positions, a.last.directions, a.last.frequencies}, a.result, filled);
  });
}

brindle_status brindle_set_last_phases(brindle_animator* animator, brindle_array z) {
  return guarded(
      [&] { given(animator, "animator").animator.set_last_phases(phases(z, "phases")); });
}

brindle_status brindle_set_slack(brindle_animator* animator, float slack) {
  return guarded([&] { given(animator, "animator").animator.set_slack(slack); });
}

brindle_status brindle_restart(brindle_animator* animator) {
  return guarded([&] { given(animator, "animator").animator.restart(); });
}

// ---- Saving ------------------------------------------------------------------------------------

brindle_status brindle_save_pattern(const brindle_pattern* pattern, const char* path) {
  return guarded([&] {
    const brindle_pattern& p = given(pattern, "pattern");
    save(path_of(path), *p.surface, p.pattern);
  });
}

brindle_status brindle_load_pattern(const char* path, brindle_pattern** pattern) {
  return made(pattern, [&] {
    auto loaded = load_pattern(path_of(path));
    return new brindle_pattern{shared(std::move(loaded.surface)), std::move(loaded.result)};
  });
}

brindle_status brindle_save_animator(const brindle_animator* animator, const char* path) {
  return guarded([&] {
    const brindle_animator& a = given(animator, "animator");
    save(path_of(path), *a.surface, a.animator);
  });
}

brindle_status brindle_load_animator(const char* path, brindle_animator** animator) {
  return made(animator, [&] {
    auto loaded = load_stripe_animator(path_of(path));
    return new brindle_animator{shared(std::move(loaded.surface)), std::move(loaded.result)};
  });
}

brindle_status brindle_copy_pattern_surface(const brindle_pattern* pattern,
                                            brindle_surface** surface) {
  return made(surface, [&] { return new brindle_surface{given(pattern, "pattern").surface}; });
}

brindle_status brindle_copy_animator_surface(const brindle_animator* animator,
                                             brindle_surface** surface) {
  return made(surface, [&] { return new brindle_surface{given(animator, "animator").surface}; });
}
