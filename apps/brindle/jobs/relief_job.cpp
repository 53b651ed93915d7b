#include "jobs/relief_job.h"

#include <algorithm>
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

bool is_region_file(const std::string& only) { return lower_extension(only) == ".csv"; }

/// Sets the direction and angle of "AXIS[@DEG]".
void parse_faces(const std::string& text, ReliefFaces& faces) {
  const std::size_t at = text.find('@');
  faces.towards = parse_direction("--only", text.substr(0, at));
  if (at == std::string::npos) return;
  faces.degrees = parse_positive_number("--only", text.substr(at + 1));
  if (!(faces.degrees <= 180)) wrong_usage("--only", "an angle up to 180 degrees", text);
}

/// The faces but their spacing.
ReliefFaces faces_of(const ReliefChoice& choice, const Preparation& prepared) {
  ReliefFaces faces;
  if (is_region_file(choice.only)) {
    faces.weights = read_branch_penalty_csv(choice.only, prepared.surface.own_vertex_count(),
                                            prepared.vertex_of_row);
    add_rows_of_copies(prepared.surface.creases, faces.weights);
  } else if (!choice.only.empty()) {
    parse_faces(choice.only, faces);
  }
  return faces;
}

ReliefOptions options_of(const ReliefChoice& choice, float diagonal) {
  ReliefOptions options{.height = choice.height.on(diagonal)};
  if (choice.tolerance) options.tolerance = choice.tolerance->on(diagonal);
  if (choice.inlay) {
    options.kind = ReliefKind::inlay;
    options.depth = choice.inlay->on(diagonal);
  } else if (choice.cut) {
    options.kind = ReliefKind::cut;
  } else {
    options.fill_holes = choice.fill_holes.on(diagonal);
  }
  return options;
}

void note_relief(const Relief& relief, JobListener& listener) {
  const ReliefMetrics& metrics = relief.metrics;
  if (metrics.filled_holes > 0) {
    listener.note(formatted("%zu %s filled (--fill-holes)\n", metrics.filled_holes,
                            metrics.filled_holes == 1 ? "hole is" : "holes are"));
  }
  if (!metrics.closed) {
    listener.note(
        "the relief is open, as the surface is: raise --fill-holes, or make closed bodies with "
        "--inlay or --cut\n");
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
  ReliefFaces faces;
  if (!only.empty() && !is_region_file(only)) parse_faces(only, faces);
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
  ReliefFaces faces = faces_of(choice, prepared);
  listener.stage(kTexture);
  ReliefJob job;
  job.texture = make_stripe_job(pattern, std::move(prepared), std::move(tile), listener.progress());
  const Surface& surface = *job.texture.surface;
  const Texture& texture = *job.texture.result.texture();
  listener.note(quality_warning(job.texture.report.waves, job.texture.report.quality,
                                surface.mesh.triangle_count()));
  listener.stage(kRelief);
  Stopwatch watch;
  ReliefOptions options = options_of(choice, bounding_box(surface.mesh).diagonal());
  if (choice.keep_flat) {
    faces.flat_width =
        static_cast<float>(mean_spacing(job.texture.result.stripes().waves.frequencies));
  }
  options.only = chosen_faces(surface, faces);
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
  nlohmann::ordered_json json;
  visit_metrics(job.relief, [&](const char* name, const auto& value) { json[name] = value; });
  json["branches"] = job.texture.report.quality.branches;
  json["threads"] = ThreadLimit::current();
  json["milliseconds"] = {{"relief", job.relief_milliseconds}};
  return json;
}

void print(std::ostream& out, const ReliefJob& job) {
  const ReliefMetrics& metrics = job.relief.metrics;
  out << formatted("relief    %zu vertices, %zu triangles, %s, %zu %s\n",
                   job.relief.mesh.vertex_count(), job.relief.mesh.triangle_count(),
                   metrics.closed ? "closed" : "open", metrics.bodies,
                   metrics.bodies == 1 ? "body" : "bodies")
      << formatted("height    up to %.4g, limited on %.3g %% of the area\n",
                   static_cast<double>(metrics.greatest_height),
                   100 * metrics.limited_area / std::max(metrics.area, 1e-300))
      << formatted("volume    %.6g, %.6g before\n", metrics.volume, metrics.volume_before)
      << formatted("time      relief in %.1f ms\n", job.relief_milliseconds);
}

}  // namespace brindle::tool
