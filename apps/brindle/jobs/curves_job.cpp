#include "jobs/curves_job.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "brindle/base/memory.h"
#include "brindle/base/stopwatch.h"
#include "brindle/error.h"
#include "brindle/polylines.h"
#include "brindle/recipe/report.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"
#include "pictures/paper.h"

namespace brindle::tool {
namespace {

WantedWinding parse_wales(const std::string& option, const std::string& text) {
  WantedWinding wales = parse_winding(option, text);
  if (wales.periods < 1) wrong_usage(option, "a number from 1 to 1000000", text);
  return wales;
}

}  // namespace

void add_traced_options(CLI::App& command, CurvesArguments& arguments) {
  add_surface_options(command, arguments.surface);
  add_wave_options(command, arguments.waves);
  add_fields(command, arguments.second);
  add_fabrication_options(command, arguments.fabrication);
  add_parsed_option(command, "--wales", arguments.second.wales, parse_wales);
  add_solver_option(command, arguments.solving);
  add_solving_options(command, arguments.solving);
  add_output_options(command, arguments);
  add_camera_options(command, arguments.picture);
}

void add_curves_options(CLI::App& command, CurvesArguments& arguments) {
  add_traced_options(command, arguments);
  add_fields<TracingOptions>(command, arguments);
  add_field(command, "--creases", arguments.crease_deg);
  add_paper_options(command, arguments.picture);
}

void check_traced_options(const CLI::App& command, const CurvesArguments& arguments) {
  check_field_options(command, arguments.waves);
  check_solving_options(command, arguments.solving);
  check_fabrication_options(arguments.fabrication, arguments.solving.stripes.solver.solver);
  if (arguments.traced == TracedWaves::v) {
    refuse_given(command, {"--winding", "--anchor-boundary"}, "U is not traced; leave out --lines");
  }
  if (arguments.second.wales.periods > 0) {
    refuse_given(command, {"--field-v", "--stripes-v", "--frequency-v"},
                 "--wales says how many stripes of V there are, and where they run");
  }
  if (arguments.traced == TracedWaves::u) {
    refuse_given(command, {"--field-v", "--stripes-v", "--frequency-v", "--wales"},
                 "V is not traced; add --lines v or --lines both");
  }
}

void check_curves_options(const CLI::App& command, const CurvesArguments& arguments,
                          const Outputs& outputs) {
  check_traced_options(command, arguments);
  const bool picture = has(outputs, OutputKind::picture);
  if (!picture && !has(outputs, OutputKind::drawing)) {
    refuse_picture_options(command, arguments.waves,
                           "nothing is drawn; add --output FILE.svg or FILE.png");
  }
  check_paper_options(command, arguments.picture, picture, has(outputs, OutputKind::drawing));
  if (!picture && has(outputs, OutputKind::drawing)) {
    refuse_given(command, {"--quality"}, "a drawing of lines has but one; add --output FILE.png");
    if (arguments.traced == TracedWaves::v) {
      refuse_given(command, {"--colors"},
                   "a drawing has lines alone, and those of V have a colour of their own; add "
                   "--output FILE.png");
    }
    refuse_light_option(command, arguments.waves,
                        "a drawing of lines shows no light; add --output FILE.png");
  }
  if (!has(outputs, OutputKind::lines)) {
    refuse_given(command, {"--creases"},
                 "no lines are written; add --output FILE.obj, .ply, .vtp or .csv (drawings have "
                 "their outline)");
  }
  if (!picture && !has(outputs, OutputKind::tubes)) {
    refuse_given(command, {"--tube-radius", "--tube-sides"},
                 "no tubes are written; add --output with a mesh file or FILE.png");
  }
}

void check_curves_points(const CurvesArguments& arguments) {
  if (!is_points(arguments.surface)) return;
  throw Error("curves need triangles, and '" + arguments.surface.mesh +
              "' has points alone; 'brindle stripe' and 'brindle sample' take points");
}

std::vector<UsedFile> curves_inputs(const CurvesArguments& arguments) {
  std::vector<UsedFile> inputs = job_inputs(arguments);
  if (!arguments.second.field.empty()) inputs.push_back({"--field-v", arguments.second.field});
  return inputs;
}

namespace {

constexpr const char* kEdges = "edges";

std::string stripes_of(const char* family) { return std::string("stripes of ") + family; }

// What to ask for instead of more curves than there is room for.
std::string fewer_stripes(const Mesh& mesh, const WaveOptions& waves, double share) {
  const auto fewer = [&](const char* option, float asked) {
    return std::string("; ") + option + ' ' + rounded_down(static_cast<double>(asked) * share) +
           " would do";
  };
  if (waves.stripes) return fewer("--stripes", *waves.stripes);
  if (!waves.frequency && !waves.spacing) return "";
  return fewer("--frequency", constant_frequency(mesh, waves));
}

StripeCurves traced_curves(const StripeTracer& tracer, const Mesh& mesh,
                           const StripePattern& pattern, const CurvesArguments& arguments,
                           const Progress& progress) {
  try {
    return tracer.curves(pattern, arguments.curves, progress);
  } catch (const TooLarge& error) {
    throw Error(error.what() + fewer_stripes(mesh, arguments.waves, error.share()));
  }
}

// Whether the spacing can be measured in about half a second. It is sampled on both sides of the
// curves at every fifth of 1/f.
bool is_soon_measured(const CurveFamily& family) {
  constexpr double kMost = 100'000;
  const FrequencyField& frequencies = family.pattern.waves.frequencies;
  return 10 * total_length(family.curves.lines) <= kMost * mean_spacing(frequencies);
}

void measure_spacing(const StripeTracer& tracer, CurveMetrics metrics, CurveFamily& family,
                     JobListener& listener) {
  if (metrics == CurveMetrics::few) return;
  if (metrics == CurveMetrics::brief && !is_soon_measured(family)) {
    return listener.note("the gaps between so many curves (" + family.name +
                         ") take long to measure; a report, as 'Export curves' writes it (.json), "
                         "has them\n");
  }
  listener.stage("spacing");
  const auto spacing = tracer.spacing(family.pattern, family.curves, listener.progress());
  if (spacing && spacing->measured > 0) family.spacing = spacing;
}

// Removes short curves after all ends are counted.
void drop_short(CurveFamily& family, float min_length) {
  if (min_length <= 0) return;
  const StripeCurves all = std::move(family.curves);
  family.curves = longer_than(all, min_length);
  family.short_curves = all.lines.count() - family.curves.lines.count();
}

void shape_lines(const CurvesArguments& arguments, const Mesh& mesh, CurveFamily& family,
                 JobListener& listener) {
  const float diagonal = bounding_box(mesh).diagonal();
  drop_short(family, arguments.min_length.on(diagonal));
  if (family.curves.lines.count() == 0)
    listener.note(why_no_curves(family.name, family.short_curves));
  Polylines& lines = family.curves.lines;
  if (arguments.path_width) {
    listener.stage("coverage");
    const CurveCoverage coverage =
        measure_coverage(mesh, lines, arguments.path_width->on(diagonal), listener.progress());
    family.coverage = coverage.once;
    family.covered_twice = coverage.twice;
  }
  listener.stage("points");
  reshape(lines, arguments, diagonal, listener.progress());
  family.lengths = curve_lengths(lines);
}

// Solves, notes and traces.
CurveFamily family_of(const CurvesArguments& arguments, const CurvesJob& job,
                      const StripeTracer& tracer, const char* name, WaveSet waves,
                      FabricationOptions fabrication, JobListener& listener) {
  const Surface& surface = job.prepared.surface;
  listener.stage(stripes_of(name));
  fabrication.measure_windings = true;
  PatternResult made =
      pattern_of(surface, std::move(waves),
                 {PatternKind::stripes, job.options, std::move(fabrication)}, listener.progress());
  StripePattern& pattern = std::get<StripePattern>(made.of);
  listener.note(
      quality_warning(job.prepared.metrics, pattern.quality, surface.mesh.triangle_count()));
  CurveFamily family = traced_family(arguments, surface, tracer, name, std::move(pattern),
                                     CurveMetrics::all, listener);
  family.fabrication = std::move(made.fabrication);
  return family;
}

}  // namespace

CurveFamily traced_family(const CurvesArguments& arguments, const Surface& surface,
                          const StripeTracer& tracer, std::string name, StripePattern traced,
                          CurveMetrics metrics, JobListener& listener) {
  CurveFamily family;
  family.name = std::move(name);
  family.pattern = std::move(traced);
  StripePattern& pattern = family.pattern;
  family.jogs = shift_stripes(surface, arguments.offset, pattern);
  listener.stage("curves");
  Stopwatch watch;
  family.curves = traced_curves(tracer, surface.mesh, pattern, arguments, listener.progress());
  family.extract_milliseconds = watch.lap();
  family.ends = family.curves.end_counts();
  measure_spacing(tracer, metrics, family, listener);
  shape_lines(arguments, surface.mesh, family, listener);
  return family;
}

FabricationOptions fabrication_of_v(const CurvesArguments& arguments) {
  FabricationOptions fabrication;
  fabrication.cancel_branches = arguments.fabrication.cancel_branches;
  fabrication.cancel_distance = arguments.fabrication.cancel_distance;
  if (arguments.second.wales.periods > 0) fabrication.windings = {arguments.second.wales};
  return fabrication;
}

std::vector<JobStage> curves_stages(const CurvesArguments& arguments) {
  std::vector<JobStage> stages = preparation_stages(arguments.surface);
  stages.push_back({kEdges, 1});
  const auto add = [&](const char* name) {
    stages.insert(stages.end(), {{stripes_of(name), 4}, {"curves", 4}, {"spacing", 3}});
    if (arguments.path_width) stages.push_back({"coverage", 2});
    stages.push_back({"points", 1});
  };
  if (arguments.traced != TracedWaves::v) add("u");
  if (arguments.traced != TracedWaves::u) add("v");
  return stages;
}

CurvesJob make_curves_job(const CurvesArguments& arguments, JobListener& listener) {
  CurvesJob job;
  Preparation& prepared = job.prepared;
  prepared = prepare(arguments.surface, arguments.waves, listener, viewpoint_of(arguments.picture));
  job.options = stripe_options(arguments.solving, prepared);
  Stopwatch watch;
  listener.stage(kEdges);
  const StripeTracer tracer(prepared.surface, listener.progress());
  job.edges_milliseconds = watch.lap();
  WaveSet v;
  if (arguments.traced != TracedWaves::u) {
    v = make_second_waves(first_waves(prepared), arguments.second, listener);
  }
  const auto add = [&](const char* name, WaveSet& waves, const FabricationOptions& fabrication) {
    job.families.push_back(
        family_of(arguments, job, tracer, name, std::move(waves), fabrication, listener));
  };
  if (arguments.traced != TracedWaves::v) add("u", prepared.waves, arguments.fabrication);
  if (arguments.traced != TracedWaves::u) add("v", v, fabrication_of_v(arguments));
  return job;
}

double total_length(const Polylines& lines) {
  double length = 0;
  for (std::size_t line = 0; line < lines.count(); ++line) length += length_of(lines, line);
  return length;
}

std::size_t closed_count(const Polylines& lines) {
  return std::accumulate(lines.closed.begin(), lines.closed.end(), std::size_t{0});
}

void reshape(Polylines& lines, const LineShape& shape, float diagonal, const Progress& progress) {
  if (shape.resample) {
    try {
      lines = resampled(lines, shape.resample->on(diagonal), progress.part(0, 0.7));
    } catch (const TooLarge& error) {
      throw Error(std::string("--resample: ") + error.what());
    }
  }
  if (shape.simplify) {
    lines = simplified(lines, shape.simplify->on(diagonal), progress.part(0.7, 1));
  }
}

namespace {

// The default leaves most of the surface visible: a sixth of the spacing in diameter.
float tube_radius_of(const CurvesArguments& arguments, const Mesh& mesh,
                     const FrequencyField& frequencies) {
  if (arguments.tube_radius) return arguments.tube_radius->on(bounding_box(mesh).diagonal());
  return static_cast<float>(mean_spacing(frequencies) / 12);
}

}  // namespace

std::vector<Ornament> tubes_of(const CurvesArguments& arguments, const Mesh& mesh,
                               std::span<const CurveFamily> families) {
  const TubeOptions options{
      tube_radius_of(arguments, mesh, families.front().pattern.waves.frequencies),
      arguments.tube_sides};
  std::vector<Ornament> ornaments;
  for (const CurveFamily& family : families) {
    ornaments.push_back({tubes(family.curves.lines, options), family.name == "v"});
  }
  return ornaments;
}

}  // namespace brindle::tool
