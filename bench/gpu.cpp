#include <array>
#include <numeric>

#include <epoxy/gl.h>

#include "benchmarks.h"
#include "brindle/base/stopwatch.h"
#include "brindle/gl/gl_buffer.h"

namespace brindle::bench {
namespace {

/// The two alternating inputs of a field, in device memory.
class ResidentInput {
 public:
  explicit ResidentInput(const ChangingInput& input) {
    for (int number = 0; number < 2; ++number) {
      const FrameInput frame = input.frame(number);
      buffers_.push_back({buffer_of(frame.positions, "positions"),
                          buffer_of(frame.directions, "directions"),
                          buffer_of(frame.frequencies, "frequencies")});
    }
  }
  WaveBuffers frame(int number) const {
    const auto& [positions, directions, frequencies] =
        buffers_[static_cast<std::size_t>(number) % 2];
    return {positions, directions, frequencies};
  }

 private:
  std::vector<std::array<GlBuffer, 3>> buffers_;
};

/// An animator per field, after its first frame.
std::vector<GpuAnimator> started_animators(const Gpu& gpu, const Subject& subject) {
  std::vector<GpuAnimator> animators;
  animators.emplace_back(gpu.solver.kernels(), subject.surface.neighborhood);
  animators[0].frame(subject.inputs[0].frame(0));
  for (std::size_t field = 1; field < subject.inputs.size(); ++field) {
    animators.push_back(animators[0].sibling());
    animators[field].frame(subject.inputs[field].frame(0));
  }
  return animators;
}

/// Idle devices take a while to raise their clock.
void warm_up(const std::function<Sample()>& frame) {
  constexpr double kMilliseconds = 500;
  Stopwatch watch;
  for (double passed = 0; passed < kMilliseconds; passed += watch.lap()) frame();
}

/// Frames until the device has finished, with their input on the host or, by ResidentInput, on the
/// device. Stages are times on the device, sums over fields.
template <class Input>
void run_frames(benchmark::State& state, const Gpu& gpu, const Subject& subject) {
  const std::vector<Input> inputs(subject.inputs.begin(), subject.inputs.end());
  std::vector<GpuAnimator> animators = started_animators(gpu, subject);
  int number = 0;
  const auto frame = [&] {
    ++number;
    Sample sample;
    glFinish();
    Stopwatch watch;
    for (std::size_t field = 0; field < inputs.size(); ++field) {
      animators[field].frame(inputs[field].frame(number));
    }
    glFinish();
    sample.time = watch.lap();
    sample.stages = animators[0].stage_milliseconds();
    for (std::size_t field = 1; field < animators.size(); ++field) {
      const std::vector<StageTime> stages = animators[field].stage_milliseconds();
      for (std::size_t s = 0; s < stages.size(); ++s) sample.stages[s].second += stages[s].second;
    }
    sample.stages.emplace_back(
        "device",
        std::accumulate(sample.stages.begin(), sample.stages.end(), 0.0,
                        [](double sum, const StageTime& stage) { return sum + stage.second; }));
    return sample;
  };
  // Of the second frame, because the number of frames differs from run to run.
  frame();
  std::vector<std::vector<Complex>> z;
  for (const GpuAnimator& animator : animators) z.push_back(animator.read_phases());
  show(state, quality_of(subject, number, z));
  warm_up(frame);
  repeat(state, frame);
  state.counters["dispatches"] = std::accumulate(
      animators.begin(), animators.end(), 0.0, [](double sum, const GpuAnimator& animator) {
        return sum + static_cast<double>(animator.dispatches());
      });
  state.counters["topology_ms"] = animators[0].topology_milliseconds();
  gpu.context.check_errors("measuring frames on the GPU");
}

/// Pictures from the buffer of phases, with readback.
void run_pictures(benchmark::State& state, const Gpu& gpu, const Subject& subject) {
  const std::vector<GpuAnimator> animators = started_animators(gpu, subject);
  Renderer renderer;
  renderer.upload({.mesh = subject.surface.mesh,
                   .normals = subject.surface.normals,
                   .waves = &subject.fields[0]});
  renderer.use_phases(animators[0].phases());
  RenderOptions options;
  options.width = 1920;
  options.height = 1080;
  repeat_picture(state, renderer, options);
  gpu.context.check_errors("measuring pictures on the GPU");
}

}  // namespace

void add_gpu(const Gpu& gpu, const Subject& subject, const std::vector<SolverCase>& solvers,
             int threads) {
  const auto add = [&](const std::string& name, auto run) {
    add_benchmark(name, subject, threads,
                  [&gpu, &subject, run](benchmark::State& state) { run(state, gpu, subject); });
  };
  add("frame", run_frames<ChangingInput>);
  add("frame_of_resident_input", run_frames<ResidentInput>);
  add("picture", run_pictures);
  const SolvePhases solve = [&gpu](const PhaseGraph& graph, const SolverOptions& options,
                                   const Progress& progress, const SolverData& /*data*/) {
    PhaseSolution solution = gpu.solver.solve(graph, options, progress);
    gpu.context.check_errors("solving on the GPU");
    return solution;
  };
  for (const SolverCase& solver : solvers) {
    if (is_available_on_gpu(solver.options.solver)) add_solver(subject, threads, solver, solve);
  }
}

}  // namespace brindle::bench
