#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "benchmarks.h"
#include "brindle/base/memory.h"
#include "brindle/base/stopwatch.h"
#include "brindle/cross_animator.h"
#include "brindle/cross_texture.h"
#include "brindle/direction_field.h"
#include "brindle/measured_field.h"
#include "brindle/phases/coloring.h"
#include "brindle/smooth_field.h"
#include "brindle/texture_animator.h"
#include "brindle/waves/relaxed_frequency_solver.h"

namespace brindle::bench {
namespace {

using benchmark::State;

double milliseconds_of(const std::function<void()>& work) {
  Stopwatch watch;
  work();
  return watch.lap();
}

/// An animator per field, after its first frame.
std::vector<StripeAnimator> started_animators(const Subject& subject) {
  std::vector<StripeAnimator> animators;
  animators.emplace_back(subject.surface.neighborhood);
  for (std::size_t field = 1; field < subject.inputs.size(); ++field) {
    animators.push_back(animators[0].sibling());
  }
  for (std::size_t field = 0; field < subject.inputs.size(); ++field) {
    animators[field].frame(subject.inputs[field].frame(0));
  }
  return animators;
}

void run_solver(State& state, const Subject& subject, const StripeOptions& options) {
  Quality quality;
  int iterations = 0;  // of the last field
  repeat(state, [&] {
    quality = {};
    StripeMilliseconds sum;
    for (const WaveSet& waves : subject.fields) {
      const StripePattern pattern = stripe_pattern(subject.surface, waves, options);
      const StripeMilliseconds& time = pattern.milliseconds;
      // Averages depend on the field; colours and aggregates do not.
      const bool shared = options.solver.solver != Solver::averaged;
      sum.topology = shared ? time.topology : sum.topology + time.topology;
      sum.couple += time.couple;
      sum.solve += time.solve;
      iterations = pattern.solution.iterations;
      quality.add(pattern.solution.energy, pattern.quality, subject.fields.size());
    }
    return Sample{sum.solve, {{"topology", sum.topology}, {"couple", sum.couple}}};
  });
  state.counters["iterations"] = iterations;
  show(state, quality);
}

void run_topology(State& state, const Subject& subject) {
  const Adjacency& neighborhood = *subject.surface.neighborhood;
  repeat(state, [&] {
    StripeAnimator animator(subject.surface.neighborhood);
    animator.frame(subject.inputs[0].frame(0));
    return Sample{animator.topology_milliseconds()};
  });
  state.counters["edges"] = static_cast<double>(neighborhood.edge_count());
  state.counters["colors"] = greedy_coloring(neighborhood).color_count;
  state.counters["colors_of_the_paper"] = luby_coloring(neighborhood).color_count;
}

void run_frames(State& state, const Subject& subject) {
  std::vector<StripeAnimator> animators = started_animators(subject);
  std::vector<std::vector<Complex>> z(animators.size());
  int number = 0;
  const auto frame = [&] {
    ++number;
    FrameMilliseconds sum;
    for (std::size_t field = 0; field < animators.size(); ++field) {
      const FrameResult result = animators[field].frame(subject.inputs[field].frame(number));
      sum.couple += result.milliseconds.couple;
      sum.sum += result.milliseconds.sum;
      sum.solve += result.milliseconds.solve;
      z[field].assign(result.z.begin(), result.z.end());
    }
    return Sample{sum.couple + sum.sum + sum.solve,
                  {{"couple", sum.couple}, {"sum", sum.sum}, {"solve", sum.solve}}};
  };
  // Of the second frame, because the number of frames differs from run to run.
  frame();
  show(state, quality_of(subject, number, z));
  repeat(state, frame);
}

/// Corner phases, branches and errors of a frame.
void run_measure(State& state, const Subject& subject) {
  const Mesh& mesh = subject.surface.mesh;
  std::vector<StripeAnimator> animators = started_animators(subject);
  std::vector<WaveSet> waves;
  std::vector<FrameResult> frames;
  for (std::size_t field = 0; field < animators.size(); ++field) {
    waves.push_back(subject.inputs[field].waves(1));
    frames.push_back(animators[field].frame(subject.inputs[field].frame(1)));
  }
  std::vector<CornerPhases> corners;
  repeat(state, [&] {
    return Sample{milliseconds_of([&] {
      for (std::size_t field = 0; field < frames.size(); ++field) {
        corners =
            corner_phases(mesh.triangles, waves[field], frames[field].z, PhaseShiftKind::aligned);
        measure_quality(mesh, waves[field], corners);
      }
    })};
  });
}

/// The motif that stays whole for the tile of that name, also in builds without tiles.
TileMotifs dots() {
  TileMotifs metrics;
  metrics.extents.fill({Eigen::Vector2f(-0.29f, -0.29f), Eigen::Vector2f(0.29f, 0.29f)});
  metrics.symmetries = 0xff;
  return metrics;
}

/// A frame without solving. Frames with and without whole tiles alternate, because broken tiles are
/// computed while others are measured.
void run_texture(State& state, const Subject& subject) {
  TextureAnimatorOptions options;
  options.whole_tiles = dots();
  TextureAnimator animator(subject.surface, options);
  int number = 0;
  const auto beside_solving = [&](const std::optional<TileMotifs>& whole) {
    animator.set_whole_tiles(whole);
    const auto frame = animator.frame({subject.inputs[0].frame(number++), {}, {}}).milliseconds;
    return frame.orient + frame.measure + frame.tiles;
  };
  beside_solving(dots());
  repeat(state, [&] {
    const double with = beside_solving(dots()), without = beside_solving(std::nullopt);
    return Sample{without, {{"whole_tiles", with - without}}};
  });
}

/// A frame without solving.
void run_cross_frame(State& state, const Subject& subject) {
  CrossAnimator crosses(subject.surface);
  int number = 0;
  repeat(state, [&] {
    const auto frame = crosses.frame({subject.inputs[0].frame(number++), {}}).milliseconds;
    return Sample{frame.match + frame.orient + frame.measure};
  });
}

/// The texture and the corner phases of one cross field.
void run_cross_texture(State& state, const Subject& subject) {
  repeat(state, [&] {
    const CrossPattern cross = cross_pattern(subject.surface, subject.fields[0]);
    const double texture = milliseconds_of([&] { cross_texture(subject.surface, cross); });
    return Sample{texture + cross.pattern.milliseconds.pattern};
  });
}

constexpr float kSlack = 0.25f;

int solve(RelaxedFrequencySolver& relaxed, const FrameInput& frame) {
  const FrequencyInput input = {frame.positions, frame.directions, frame.frequencies};
  relaxed.solve(input);
  relaxed.keep(input);
  return relaxed.change().sweeps;
}

/// Includes everything that depends on connectivity alone.
void run_slack(State& state, const Subject& subject) {
  int sweeps = 0;
  repeat(state, [&] {
    return Sample{milliseconds_of([&] {
      RelaxedFrequencySolver relaxed(relaxed_setting(subject.surface, kSlack));
      sweeps = solve(relaxed, subject.inputs[0].frame(0));
    })};
  });
  state.counters["sweeps"] = sweeps;
}

/// Starts from the last frame's frequencies.
void run_slack_in_frame(State& state, const Subject& subject) {
  RelaxedFrequencySolver relaxed(relaxed_setting(subject.surface, kSlack));
  solve(relaxed, subject.inputs[0].frame(0));
  int number = 0, sweeps = 0;
  repeat(state, [&] {
    return Sample{
        milliseconds_of([&] { sweeps = solve(relaxed, subject.inputs[0].frame(++number)); })};
  });
  state.counters["sweeps"] = sweeps;
}

/// The field turned by an angle, and by noise of 20 degrees on average.
MeasuredField noisy(const Subject& subject, int seed, float turn) {
  const DirectionField& field = subject.fields[0].directions;
  MeasuredField measured{field, {}};
  for (std::size_t i = 0; i < field.size(); ++i) {
    const double sine = std::sin(static_cast<double>(i) * 12.9898 + seed * 78.233) * 43758.5453;
    const float angle = turn + 0.7f * static_cast<float>(2 * (sine - std::floor(sine)) - 1);
    measured.directions[i] =
        std::cos(angle) * field[i] + std::sin(angle) * subject.surface.normals[i].cross(field[i]);
  }
  return measured;
}

/// A noisy field that turns from frame to frame, with the same or with `new_noise`.
void run_smoothing_in_frame(State& state, const Subject& subject, bool new_noise) {
  FieldSmoothing smoothing(subject.surface);
  int number = 0;
  repeat(state, [&] {
    const float turn = 0.01f * static_cast<float>(++number);
    const MeasuredField measured = noisy(subject, new_noise ? number : 0, turn);
    return Sample{
        milliseconds_of([&] { smoothing.frame(measured, subject.fields[0].frequencies); })};
  });
}

void run_smoothing(State& state, const Subject& subject) {
  const MeasuredField measured = noisy(subject, 0, 0);
  repeat(state, [&] {
    return Sample{milliseconds_of(
        [&] { FieldSmoothing(subject.surface).frame(measured, subject.fields[0].frequencies); })};
  });
}

/// Neighbour lists and normals.
void run_surface(State& state, const Subject& subject) {
  repeat(state, [&] {
    Mesh mesh = subject.surface.mesh;
    Creases creases = subject.surface.creases;
    return Sample{milliseconds_of([&] { make_surface(std::move(mesh), std::move(creases)); })};
  });
}

void run_memory(State& state, const Subject& subject) {
  const ChangingInput& input = subject.inputs[0];
  const auto resident = [] {
    return_free_memory();
    return resident_memory().value_or(ResidentMemory{});
  };
  const auto per_vertex = [&](std::size_t after, std::size_t before) {
    return static_cast<double>(std::max(after, before) - before) /
           static_cast<double>(subject.vertex_count());
  };
  const Adjacency& neighborhood = *subject.surface.neighborhood;
  for (auto _ : state) {
    const ResidentMemory before = resident();
    reset_memory_peak();
    StripeAnimator animator(subject.surface.neighborhood);
    for (const int number : {0, 1}) animator.frame(input.frame(number));
    const ResidentMemory one = resident();
    StripeAnimator sibling = animator.sibling();
    for (const int number : {0, 1}) sibling.frame(input.frame(number));
    const ResidentMemory two = resident();
    state.counters["animator_bytes"] = per_vertex(one.now, before.now);
    state.counters["animator_peak_bytes"] = per_vertex(one.peak, before.now);
    state.counters["second_field_bytes"] = per_vertex(two.now, one.now);
  }
  state.counters["neighborhood_bytes"] =
      per_vertex((neighborhood.offsets.size() + neighborhood.neighbors.size()) * sizeof(Index), 0);
}

}  // namespace

void add_memory(const Subject& subject) {
  add_benchmark("memory", subject, 1, [&subject](State& state) {
    run_memory(state, subject);
  })->Iterations(1);
}

void add_solver(const Subject& subject, int threads, const SolverCase& solver,
                const SolvePhases& solve) {
  StripeOptions options;
  options.solver = solver.options;
  options.solve = solve;
  add_benchmark(solver.name, subject, threads,
                [&subject, options](State& state) { run_solver(state, subject, options); });
}

void add_frames(const Subject& subject, int threads) {
  add_benchmark("topology", subject, threads,
                [&subject](State& state) { run_topology(state, subject); });
  add_benchmark("frame", subject, threads,
                [&subject](State& state) { run_frames(state, subject); });
  add_benchmark("measure", subject, threads,
                [&subject](State& state) { run_measure(state, subject); });
}

void add_surroundings(const Subject& subject, int threads) {
  const auto add = [&](const std::string& name, void (*run)(State&, const Subject&)) {
    add_benchmark(name, subject, threads, [&subject, run](State& state) { run(state, subject); });
  };
  add("surface", run_surface);
  add("texture_frame", run_texture);
  add("cross_frame", run_cross_frame);
  add("cross_texture", run_cross_texture);
  add("smooth_field", [](State& state, const Subject& of) {
    repeat(state,
           [&] { return Sample{milliseconds_of([&] { smooth_direction_field(of.surface); })}; });
  });
  add("slack", run_slack);
  add("slack_in_frame", run_slack_in_frame);
  add("smoothing", run_smoothing);
  add("smoothing_in_frame",
      [](State& state, const Subject& of) { run_smoothing_in_frame(state, of, false); });
  add("smoothing_of_new_noise",
      [](State& state, const Subject& of) { run_smoothing_in_frame(state, of, true); });
}

}  // namespace brindle::bench
