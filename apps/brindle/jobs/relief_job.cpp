#include "jobs/relief_job.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <utility>

#include "brindle/base/file_names.h"
#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"
#include "outputs/outputs.h"

namespace brindle::tool {
namespace {

constexpr const char* kRelief = "relief";
constexpr const char* kTexture = "texture";

/// Faces by their normals.
struct FacesTowards {
  Vec3 direction;
  float cosine;
};

bool is_region_file(const std::string& only) { return lower_extension(only) == ".csv"; }

FacesTowards parse_faces(const std::string& text) {
  constexpr float kWithin = 45;
  const std::size_t at = text.find('@');
  const Vec3 direction = parse_direction("--only", text.substr(0, at));
  const float degrees =
      at == std::string::npos ? kWithin : parse_positive_number("--only", text.substr(at + 1));
  if (!(degrees <= 180)) wrong_usage("--only", "an angle up to 180 degrees", text);
  return {direction.normalized(), std::cos(degrees * std::numbers::pi_v<float> / 180)};
}

Vec3 normal_of(const Surface& surface, std::size_t t) {
  const Triangle& c = surface.mesh.triangles[t];
  const std::vector<Vec3>& p = surface.mesh.positions;
  const Vec3 normal = (p[c[1]] - p[c[0]]).cross(p[c[2]] - p[c[0]]).normalized();
  return !surface.turned.empty() && surface.turned[t] != 0 ? Vec3(-normal) : normal;
}

/// 1 for triangles with the texture. `weights` has a number per vertex of the mesh, or is empty.
std::vector<std::uint8_t> chosen_faces(const ReliefChoice& choice, const Surface& surface,
                                       const std::vector<float>& weights, float spacing) {
  const std::size_t count = surface.mesh.triangle_count();
  std::vector<std::uint8_t> chosen(count, 1);
  if (choice.keep_flat) {
    chosen = flat_faces(surface, spacing);
    for (std::uint8_t& face : chosen) face = face != 0 ? 0 : 1;
  }
  if (!weights.empty()) {
    // Triangles of crosses may have new vertices in their middle.
    const auto is_in = [&](Index v) { return v >= weights.size() || weights[v] > 0.5f; };
    for (std::size_t t = 0; t < count; ++t) {
      if (!std::ranges::all_of(surface.mesh.triangles[t], is_in)) chosen[t] = 0;
    }
  } else if (!choice.only.empty()) {
    const FacesTowards faces = parse_faces(choice.only);
    for (std::size_t t = 0; t < count; ++t) {
      if (!(normal_of(surface, t).dot(faces.direction) >= faces.cosine)) chosen[t] = 0;
    }
  }
  if (std::ranges::find(chosen, 1) == chosen.end()) {
    throw Error("no face has the relief; change --only or leave out --keep-flat");
  }
  return chosen;
}

/// The median distance of stripes.
float spacing_of(const WaveSet& waves) {
  std::vector<float> frequencies = waves.frequencies;
  const auto middle = frequencies.begin() + static_cast<std::ptrdiff_t>(frequencies.size() / 2);
  std::nth_element(frequencies.begin(), middle, frequencies.end());
  return 1 / *middle;
}

void note_relief(const Relief& relief, JobListener& listener) {
  const ReliefMetrics& metrics = relief.metrics;
  if (!metrics.closed) {
    listener.note(
        "the relief is open, as the surface is: close it before printing, or make closed "
        "bodies with --inlay or --cut\n");
  }
  if (metrics.limited_area > 0.01 * metrics.area) {
    listener.note(
        formatted("on %.0f %% of the surface the relief is lower than the texture, where "
                  "it would meet itself: hollows and narrow gaps\n",
                  100 * metrics.limited_area / metrics.area));
  }
  if (metrics.intersecting_triangles > 0) {
    listener.note(
        formatted("%zu triangles of the relief intersect others, as those of the surface "
                  "do, or as an inlay is deeper than the wall\n",
                  metrics.intersecting_triangles));
  }
}

}  // namespace

void add_relief_options(CLI::App& command, ReliefArguments& arguments) {
  StripeArguments& pattern = arguments.pattern;
  add_surface_options(command, pattern.surface);
  add_wave_options(command, pattern.waves);
  add_cross_option(command, pattern.waves);
  add_solver_option(command, pattern.solving);
  add_solving_options(command, pattern.solving);
  add_texture_options(command, pattern.texture, pattern.waves);
  command.get_option("--texture")->required();
  add_fields(command, arguments.relief);
  command.get_option("--height")->required();
  add_output_options(command, pattern);
}

std::vector<UsedFile> relief_inputs(const ReliefArguments& arguments) {
  std::vector<UsedFile> inputs = stripe_inputs(arguments.pattern);
  const std::string& only = arguments.relief.only;
  if (is_region_file(only)) inputs.push_back({"--only", only});
  return inputs;
}

void check_relief_options(const CLI::App& command, const ReliefArguments& arguments) {
  check_field_options(command, arguments.pattern.waves);
  check_solving_options(command, arguments.pattern.solving);
  const std::string& only = arguments.relief.only;
  if (!only.empty() && !is_region_file(only)) parse_faces(only);
}

std::vector<JobStage> relief_stages(const ReliefArguments& arguments) {
  std::vector<JobStage> stages = preparation_stages(arguments.pattern.surface);
  stages.push_back({kTexture, 8});
  stages.push_back({kRelief, 20});
  return stages;
}

ReliefJob make_relief_job(const ReliefArguments& arguments, JobListener& listener) {
  const StripeArguments& pattern = arguments.pattern;
  const ReliefChoice& choice = arguments.relief;
  std::optional<TextureTile> tile = chosen_tile(pattern.texture, pattern.waves.cross);
  Preparation prepared = prepare(pattern.surface, pattern.waves, listener);
  std::vector<float> weights;
  if (is_region_file(choice.only)) {
    weights = read_branch_penalty_csv(choice.only, prepared.surface.own_vertex_count(),
                                      prepared.vertex_of_row);
    add_rows_of_copies(prepared.surface.creases, weights);
  }
  listener.stage(kTexture);
  ReliefJob job;
  job.texture = make_stripe_job(pattern, std::move(prepared), std::move(tile), listener.progress());
  const Surface& surface = *job.texture.surface;
  const Texture& texture = *job.texture.result.texture();
  listener.note(quality_warning(job.texture.report.waves, job.texture.report.quality,
                                surface.mesh.triangle_count()));
  listener.stage(kRelief);
  Stopwatch watch;
  const float diagonal = bounding_box(surface.mesh).diagonal();
  ReliefOptions options{.height = choice.height.on(diagonal)};
  if (choice.tolerance) options.tolerance = choice.tolerance->on(diagonal);
  if (choice.inlay) {
    options.kind = ReliefKind::inlay;
    options.depth = choice.inlay->on(diagonal);
  }
  if (choice.cut) options.kind = ReliefKind::cut;
  if (choice.keep_flat || !choice.only.empty()) {
    options.only =
        chosen_faces(choice, surface, weights, spacing_of(job.texture.result.stripes().waves));
  }
  const Progress progress = listener.progress();
  const auto broken = texture.broken(surface.mesh);
  const TexturedMesh coordinates =
      texture_coordinates(surface, texture.pattern, progress.part(0, 0.1));
  const auto height = [&](float u, float v) { return tile_height(texture.tile, u, v); };
  job.relief = make_relief(surface, {coordinates, height, broken.get(), tile_detail(texture.tile)},
                           options, progress.part(0.1, 1));
  job.relief_milliseconds = watch.lap();
  note_relief(job.relief, listener);
  return job;
}

nlohmann::ordered_json to_json(const ReliefJob& job) {
  const Mesh& mesh = job.relief.mesh;
  const ReliefMetrics& metrics = job.relief.metrics;
  const Report& report = job.texture.report;
  nlohmann::ordered_json json = {{"vertices", mesh.vertex_count()},
                                 {"triangles", mesh.triangle_count()},
                                 {"refined_triangles", metrics.refined_triangles},
                                 {"bodies", metrics.bodies},
                                 {"closed", metrics.closed},
                                 {"intersecting_triangles", metrics.intersecting_triangles},
                                 {"volume_before", metrics.volume_before},
                                 {"volume", metrics.volume},
                                 {"least_height", metrics.least_height},
                                 {"greatest_height", metrics.greatest_height},
                                 {"area", metrics.area},
                                 {"limited_area", metrics.limited_area},
                                 {"branches", report.quality.branches},
                                 {"threads", ThreadLimit::current()}};
  json["milliseconds"] = {{"relief", job.relief_milliseconds}};
  return json;
}

void print(std::ostream& out, const ReliefJob& job) {
  const ReliefMetrics& metrics = job.relief.metrics;
  out << formatted("relief    %zu vertices, %zu triangles, %s, %zu %s\n",
                   job.relief.mesh.vertex_count(), job.relief.mesh.triangle_count(),
                   metrics.closed ? "closed" : "open", metrics.bodies,
                   metrics.bodies == 1 ? "body" : "bodies")
      << formatted("height    %.4g to %.4g\n", metrics.least_height, metrics.greatest_height)
      << formatted("volume    %.6g, %.6g before\n", metrics.volume, metrics.volume_before)
      << formatted("time      relief in %.1f ms\n", job.relief_milliseconds);
}

}  // namespace brindle::tool
