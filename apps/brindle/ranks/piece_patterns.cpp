#include "ranks/piece_patterns.h"

#include <algorithm>
#include <ostream>
#include <utility>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/base/text.h"
#include "brindle/frequency_field.h"
#include "brindle/pattern_warnings.h"
#include "brindle/recipe/report.h"
#include "cli/command_line.h"
#include "cli/option_values.h"
#include "input/used_files.h"
#include "outputs/outputs.h"
#include "outputs/resident_memory.h"
#include "ranks/mpi_arguments.h"
#include "ranks/piece_output.h"
#include "ranks/stall_watch.h"

namespace brindle::tool {
namespace {

std::optional<float> frequency_of_v(const PatternArguments& arguments, double diagonal) {
  if (!arguments.stripes_v) return arguments.frequency_v;
  return frequency_of_stripes(*arguments.stripes_v, static_cast<float>(diagonal));
}

/// U's waves turned by 90 degrees, with V's own frequency if given.
WaveSet waves_of_v(const WaveSet& u, const DistributedSurface& surface,
                   std::optional<float> frequency) {
  FrequencyField own;
  if (frequency) own = constant_frequency_field(*frequency, u.positions.size());
  return waves_across(u, surface.normals(), own);
}

SolvedPattern solve(Communicator& ranks, PiecePatterns& patterns, WaveSet waves,
                    const PatternArguments& arguments, const Progress& progress) {
  DistributedStripeAnimator animator(
      *patterns.surface, animator_options(ranks, arguments.solving, arguments.plan_below,
                                          patterns.read, *patterns.surface));
  SolvedPattern solved;
  const FrameResult frame =
      animator.frame({waves.positions, waves.directions, waves.frequencies}, progress);
  solved.z.assign(frame.z.begin(), frame.z.end());
  patterns.topology += animator.figures().topology_milliseconds;
  patterns.frequency += frame.milliseconds.frequency;
  patterns.couple += frame.milliseconds.couple;
  patterns.solve += frame.milliseconds.sum + frame.milliseconds.solve;
  Stopwatch watch;
  solved.quality = animator.measure().quality;
  solved.energy = animator.energy();
  patterns.pattern += watch.lap();
  if (frame.frequency_change.sweeps > 0) solved.frequency_change = frame.frequency_change;
  solved.waves = std::move(waves);
  if (!frame.frequencies.empty()) {
    solved.frequencies_wanted = std::exchange(solved.waves.frequencies,
                                              {frame.frequencies.begin(), frame.frequencies.end()});
  }
  return solved;
}

}  // namespace

void add_pattern_options(CLI::App& command, PatternArguments& arguments, const std::string& what,
                         const std::string& files) {
  add_surface_options(command, arguments.surface);
  add_wave_options(command, arguments.waves);
  CLI::Option* stripes =
      add_parsed_option(command, "--stripes-v", arguments.stripes_v, parse_positive_number,
                        "V: as --stripes (default: U's frequency)")
          ->type_name("N");
  add_parsed_option(command, "--frequency-v", arguments.frequency_v, parse_positive_number,
                    "V: as --frequency")
      ->type_name("F")
      ->excludes(stripes);
  add_solving_options(command, arguments.solving);
  add_bounds_options(command, arguments.plan_below);
  command.add_option("-o,--output", arguments.output, what)->type_name(files);
  command.add_option("--report", arguments.report, "write the report here")->type_name("FILE.json");
  command.add_flag("-q,--quiet", arguments.quiet, "print nothing but errors");
}

bool writes_pieces(const PatternArguments& arguments) {
  return lower_extension(arguments.output) == ".pvtp";
}

void check_pattern_options(const CLI::App& command, const PatternArguments& arguments,
                           Communicator& ranks) {
  check_mpi_waves(command, arguments.waves, arguments.solving);
  std::vector<UsedFile> outputs;
  if (writes_pieces(arguments)) {
    outputs = files_of_pieces(arguments.output, ranks.size());
  } else if (!arguments.output.empty()) {
    outputs.push_back({"--output", arguments.output});
  }
  if (!arguments.report.empty()) {
    check_report("--report", arguments.report);
    outputs.push_back({"--report", arguments.report});
  }
  check_files(mpi_inputs(ranks, arguments.surface, arguments.waves, arguments.solving), outputs);
  if (writes_pieces(arguments)) return check_pieces(ranks, arguments.output);
  ranks.throw_on_all([&] {
    if (ranks.rank() == 0 && !arguments.output.empty()) check_output_path(arguments.output);
  });
}

PiecePatterns make_piece_patterns(Communicator& ranks, const PatternArguments& arguments,
                                  bool with_u, bool with_v, ProgressDisplay& display) {
  const auto stage = [&](const char* name) { enter_stage(ranks, display, name); };
  PiecePatterns patterns;
  stage("loading");
  Stopwatch watch;
  patterns.read = read_piece(ranks, arguments.surface, wanted_arrays(arguments.waves), display);
  patterns.load = watch.lap();
  stage("neighbourhood and normals");
  patterns.surface = make_piece_surface(patterns.read, arguments.surface);
  patterns.topology = watch.lap();
  stage("direction field");
  PieceWaves waves =
      make_piece_waves(ranks, *patterns.surface, patterns.read, arguments.waves, display);
  patterns.figures = waves.figures;
  patterns.field_rows_nonfinite = waves.field_rows_nonfinite;
  patterns.field = waves.milliseconds;
  const auto frequency_v = frequency_of_v(arguments, patterns.surface->diagonal());
  WaveSet across;
  if (with_v) across = waves_of_v(waves.waves, *patterns.surface, frequency_v);
  const auto make = [&](WaveSet& set) {
    stage("stripes");
    return solve(ranks, patterns, std::move(set), arguments, display.progress());
  };
  if (with_u) patterns.u = make(waves.waves);
  if (with_v) patterns.v = make(across);
  PatternQuality quality;
  for (const auto& solved : {&patterns.u, &patterns.v}) {
    if (*solved) quality = worse_of(quality, (*solved)->quality);
  }
  patterns.figures.measured = is_measured(arguments.waves);
  display.note(quality_warning(patterns.figures, quality, patterns.surface->triangle_count()));
  return patterns;
}

void add_frequency_change(const SolvedPattern& solved, const char* name,
                          nlohmann::ordered_json& json) {
  const auto report = frequency_report(solved.frequency_change, solved.quality);
  if (report) json[name] = to_json(*report);
}

nlohmann::ordered_json to_json(Communicator& ranks, const PiecePatterns& patterns,
                               double extract_milliseconds) {
  const DistributedSurface& surface = *patterns.surface;
  const Traffic traffic = surface.traffic();
  const auto memory = resident_memory();
  const auto bytes = ranks.sum(traffic.bytes);
  const auto most = ranks.greatest(memory ? memory->peak : std::size_t{0});
  nlohmann::ordered_json json = {{"vertices", surface.own_vertex_count()},
                                 {"triangles", surface.triangle_count()},
                                 {"edges", surface.edge_count()},
                                 {"vertices_joined", patterns.read.vertices_joined},
                                 {"threads", ThreadLimit::current()}};
  json.update(to_json(patterns.figures, patterns.field_rows_nonfinite));
  json["ranks"] = {{"count", ranks.size()}, {"bytes_sent", bytes}, {"memory_peak_most", most}};
  json["milliseconds"] = {{"load", patterns.load},          {"field", patterns.field},
                          {"topology", patterns.topology},  {"couple", patterns.couple},
                          {"solve", patterns.solve},        {"pattern", patterns.pattern},
                          {"extract", extract_milliseconds}};
  for (const auto& solved : {&patterns.u, &patterns.v}) {
    if (!*solved || !(*solved)->frequency_change) continue;
    json["milliseconds"]["frequency"] = patterns.frequency;
  }
  return json;
}

void write_pattern_report(const CLI::App& command, const PatternArguments& arguments,
                          const nlohmann::ordered_json& report) {
  if (arguments.report.empty()) return;
  nlohmann::ordered_json json = invocation_of(command);
  json.update(report);
  write_json(arguments.report, json);
}

void print_pattern_ranks(std::ostream& out, const nlohmann::ordered_json& report) {
  out << formatted("ranks     %d; %.3f MB sent, memory %.0f MB at most\n",
                   report["ranks"]["count"].get<int>(),
                   1e-6 * report["ranks"]["bytes_sent"].get<double>(),
                   1e-6 * report["ranks"]["memory_peak_most"].get<double>());
}

}  // namespace brindle::tool
