#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>

#include <epoxy/gl.h>

#include "benchmarks.h"
#include "brindle/base/stopwatch.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/gl/shader_program.h"

namespace brindle::bench {
namespace {

// More than any device's cache, and within the buffer size of software Mesa.
constexpr std::size_t kCopiedBytes = std::size_t{128} << 20;
constexpr int kCopies = 8;
// Groups of 64 vectors of 16 bytes.
constexpr GLuint kCopyRows = 4, kCopyColumns = kCopiedBytes / (64 * 16 * kCopyRows);

// Copies by a shader: glCopyNamedBufferSubData may use the copy engine for host transfers, which is
// ten times as slow on some devices.
constexpr std::string_view kCopy = R"glsl(
layout(local_size_x = 64) in;
layout(std430, binding = 0) restrict readonly buffer From { uvec4 from[]; };
layout(std430, binding = 1) restrict writeonly buffer To { uvec4 to[]; };

void main() {
  const uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  const uint n = group * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
  to[n] = from[n];
}
)glsl";

double copy_bandwidth() {
  const ShaderProgram copy = ShaderProgram::compute({{"copy", kCopy}});
  const GlBuffer from = make_buffer(kCopiedBytes, nullptr, "copied bytes");
  const GlBuffer to = make_buffer(kCopiedBytes, nullptr, "copied bytes");
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, from);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, to);
  glUseProgram(copy.name());
  std::array<GLuint, 2> marks{};  // software Mesa has timestamps, but no elapsed-time queries
  glCreateQueries(GL_TIMESTAMP, 2, marks.data());
  std::vector<GLuint64> nanoseconds(kCopies);
  for (GLuint64& time : nanoseconds) {
    GLuint64 begin = 0, end = 0;
    glQueryCounter(marks[0], GL_TIMESTAMP);
    glDispatchCompute(kCopyColumns, kCopyRows, 1);
    glQueryCounter(marks[1], GL_TIMESTAMP);
    glGetQueryObjectui64v(marks[0], GL_QUERY_RESULT, &begin);
    glGetQueryObjectui64v(marks[1], GL_QUERY_RESULT, &end);
    time = end - begin;
  }
  glDeleteQueries(2, marks.data());
  return 2e9 * static_cast<double>(kCopiedBytes) /
         static_cast<double>(*std::ranges::min_element(nanoseconds));
}

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

void show_traffic(benchmark::State& state, const Gpu& gpu,
                  const std::vector<GpuAnimator>& animators) {
  double bytes = 0, dispatches = 0;
  for (const GpuAnimator& animator : animators) {
    dispatches += static_cast<double>(animator.dispatches());
    for (const auto& [stage, moved] : animator.stage_bytes()) {
      state.counters[std::string(stage) + "_bytes"].value += static_cast<double>(moved);
      bytes += static_cast<double>(moved);
    }
  }
  state.counters["dispatches"] = dispatches;
  state.counters["bytes"] = bytes;
  state.counters["floor_ms"] = 1000 * bytes / gpu.copied_bytes_per_second;
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
  show_traffic(state, gpu, animators);
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

Gpu::Gpu() : copied_bytes_per_second(copy_bandwidth()) {}

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
