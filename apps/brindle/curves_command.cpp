#include <algorithm>
#include <iostream>
#include <memory>
#include <numeric>

#include "brindle/base/file_extension.h"
#include "brindle/base/output_file.h"
#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/curve_measures.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/geometry/append_mesh.h"
#include "brindle/pattern/curve_spacing.h"
#include "brindle/points/point_tree.h"
#include "brindle/polylines.h"
#include "carried_arrays.h"
#include "command_line.h"
#include "commands.h"
#include "formatted.h"
#include "frequency_report.h"
#include "making_options.h"
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

constexpr const char* kCurvesExamples = R"(Examples:
  brindle curves horse.ply --stripes 100 --output horse.svg --camera 60,15
  brindle curves scan.obj --lines both --stripes 30 --stripes-v 60 --output grid.obj
  brindle curves shape:torus --tube-radius 0.4% --output tubes.glb
  brindle curves scan.obj --offset 0.5 --min-length 2% --simplify 0.05% --output gaps.csv
  brindle curves shape:torus --stripes 60 --line-width 0.8% --report torus.json
  brindle curves shape:tube --field curvature --curvature-direction min --winding 1 --output vase.vtp
  brindle curves shape:trefoil --join --output curves.vtp --report curves.json
  brindle curves plate.vtp --field array:stress --along --lines both --output stress.svg

Files by extension: .obj .ply .vtp .csv lines; with --tube-radius .obj .ply .vtp .gltf .glb a mesh
of tubes; .svg a drawing with hidden lines removed; .png a picture; .json a report. Lengths are in
the mesh's units, or in percent of the bounding box's diagonal. --help of 'brindle stripe' tells
more of fields and cameras.)";

enum class Which { u, v, both };

std::optional<Which> parse_which(std::string_view name) {
  if (name == "u") return Which::u;
  if (name == "v") return Which::v;
  if (name == "both") return Which::both;
  return std::nullopt;
}

struct CurvesArguments {
  SurfaceOptions surface;
  WaveOptions waves;
  SecondWaveOptions second;
  SolvingOptions solving;
  MakingOptions making;
  int wales = 0;
  std::shared_ptr<PictureOptions> picture;
  Which which = Which::u;
  float offset = 0;
  bool join = false;
  Length min_length;
  std::optional<Length> simplify, resample, tube_radius, line_width;
  int tube_sides = 8;
  std::vector<std::string> outputs;
  std::string report;
  bool quiet = false;
};

enum class CurveOutput { lines, tubes, drawing, picture, report };

// What a path asks for. Throws CLI::ValidationError, naming what to do, for what it cannot hold.
CurveOutput planned(const std::string& path, bool tubes) {
  const std::string kind = lower_extension(path);
  check_output_path(path);
  if (kind == ".json") return CurveOutput::report;
  if (kind == ".svg" || kind == ".png") {
    check_pictures_available();
    return kind == ".svg" ? CurveOutput::drawing : CurveOutput::picture;
  }
  const bool mesh = kind == ".gltf" || kind == ".glb";
  if (mesh && !tubes) {
    refuse_output(path, "brindle writes no lines into " + kind +
                            "; use .obj, .ply, .vtp or .csv, or ask for tubes with --tube-radius");
  }
  if (tubes && kind == ".csv") {
    refuse_output(path,
                  ".csv holds no tubes; use .obj, .ply, .vtp, .gltf or .glb, or leave out "
                  "--tube-radius");
  }
  if (mesh || is_polyline_format(path)) return tubes ? CurveOutput::tubes : CurveOutput::lines;
  refuse_output(path, "unknown extension '" + kind +
                          "'; use .obj, .ply, .vtp or .csv for lines, .gltf or .glb for tubes, "
                          ".svg for a drawing, .png for a picture, .json for a report");
}

// One of U and V with its curves.
struct Family {
  std::string name;
  StripePattern pattern;
  StripeCurves curves;
  std::array<std::size_t, kCurveEndKinds> ends{};  // of all curves
  std::size_t jogs = 0;                            // edges that moved curves do not cross straight
  std::size_t short_curves = 0;                    // left out
  std::optional<CurveSpacing> spacing;
  CurveLengths lengths;  // of the curves that are left
  std::optional<double> coverage;
  MakingFigures making;
  double extract_milliseconds = 0;
};

struct CurvesResult {
  Preparation prepared;
  StripeOptions options;
  MeshEdges edges;
  std::vector<Family> families;
  double edges_milliseconds = 0;
  std::optional<double> draw_milliseconds;
};

double total_length(const Polylines& lines) {
  double length = 0;
  for (std::size_t line = 0; line < lines.count(); ++line) length += length_of(lines, line);
  return length;
}

std::size_t closed_count(const Polylines& lines) {
  return std::accumulate(lines.closed.begin(), lines.closed.end(), std::size_t{0});
}

// Throws away short curves after all ends were counted.
void drop_short(Family& family, float min_length) {
  if (min_length <= 0) return;
  const StripeCurves all = std::move(family.curves);
  family.curves = longer_than(all, min_length);
  family.short_curves = all.lines.count() - family.curves.lines.count();
}

std::string why_no_curves(const Family& family) {
  if (family.short_curves == 0) {
    return family.name +
           ": no curves: no stripe's centre runs over the surface; ask for more "
           "stripes\n";
  }
  return family.name + ": no curves left: all " + std::to_string(family.short_curves) +
         " are shorter than --min-length\n";
}

// Windings are those of U, or of V where --wales counts it.
MakingOptions making_of(const CurvesArguments& arguments, const std::string& name) {
  MakingOptions making = arguments.making;
  if (name == "v") {
    making = {};
    making.merge_branches = arguments.making.merge_branches;
    if (arguments.wales > 0) making.windings = {{"", arguments.wales}};
  }
  return making;
}

Family make_family(const CurvesArguments& arguments, CurvesResult& result, std::string name,
                   WaveSet waves, ProgressDisplay& display) {
  const Surface& surface = result.prepared.surface;
  const float diagonal = bounding_box(surface.mesh).diagonal();
  Family family;
  family.name = std::move(name);
  family.pattern =
      make_pattern(surface, std::move(waves), result.options, making_of(arguments, family.name),
                   display.progress(), family.making);
  measure_windings(surface, family.pattern, family.making);
  StripePattern& pattern = family.pattern;
  family.jogs =
      move_peaks(*surface.neighborhood, arguments.offset, pattern.waves, pattern.solution.z);

  display.note(branch_warning(result.prepared.figures, pattern.quality.branches,
                              surface.mesh.triangle_count()));
  display.stage("curves");
  Stopwatch watch;
  const WavePattern wave_pattern{surface.mesh,       result.edges,
                                 surface.normals,    pattern.waves,
                                 pattern.solution.z, arguments.solving.stripes.phase_shift};
  family.curves = stripe_curves(LiftedWaves(wave_pattern), {.join = arguments.join});
  family.extract_milliseconds = watch.lap();
  family.ends = family.curves.end_counts();
  if (PointTree::available()) {
    display.stage("spacing");
    const CurveSpacing spacing = measure_curve_spacing(wave_pattern, family.curves);
    if (spacing.measured > 0) family.spacing = spacing;
  }
  drop_short(family, arguments.min_length.on(diagonal));
  if (family.curves.lines.count() == 0) display.note(why_no_curves(family));
  Polylines& lines = family.curves.lines;
  family.lengths = curve_lengths(lines);
  if (arguments.line_width) {
    display.stage("coverage");
    family.coverage = curve_coverage(surface.mesh, lines, arguments.line_width->on(diagonal));
  }
  if (arguments.resample) lines = resampled(lines, arguments.resample->on(diagonal));
  if (arguments.simplify) lines = simplified(lines, arguments.simplify->on(diagonal));
  return family;
}

CurvesResult make_result(const CurvesArguments& arguments, ProgressDisplay& display) {
  CurvesResult result;
  result.prepared =
      prepare(arguments.surface, arguments.waves, display, viewpoint_of(*arguments.picture));
  result.options = stripe_options(arguments.solving, result.prepared);
  Stopwatch watch;
  result.edges = mesh_edges(result.prepared.surface.mesh, *result.prepared.surface.neighborhood);
  result.edges_milliseconds = watch.lap();
  WaveSet& u = result.prepared.waves;
  WaveSet v;
  if (arguments.which != Which::u) {
    v = make_second_waves(result.prepared, arguments.second);
    if (arguments.wales > 0) {
      v = waves_round(result.prepared.surface, v.directions, {"", arguments.wales});
    }
    if (is_other(arguments.second)) {
      noted_waves(result.prepared.surface, v, "the field of V", display);
    }
  }
  const auto add = [&](const char* name, WaveSet&& waves) {
    result.families.push_back(make_family(arguments, result, name, std::move(waves), display));
  };
  if (arguments.which != Which::v) add("u", std::move(u));
  if (arguments.which != Which::u) add("v", std::move(v));
  return result;
}

nlohmann::ordered_json to_json(const CurveSpacing& spacing) {
  return {{"measured", spacing.measured},
          {"mean", spacing.mean},
          {"deviation", spacing.deviation},
          {"share_within_10_percent", spacing.share_within_10_percent}};
}

nlohmann::ordered_json to_json(const CurveGaps& gaps) {
  return {{"measured", gaps.measured},
          {"least", gaps.least},
          {"mean", gaps.mean},
          {"most", gaps.most},
          {"least_ratio", gaps.least_ratio},
          {"mean_ratio", gaps.mean_ratio},
          {"most_ratio", gaps.most_ratio}};
}

nlohmann::ordered_json to_json(const CurveLengths& lengths) {
  return {{"closed", lengths.closed_length},
          {"open", lengths.open_length},
          {"shortest", lengths.shortest},
          {"mean", lengths.mean},
          {"longest", lengths.longest}};
}

nlohmann::ordered_json to_json(const Family& family) {
  const Polylines& lines = family.curves.lines;
  const auto end = [&](CurveEnd kind) { return family.ends[static_cast<std::size_t>(kind)]; };
  nlohmann::ordered_json json = {
      {"energy", family.pattern.solution.energy},
      {"branches", family.pattern.quality.branches},
      {"field_singularities", family.pattern.quality.field_singularities},
      {"curves", lines.count()},
      {"closed", closed_count(lines)},
      {"open", lines.count() - closed_count(lines)},
      {"short_curves_left_out", family.short_curves},
      {"points", lines.points.size()},
      {"length", total_length(lines)},
      {"ends",
       {{"total", std::accumulate(family.ends.begin(), family.ends.end(), std::size_t{0})},
        {"boundary", end(CurveEnd::boundary)},
        {"no_wave", end(CurveEnd::no_wave)},
        {"nonmanifold", end(CurveEnd::nonmanifold)},
        {"branch", end(CurveEnd::branch)},
        {"singularity", end(CurveEnd::singularity)}}},
      {"joined_ends", family.curves.joined_ends},
      {"ends_at_neighbours", family.curves.ends_at_neighbors},
      {"edges_with_jogs", family.jogs}};
  json["lengths"] = to_json(family.lengths);
  if (family.spacing) json["spacing"] = to_json(*family.spacing);
  if (family.spacing) json["gaps"] = to_json(family.spacing->gaps);
  if (family.coverage) json["coverage"] = *family.coverage;
  add_to_json(family.making, json);
  const auto frequency = frequency_report(family.pattern.frequency_change, family.pattern.quality);
  if (frequency) json["frequency_change"] = to_json(*frequency);
  return json;
}

nlohmann::ordered_json to_json(const CurvesResult& result, const PictureOptions& picture) {
  const Surface& surface = result.prepared.surface;
  StripeMilliseconds time;
  time.load = result.prepared.load_milliseconds;
  time.topology = result.prepared.topology_milliseconds + result.edges_milliseconds;
  double extract = 0;
  nlohmann::ordered_json json = {{"vertices", surface.mesh.vertex_count()},
                                 {"triangles", surface.mesh.triangle_count()},
                                 {"edges", surface.neighborhood->edge_count()},
                                 {"vertices_joined", result.prepared.vertices_joined},
                                 {"threads", ThreadLimit::current()}};
  json.update(to_json(result.prepared.figures, result.prepared.field_rows_nonfinite));
  for (const Family& family : result.families) {
    json[family.name] = to_json(family);
    const StripeMilliseconds& own = family.pattern.milliseconds;
    time.topology += own.topology;
    time.frequency += own.frequency;
    time.couple += own.couple;
    time.solve += own.solve;
    time.pattern += own.pattern;
    extract += family.extract_milliseconds;
  }
  json["milliseconds"] = {
      {"load", time.load},         {"field", result.prepared.field_milliseconds},
      {"topology", time.topology}, {"couple", time.couple},
      {"solve", time.solve},       {"pattern", time.pattern},
      {"extract", extract}};
  if (result.draw_milliseconds) {
    json["milliseconds"]["draw"] = *result.draw_milliseconds;
    json["picture_quality"] = quality_name(picture);
  }
  if (result.options.slack.yields()) json["milliseconds"]["frequency"] = time.frequency;
  return json;
}

void print_measures(std::ostream& out, const Family& family) {
  const CurveLengths& lengths = family.lengths;
  if (lengths.closed + lengths.open > 0) {
    out << formatted("   lengths: closed %g, open %g; a curve %g to %g, on average %g\n",
                     lengths.closed_length, lengths.open_length, lengths.shortest, lengths.longest,
                     lengths.mean);
  }
  if (family.spacing) {
    const CurveGaps& gaps = family.spacing->gaps;
    out << formatted("   gaps: %g to %g, on average %g: %.2f / f to %.2f / f, %.3f / f\n",
                     gaps.least, gaps.most, gaps.mean, gaps.least_ratio, gaps.most_ratio,
                     gaps.mean_ratio);
  }
  if (family.coverage) {
    out << formatted("   lines of that width cover %.1f %% of the surface\n",
                     100 * *family.coverage);
  }
}

void print(std::ostream& out, const CurvesResult& result) {
  print_waves(out, result.prepared.figures);
  for (const Family& family : result.families) {
    const auto end = [&](CurveEnd kind) { return family.ends[static_cast<std::size_t>(kind)]; };
    const Polylines& lines = family.curves.lines;
    out << formatted("%s  %zu curves, %zu of them closed, of %zu points, length %g\n",
                     family.name.c_str(), lines.count(), closed_count(lines), lines.points.size(),
                     total_length(lines))
        << formatted(
               "   ends: %zu at the boundary, %zu at branches, %zu at singularities, %zu beside "
               "vertices without wave, %zu at edges of three triangles or more\n",
               end(CurveEnd::boundary), end(CurveEnd::branch), end(CurveEnd::singularity),
               end(CurveEnd::no_wave), end(CurveEnd::nonmanifold));
    if (family.curves.joined_ends + family.curves.ends_at_neighbors > 0) {
      out << formatted("   %zu more ends joined in pairs, %zu run on into neighbours\n",
                       family.curves.joined_ends, family.curves.ends_at_neighbors);
    }
    if (family.short_curves > 0) {
      out << formatted("   %zu shorter curves left out\n", family.short_curves);
    }
    if (family.jogs > 0) {
      out << formatted("   the field has no orientation: curves jog at %zu edges\n", family.jogs);
    }
    print_measures(out, family);
    out << lines_of(family.making);
    if (family.spacing) {
      out << formatted(
          "   spacing: %.3f / f on average, deviation %.3f, within 10 %% for %.1f %% of the "
          "length\n",
          family.spacing->mean, family.spacing->deviation,
          100 * family.spacing->share_within_10_percent);
    }
    out << formatted("   extracted in %.1f ms\n", family.extract_milliseconds);
  }
}

// A default that leaves most of the surface to see: a sixth of the spacing, across both sides.
float tube_radius_of(const CurvesArguments& arguments, const CurvesResult& result) {
  const Mesh& mesh = result.prepared.surface.mesh;
  if (arguments.tube_radius) return arguments.tube_radius->on(bounding_box(mesh).diagonal());
  const auto& frequencies = result.families.front().pattern.waves.frequencies;
  const double sum = std::accumulate(frequencies.begin(), frequencies.end(), 0.0);
  return static_cast<float>(static_cast<double>(frequencies.size()) / (12 * sum));
}

std::vector<Ornament> tubes_of(const CurvesArguments& arguments, const CurvesResult& result) {
  const TubeOptions options{tube_radius_of(arguments, result), arguments.tube_sides};
  std::vector<Ornament> ornaments;
  for (const Family& family : result.families) {
    ornaments.push_back({tubes(family.curves.lines, options), family.name == "v"});
  }
  return ornaments;
}

void write_tubes(const std::string& path, const std::vector<Ornament>& ornaments) {
  Mesh all;
  for (const Ornament& ornament : ornaments) append(ornament.mesh, all);
  if (all.triangles.empty()) throw Error("cannot write '" + path + "': there are no curves");
  write_mesh(path, all);
}

// Columns and arrays of all formats, which those of the input's file do not replace.
const std::vector<std::string> kCurveColumns = {"kind",   "curve",    "closed",      "length",
                                                "normal", "triangle", "barycentric", "frequency"};

// Where each point is on the mesh, and what is there.
std::vector<DataArray> arrays_of(const Family& family, const Mesh& mesh, DataArrays input) {
  const std::vector<TrianglePoint>& places = family.curves.lines.places;
  std::vector<Index> triangles;
  std::vector<float> barycentric;
  for (const TrianglePoint& place : places) {
    triangles.push_back(place.triangle);
    for (const double share : place.barycentric) barycentric.push_back(static_cast<float>(share));
  }
  std::vector<DataArray> arrays = {make_data_array("triangle", 1, triangles),
                                   make_data_array("barycentric", 3, barycentric)};
  input.points.insert(input.points.begin(),
                      make_data_array("frequency", 1, family.pattern.waves.frequencies));
  for (DataArray& array : arrays_at(places, mesh.triangles, input)) {
    arrays.push_back(std::move(array));
  }
  return arrays;
}

void write_lines(const std::string& path, const CurvesResult& result, ProgressDisplay& display) {
  const Preparation& prepared = result.prepared;
  DataArrays input = held_beside(kCurveColumns, path, prepared.arrays, display);
  std::vector<NamedLines> lines;
  for (const Family& family : result.families) {
    lines.push_back(
        {family.name, family.curves.lines, arrays_of(family, prepared.surface.mesh, input)});
  }
  write_polylines(path, lines);
}

void write(CurveOutput kind, const std::string& path, const CLI::App& command,
           const CurvesArguments& arguments, const CurvesResult& result, ProgressDisplay& display) {
  const Surface& surface = result.prepared.surface;
  std::vector<PenLines> pens;
  for (const Family& family : result.families) {
    pens.push_back({family.name, family.curves.lines, family.name == "v"});
  }
  switch (kind) {
    case CurveOutput::lines:
      return write_lines(path, result, display);
    case CurveOutput::tubes:
      return write_tubes(path, tubes_of(arguments, result));
    case CurveOutput::drawing:
      return write_line_drawing(path, surface, pens, *arguments.picture);
    case CurveOutput::picture:
      return write_ornaments(path, surface, tubes_of(arguments, result), *arguments.picture);
    case CurveOutput::report:
      return write_report(path, command, surface.mesh, to_json(result, *arguments.picture));
  }
}

// Options that would change nothing.
void check_options(const CLI::App& command, const CurvesArguments& arguments,
                   const PlannedFiles<CurveOutput>& files) {
  check_field_options(command, arguments.waves);
  check_solving_options(command, arguments.solving);
  check_making_options(command, arguments.making, arguments.solving.stripes.solver.solver);
  if (arguments.which == Which::v) {
    refuse_given(command, {"--winding", "--anchor-boundary"}, "U is not traced; leave out --lines");
  }
  if (arguments.wales > 0) {
    refuse_given(command, {"--field-v", "--stripes-v", "--frequency-v"},
                 "--wales says how many stripes of V there are, and where they run");
  }
  if (arguments.which == Which::u) {
    refuse_given(command, {"--field-v", "--stripes-v", "--frequency-v", "--wales"},
                 "V is not traced; add --lines v or --lines both");
  }
  const bool picture = has(files, CurveOutput::picture);
  if (!picture && !has(files, CurveOutput::drawing)) {
    refuse_picture_options(command, arguments.waves,
                           "nothing is drawn; add --output FILE.svg or FILE.png");
  }
  if (!picture && has(files, CurveOutput::drawing)) {
    refuse_given(command, {"--quality"}, "a drawing of lines has but one; add --output FILE.png");
  }
  if (!picture && !has(files, CurveOutput::tubes)) {
    refuse_given(command, {"--tube-radius", "--tube-sides"},
                 "no tubes are written; add --output with a mesh file or FILE.png");
  }
}

void run_curves(const CLI::App& command, const CurvesArguments& arguments) {
  std::vector<UsedFile> inputs = input_files(arguments.surface, arguments.waves);
  if (!arguments.second.field.empty()) inputs.push_back({"--field-v", arguments.second.field});
  add_slack_files(arguments.solving.slack, inputs);
  const auto files = plan_files<CurveOutput>(
      inputs, arguments.outputs, arguments.report,
      [&](const std::string& path) { return planned(path, arguments.tube_radius.has_value()); });
  check_options(command, arguments, files);
  if (is_points(arguments.surface)) {
    throw Error("curves need triangles, and '" + arguments.surface.mesh +
                "' has points alone; 'brindle stripe' and 'brindle sample' take points");
  }
  if (is_shape(arguments.surface)) stand_on_z(*arguments.picture);
  const ThreadLimit threads(arguments.solving.threads);
  const CurvesResult result = make_and_write(
      files, arguments.quiet,
      [&](ProgressDisplay& display) { return make_result(arguments, display); },
      [&](CurveOutput kind, const std::string& path, const CurvesResult& made,
          ProgressDisplay& display) { write(kind, path, command, arguments, made, display); });
  if (arguments.quiet) return;
  print(std::cout, result);
  print_written(std::cout, files);
}

void add_curve_options(CLI::App& command, CurvesArguments& arguments) {
  add_named_option(command, "--lines", arguments.which, parse_which, "u|v|both",
                   "across the field (u, default), along it (v: stripes of the field turned by 90 "
                   "degrees), or both");
  add_parsed_option(command, "--offset", arguments.offset, parse_number,
                    "in periods from the stripes' centres (default 0; 0.5: centres of the gaps)")
      ->type_name("P");
  command.add_flag(
      "--join", arguments.join,
      "join curves that end in the same triangle in pairs, and let others run on into their "
      "neighbours");
  add_parsed_option(command, "--min-length", arguments.min_length, parse_length,
                    "leave out shorter curves")
      ->type_name("L|P%");
  add_parsed_option(command, "--simplify", arguments.simplify, parse_length,
                    "leave out points up to this far from the curve")
      ->type_name("L|P%");
  add_parsed_option(
      command, "--resample", arguments.resample, parse_positive_length,
      "points at equal distances, about this far apart; --simplify then leaves out some of "
      "them")
      ->type_name("L|P%");
  add_parsed_option(command, "--line-width", arguments.line_width, parse_positive_length,
                    "report how much of the surface lines of this width cover")
      ->type_name("L|P%");
  add_parsed_option(command, "--tube-radius", arguments.tube_radius, parse_positive_length,
                    "write mesh files of tubes, not lines (pictures show tubes anyway)")
      ->type_name("L|P%");
  command.add_option("--tube-sides", arguments.tube_sides, "3 to 64 (default 8)")
      ->type_name("N")
      ->check(CLI::Range(3, 64));
}

void add_curves_options(CLI::App& command, CurvesArguments& arguments) {
  add_surface_options(command, arguments.surface);
  add_wave_options(command, arguments.waves);
  add_second_wave_options(command, arguments.second);
  add_curve_options(command, arguments);
  add_making_options(command, arguments.making);
  command
      .add_option(
          "--wales", arguments.wales,
          "V: exactly N stripes round a surface with one way round, as the wales of a sleeve")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000));
  add_solver_option(command, arguments.solving);
  add_solving_options(command, arguments.solving);
  add_output_options(command, arguments.outputs, arguments.report, arguments.quiet);
  arguments.picture = add_camera_options(command);
}

}  // namespace

Command add_curves_command(CLI::App& app) {
  return add_command<CurvesArguments>(app, "curves", "Trace the stripes as curves", kCurvesExamples,
                                      add_curves_options, run_curves);
}

}  // namespace brindle::tool
