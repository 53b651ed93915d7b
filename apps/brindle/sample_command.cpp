#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <memory>
#include <numbers>

#include <Eigen/Geometry>

#include "brindle/base/file_extension.h"
#include "brindle/base/output_file.h"
#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/pattern/point_sampling.h"
#include "brindle/points/point_tree.h"
#include "carried_arrays.h"
#include "command_line.h"
#include "commands.h"
#include "formatted.h"
#include "frequency_report.h"
#include "glyph_options.h"
#include "option_values.h"
#include "outputs.h"
#include "picture.h"
#include "planned_files.h"
#include "preparation.h"
#include "report.h"
#include "second_waves.h"
#include "solving_options.h"

namespace brindle::tool {
namespace {

constexpr const char* kSampleExamples = R"(Examples:
  brindle sample horse.ply --stripes 100 --output samples.csv
  brindle sample scan.obj --stripes 30 --stripes-v 90 --output anisotropic.ply
  brindle sample scan.obj --field importance.csv --output samples.vtp --report samples.json
  brindle sample shape:torus --output samples.png
  brindle sample scan.obj --glyph arrow --size-by curvature --output arrows.png
  brindle sample points.ply --stripes 50 --output samples.csv
  brindle sample flow.vtp --frequency-by array:speed --output samples.csv

Files by extension: .csv .ply .vtp samples, each with position, normal, both directions and
spacings, triangle and barycentric coordinates; .png a picture; .json a report. A field file's
fourth column and that of --field-v are frequencies, and so is --field's fifth, of V: the higher,
the denser the samples.)";

constexpr const char* kNoSamples =
    "no samples: nowhere do stripes of both patterns cross; ask for more stripes\n";

struct SampleArguments {
  SurfaceOptions surface;
  WaveOptions waves;
  SecondWaveOptions second;
  SolvingOptions solving;
  std::shared_ptr<PictureOptions> picture;
  GlyphOptions glyphs;
  float min_distance = 0.25f;
  std::vector<std::string> outputs;
  std::string report;
  bool quiet = false;
};

enum class SampleOutput { samples, picture, report };

SampleOutput planned_sample(const std::string& path) {
  check_output_path(path);
  const std::string kind = lower_extension(path);
  if (kind == ".json") return SampleOutput::report;
  if (kind == ".png") {
    check_pictures_available();
    return SampleOutput::picture;
  }
  if (is_sample_format(path)) return SampleOutput::samples;
  refuse_output(path, "'" + kind +
                          "' files hold no samples; use .csv, .ply or .vtp, .png for a picture, "
                          ".json for a report");
}

struct SampleResult {
  Preparation prepared;
  StripePattern u, v;
  std::vector<Sample> samples;
  std::size_t doubles = 0;  // left out
  std::optional<SampleSpacing> spacing;
  double edges_milliseconds = 0;
  double extract_milliseconds = 0;
  std::optional<double> draw_milliseconds;
  GlyphInput glyphs;
};

WavePattern wave_pattern(const SampleArguments& arguments, const Surface& surface,
                         const MeshEdges& edges, const StripePattern& pattern) {
  return {surface.mesh,       edges,
          surface.normals,    pattern.waves,
          pattern.solution.z, arguments.solving.stripes.phase_shift};
}

void drop_and_measure(SampleResult& result, float min_distance) {
  result.doubles = drop_doubles(result.samples, min_distance);
  result.spacing = measure_sample_spacing(result.samples);
}

SampleResult make_result(const SampleArguments& arguments, ProgressDisplay& display) {
  SampleResult result;
  result.prepared =
      prepare(arguments.surface, arguments.waves, display, viewpoint_of(*arguments.picture));
  const Surface& surface = result.prepared.surface;
  WaveSet waves_v = make_second_waves(result.prepared, arguments.second);
  if (is_other(arguments.second)) {
    noted_waves(surface, waves_v, "the field of V", display);
  }
  const StripeOptions options = stripe_options(arguments.solving, result.prepared);
  result.u = stripe_pattern(surface, std::move(result.prepared.waves), options, display.progress());
  result.v = stripe_pattern(surface, std::move(waves_v), options, display.progress());

  display.note(branch_warning(result.prepared.figures,
                              std::max(result.u.quality.branches, result.v.quality.branches),
                              surface.mesh.triangle_count()));
  display.stage("samples");
  Stopwatch watch;
  if (surface.mesh.triangles.empty()) {
    result.samples =
        point_samples(*surface.neighborhood, surface.normals, {result.u.waves, result.u.solution.z},
                      {result.v.waves, result.v.solution.z});
    result.extract_milliseconds = watch.lap();
    drop_and_measure(result, arguments.min_distance);
    return result;
  }
  const MeshEdges edges = mesh_edges(surface.mesh, *surface.neighborhood);
  result.edges_milliseconds = watch.lap();
  const LiftedWaves u(wave_pattern(arguments, surface, edges, result.u));
  const LiftedWaves v(wave_pattern(arguments, surface, edges, result.v));
  result.samples = wave_samples(surface.mesh, surface.normals, sampled_waves(u), sampled_waves(v));
  result.extract_milliseconds = watch.lap();
  if (PointTree::available()) drop_and_measure(result, arguments.min_distance);
  return result;
}

nlohmann::ordered_json to_json(const SampleResult& result, const PictureOptions& picture) {
  const Surface& surface = result.prepared.surface;
  const auto both = [&](double StripeMilliseconds::*part) {
    return result.u.milliseconds.*part + result.v.milliseconds.*part;
  };
  nlohmann::ordered_json json = {{"vertices", surface.mesh.vertex_count()},
                                 {"triangles", surface.mesh.triangle_count()},
                                 {"edges", surface.neighborhood->edge_count()},
                                 {"vertices_joined", result.prepared.vertices_joined},
                                 {"threads", ThreadLimit::current()},
                                 {"samples", result.samples.size()},
                                 {"doubles_left_out", result.doubles},
                                 {"branches_u", result.u.quality.branches},
                                 {"branches_v", result.v.quality.branches}};
  json.update(to_json(result.prepared.figures, result.prepared.field_rows_nonfinite));
  const auto add_frequency = [&](const char* name, const StripePattern& pattern) {
    const auto frequency = frequency_report(pattern.frequency_change, pattern.quality);
    if (frequency) json[name] = to_json(*frequency);
  };
  add_frequency("frequency_change_u", result.u);
  add_frequency("frequency_change_v", result.v);
  if (result.spacing) {
    json["nearest_neighbour"] = {{"measured", result.spacing->samples},
                                 {"mean", result.spacing->mean},
                                 {"deviation", result.spacing->deviation},
                                 {"isolated_double_share", result.spacing->double_share}};
  }
  json["milliseconds"] = {
      {"load", result.prepared.load_milliseconds},
      {"field", result.prepared.field_milliseconds},
      {"topology", result.prepared.topology_milliseconds + result.edges_milliseconds +
                       both(&StripeMilliseconds::topology)},
      {"couple", both(&StripeMilliseconds::couple)},
      {"solve", both(&StripeMilliseconds::solve)},
      {"pattern", both(&StripeMilliseconds::pattern)},
      {"extract", result.extract_milliseconds}};
  if (result.u.frequency_change) {
    json["milliseconds"]["frequency"] = both(&StripeMilliseconds::frequency);
  }
  if (result.draw_milliseconds) {
    json["milliseconds"]["draw"] = *result.draw_milliseconds;
    json["picture_quality"] = quality_name(picture);
  }
  return json;
}

void print(std::ostream& out, const SampleResult& result) {
  print_waves(out, result.prepared.figures);
  out << formatted("samples   %zu, %zu more left out as too near to others\n",
                   result.samples.size(), result.doubles)
      << formatted("branches  %zu of U, %zu of V\n", result.u.quality.branches,
                   result.v.quality.branches);
  if (result.spacing && result.spacing->samples > 0) {
    out << formatted(
        "nearest   %.3f of the ideal grid's distance on average, deviation %.3f, doubles %.2f %%\n",
        result.spacing->mean, result.spacing->deviation, 100 * result.spacing->double_share);
  }
  out << formatted("time      extracted in %.1f ms\n", result.extract_milliseconds);
}

// Discs a third as wide as the spacing, just above and below: a surface may be wound either way.
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
      mesh.positions.push_back(centre + radius * (std::cos(angle) * x + std::sin(angle) * y));
    }
    for (Index k = 1; k + 1 < kCorners; ++k) {
      mesh.triangles.push_back({first, first + k, first + k + 1});
    }
  }
}

// Columns and arrays of all formats, which those of the input's file do not replace.
const std::vector<std::string> kSampleColumns = {"normal",      "direction_u", "direction_v",
                                                 "spacing_u",   "spacing_v",   "triangle",
                                                 "barycentric", "frequency_u", "frequency_v"};

std::vector<TrianglePoint> places_of(std::span<const Sample> samples) {
  std::vector<TrianglePoint> places;
  for (const Sample& sample : samples) {
    const Eigen::Vector3d shares = sample.barycentric.cast<double>();
    const Eigen::Vector3d b = shares / shares.sum();
    places.push_back({sample.triangle, {b[0], b[1], b[2]}});
  }
  return places;
}

// Of samples of points, whose numbers stand for triangles.
std::vector<Index> points_of(std::span<const Sample> samples) {
  std::vector<Index> points;
  for (const Sample& sample : samples) points.push_back(sample.triangle);
  return points;
}

// What samples have as spacings.
DataArray frequencies_of(const char* name, std::span<const Sample> samples,
                         float Sample::*spacing) {
  std::vector<float> frequencies;
  for (const Sample& sample : samples) frequencies.push_back(1 / sample.*spacing);
  return make_data_array(name, 1, frequencies);
}

void write_all_samples(const std::string& path, const SampleResult& result,
                       ProgressDisplay& display) {
  const Mesh& mesh = result.prepared.surface.mesh;
  const std::vector<Sample>& samples = result.samples;
  std::vector<DataArray> arrays = {frequencies_of("frequency_u", samples, &Sample::spacing_u),
                                   frequencies_of("frequency_v", samples, &Sample::spacing_v)};
  const DataArrays held = held_beside(kSampleColumns, path, result.prepared.arrays, display);
  std::vector<DataArray> carried = mesh.triangles.empty()
                                       ? rows_of(held.points, points_of(samples))
                                       : arrays_at(places_of(samples), mesh.triangles, held);
  std::move(carried.begin(), carried.end(), std::back_inserter(arrays));
  write_samples(path, samples, mesh.origin, arrays);
}

void write(SampleOutput kind, const std::string& path, const CLI::App& command,
           const SampleArguments& arguments, const SampleResult& result, ProgressDisplay& display) {
  switch (kind) {
    case SampleOutput::samples:
      return write_all_samples(path, result, display);
    case SampleOutput::picture: {
      if (has_glyphs(command)) {
        return write_glyphs(path, result.prepared.surface, result.samples, arguments.glyphs,
                            result.glyphs, *arguments.picture);
      }
      Ornament discs{{}, true};
      discs.mesh.origin = result.prepared.surface.mesh.origin;
      for (const Sample& sample : result.samples) add_disc(sample, discs.mesh);
      return write_ornaments(path, result.prepared.surface, std::span(&discs, 1),
                             *arguments.picture);
    }
    case SampleOutput::report:
      return write_report(path, command, result.prepared.surface.mesh,
                          to_json(result, *arguments.picture));
  }
}

// What would change nothing, and what cannot be drawn.
void check(const CLI::App& command, const SampleArguments& arguments,
           const PlannedFiles<SampleOutput>& files) {
  check_field_options(command, arguments.waves);
  check_solving_options(command, arguments.solving);
  check_glyph_options(command, arguments.glyphs);
  if (!has(files, SampleOutput::picture)) {
    refuse_glyph_options(command, "no picture is written; add --output FILE.png");
    refuse_picture_options(command, arguments.waves,
                           "no picture is written; add --output FILE.png");
  }
  if (!PointTree::available()) {
    refuse_given(command, {"--min-distance"},
                 "this build has no nanoflann; configure with -DBRINDLE_NANOFLANN=ON");
  }
  if (!is_points(arguments.surface)) return;
  refuse_triangle_options(command);
  for (const auto& [kind, path] : files) {
    if (kind == SampleOutput::picture) {
      refuse_output(path, "samples are drawn on meshes alone; write .csv, .ply or .vtp");
    }
  }
  if (arguments.min_distance < kDoubleShare) {
    throw CLI::ValidationError("--min-distance",
                               "has no effect on points below 0.25: so near to each other, what "
                               "two points find of one crossing is merged");
  }
}

void run_sample(const CLI::App& command, const SampleArguments& arguments) {
  std::vector<UsedFile> inputs = input_files(arguments.surface, arguments.waves);
  if (!arguments.second.field.empty()) inputs.push_back({"--field-v", arguments.second.field});
  for (UsedFile& file : glyph_files(arguments.glyphs)) inputs.push_back(std::move(file));
  add_slack_files(arguments.solving.slack, inputs);
  const auto files =
      plan_files<SampleOutput>(inputs, arguments.outputs, arguments.report, planned_sample);
  check(command, arguments, files);
  if (is_shape(arguments.surface)) stand_on_z(*arguments.picture);
  const ThreadLimit threads(arguments.solving.threads);
  const std::optional<Image> picture = read_glyph_picture(arguments.glyphs);
  const SampleResult result = make_and_write(
      files, arguments.quiet,
      [&](ProgressDisplay& display) {
        SampleResult made = make_result(arguments, display);
        if (has_glyphs(command)) {
          made.glyphs = read_glyph_input(arguments.glyphs, made.prepared, arguments.surface,
                                         arguments.waves, *arguments.picture);
          made.glyphs.picture = picture;
        }
        if (made.samples.empty()) display.note(kNoSamples);
        return made;
      },
      [&](SampleOutput kind, const std::string& path, const SampleResult& made,
          ProgressDisplay& display) { write(kind, path, command, arguments, made, display); });
  if (arguments.quiet) return;
  print(std::cout, result);
  print_written(std::cout, files);
}

void add_sample_options(CLI::App& command, SampleArguments& arguments) {
  add_surface_options(command, arguments.surface);
  add_point_options(command, arguments.surface);
  add_wave_options(command, arguments.waves);
  add_second_wave_options(command, arguments.second);
  add_parsed_option(command, "--min-distance", arguments.min_distance, parse_not_negative_number,
                    "leave out samples nearer to another, in spacings (default 0.25)")
      ->type_name("D");
  add_solver_option(command, arguments.solving);
  add_solving_options(command, arguments.solving);
  add_output_options(command, arguments.outputs, arguments.report, arguments.quiet);
  arguments.picture = add_camera_options(command);
  add_glyph_options(command, arguments.glyphs);
}

}  // namespace

Command add_sample_command(CLI::App& app) {
  return add_command<SampleArguments>(app, "sample", "Sample a surface where two patterns cross",
                                      kSampleExamples, add_sample_options, run_sample);
}

}  // namespace brindle::tool
