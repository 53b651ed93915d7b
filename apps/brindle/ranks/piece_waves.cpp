#include "ranks/piece_waves.h"

#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/distributed_pattern.h"
#include "brindle/distributed_waves.h"
#include "brindle/waves_of.h"
#include "input/make_waves.h"
#include "ranks/piece_detail.h"
#include "ranks/piece_fields.h"
#include "ranks/piece_frequencies.h"
#include "ranks/piece_slack.h"

namespace brindle::tool {

WantedArrays wanted_arrays(const WaveOptions& options) {
  WantedArrays wanted;
  if (!options.arrays.mesh.empty()) return wanted;  // arrays are from another file
  if (is_array(options.field)) wanted.names.push_back(parse_array("--field", options.field));
  const ArrayOptions& arrays = options.arrays;
  if (!arrays.frequency.empty()) wanted.names.push_back(arrays.frequency);
  if (is_array(arrays.frequency_by)) {
    wanted.names.push_back(parse_array("--frequency-by", arrays.frequency_by));
  }
  if (is_array(options.detail.weight)) {
    wanted.names.push_back(parse_array("--field-weight", options.detail.weight));
  }
  return wanted;
}

PieceWaves make_piece_waves(Communicator& ranks, const DistributedSurface& surface,
                            const ReadPiece& read, const WaveOptions& options,
                            JobListener& listener) {
  Stopwatch watch;
  listener.stage("direction field");
  PieceWaves made;
  PieceField field = make_piece_field(ranks, surface, read, options);
  field.missing.too_far = field.arrays->drop_too_far(field.directions);
  MeasuredField measured = piece_measured(ranks, surface, read, options, field);
  choose_piece_frequencies(ranks, surface, read, options, field);
  WaveInput found{std::move(field.directions), std::move(field.frequencies)};
  found.may_have_gaps = field.may_have_gaps || says_frequencies(options);
  found.is_near = [&](Index v) { return field.arrays->is_near(v); };
  found.missing = field.missing;
  found.measured = std::move(measured);
  WaveResult seen = waves_of(PieceSurface(surface, read.piece.mesh), wave_request(options),
                             std::move(found), listener.progress());
  listener.note(field.notes);
  made.waves = std::move(seen.waves);
  made.field_rows_nonfinite = field.rows_nonfinite;
  made.support = std::move(seen.support);
  made.figures = {measure_waves(surface, made.waves), seen.missing};
  made.figures.turned_apart = seen.turned_apart;
  made.figures.measured = is_measured(options);
  made.figures.subdivided = read.subdivided;
  made.figures.detail = seen.detail;
  made.figures.frequency_smoothing = seen.frequency_smoothing;
  ranks.throw_on_all([&] { check_wave_report(made.figures, source_of(options)); });
  listener.note(warnings(made.figures, source_of(options)));
  made.milliseconds = watch.lap();
  return made;
}

DistributedOptions animator_options(Communicator& ranks, const SolvingOptions& solving,
                                    std::size_t plan_below, const ReadPiece& read,
                                    const DistributedSurface& surface) {
  DistributedOptions options;
  options.solver = FrameSolver::multilevel;
  options.plan_below = plan_below;
  options.phase_shift = solving.stripes.phase_shift;
  options.weights = solving.stripes.weights;
  options.sweeps = solving.stripes.solver.sweeps;
  options.cycles = solving.stripes.solver.cycles;
  options.slack = piece_slack(ranks, solving.slack, read, surface.own_vertex_count());
  return options;
}

}  // namespace brindle::tool
