#include <algorithm>
#include <iostream>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/base/parallel.h"
#include "brindle/base/text.h"
#include "brindle/files.h"
#include "brindle/recipe/report.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "jobs/sample_job.h"
#include "outputs/outputs.h"

namespace brindle::tool {
namespace {

constexpr const char* kSampleExamples = R"(Examples:
  brindle sample horse.ply --stripes 100 --output samples.csv
  brindle sample scan.obj --stripes 30 --stripes-v 90 --output anisotropic.ply
  brindle sample scan.obj --field importance.csv --output samples.vtp --report samples.json
  brindle sample shape:torus --output samples.png
  brindle sample scan.obj --glyph arrow --size-by curvature --output arrows.png
  brindle sample points.ply --stripes 50 --output samples.csv
  brindle sample flow.vtp --frequency-by array:speed --output samples.csv)";

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
  json.update(to_json(job.prepared.figures, job.prepared.field_rows_nonfinite));
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
  if (job.draw_milliseconds) {
    json["milliseconds"]["draw"] = *job.draw_milliseconds;
    json.update(picture_json(picture));
  }
  return json;
}

void print(std::ostream& out, const SampleJob& job) {
  print_waves(out, job.prepared.figures);
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

void write(SampleOutput kind, const std::string& path, const CLI::App& command,
           const SampleArguments& arguments, const SampleJob& job, ProgressDisplay& display) {
  const Preparation& prepared = job.prepared;
  const Mesh& mesh = prepared.surface.mesh;
  const std::vector<Sample>& samples = job.taken.samples;
  switch (kind) {
    case SampleOutput::samples:
      return write_all_samples(path, mesh, prepared.arrays, samples, display);
    case SampleOutput::picture: {
      if (has_glyphs(command)) {
        return write_glyphs(path, prepared.surface, samples, arguments.glyphs, job.glyphs,
                            *arguments.picture, display.progress());
      }
      const Ornament discs = discs_of(samples, mesh.origin);
      return write_ornaments(path, prepared.surface, std::span(&discs, 1), *arguments.picture,
                             display.progress());
    }
    case SampleOutput::report:
      return write_report(path, command, mesh, to_json(job, *arguments.picture),
                          display.progress());
  }
}

void run_sample(const CLI::App& command, const SampleArguments& arguments) {
  const auto files = plan_files<SampleOutput>(sample_inputs(arguments), arguments.outputs,
                                              arguments.report, planned_sample);
  check_sample_options(command, arguments, files);
  check_sample_points(command, arguments, files);
  stand_upright(*arguments.picture, arguments.surface.mesh);
  const ThreadLimit threads(arguments.solving.threads);
  const std::optional<Image> picture = read_glyph_picture(arguments.glyphs);
  const SampleJob job = make_and_write(
      files, arguments.quiet, sample_stages(arguments),
      [&](ProgressDisplay& display) {
        SampleJob made = make_sample_job(arguments, display);
        if (has_glyphs(command)) {
          made.glyphs = read_glyph_input(arguments.glyphs, made.prepared, arguments.surface,
                                         arguments.waves, *arguments.picture);
          made.glyphs.picture = picture;
        }
        return made;
      },
      [&](SampleOutput kind, const std::string& path, const SampleJob& made,
          ProgressDisplay& display) { write(kind, path, command, arguments, made, display); });
  if (arguments.quiet) return;
  print(std::cout, job);
  print_written(std::cout, files);
}

}  // namespace

Command add_sample_command(CLI::App& app) {
  return add_command<SampleArguments>(app, "sample", "Sample a surface where two patterns cross",
                                      kSampleExamples, add_sample_options, run_sample);
}

}  // namespace brindle::tool
