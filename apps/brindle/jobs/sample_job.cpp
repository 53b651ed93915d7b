#include "jobs/sample_job.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <ostream>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/file_names.h"
#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/pattern_warnings.h"
#include "brindle/points.h"
#include "brindle/recipe/report.h"
#include "brindle/stripe_tracer.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"
#include "outputs/outputs.h"
#include "pictures/paper.h"

namespace brindle::tool {

void add_sample_options(CLI::App& command, SampleArguments& arguments) {
  add_surface_options(command, arguments.surface);
  add_point_options(command, arguments.surface);
  add_wave_options(command, arguments.waves);
  add_fields(command, arguments.second);
  add_field(command, "--min-distance", arguments.min_distance);
  add_solver_option(command, arguments.solving);
  add_solving_options(command, arguments.solving);
  add_output_options(command, arguments);
  add_camera_options(command, arguments.picture);
  add_paper_options(command, arguments.picture);
  add_glyph_options(command, arguments.glyphs);
}

OutputKind planned_sample(const std::filesystem::path& path) {
  const std::string kind = lower_extension(path);
  if (kind == ".json") return OutputKind::report;
  if (kind == ".png") return OutputKind::picture;
  if (is_sample_format(path)) return OutputKind::samples;
  refuse_output(path, "'" + kind +
                          "' files hold no samples; use .csv, .ply or .vtp, .png for a picture, "
                          ".json for a report");
}

void check_sample_options(const CLI::App& command, const SampleArguments& arguments,
                          const Outputs& outputs) {
  check_field_options(command, arguments.waves);
  check_solving_options(command, arguments.solving);
  check_glyph_options(command, arguments.glyphs);
  if (!has(outputs, OutputKind::picture)) {
    refuse_style_options(command, "no picture is written; add --output FILE.png");
    refuse_picture_options(command, arguments.waves,
                           "no picture is written; add --output FILE.png");
  }
  check_paper_options(command, arguments.picture, has(outputs, OutputKind::picture), false);
  if (!has_point_trees()) {
    refuse_given(command, {"--min-distance"},
                 "this build has no nanoflann; configure with -DBRINDLE_NANOFLANN=ON");
  }
}

void check_sample_points(const CLI::App& command, const SampleArguments& arguments,
                         const Outputs& outputs) {
  if (!is_points(arguments.surface)) return;
  refuse_triangle_options(command);
  for (const Output& output : outputs) {
    if (output.kind == OutputKind::picture) {
      refuse_output(output.path, "samples are drawn on meshes alone; write .csv, .ply or .vtp");
    }
  }
  refuse_usage([&] { check_min_distance_on_points(arguments.min_distance); });
}

std::vector<UsedFile> sample_inputs(const SampleArguments& arguments) {
  std::vector<UsedFile> inputs = job_inputs(arguments);
  if (!arguments.second.field.empty()) inputs.push_back({"--field-v", arguments.second.field});
  for (UsedFile& file : glyph_files(arguments.glyphs)) inputs.push_back(std::move(file));
  return inputs;
}

namespace {

TakenSamples all_samples(const Surface& surface, const StripePattern& u, const StripePattern& v,
                         const Progress& progress) {
  TakenSamples taken;
  Stopwatch watch;
  const StripeTracer tracer(surface, progress.part(0, 0.3));
  taken.edges_milliseconds = watch.lap();
  taken.samples = tracer.crossings(u, v, progress.part(0.3, 1));
  taken.extract_milliseconds = watch.lap();
  return taken;
}

}  // namespace

TakenSamples taken_samples(const SampleArguments& arguments, const Surface& surface,
                           const StripePattern& u, const StripePattern& v, JobListener& listener) {
  listener.stage("samples");
  TakenSamples taken = all_samples(surface, u, v, listener.progress());
  if (surface.mesh.triangles.empty() || has_point_trees()) {
    listener.stage("doubles");
    taken.doubles = drop_doubles(taken.samples, arguments.min_distance, listener.progress());
    listener.stage("spacing");
    taken.spacing = measure_sample_spacing(taken.samples, listener.progress());
  }
  if (taken.samples.empty()) listener.note(kNoSamples);
  return taken;
}

std::vector<JobStage> sample_stages(const SampleArguments& arguments) {
  std::vector<JobStage> stages = preparation_stages(arguments.surface);
  stages.insert(
      stages.end(),
      {{"stripes of u", 4}, {"stripes of v", 4}, {"samples", 4}, {"doubles", 2}, {"spacing", 2}});
  return stages;
}

SampleJob make_sample_job(const SampleArguments& arguments, JobListener& listener) {
  SampleJob job;
  Preparation& prepared = job.prepared;
  prepared = prepare(arguments.surface, arguments.waves, listener, viewpoint_of(arguments.picture));
  const Surface& surface = prepared.surface;
  WaveSet waves_v = make_second_waves(first_waves(prepared), arguments.second, listener);
  const StripeOptions options = stripe_options(arguments.solving, prepared);
  listener.stage("stripes of u");
  job.u = stripe_pattern(surface, std::move(prepared.waves), options, listener.progress());
  listener.stage("stripes of v");
  job.v = stripe_pattern(surface, std::move(waves_v), options, listener.progress());
  listener.note(quality_warning(prepared.metrics, worse_of(job.u.quality, job.v.quality),
                                surface.mesh.triangle_count()));
  job.taken = taken_samples(arguments, surface, job.u, job.v, listener);
  return job;
}

namespace {

// Discs a third of the spacing wide, just above and below the surface, whose winding may be either.
void add_disc(const Sample& sample, Mesh& mesh) {
  constexpr int kCorners = 16;
  const float radius = 0.16f * std::min(sample.spacing_u, sample.spacing_v);
  const Vec3 x = sample.direction_u;
  const Vec3 y = sample.normal.cross(x);
  for (const float height : {-0.12f, 0.12f}) {
    const auto first = static_cast<Index>(mesh.positions.size());
    const Vec3 centre = sample.position + height * radius * sample.normal;
    for (int k = 0; k < kCorners; ++k) {
      const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / kCorners;
      mesh.positions.push_back(centre +
                               radius * (elementary::cos(angle) * x + elementary::sin(angle) * y));
    }
    for (Index k = 1; k + 1 < kCorners; ++k) {
      mesh.triangles.push_back({first, first + k, first + k + 1});
    }
  }
}

}  // namespace

Ornament discs_of(std::span<const Sample> samples, const Eigen::Vector3d& origin) {
  Ornament discs{{}, true};
  discs.mesh.origin = origin;
  for (const Sample& sample : samples) add_disc(sample, discs.mesh);
  return discs;
}

namespace {

// Columns and arrays of all formats, which input arrays must not replace.
const std::vector<std::string> kSampleColumns = {"normal",      "direction_u", "direction_v",
                                                 "spacing_u",   "spacing_v",   "triangle",
                                                 "barycentric", "frequency_u", "frequency_v"};

// What samples have as spacings.
DataArray frequencies_of(const char* name, std::span<const Sample> samples,
                         float Sample::*spacing) {
  std::vector<float> frequencies;
  for (const Sample& sample : samples) frequencies.push_back(1 / sample.*spacing);
  return make_data_array(name, 1, frequencies);
}

}  // namespace

std::vector<DataArray> frequency_arrays(std::span<const Sample> samples) {
  return {frequencies_of("frequency_u", samples, &Sample::spacing_u),
          frequencies_of("frequency_v", samples, &Sample::spacing_v)};
}

void write_all_samples(const std::filesystem::path& path, const Mesh& mesh, const DataArrays& input,
                       std::span<const Sample> samples, JobListener& listener) {
  std::vector<DataArray> arrays = frequency_arrays(samples);
  const DataArrays held = held_beside(kSampleColumns, path, input, listener);
  std::vector<DataArray> carried = arrays_at(samples, mesh.triangles, held);
  std::move(carried.begin(), carried.end(), std::back_inserter(arrays));
  write_samples(path, samples, mesh.origin, arrays, listener.progress());
}

nlohmann::ordered_json to_json(const SampleJob& job, const PictureOptions& picture) {
  const Surface& surface = job.prepared.surface;
  const auto both = [&](double StripeMilliseconds::*part) {
    return job.u.milliseconds.*part + job.v.milliseconds.*part;
  };
  nlohmann::ordered_json json = {
      {"vertices", surface.own_vertex_count()}, {"triangles", surface.mesh.triangle_count()},
      {"edges", surface.own_edge_count()},      {"vertices_joined", job.prepared.vertices_joined},
      {"threads", ThreadLimit::current()},      {"samples", job.taken.samples.size()},
      {"doubles_left_out", job.taken.doubles},  {"branches_u", job.u.quality.branches},
      {"branches_v", job.v.quality.branches}};
  json.update(to_json(job.prepared.metrics, job.prepared.field_rows_nonfinite));
  const auto add_frequency = [&](const char* name, const StripePattern& pattern) {
    const auto frequency = frequency_report(pattern.frequency_change, pattern.quality);
    if (frequency) json[name] = to_json(*frequency);
  };
  add_frequency("frequency_change_u", job.u);
  add_frequency("frequency_change_v", job.v);
  if (job.taken.spacing) json["nearest_neighbour"] = brindle::to_json(*job.taken.spacing);
  json["milliseconds"] = {
      {"load", job.prepared.load_milliseconds},
      {"field", job.prepared.field_milliseconds},
      {"topology", job.prepared.topology_milliseconds + job.taken.edges_milliseconds +
                       both(&StripeMilliseconds::topology)},
      {"couple", both(&StripeMilliseconds::couple)},
      {"solve", both(&StripeMilliseconds::solve)},
      {"pattern", both(&StripeMilliseconds::pattern)},
      {"extract", job.taken.extract_milliseconds}};
  if (job.u.frequency_change) {
    json["milliseconds"]["frequency"] = both(&StripeMilliseconds::frequency);
  }
  if (!job.ranks.is_null()) json["ranks"] = job.ranks;
  if (job.draw_milliseconds) {
    json["milliseconds"]["draw"] = *job.draw_milliseconds;
    json.update(picture_json(picture));
  }
  return json;
}

void print(std::ostream& out, const SampleJob& job) {
  print_waves(out, job.prepared.metrics);
  out << formatted("samples   %zu, %zu more left out as too near to others\n",
                   job.taken.samples.size(), job.taken.doubles)
      << formatted("branches  %zu of U, %zu of V\n", job.u.quality.branches,
                   job.v.quality.branches);
  if (job.taken.spacing && job.taken.spacing->samples > 0) {
    out << formatted(
        "nearest   %.3f of the ideal grid's distance on average, deviation %.3f, doubles %.2f %%\n",
        job.taken.spacing->mean, job.taken.spacing->deviation,
        100 * job.taken.spacing->double_share);
  }
  out << formatted("time      extracted in %.1f ms\n", job.taken.extract_milliseconds);
}

void write_sample_file(const Output& output, const CLI::App& command,
                       const SampleArguments& arguments, const SampleJob& job,
                       JobListener& listener) {
  const Preparation& prepared = job.prepared;
  const Mesh& mesh = prepared.surface.mesh;
  const std::vector<Sample>& samples = job.taken.samples;
  const std::filesystem::path& path = output.path;
  switch (output.kind) {
    case OutputKind::samples:
      return write_all_samples(path, mesh, prepared.arrays, samples, listener);
    case OutputKind::picture: {
      if (is_styled(command)) {
        return write_glyphs(path, prepared.surface, samples, arguments.glyphs, job.glyphs,
                            arguments.picture, listener.progress());
      }
      const Ornament discs = discs_of(samples, mesh.origin);
      return write_ornaments(path, prepared.surface, std::span(&discs, 1), arguments.picture,
                             listener.progress());
    }
    case OutputKind::report:
      return write_report(path, command, mesh, to_json(job, arguments.picture),
                          listener.progress());
    default:
      throw Error(shown(path.native()) + ": holds no samples of one process");
  }
}

}  // namespace brindle::tool
