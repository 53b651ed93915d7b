#include "brindle/gpu_animator.h"

#include <algorithm>
#include <cmath>

#include "bad_waves.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/frequency_field.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/quality.h"
#include "device.h"
#include "extruded.h"
#include "phase_graphs.h"
#include "progress_reports.h"
#include "scenes/scene.h"

namespace brindle {
namespace {

using testing_support::flip_half;
using testing_support::kAxis;
using testing_support::Reports;
using testing_support::wavy_surface;
using testing_support::WavySurface;

using GpuAnimatorTest = test::GpuTest;

AnimatorOptions options_with(float lambda, PhaseShiftKind kind = PhaseShiftKind::aligned) {
  AnimatorOptions options;
  options.lambda = lambda;
  options.phase_shift = kind;
  return options;
}

/// What a frame is judged by.
struct Judged {
  double energy;
  double branches;
};

Judged judge(const SceneFrame& frame, const PhaseGraph& graph, std::span<const Complex> z,
             PhaseShiftKind kind) {
  const auto corners = corner_phases(frame.mesh.triangles, frame.waves, z, kind);
  const PatternQuality quality = measure_quality(frame.mesh, frame.waves, corners);
  return {energy(graph, z), static_cast<double>(quality.branches)};
}

/// Plays 60 frames on both devices. Two descents that round differently part ways where two phases
/// are as good, and anchors carry that on from frame to frame: single frames are compared loosely,
/// those that hang on the last ones more so, and their sums closely.
void expect_same_scene(const GpuSolver& solver, SceneKind kind, const AnimatorOptions& options) {
  const Surface surface = make_surface(make_shape("torus,resolution=100"));
  const float frequency = 25 / bounding_box(surface.mesh).diagonal();
  Scene scene(surface, {.kind = kind, .frequency = frequency});
  StripeAnimator cpu(surface.neighborhood, options);
  GpuAnimator gpu(solver.kernels(), surface.neighborhood, options);
  const double alike = options.lambda > 0 ? 0.1 : 0.05;
  Judged cpu_sum{}, gpu_sum{};
  for (int number = 0; number < 60; ++number) {
    const SceneFrame& frame = scene.frame(number);
    const PhaseGraph graph =
        build_phase_graph(surface.neighborhood, frame.waves, options.phase_shift);
    const Judged on_cpu =
        judge(frame, graph, cpu.frame(test::input_of(frame.waves)).z, options.phase_shift);
    gpu.frame(test::input_of(frame.waves));
    const Judged on_gpu = judge(frame, graph, gpu.read_phases(), options.phase_shift);
    EXPECT_NEAR(on_gpu.energy, on_cpu.energy, alike * on_cpu.energy + 1e-7) << number;
    EXPECT_NEAR(on_gpu.branches, on_cpu.branches, std::max(3.0, alike * on_cpu.branches)) << number;
    cpu_sum = {cpu_sum.energy + on_cpu.energy, cpu_sum.branches + on_cpu.branches};
    gpu_sum = {gpu_sum.energy + on_gpu.energy, gpu_sum.branches + on_gpu.branches};
  }
  EXPECT_NEAR(gpu_sum.energy, cpu_sum.energy, 0.01 * cpu_sum.energy + 1e-7);
  EXPECT_NEAR(gpu_sum.branches, cpu_sum.branches, 0.03 * cpu_sum.branches + 2);
}

// Faces are solved on the device and laid against each other as on the processor, in every frame
// that does not follow another.
TEST_F(GpuAnimatorTest, StripesMeetAtCreasesAsOnTheProcessor) {
  const Surface surface =
      with_creases(extruded_ring(square_round(32, 3), toothed_circle(32, 1), 0.4f));
  for (const float lambda : {0.0f, 0.02f}) {
    GpuAnimator gpu(device.solver.kernels(), surface, options_with(lambda));
    gpu.measure_frames(true);
    StripeAnimator cpu(surface, options_with(lambda));
    for (const float frequency : {3.0f, 3.1f}) {
      const WaveSet waves{surface.mesh.positions,
                          projected_direction_field({1, 0, 0}, surface.normals),
                          constant_frequency_field(frequency, surface.mesh.vertex_count())};
      const PhaseGraph graph = build_phase_graph(surface.neighborhood, waves);
      gpu.frame(test::input_of(waves));
      const std::vector<Complex> z = gpu.read_phases();
      const auto measured = gpu.measure_now();
      ASSERT_TRUE(measured);
      EXPECT_NEAR(measured->energy, energy(graph, z), 1e-5) << lambda << ' ' << frequency;
      const FrameResult frame = cpu.frame(test::input_of(waves));
      EXPECT_NEAR(energy(graph, z), energy(graph, frame.z), 1e-4) << lambda << ' ' << frequency;
      const auto slip = crease_slip(surface, waves, z);
      ASSERT_TRUE(slip);
      EXPECT_LT(slip->share, 0.2) << lambda << ' ' << frequency;
      EXPECT_NEAR(slip->mean_deg, crease_slip(surface, waves, frame.z)->mean_deg, 1);
    }
  }
}

constexpr SceneKind kScenes[] = {SceneKind::zoom, SceneKind::vortices, SceneKind::rotate,
                                 SceneKind::wobble, SceneKind::brush};

TEST_F(GpuAnimatorTest, EverySceneRunsAsOnTheProcessor) {
  for (const SceneKind scene : kScenes) {
    SCOPED_TRACE(name_of(scene));
    expect_same_scene(device.solver, scene, options_with(0.02f));
  }
}

TEST_F(GpuAnimatorTest, EverySceneRunsAsOnTheProcessorFromScratch) {
  for (const SceneKind scene : kScenes) {
    SCOPED_TRACE(name_of(scene));
    expect_same_scene(device.solver, scene, options_with(0));
  }
}

TEST_F(GpuAnimatorTest, FurtherDescentsRunAsOnTheProcessor) {
  AnimatorOptions options = options_with(0.02f);
  options.cycles = 2;
  expect_same_scene(device.solver, SceneKind::vortices, options);
}

TEST_F(GpuAnimatorTest, ThePapersModeRunsAsOnTheProcessor) {
  AnimatorOptions options;
  options.solver = FrameSolver::relaxation;
  expect_same_scene(device.solver, SceneKind::rotate, options);
}

Surface surface_with(const WavySurface& s) { return {s.mesh, s.neighborhood, s.normals}; }

TEST_F(GpuAnimatorTest, FrequenciesYieldAsOnTheProcessor) {
  auto s = wavy_surface("torus,resolution=60", kAxis, 25);
  AnimatorOptions options = options_with(0.02f);
  options.slack = 0.2f;
  StripeAnimator cpu(surface_with(s), options);
  GpuAnimator gpu(device.solver.kernels(), surface_with(s), options);
  for (int number = 0; number < 4; ++number) {
    SCOPED_TRACE(number);
    s.waves.directions = rotated(s.waves.directions, s.normals, 0.03f);
    const FrameResult on_cpu = cpu.frame(test::input_of(s.waves));
    EXPECT_TRUE(gpu.frame(test::input_of(s.waves)));
    EXPECT_TRUE(std::ranges::equal(gpu.frequencies(), on_cpu.frequencies));
    EXPECT_EQ(gpu.frequency_change().ratio_mean, on_cpu.frequency_change.ratio_mean);
    WaveSet yielded = s.waves;
    yielded.frequencies.assign(on_cpu.frequencies.begin(), on_cpu.frequencies.end());
    const PhaseGraph graph = build_phase_graph(s.neighborhood, yielded);
    EXPECT_NEAR(energy(graph, gpu.read_phases()), energy(graph, on_cpu.z),
                0.1 * energy(graph, on_cpu.z));
    EXPECT_FALSE(gpu.frame(test::input_of(s.waves)));
  }
}

TEST_F(GpuAnimatorTest, CancelledFramesLeaveFrequenciesAsTheyWere) {
  const auto s = wavy_surface("torus,resolution=60", kAxis, 25);
  AnimatorOptions options = options_with(0.02f);
  options.slack = 0.2f;
  options.cycles = 2;
  const auto see = [&](bool cancelled) {
    GpuAnimator gpu(device.solver.kernels(), surface_with(s), options);
    WaveSet waves = s.waves;
    std::vector<float> seen;
    for (int number = 0; number < 3; ++number) {
      waves.directions = rotated(waves.directions, s.normals, 0.03f);
      if (cancelled) {
        WaveSet other = waves;
        other.directions = rotated(other.directions, s.normals, 0.4f);
        Reports reports(1);
        EXPECT_THROW(gpu.frame(test::input_of(other), reports.progress()), Cancelled);
      }
      gpu.frame(test::input_of(waves));
      seen.insert(seen.end(), gpu.frequencies().begin(), gpu.frequencies().end());
    }
    return seen;
  };
  EXPECT_EQ(see(true), see(false));
}

TEST_F(GpuAnimatorTest, SlackNeedsTheSurfaceAndItsInputOnTheProcessor) {
  const auto s = wavy_surface("torus,resolution=20", kAxis, 5);
  AnimatorOptions options;
  options.slack = 0.2f;
  EXPECT_THROW(GpuAnimator(device.solver.kernels(), s.neighborhood, options), Error);
  GpuAnimator gpu(device.solver.kernels(), surface_with(s), options);
  EXPECT_THROW(gpu.frame(WaveBuffers{}), Error);
}

TEST_F(GpuAnimatorTest, CouplesEveryPhaseShiftAsTheProcessorDoes) {
  auto surface = wavy_surface("torus,resolution=80", kAxis, 25);
  flip_half(surface.waves, 4);
  for (const auto kind :
       {PhaseShiftKind::aligned, PhaseShiftKind::common_source, PhaseShiftKind::trapezoid}) {
    SCOPED_TRACE(name_of(kind));
    GpuAnimator gpu(device.solver.kernels(), surface.neighborhood, options_with(0, kind));
    gpu.measure_frames(true);
    gpu.frame(test::input_of(surface.waves));
    const PhaseGraph graph = surface.graph(kind);
    const double on_cpu = solve_phases(graph).energy;
    EXPECT_NEAR(energy(graph, gpu.read_phases()), on_cpu, 0.01 * on_cpu);
    // Measured with the device's own couplings.
    EXPECT_NEAR(gpu.measure_now()->energy, energy(graph, gpu.read_phases()), 1e-3 * on_cpu);
  }
}

/// A buffer as an application would have it.
template <class Item>
GlBuffer application_buffer(const std::vector<Item>& items) {
  return buffer_of(items, "the application's data");
}

TEST_F(GpuAnimatorTest, TakesBuffersThatAreOnTheDeviceAlready) {
  auto surface = wavy_surface("torus,resolution=80", kAxis, 25);
  GpuAnimator from_spans(device.solver.kernels(), surface.neighborhood);
  GpuAnimator from_buffers(device.solver.kernels(), surface.neighborhood);
  for (int n = 0; n < 3; ++n) {
    for (float& f : surface.waves.frequencies) f *= 1.01f;
    const GlBuffer positions = application_buffer(surface.waves.positions);
    const GlBuffer directions = application_buffer(surface.waves.directions);
    const GlBuffer frequencies = application_buffer(surface.waves.frequencies);
    from_buffers.frame(WaveBuffers{positions, directions, frequencies});
    from_spans.frame(test::input_of(surface.waves));
    EXPECT_EQ(from_buffers.read_phases(), from_spans.read_phases());
  }
}

TEST_F(GpuAnimatorTest, MeasuresComeOneFrameLate) {
  auto surface = wavy_surface("torus,resolution=80", kAxis, 25);
  GpuAnimator animator(device.solver.kernels(), surface.neighborhood);
  StripeAnimator twin(surface.neighborhood);
  animator.measure_frames(true);
  std::vector<double> energies, steps;
  for (int n = 0; n < 5; ++n) {
    for (float& f : surface.waves.frequencies) f *= 1.01f;
    animator.frame(test::input_of(surface.waves));
    if (n == 0) {
      EXPECT_FALSE(animator.measured().has_value());
    } else {
      ASSERT_EQ(animator.measured()->frame, n - 1);
      EXPECT_NEAR(animator.measured()->energy, energies.back(), 1e-4 * energies.back());
      EXPECT_NEAR(animator.measured()->phase_step, steps.back(), 0.03 * steps.back() + 1e-6);
    }
    energies.push_back(energy(surface.graph(), animator.read_phases()));
    steps.push_back(twin.frame(test::input_of(surface.waves)).phase_step);
  }
  EXPECT_EQ(animator.measure_now()->frame, 4);
}

TEST_F(GpuAnimatorTest, UnchangedInputGivesUnchangedPhases) {
  auto surface = wavy_surface("torus,resolution=80", kAxis, 25);
  GpuAnimator animator(device.solver.kernels(), surface.neighborhood);
  EXPECT_TRUE(animator.frame(test::input_of(surface.waves)));
  const std::vector<Complex> z = animator.read_phases();
  EXPECT_FALSE(animator.frame(test::input_of(surface.waves)));
  EXPECT_EQ(animator.read_phases(), z);
  surface.waves.frequencies[7] *= 1.5f;
  EXPECT_TRUE(animator.frame(test::input_of(surface.waves)));
}

TEST_F(GpuAnimatorTest, TurningDirectionsRoundIsNoChangeOfThePattern) {
  auto surface = wavy_surface("torus,resolution=80", kAxis, 25);
  GpuAnimator animator(device.solver.kernels(), surface.neighborhood, options_with(0.5f));
  animator.measure_frames(true);
  animator.frame(test::input_of(surface.waves));
  flip_half(surface.waves, 3);
  animator.frame(test::input_of(surface.waves));
  EXPECT_LT(animator.measure_now()->phase_step, 0.02);
}

float farthest_apart(std::span<const Complex> a, std::span<const Complex> b) {
  float farthest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) farthest = std::max(farthest, std::abs(a[v] - b[v]));
  return farthest;
}

/// Momenta are turned with the phases, and forgotten with the last frame; what is not known of
/// given phases begins at the peak. Few iterations round alike on both devices.
TEST_F(GpuAnimatorTest, ThePapersModeFollowsLastPhasesAsOnTheProcessor) {
  auto s = wavy_surface("torus,resolution=40", kAxis, 15);
  AnimatorOptions options = options_with(0);
  options.solver = FrameSolver::relaxation;
  options.iterations = 3;
  const WaveSet first = s.waves;
  std::vector<Complex> given = solve_phases(s.graph()).z;
  for (std::size_t v = 0; v < given.size(); ++v) {
    if (first.positions[v].x() > 0) given[v] = 0;
  }
  StripeAnimator cpu(s.neighborhood, options);
  GpuAnimator gpu(device.solver.kernels(), s.neighborhood, options);
  for (int round = 0; round < 2; ++round) {
    cpu.set_last_phases(given);
    gpu.set_last_phases(given);
    for (int number = 0; number < 4; ++number) {
      SCOPED_TRACE(number);
      const auto expected = cpu.frame(test::input_of(s.waves)).z;
      gpu.frame(test::input_of(s.waves));
      EXPECT_LT(farthest_apart(gpu.read_phases(), expected), 2e-3f);
      flip_half(s.waves, 2 + number);
      s.waves.directions = rotated(s.waves.directions, s.normals, 0.02f);
    }
    cpu.restart();
    gpu.restart();
  }
}

TEST_F(GpuAnimatorTest, FramesFromBuffersComeBetweenThoseWithSlack) {
  auto s = wavy_surface("torus,resolution=40", kAxis, 15);
  AnimatorOptions options = options_with(0.1f);
  options.slack = 0.2f;
  GpuAnimator animator(device.solver.kernels(), surface_with(s), options);
  animator.set_slack(0);
  const WaveSet first = s.waves;
  animator.frame(test::input_of(first));
  EXPECT_EQ(animator.frequencies().size(), first.frequencies.size());
  for (float& f : s.waves.frequencies) f *= 1.3f;
  const GlBuffer positions = application_buffer(s.waves.positions);
  const GlBuffer directions = application_buffer(s.waves.directions);
  const GlBuffer frequencies = application_buffer(s.waves.frequencies);
  animator.frame(WaveBuffers{positions, directions, frequencies});
  const std::vector<Complex> others = animator.read_phases();
  EXPECT_TRUE(animator.frequencies().empty());
  EXPECT_TRUE(animator.frame(test::input_of(first)));
  EXPECT_GT(farthest_apart(animator.read_phases(), others), 0.1f);
  EXPECT_FALSE(animator.frequencies().empty());
}

TEST_F(GpuAnimatorTest, SiblingSolvesItsOwnFieldOnTheSameTopology) {
  auto surface = wavy_surface("torus,resolution=80", kAxis, 25);
  GpuAnimator u(device.solver.kernels(), surface.neighborhood);
  u.frame(test::input_of(surface.waves));
  const std::vector<Complex> u_phases = u.read_phases();
  GpuAnimator v = u.sibling();
  surface.waves.directions =
      rotated(surface.waves.directions, surface.normals, static_cast<float>(M_PI / 2));
  v.frame(test::input_of(surface.waves));
  EXPECT_LT(energy(surface.graph(), v.read_phases()), 1.1 * solve_phases(surface.graph()).energy);
  EXPECT_EQ(v.topology_milliseconds(), 0);
  EXPECT_EQ(u.read_phases(), u_phases);
}

TEST_F(GpuAnimatorTest, GivenPhasesAreThoseOfTheLastFrame) {
  for (const FrameSolver solver : {FrameSolver::multilevel, FrameSolver::relaxation}) {
    auto s = wavy_surface("torus,resolution=60", kAxis, 25);
    AnimatorOptions options = options_with(0.2f);
    options.solver = solver;
    GpuAnimator goes_on(device.solver.kernels(), s.neighborhood, options);
    GpuAnimator resumed(device.solver.kernels(), s.neighborhood, options);
    resumed.frame(test::input_of(s.waves));  // aggregates follow the first frame
    goes_on.frame(test::input_of(s.waves));
    const auto last = goes_on.read_phases();
    for (float& f : s.waves.frequencies) f *= 1.02f;
    goes_on.frame(test::input_of(s.waves));
    resumed.restart();
    resumed.set_last_phases(last);
    EXPECT_TRUE(resumed.frame(test::input_of(s.waves)));
    EXPECT_EQ(resumed.read_phases(), goes_on.read_phases());
    resumed.set_last_phases(last);
    EXPECT_TRUE(resumed.frame(test::input_of(s.waves)))
        << "given phases count for the same input, too";
    EXPECT_FALSE(resumed.frame(test::input_of(s.waves)));
    EXPECT_THROW(resumed.set_last_phases(std::span(last).first(3)), Error);
  }
}

TEST_F(GpuAnimatorTest, TakesAnotherSlackAsTheProcessorDoes) {
  const auto s = wavy_surface("torus,resolution=60", kAxis, 25);
  AnimatorOptions options = options_with(0.02f);
  options.slack = 0.3f;
  StripeAnimator cpu(surface_with(s), options);
  GpuAnimator gpu(device.solver.kernels(), surface_with(s), options);
  for (const float slack : {0.3f, 0.1f, 0.2f}) {
    cpu.set_slack(slack);
    gpu.set_slack(slack);
    const auto expected = cpu.frame(test::input_of(s.waves)).frequencies;
    gpu.frame(test::input_of(s.waves));
    EXPECT_TRUE(std::ranges::equal(gpu.frequencies(), expected)) << slack;
  }
  GpuAnimator without(device.solver.kernels(), surface_with(s), options_with(0.02f));
  EXPECT_THROW(without.set_slack(0.1f), Error);
}

TEST_F(GpuAnimatorTest, RestartForgetsTheLastFrame) {
  auto surface = wavy_surface("torus,resolution=80", kAxis, 25);
  GpuAnimator used(device.solver.kernels(), surface.neighborhood);
  GpuAnimator fresh(device.solver.kernels(), surface.neighborhood);
  used.frame(test::input_of(surface.waves));
  fresh.frame(test::input_of(surface.waves));
  const std::vector<Complex> first = fresh.read_phases();
  used.restart();
  used.frame(test::input_of(surface.waves));
  EXPECT_EQ(used.read_phases(), first);
}

/// What a caller sees of a frame.
struct Seen {
  std::vector<Complex> z;
  double energy;
  double phase_step;
  bool operator==(const Seen&) const = default;
};

Seen see(GpuAnimator& animator, const WavySurface& surface) {
  animator.frame(test::input_of(surface.waves));
  const auto measure = animator.measure_now();
  return {animator.read_phases(), measure->energy, measure->phase_step};
}

/// Three inputs that differ in everything, and animators for them.
struct InterruptedGpu : test::GpuTest {
  WavySurface first = wavy_surface("torus,resolution=30", kAxis, 8);
  WavySurface second = first, third = first;
  AnimatorOptions options = options_with(0.025f);

  InterruptedGpu() {
    options.cycles = 3;
    flip_half(second.waves, 3);
    for (float& f : second.waves.frequencies) f *= 1.01f;
    third.waves.directions = rotated(third.waves.directions, third.normals, 1.2f);
    for (Vec3& p : third.waves.positions) p.x() *= 1.1f;
  }

  GpuAnimator animator() const {
    GpuAnimator made(device.solver.kernels(), first.neighborhood, options);
    made.measure_frames(true);
    return made;
  }

  /// Cancels a frame at every report of progress that it makes, each time of an animator that
  /// `start` hands over, and lets `expect` look at what is left of it.
  template <class Start, class Expect>
  void cancel_everywhere(const WavySurface& input, const Start& start, const Expect& expect) const {
    GpuAnimator undisturbed = start();
    Reports all;
    undisturbed.frame(test::input_of(input.waves), all.progress());
    EXPECT_GE(all.count(), options.cycles);
    for (const int k : testing_support::reports_to_cancel(all.count())) {
      SCOPED_TRACE(k);
      GpuAnimator cancelled = start();
      Reports reports(k);
      EXPECT_THROW(cancelled.frame(test::input_of(input.waves), reports.progress()), Cancelled);
      expect(cancelled);
    }
  }
};

TEST_F(InterruptedGpu, FirstFrameLeavesNothingBehind) {
  GpuAnimator undisturbed = animator();
  const Seen a = see(undisturbed, first), b = see(undisturbed, second);
  for (const WavySurface* tried : {&first, &third}) {
    cancel_everywhere(
        *tried, [&] { return animator(); },
        [&](GpuAnimator& cancelled) {
          EXPECT_TRUE(cancelled.read_phases().empty());
          EXPECT_EQ(see(cancelled, first), a);
          EXPECT_EQ(see(cancelled, second), b);
        });
  }
}

TEST_F(InterruptedGpu, LaterFrameLeavesTheLastOne) {
  GpuAnimator undisturbed = animator();
  const Seen a = see(undisturbed, first), b = see(undisturbed, second);
  const Seen c = see(undisturbed, third);
  for (const WavySurface* tried : {&second, &third}) {
    cancel_everywhere(
        *tried,
        [&] {
          GpuAnimator started = animator();
          started.frame(test::input_of(first.waves));
          return started;
        },
        [&](GpuAnimator& cancelled) {
          EXPECT_EQ(cancelled.read_phases(), a.z);
          EXPECT_FALSE(cancelled.frame(test::input_of(first.waves)));
          EXPECT_EQ(cancelled.read_phases(), a.z);
          EXPECT_EQ(see(cancelled, second), b);
          EXPECT_EQ(see(cancelled, third), c);
        });
  }
}

TEST_F(InterruptedGpu, BuffersOnTheDeviceLeaveTheLastFrameToo) {
  GpuAnimator undisturbed = animator(), cancelled = animator();
  const Seen a = see(undisturbed, first), b = see(undisturbed, second);
  cancelled.frame(test::input_of(first.waves));
  const GlBuffer positions = application_buffer(third.waves.positions);
  const GlBuffer directions = application_buffer(third.waves.directions);
  const GlBuffer frequencies = application_buffer(third.waves.frequencies);
  for (int k = 0; k < options.cycles; ++k) {
    Reports reports(k);
    EXPECT_THROW(
        cancelled.frame(WaveBuffers{positions, directions, frequencies}, reports.progress()),
        Cancelled);
    EXPECT_EQ(cancelled.read_phases(), a.z);
  }
  EXPECT_EQ(see(cancelled, second), b);
}

TEST_F(InterruptedGpu, BadValuesLeaveTheLastFrame) {
  GpuAnimator undisturbed = animator(), refusing = animator();
  const auto refuse = [&](const WaveSet& bad) { refusing.frame(test::input_of(bad)); };
  testing_support::expect_refused(first.waves, 5, refuse);
  EXPECT_EQ(see(refusing, first), see(undisturbed, first));
  testing_support::expect_refused(second.waves, 7, refuse);
  EXPECT_EQ(see(refusing, second), see(undisturbed, second));
  const WaveSet& good = first.waves;
  testing_support::expect_refused(good, 5, [&](const WaveSet& bad) {
    GpuAnimator fresh = animator();
    const GlBuffer positions = application_buffer(bad.positions);
    const GlBuffer directions = application_buffer(bad.directions);
    const GlBuffer frequencies = application_buffer(bad.frequencies);
    fresh.frame(WaveBuffers{positions, directions, frequencies});
  });
}

TEST_F(InterruptedGpu, RestartForgetsTheCyclesOfTheLastFrame) {
  GpuAnimator used = animator(), fresh = animator();
  used.restart();  // before there is anything to forget
  const Seen a = see(fresh, first);
  EXPECT_EQ(see(used, first), a);
  used.restart();
  EXPECT_EQ(see(used, first).z, a.z);
}

TEST_F(GpuAnimatorTest, InputOfTheLastFrameButOneIsNoUnchangedInput) {
  auto surface = wavy_surface("torus,resolution=40", kAxis, 15);
  GpuAnimator animator(device.solver.kernels(), surface.neighborhood);
  GpuAnimator twin(device.solver.kernels(), surface.neighborhood);
  const WaveSet first = surface.waves;
  for (float& f : surface.waves.frequencies) f *= 1.3f;
  const GlBuffer positions = application_buffer(surface.waves.positions);
  const GlBuffer directions = application_buffer(surface.waves.directions);
  const GlBuffer frequencies = application_buffer(surface.waves.frequencies);
  animator.frame(test::input_of(first));
  animator.frame(WaveBuffers{positions, directions, frequencies});
  EXPECT_TRUE(animator.frame(test::input_of(first)));
  twin.frame(test::input_of(first));
  twin.frame(test::input_of(surface.waves));
  twin.frame(test::input_of(first));
  EXPECT_EQ(animator.read_phases(), twin.read_phases());
}

TEST_F(GpuAnimatorTest, TellsItsDispatchesAndTheirTimes) {
  auto surface = wavy_surface("sphere,resolution=60", kAxis, 25);
  GpuAnimator animator(device.solver.kernels(), surface.neighborhood);
  animator.frame(test::input_of(surface.waves));
  EXPECT_GT(animator.dispatches(), 4u);
  EXPECT_LT(animator.dispatches(), 60u);
  double total = 0;
  for (const auto& [stage, milliseconds] : animator.stage_milliseconds()) {
    EXPECT_GE(milliseconds, 0) << stage;
    total += milliseconds;
  }
  EXPECT_GT(total, 0);
}

TEST_F(GpuAnimatorTest, RefusesBadInputAndOptions) {
  const auto surface = wavy_surface("plane,resolution=5", kAxis, 5);
  GpuAnimator animator(device.solver.kernels(), surface.neighborhood);
  FrameInput input = test::input_of(surface.waves);
  input.frequencies = input.frequencies.first(3);
  EXPECT_THROW(animator.frame(input), Error);
  EXPECT_THROW(GpuAnimator(device.solver.kernels(), surface.neighborhood, options_with(-1)), Error);
  AnimatorOptions weighted;
  weighted.edge_weights.assign(surface.neighborhood->directed_edge_count(), 2);
  EXPECT_THROW(GpuAnimator(device.solver.kernels(), surface.neighborhood, weighted), Error);
}

}  // namespace
}  // namespace brindle
