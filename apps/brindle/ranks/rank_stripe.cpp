#include <iostream>
#include <limits>
#include <utility>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/base/parallel.h"
#include "brindle/files.h"
#include "brindle/pattern_arrays.h"
#include "brindle/recipe/report.h"
#include "cli/command_line.h"
#include "cli/progress_display.h"
#include "outputs/outputs.h"
#include "ranks/piece_output.h"
#include "ranks/piece_rows.h"
#include "ranks/pvtp_pieces.h"
#include "ranks/rank_patterns.h"
#include "ranks/rank_report.h"

namespace brindle::tool {
namespace {

Report report_of(const RankPreparation& prepared, const RankPattern& solved) {
  const DistributedSurface& surface = *prepared.surface;
  const StripePattern& pattern = solved.pattern;
  Report report;
  report.vertices = surface.own_vertex_count();
  report.crease_vertices = surface.vertex_count() - surface.own_vertex_count();
  report.slip = solved.slip;
  report.triangles = surface.triangle_count();
  report.edges = surface.edge_count();
  report.vertices_joined = prepared.vertices_joined;
  report.threads = ThreadLimit::current();
  report.iterations = pattern.solution.iterations;
  report.energy = pattern.solution.energy;
  report.quality = pattern.quality;
  report.milliseconds = pattern.milliseconds;
  report.milliseconds.load = prepared.load_milliseconds;
  report.milliseconds.topology += prepared.topology_milliseconds;
  report.field_milliseconds = prepared.field_milliseconds;
  report.waves = prepared.metrics;
  report.field_rows_nonfinite = prepared.field_rows_nonfinite;
  report.frequency = frequency_report(pattern.frequency_change, pattern.quality);
  return report;
}

/// The pattern's arrays of a partition's file. Partitions without vertices have all arrays, too.
DataArrays arrays_of(const StripePattern& pattern, const std::vector<float>& branches) {
  DataArrays arrays;
  const FrequencyField& wanted = pattern.frequencies_wanted;
  add_waves(arrays.points, {pattern.waves, wanted, pattern.solution.z, ""},
            std::numeric_limits<float>::quiet_NaN(), branches);
  if (pattern.frequency_change && wanted.empty()) {
    arrays.points.push_back(make_data_array("frequency_wanted", 1, wanted));
  }
  if (branches.empty()) arrays.points.push_back(make_data_array("branch", 1, branches));
  arrays.cells.push_back(branches_in_triangles(pattern, "branch"));
  arrays.cells.push_back(corner_phases_of(pattern, "corner_phase"));
  return arrays;
}

void add_support_of_piece(const RankPreparation& prepared, std::vector<DataArray>& arrays) {
  const auto& [coherence, filled] = prepared.support;
  const bool smoothing = prepared.metrics.smoothing.has_value();
  if (smoothing) arrays.push_back(make_data_array("coherence", 1, coherence));
  if (!smoothing && !prepared.metrics.frequency_smoothing) return;
  arrays.push_back(
      make_data_array("filled", 1, std::vector<std::uint8_t>(filled.begin(), filled.end())));
}

void write_stripes(const RankRun& run, const std::filesystem::path& path,
                   const RankPreparation& prepared, const RankPattern& solved,
                   JobListener& listener) {
  const ReadPiece& read = prepared.read;
  const Mesh& mesh = read.piece.mesh;
  const std::vector<float> branches =
      flags_of_all(run.ranks, read, branches_at_vertices(mesh, solved.pattern.corners));
  DataArrays own = arrays_of(solved.pattern, branches);
  add_support_of_piece(prepared, own.points);
  copy_from_partners(run.ranks, *prepared.surface, read, own.points);
  // Copies at creases have the number of their vertex, so that readers join them again.
  own.points.push_back(make_data_array("global_id", 1, read.row_ids));
  if (read.numbered) own.points.push_back(make_data_array("original_id", 1, read.original_ids));
  add_turn(own.points, prepared.turn_deg, mesh.vertex_count());
  write_pieces(run.ranks, path, mesh,
               fitted("piece.vtp", std::move(own), without_turn(read.arrays), listener));
}

/// Collective. Throws CLI::ValidationError for options without effect, and for conflicting files.
Outputs checked_outputs(const RankRun& run, const CLI::App& command,
                        const StripeArguments& arguments) {
  Outputs outputs;
  std::vector<UsedFile> files;
  for (const std::string& path : arguments.outputs) {
    if (!is_pvtp(path)) {
      refuse_output(path,
                    "stripes over MPI ranks are written as .pvtp; pictures and other files are for "
                    "brindle in one process");
    }
    check_name_in_xml(path);
    outputs.push_back({path, OutputKind::pieces});
    for (UsedFile& file : files_of_pieces(path, run.ranks.size())) files.push_back(std::move(file));
  }
  if (!arguments.report.empty()) {
    outputs.push_back({arguments.report, OutputKind::report, "--report"});
    files.push_back({"--report", arguments.report});
  }
  check_rank_options(arguments.waves, arguments.solving);
  check_stripe_options(command, arguments, outputs);
  check_files(rank_inputs(run, arguments.surface, stripe_inputs(arguments)), files);
  for (const std::string& path : arguments.outputs) check_pieces(run.ranks, path);
  run.ranks.throw_on_all([&] {
    if (run.is_first()) check_report("--report", arguments.report);
  });
  return outputs;
}

/// The waves before their frequencies are relaxed.
WaveSet requested_waves(const StripePattern& pattern) {
  WaveSet waves = pattern.waves;
  if (pattern.frequency_change) waves.frequencies = pattern.frequencies_wanted;
  return waves;
}

/// On rank 0.
void tell(const CLI::App& command, const StripeArguments& arguments, Report& report,
          const nlohmann::ordered_json& metrics, const nlohmann::ordered_json& frames,
          const Outputs& outputs) {
  report.invocation = invocation_of(command);
  if (!arguments.report.empty()) {
    nlohmann::ordered_json json = to_json(report);
    json["ranks"] = metrics;
    if (!frames.is_null()) json["frames"] = frames;
    write_json(arguments.report, json);
  }
  if (arguments.quiet) return;
  print_report(std::cout, report);
  print_ranks(std::cout, metrics);
  if (!frames.is_null()) print_frames(std::cout, frames);
  print_written(std::cout, outputs);
}

}  // namespace

void run_stripe_over(const RankRun& run, const CLI::App& command,
                     const StripeArguments& arguments) {
  const Outputs outputs = checked_outputs(run, command, arguments);
  const ThreadLimit threads(arguments.solving.threads);
  Report report;
  nlohmann::ordered_json metrics, frames;
  {
    ProgressDisplay display(arguments.quiet || !run.is_first());
    RankPreparation prepared = prepare_piece(run, arguments, !arguments.outputs.empty(), display);
    RankPattern solved =
        solve_piece(run, prepared, std::move(prepared.waves), arguments.solving, display);
    report = report_of(prepared, solved);
    display.note(quality_warning(report.waves, report.quality, report.triangles));
    for (const std::string& path : arguments.outputs) {
      enter_stage(run, display, "writing");
      write_stripes(run, path, prepared, solved, display);
    }
    if (run.frames > 0) {
      enter_stage(run, display, "frames");
      frames = measure_frames(run.ranks, *prepared.surface, solved.animator,
                              requested_waves(solved.pattern), run.frames);
    }
    metrics = rank_metrics(run.ranks, *prepared.surface, solved.animator);
  }
  run.ranks.throw_on_all([&] {
    if (run.is_first()) tell(command, arguments, report, metrics, frames, outputs);
  });
}

}  // namespace brindle::tool
