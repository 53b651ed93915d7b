#include "bench/gpu_measurements.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>
#include <utility>

#include <epoxy/gl.h>

#include "bench/changing_input.h"
#include "bench/draw_measurements.h"
#include "brindle/base/stopwatch.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/gl/shader_program.h"
#include "brindle/gpu_animator.h"
#include "brindle/renderer.h"
#include "device/gpu.h"

namespace brindle::tool {
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

/// An animator per field, after its first frame.
std::vector<GpuAnimator> started_animators(const Device& device, const Subject& subject,
                                           const std::vector<ChangingInput>& inputs) {
  std::vector<GpuAnimator> animators;
  animators.emplace_back(device.gpu()->kernels(), subject.surface.neighborhood);
  animators[0].frame(inputs[0].frame(0));
  for (std::size_t field = 1; field < inputs.size(); ++field) {
    animators.push_back(animators[0].sibling());
    animators[field].frame(inputs[field].frame(0));
  }
  return animators;
}

struct Sample {
  std::vector<StageTime> stages;
  double wall = 0;

  double device() const {
    return std::accumulate(stages.begin(), stages.end(), 0.0,
                           [](double sum, const StageTime& stage) { return sum + stage.second; });
  }
};

void add(std::vector<StageTime>& sums, const std::vector<StageTime>& stages) {
  if (sums.empty()) {
    sums = stages;
    return;
  }
  for (std::size_t s = 0; s < sums.size(); ++s) sums[s].second += stages[s].second;
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

/// A frame of each field, from inputs on the host or the device.
template <class Input>
Sample sample_of(std::vector<GpuAnimator>& animators, const std::vector<Input>& inputs,
                 int number) {
  Sample sample;
  glFinish();
  Stopwatch watch;
  for (std::size_t field = 0; field < inputs.size(); ++field) {
    animators[field].frame(inputs[field].frame(number));
  }
  glFinish();
  sample.wall = watch.lap();
  for (const GpuAnimator& animator : animators) add(sample.stages, animator.stage_milliseconds());
  return sample;
}

/// Idle devices take a while to raise their clock.
template <class Frame>
void warm_up(const Frame& frame) {
  constexpr double kMilliseconds = 500;
  Stopwatch watch;
  double passed = 0;
  while (passed < kMilliseconds) {
    frame();
    passed += watch.lap();
  }
}

std::vector<GpuStage> stages_of(const std::vector<Sample>& samples,
                                const std::vector<GpuAnimator>& animators) {
  std::vector<GpuStage> stages;
  for (std::size_t s = 0; s < samples[0].stages.size(); ++s) {
    GpuStage stage{std::string(samples[0].stages[s].first), {}, 0};
    stage.time = spread_of(samples, [s](const Sample& sample) { return sample.stages[s].second; });
    for (const GpuAnimator& animator : animators) {
      for (const auto& [name, bytes] : animator.stage_bytes()) {
        if (name == stage.name) stage.bytes += bytes;
      }
    }
    stages.push_back(std::move(stage));
  }
  return stages;
}

Spread picture_of_frame(const Subject& subject, const GpuAnimator& animator,
                        const Repetitions& repetitions) {
  Renderer renderer;
  renderer.upload({.mesh = subject.surface.mesh,
                   .normals = subject.surface.normals,
                   .waves = &subject.fields[0]});
  renderer.use_phases(animator.phases());
  RenderOptions options;
  options.width = 1920;
  options.height = 1080;
  return picture_time(renderer, options, options.quality, repetitions);
}

}  // namespace

GpuFrameMetrics measure_gpu_frames(const Device& device, const Subject& subject,
                                   const Repetitions& repetitions, const Progress& progress) {
  const std::vector<ChangingInput> inputs = changing_inputs(subject);
  progress.report("topology", 0);
  std::vector<GpuAnimator> animators = started_animators(device, subject, inputs);
  int number = 0;
  const auto measured = [&](const auto& given) {
    const auto sample = [&] {
      progress.report("frames", 0);
      return sample_of(animators, given, ++number);
    };
    warm_up(sample);
    return samples_of(repetitions, sample);
  };
  const auto wall = [](const Sample& sample) { return sample.wall; };
  GpuFrameMetrics metrics;
  metrics.topology_milliseconds = animators[0].topology_milliseconds();
  metrics.wall = spread_of(measured(inputs), wall);
  const auto samples = measured(std::vector<ResidentInput>(inputs.begin(), inputs.end()));
  metrics.stages = stages_of(samples, animators);
  metrics.device = spread_of(samples, [](const Sample& sample) { return sample.device(); });
  metrics.resident = spread_of(samples, wall);
  std::vector<std::vector<Complex>> z;
  for (const GpuAnimator& animator : animators) {
    metrics.dispatches += animator.dispatches();
    z.push_back(animator.read_phases());
  }
  metrics.quality = quality_of(subject, inputs, number, z);
  progress.report("picture", 0);
  metrics.picture = picture_of_frame(subject, animators[0], repetitions);
  device.check_errors("measuring frames on the GPU");
  return metrics;
}

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

}  // namespace brindle::tool
