#include "bench/measurements.h"

#include <numbers>
#include <utility>

#include "bench/changing_input.h"
#include "brindle/base/parallel.h"
#include "brindle/cross_animator.h"
#include "brindle/cross_texture.h"
#include "brindle/direction_field.h"
#include "brindle/quality.h"
#include "brindle/smooth_field.h"
#include "brindle/spacing_tolerance.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"
#include "brindle/texture_animator.h"
#include "outputs/resident_memory.h"

namespace brindle::tool {
namespace {

/// An animator per field, after its first frame.
std::vector<StripeAnimator> started_animators(const Subject& subject,
                                              const std::vector<ChangingInput>& inputs) {
  std::vector<StripeAnimator> animators;
  animators.emplace_back(subject.surface.neighborhood);
  animators[0].frame(inputs[0].frame(0));
  for (std::size_t field = 1; field < inputs.size(); ++field) {
    animators.push_back(animators[0].sibling());
    animators[field].frame(inputs[field].frame(0));
  }
  return animators;
}

/// Repeats corner phases, branches and errors of frame `number`.
Spread measuring_time(const Subject& subject, const std::vector<ChangingInput>& inputs, int number,
                      const std::vector<std::vector<Complex>>& z, const Repetitions& repetitions) {
  const Mesh& mesh = subject.surface.mesh;
  std::vector<WaveSet> waves;
  for (const ChangingInput& input : inputs) waves.push_back(input.waves(number));
  std::vector<CornerPhases> corners;
  return spread_of(samples_of(repetitions, [&] {
    Stopwatch watch;
    for (std::size_t field = 0; field < waves.size(); ++field) {
      corners = corner_phases(mesh.triangles, waves[field], z[field], PhaseShiftKind::aligned);
      measure_quality(mesh, waves[field], corners);
    }
    return watch.lap();
  }));
}

/// The motif that stays whole for the tile of that name, also in builds without tiles.
TileMotifs dots() {
  TileMotifs metrics;
  metrics.extents.fill({Eigen::Vector2f(-0.29f, -0.29f), Eigen::Vector2f(0.29f, 0.29f)});
  metrics.symmetries = 0xff;
  return metrics;
}

}  // namespace

Spread spread_of(std::vector<double> milliseconds) {
  std::ranges::sort(milliseconds);
  const std::size_t count = milliseconds.size();
  const double median = (milliseconds[(count - 1) / 2] + milliseconds[count / 2]) / 2;
  return {milliseconds[0], median, static_cast<int>(count)};
}

void add_crossing_field(Subject& subject) {
  WaveSet crossing = subject.fields[0];
  crossing.directions =
      rotated(crossing.directions, subject.surface.normals, std::numbers::pi_v<float> / 2);
  subject.fields.push_back(std::move(crossing));
}

void make_cross_field(Subject& subject) {
  Surface& surface = subject.surface;
  CrossCover cover = cross_cover(*surface.neighborhood, surface.mesh.triangles,
                                 cross_waves(subject.fields[0], surface.normals));
  surface = cover_surface(cover, surface.normals);
  subject.fields = {std::move(cover.waves)};
}

SolverMetrics measure_solver(const Subject& subject, const SolverCase& solver, const Device& device,
                             const Repetitions& repetitions, const Progress& progress) {
  StripeOptions options;
  options.solver = solver.options;
  options.solve = device.solver();
  SolverMetrics metrics{solver.name, ThreadLimit::current(), 0, {}, {}, {}, {}};
  const auto samples = samples_of(repetitions, [&] {
    StripeMilliseconds sum;
    metrics.quality = {};
    for (const WaveSet& waves : subject.fields) {
      const StripePattern pattern = stripe_pattern(subject.surface, waves, options, progress);
      const StripeMilliseconds& time = pattern.milliseconds;
      // Averages depend on the field; colours and aggregates do not.
      const bool shared = solver.options.solver != Solver::averaged;
      sum.topology = shared ? time.topology : sum.topology + time.topology;
      sum.couple += time.couple;
      sum.solve += time.solve;
      metrics.iterations = pattern.solution.iterations;
      add(metrics.quality, pattern.solution.energy, pattern.quality, subject.fields.size());
    }
    return sum;
  });
  metrics.topology = spread_of(samples, &StripeMilliseconds::topology);
  metrics.couple = spread_of(samples, &StripeMilliseconds::couple);
  metrics.solve = spread_of(samples, &StripeMilliseconds::solve);
  return metrics;
}

FrameMetrics measure_frames(const Subject& subject, const Repetitions& repetitions,
                            const Progress& progress) {
  const std::vector<ChangingInput> inputs = changing_inputs(subject);
  FrameMetrics metrics;
  metrics.threads = ThreadLimit::current();
  metrics.topology = spread_of(samples_of(repetitions, [&] {
    progress.report("topology", 0);
    StripeAnimator animator(subject.surface.neighborhood);
    animator.frame(inputs[0].frame(0));
    return animator.topology_milliseconds();
  }));
  std::vector<StripeAnimator> animators = started_animators(subject, inputs);
  std::vector<std::vector<Complex>> z(inputs.size());
  int number = 0;
  const auto samples = samples_of(repetitions, [&] {
    progress.report("frames", 0);
    ++number;
    FrameMilliseconds sum;
    for (std::size_t field = 0; field < inputs.size(); ++field) {
      const FrameResult result = animators[field].frame(inputs[field].frame(number));
      sum.couple += result.milliseconds.couple;
      sum.sum += result.milliseconds.sum;
      sum.solve += result.milliseconds.solve;
      z[field].assign(result.z.begin(), result.z.end());
    }
    return sum;
  });
  metrics.couple = spread_of(samples, &FrameMilliseconds::couple);
  metrics.sum = spread_of(samples, &FrameMilliseconds::sum);
  metrics.solve = spread_of(samples, &FrameMilliseconds::solve);
  metrics.total = spread_of(samples, [](const FrameMilliseconds& frame) {
    return frame.couple + frame.sum + frame.solve;
  });
  metrics.measure = measuring_time(subject, inputs, number, z, repetitions);
  metrics.quality = quality_of(subject, inputs, number, z);
  return metrics;
}

SurroundingMetrics measure_surroundings(const Subject& subject, const Repetitions& repetitions,
                                        const Progress& progress) {
  const Surface& surface = subject.surface;
  const ChangingInput input = changing_input(surface, subject.fields[0]);
  SurroundingMetrics metrics;
  metrics.threads = ThreadLimit::current();
  TextureAnimatorOptions options;
  options.whole_tiles = dots();
  TextureAnimator animator(surface, options);
  animator.frame({input.frame(0), {}, {}});
  // Frames with and without whole tiles alternate: broken tiles are computed while others are
  // measured.
  int number = 0;
  std::vector<double> more;
  metrics.texture = spread_of(samples_of(repetitions, [&] {
    progress.report("textures", 0);
    const auto beside_solving = [&](const std::optional<TileMotifs>& whole) {
      animator.set_whole_tiles(whole);
      const auto frame = animator.frame({input.frame(++number), {}, {}}).milliseconds;
      return frame.orient + frame.measure + frame.tiles;
    };
    const double with = beside_solving(dots()), without = beside_solving(std::nullopt);
    more.push_back(with - without);
    return without;
  }));
  metrics.whole_tiles = spread_of(more);
  CrossAnimator crosses(surface);
  crosses.frame({input.frame(0), {}});
  metrics.cross_frame = spread_of(samples_of(repetitions, [&] {
    progress.report("crosses", 0);
    const CrossFrameMilliseconds frame = crosses.frame({input.frame(++number), {}}).milliseconds;
    return frame.match + frame.orient + frame.measure;
  }));
  metrics.cross = spread_of(samples_of(repetitions, [&] {
    progress.report("crosses", 0);
    const CrossPattern cross = cross_pattern(surface, subject.fields[0]);
    Stopwatch watch;
    cross_texture(surface, cross);
    return watch.lap() + cross.pattern.milliseconds.pattern;
  }));
  metrics.smooth_field = spread_of(samples_of(repetitions, [&] {
    progress.report("smooth field", 0);
    Stopwatch watch;
    smooth_direction_field(surface);
    return watch.lap();
  }));
  return metrics;
}

SlackMetrics measure_slack(const Subject& subject, const Repetitions& repetitions,
                           const Progress& progress) {
  constexpr float kSlack = 0.25f;
  const ChangingInput input = changing_input(subject.surface, subject.fields[0]);
  SlackMetrics metrics;
  metrics.threads = ThreadLimit::current();
  const auto solve = [&](RelaxedFrequency& relaxed, int number) {
    progress.report("slack", 0);
    const FrameInput frame = input.frame(number);
    relaxed.solve(frame.positions, frame.directions, frame.frequencies);
    relaxed.keep();
    return relaxed.change().sweeps;
  };
  metrics.from_scratch = spread_of(samples_of(repetitions, [&] {
    Stopwatch watch;
    RelaxedFrequency relaxed(subject.surface, kSlack);
    metrics.sweeps_from_scratch = solve(relaxed, 0);
    return watch.lap();
  }));
  RelaxedFrequency relaxed(subject.surface, kSlack);
  solve(relaxed, 0);
  int number = 0;
  metrics.in_frame = spread_of(samples_of(repetitions, [&] {
    Stopwatch watch;
    metrics.sweeps_in_frame = solve(relaxed, ++number);
    return watch.lap();
  }));
  return metrics;
}

std::optional<MemoryMetrics> measure_memory(const Subject& subject) {
  const ChangingInput input = changing_input(subject.surface, subject.fields[0]);
  const auto resident = [] {
    return_free_memory();
    return resident_memory();
  };
  const auto growth = [](std::size_t after, std::size_t before) {
    return after > before ? after - before : 0;
  };
  const auto before = resident();
  if (!before) return std::nullopt;
  reset_memory_peak();
  StripeAnimator animator(subject.surface.neighborhood);
  for (const int number : {0, 1}) animator.frame(input.frame(number));
  const auto one = resident();
  StripeAnimator sibling = animator.sibling();
  for (const int number : {0, 1}) sibling.frame(input.frame(number));
  const auto two = resident();
  const Adjacency& neighborhood = *subject.surface.neighborhood;
  return MemoryMetrics{
      (neighborhood.offsets.size() + neighborhood.neighbors.size()) * sizeof(Index),
      growth(one->now, before->now), growth(one->peak, before->now), growth(two->now, one->now)};
}

}  // namespace brindle::tool
