#include "ranks/mpi_stripe.h"

#include <iostream>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "brindle/base/output_file.h"
#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/distributed_stripes.h"
#include "brindle/files.h"
#include "brindle/pattern_arrays.h"
#include "brindle/recipe/report.h"
#include "brindle/recipe/wave_report.h"
#include "cli/command_line.h"
#include "cli/progress_display.h"
#include "input/used_files.h"
#include "outputs/carried_arrays.h"
#include "outputs/outputs.h"
#include "outputs/written_files.h"
#include "ranks/mesh_pieces.h"
#include "ranks/mpi_arguments.h"
#include "ranks/mpi_report.h"
#include "ranks/piece_output.h"
#include "ranks/piece_rows.h"
#include "ranks/piece_waves.h"
#include "ranks/stall_watch.h"

namespace brindle::tool {
namespace {

constexpr const char* kMpiExamples = R"(Examples:
  mpirun -n 4 brindle stripe shape:torus,resolution=512 --output torus.pvtp
  mpirun -n 2 brindle stripe horse.ply --direction 0.31,0.9,0.27 --report horse.json
  mpirun -n 8 brindle stripe scan.ply --field curvature --stripes 400 --frames 20
  mpirun -n 4 brindle stripe horse.ply --slack 0.25 --output horse.pvtp
  mpirun -n 3 brindle stripe pieces.pvtp --field array:velocity --output stripes.pvtp
  mpirun -n 4 brindle stripe scan.ply --field wind.csv --output wind.pvtp
  mpirun -n 4 brindle stripe flow.vtp --field array:flow --frequency-by array:speed

Ranks read the pieces of a .pvtp and make their parts of shapes that have a formula. Other meshes
are read by rank 0, which sends the others their partitions. Each rank writes FILE_RANK.vtp, and
FILE.pvtp names them. Vertices have phase (radians; NaN where valid is 0: no wave), its sine,
direction, frequency, branch, global_id (the number in the whole mesh) and original_id (the number
in MESH); triangles have branch and corner_phase; all arrays of MESH are kept. Rows of files belong
to vertices in the order of these numbers. With --slack, frequency is the chosen one and
frequency_wanted the requested one. If a rank fails, all end with 1 and one message.)";

/// The same on all ranks.
bool has_yielded(const FrameResult& frame) { return frame.frequency_change.sweeps > 0; }

Report make_mpi_report(const DistributedSurface& surface, const PieceWaves& waves,
                       const DistributedStripeAnimator& animator, const FrameResult& frame,
                       const DistributedMeasures& measures, double energy) {
  const PatternQuality& quality = measures.quality;
  Report report;
  report.vertices = surface.own_vertex_count();
  report.crease_vertices = surface.vertex_count() - surface.own_vertex_count();
  report.slip = measures.slip;
  report.triangles = surface.triangle_count();
  report.edges = surface.edge_count();
  report.threads = ThreadLimit::current();
  report.iterations = animator.figures().sweeps;
  report.energy = energy;
  report.quality = quality;
  report.field_milliseconds = waves.milliseconds;
  report.waves = waves.figures;
  report.field_rows_nonfinite = waves.field_rows_nonfinite;
  if (has_yielded(frame)) {
    report.frequency = frequency_report(frame.frequency_change, quality);
  }
  return report;
}

/// The pattern's arrays of a partition's file.
DataArrays arrays_of(WaveSet waves, const FrameResult& frame, std::vector<CornerPhases> corners,
                     const std::vector<float>& branches) {
  DataArrays arrays;
  std::vector<float> wanted;
  if (has_yielded(frame)) {
    wanted = std::move(waves.frequencies);
    waves.frequencies.assign(frame.frequencies.begin(), frame.frequencies.end());
  }
  add_waves(arrays.points, {waves, wanted, frame.z, ""}, std::numeric_limits<float>::quiet_NaN(),
            branches);
  // Partitions without vertices have all arrays, too.
  if (has_yielded(frame) && wanted.empty()) {
    arrays.points.push_back(make_data_array("frequency_wanted", 1, wanted));
  }
  if (branches.empty()) arrays.points.push_back(make_data_array("branch", 1, branches));
  StripePattern pattern;
  pattern.corners = std::move(corners);
  arrays.cells.push_back(branches_in_triangles(pattern, "branch"));
  arrays.cells.push_back(corner_phases_of(pattern, "corner_phase"));
  return arrays;
}

/// Pieces without a vertex have the arrays, too.
void add_support_of_piece(std::vector<DataArray>& arrays, const PieceWaves& waves) {
  const auto& [coherence, filled] = waves.support;
  const bool detail = waves.figures.detail.has_value();
  if (detail) arrays.push_back(make_data_array("coherence", 1, coherence));
  if (!detail && !waves.figures.frequency_smoothing) return;
  arrays.push_back(
      make_data_array("filled", 1, std::vector<std::uint8_t>(filled.begin(), filled.end())));
}

void check_outputs(Communicator& ranks, const MpiArguments& arguments) {
  std::vector<UsedFile> outputs;
  if (!arguments.output.empty()) outputs = files_of_pieces(arguments.output, ranks.size());
  if (!arguments.report.empty()) outputs.push_back({"--report", arguments.report});
  check_files(mpi_inputs(ranks, arguments.surface, arguments.waves, arguments.solving), outputs);
  if (!arguments.output.empty()) check_pieces(ranks, arguments.output);
  ranks.throw_on_all([&] {
    if (ranks.rank() == 0 && !arguments.report.empty()) check_output_path(arguments.report);
  });
}

/// On rank 0.
void tell(const CLI::App& command, const MpiArguments& arguments, Report& report,
          const RankFigures& figures, const std::optional<FrameFigures>& frames) {
  report.invocation = invocation_of(command);
  if (!arguments.report.empty()) {
    nlohmann::ordered_json json = to_json(report);
    json["ranks"] = to_json(figures);
    if (frames) json["frames"] = to_json(*frames);
    write_json(arguments.report, json);
  }
  if (arguments.quiet) return;
  print_report(std::cout, report);
  print_ranks(std::cout, figures);
  if (frames) print_frames(std::cout, *frames);
  if (!arguments.output.empty()) print_written(std::cout, arguments.output);
  if (!arguments.report.empty()) print_written(std::cout, arguments.report);
}

void run_mpi_stripe(const CLI::App& command, const MpiArguments& arguments, Communicator& ranks) {
  check_mpi_options(command, arguments);
  check_outputs(ranks, arguments);
  const ThreadLimit threads(arguments.solving.threads);
  Report report;
  RankFigures figures;
  std::optional<FrameFigures> frames;
  {
    ProgressDisplay display(arguments.quiet || ranks.rank() != 0);
    // Ctrl-C may reach any number of ranks; stages synchronize the cancellation.
    const auto stage = [&](const char* name) { enter_stage(ranks, display, name); };
    Stopwatch watch;
    WantedArrays wanted = wanted_arrays(arguments.waves);
    wanted.all = !arguments.output.empty();
    stage("loading");
    ReadPiece read = read_piece(ranks, arguments.surface, wanted, display);
    const double load_milliseconds = watch.lap();
    stage("neighbourhood and normals");
    const DistributedSurface surface = make_piece_surface(read, arguments.surface);
    const double topology_milliseconds = watch.lap();
    stage("direction field");
    PieceWaves waves = make_piece_waves(ranks, surface, read, arguments.waves, display);
    stage("stripes");
    DistributedStripeAnimator animator(
        surface, animator_options(ranks, arguments.solving, arguments.plan_below, read, surface));
    const WaveSet& w = waves.waves;
    const FrameResult frame =
        animator.frame({w.positions, w.directions, w.frequencies}, display.progress());
    stage("pattern");
    watch.lap();
    DistributedMeasures measures = animator.measure();
    report = make_mpi_report(surface, waves, animator, frame, measures, animator.energy());
    report.vertices_joined = read.vertices_joined;
    report.milliseconds.load = load_milliseconds;
    report.milliseconds.topology = topology_milliseconds + animator.figures().topology_milliseconds;
    report.milliseconds.frequency = frame.milliseconds.frequency;
    report.milliseconds.couple = frame.milliseconds.couple;
    report.milliseconds.solve = frame.milliseconds.sum + frame.milliseconds.solve;
    report.milliseconds.pattern = watch.lap();
    display.note(quality_warning(report.waves, report.quality, report.triangles));
    if (!arguments.output.empty()) {
      stage("writing");
      const std::vector<float> branches =
          flags_of_all(ranks, read, branches_at_vertices(read.piece.mesh, measures.corners));
      DataArrays own = arrays_of(w, frame, std::move(measures.corners), branches);
      add_support_of_piece(own.points, waves);
      copy_from_partners(ranks, surface, read, own.points);
      // Copies at creases have the number of their vertex, so that readers join them again.
      own.points.push_back(make_data_array("global_id", 1, read.row_ids));
      if (read.numbered) {
        own.points.push_back(make_data_array("original_id", 1, read.original_ids));
      }
      add_turn(own.points, turn_deg(arguments.waves), read.piece.mesh.vertex_count());
      write_pieces(ranks, arguments.output, read.piece.mesh,
                   fitted("piece.vtp", std::move(own), without_turn(read.arrays), display));
    }
    if (arguments.frames > 0) {
      stage("frames");
      frames = measure_frames(ranks, surface, animator, w, arguments.frames);
    }
    figures = rank_figures(ranks, surface, animator);
  }
  ranks.throw_on_all([&] {
    if (ranks.rank() == 0) tell(command, arguments, report, figures, frames);
  });
}

}  // namespace

Command add_mpi_stripe_command(CLI::App& app, Communicator& ranks) {
  return add_command<MpiArguments>(
      app, "stripe", "Lay stripes over a surface that all ranks hold together", kMpiExamples,
      add_mpi_options, [&ranks](const CLI::App& command, const MpiArguments& arguments) {
        run_mpi_stripe(command, arguments, ranks);
      });
}

}  // namespace brindle::tool
