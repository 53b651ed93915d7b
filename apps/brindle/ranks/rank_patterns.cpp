#include "ranks/rank_patterns.h"

#include <filesystem>
#include <utility>

#include "brindle/base/array_numbers.h"
#include "brindle/base/stopwatch.h"
#include "brindle/distributed/gathered_pattern.h"
#include "brindle/frequency_field.h"
#include "brindle/waves_of.h"
#include "ranks/piece_rows.h"
#include "ranks/piece_source.h"
#include "ranks/pvtp_pieces.h"
#include "ranks/request.h"
#include "ranks/stall_watch.h"

namespace brindle::tool {
namespace {

/// Rank 0 reads the file of --avoid-branches and distributes its rows.
Slack piece_slack(Communicator& ranks, const SlackOptions& options, const RankPreparation& of) {
  Slack slack = options.slack;
  if (options.branch_penalty.empty()) return slack;
  const auto rows = piece_rows(ranks, of.read, "--avoid-branches", options.branch_penalty, [&] {
    const Slack whole = make_slack(options, of.surface->own_vertex_count(), of.read.vertex_of_row);
    return std::vector<DataArray>{make_data_array("avoid_branches", 1, whole.branch_penalty)};
  });
  for_each_number(rows[0].view(), [&](std::size_t, std::size_t, auto branch_penalty) {
    slack.branch_penalty.push_back(static_cast<float>(branch_penalty));
  });
  return slack;
}

/// The arrays of the mesh's file that the waves' options use.
WantedArrays wanted_arrays(const WaveOptions& options) {
  WantedArrays wanted;
  if (!options.arrays.mesh.empty()) return wanted;  // arrays are from another file
  if (is_array(options.field)) wanted.names.push_back(parse_array("--field", options.field));
  const ArrayOptions& arrays = options.arrays;
  if (!arrays.frequency.empty()) wanted.names.push_back(arrays.frequency);
  if (is_array(arrays.frequency_by)) {
    wanted.names.push_back(parse_array("--frequency-by", arrays.frequency_by));
  }
  if (is_array(options.smoothing.weight)) {
    wanted.names.push_back(parse_array(kWeightOption, options.smoothing.weight));
  }
  return wanted;
}

DistributedOptions animator_options(const RankRun& run, const RankPreparation& prepared,
                                    const SolvingOptions& solving) {
  DistributedOptions options;
  options.solver = FrameSolver::multilevel;
  options.plan_below = run.plan_below;
  options.phase_shift = solving.stripes.phase_shift;
  options.weights = solving.stripes.weights;
  options.sweeps = solving.stripes.solver.sweeps;
  options.cycles = solving.stripes.solver.cycles;
  options.slack = piece_slack(run.ranks, solving.slack, prepared);
  return options;
}

}  // namespace

std::vector<UsedFile> rank_inputs(const RankRun& run, const SurfaceOptions& surface,
                                  std::vector<UsedFile> files) {
  if (is_pvtp(surface.mesh)) {
    for (UsedFile& file : files_of_pvtp(run.ranks, surface.mesh)) files.push_back(std::move(file));
  }
  // Every rank reads these completely.
  std::vector<std::filesystem::path> of_all;
  for (const UsedFile& file : files) {
    if (file.option == "--field-mesh") of_all.push_back(file.path);
  }
  check_same_files(run.ranks, of_all);
  return files;
}

void check_rank_options(const WaveOptions& waves, const SolvingOptions& solving) {
  if (const std::string& by = waves.arrays.frequency_by; depends_on_camera(by)) {
    throw CLI::ValidationError("--frequency-by", "'" + by +
                                                     "' depends on a picture's camera, which "
                                                     "brindle in one process has");
  }
  if (solving.stripes.solver.solver != Solver::multilevel) {
    throw CLI::ValidationError(
        "--solver", "ranks solve by multilevel; take it, or start brindle in one process");
  }
  if (solving.stripes.phase_shift == PhaseShiftKind::common_source) {
    throw CLI::ValidationError("--phase-shift",
                               "common_source is solved in one process; take aligned or trapezoid");
  }
}

void enter_stage(const RankRun& run, JobListener& listener, const char* name) {
  enter_stage(run.ranks, listener, name);
}

RankPreparation prepare_piece(const RankRun& run, const JobArguments& arguments, bool all_arrays,
                              JobListener& listener) {
  const WaveOptions& waves = arguments.waves;
  const SurfaceOptions& surface = arguments.surface;
  const std::optional<Viewpoint> viewpoint = viewpoint_of(arguments.picture);
  RankPreparation prepared;
  Stopwatch watch;
  WantedArrays wanted = wanted_arrays(waves);
  wanted.all = all_arrays;
  enter_stage(run, listener, "loading");
  prepared.read = read_piece(run.ranks, surface, wanted, listener);
  prepared.vertices_joined = prepared.read.vertices_joined;
  prepared.load_milliseconds = watch.lap();
  enter_stage(run, listener, "neighbourhood and normals");
  prepared.surface = make_piece_surface(prepared.read, surface);
  prepared.topology_milliseconds = watch.lap();
  enter_stage(run, listener, "direction field");
  const PieceSource source(run.ranks, *prepared.surface, prepared.read, waves.arrays, viewpoint);
  BaseField field = make_base_field(source, waves);
  PreparedWaves made =
      prepare_waves(source, waves, prepared.read.subdivided, std::move(field), listener);
  made.field_milliseconds = watch.lap();
  static_cast<FieldMetrics&>(prepared) = std::move(static_cast<FieldMetrics&>(made));
  prepared.waves = std::move(made.waves);
  return prepared;
}

RankPattern solve_piece(const RankRun& run, const RankPreparation& prepared, WaveSet waves,
                        const SolvingOptions& solving, JobListener& listener) {
  enter_stage(run, listener, "stripes");
  RankPattern solved{
      {},
      {},
      DistributedStripeAnimator(*prepared.surface, animator_options(run, prepared, solving))};
  StripePattern& pattern = solved.pattern;
  const FrameResult frame = solved.animator.frame(
      {waves.positions, waves.directions, waves.frequencies}, listener.progress());
  pattern.waves = std::move(waves);
  pattern.phase_shift = solving.stripes.phase_shift;
  pattern.solution.z.assign(frame.z.begin(), frame.z.end());
  pattern.solution.iterations = solved.animator.metrics().sweeps;
  pattern.milliseconds.topology = solved.animator.metrics().topology_milliseconds;
  pattern.milliseconds.frequency = frame.milliseconds.frequency;
  pattern.milliseconds.couple = frame.milliseconds.couple;
  pattern.milliseconds.solve = frame.milliseconds.sum + frame.milliseconds.solve;
  if (frame.frequency_change.sweeps > 0) {
    pattern.frequency_change = frame.frequency_change;
    pattern.frequencies_wanted = std::exchange(
        pattern.waves.frequencies, {frame.frequencies.begin(), frame.frequencies.end()});
  }
  enter_stage(run, listener, "pattern");
  Stopwatch watch;
  DistributedMeasures measures = solved.animator.measure();
  pattern.corners = std::move(measures.corners);
  pattern.quality = measures.quality;
  pattern.solution.energy = solved.animator.energy();
  solved.slip = measures.slip;
  pattern.milliseconds.pattern = watch.lap();
  return solved;
}

WaveSet rank_waves_of_v(const RankPreparation& prepared, const SecondWaveOptions& options) {
  std::optional<float> frequency = options.frequency;
  if (options.stripes) {
    frequency =
        frequency_of_stripes(*options.stripes, static_cast<float>(prepared.surface->diagonal()));
  }
  FrequencyField own;
  if (frequency) own = constant_frequency_field(*frequency, prepared.waves.positions.size());
  return waves_across(prepared.waves, prepared.surface->normals(), own);
}

StripePattern whole_pattern(const GatheredSurface& whole, const RankPreparation& prepared,
                            const RankPattern& solved) {
  StripePattern pattern = gathered_pattern(whole, solved.of(prepared));
  const StripePattern& own = solved.pattern;
  if (own.frequency_change) pattern.frequencies_wanted = whole.of_vertices(own.frequencies_wanted);
  pattern.frequency_change = own.frequency_change;
  pattern.quality = own.quality;
  pattern.solution.energy = own.solution.energy;
  pattern.milliseconds = own.milliseconds;
  return pattern;
}

Preparation whole_preparation(const GatheredSurface& whole, const RankPreparation& prepared) {
  Preparation result;
  static_cast<PreparationMetrics&>(result) = prepared;
  result.surface = whole.surface();
  return result;
}

}  // namespace brindle::tool
