#include "bench/gpu_measurements.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <epoxy/gl.h>

#include "bench/changing_input.h"
#include "brindle/base/stopwatch.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/gpu_animator.h"
#include "brindle/renderer.h"
#include "input/gpu.h"

namespace brindle::tool {
namespace {

constexpr std::size_t kCopiedBytes = std::size_t{64} << 20;
constexpr int kCopies = 8;

/// An animator for every field, all with their first frame behind them.
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

Sample sample_of(std::vector<GpuAnimator>& animators, const std::vector<ChangingInput>& inputs,
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

Spread picture_time(const Subject& subject, const GpuAnimator& animator,
                    const Repetitions& repetitions) {
  Renderer renderer;
  renderer.upload({.mesh = subject.surface.mesh,
                   .normals = subject.surface.normals,
                   .waves = &subject.fields[0]});
  renderer.use_phases(animator.phases());
  RenderOptions options;
  options.width = 1920;
  options.height = 1080;
  return spread_of(samples_of(repetitions, [&] {
    Stopwatch watch;
    renderer.draw(options);
    return watch.lap();
  }));
}

}  // namespace

GpuFrameFigures measure_gpu_frames(const Device& device, const Subject& subject,
                                   const Repetitions& repetitions, const Progress& progress) {
  const std::vector<ChangingInput> inputs = changing_inputs(subject);
  progress.report("topology", 0);
  std::vector<GpuAnimator> animators = started_animators(device, subject, inputs);
  int number = 0;
  const auto samples = samples_of(repetitions, [&] {
    progress.report("frames", 0);
    return sample_of(animators, inputs, ++number);
  });
  GpuFrameFigures figures;
  figures.topology_milliseconds = animators[0].topology_milliseconds();
  figures.stages = stages_of(samples, animators);
  figures.device = spread_of(samples, [](const Sample& sample) { return sample.device(); });
  figures.wall = spread_of(samples, [](const Sample& sample) { return sample.wall; });
  std::vector<std::vector<Complex>> z;
  for (const GpuAnimator& animator : animators) {
    figures.dispatches += animator.dispatches();
    z.push_back(animator.read_phases());
  }
  figures.quality = quality_of(subject, inputs, number, z);
  progress.report("picture", 0);
  figures.picture = picture_time(subject, animators[0], repetitions);
  device.check_errors("measuring frames on the GPU");
  return figures;
}

double copy_bandwidth() {
  const GlBuffer from = make_buffer(kCopiedBytes, nullptr, "copied bytes");
  const GlBuffer to = make_buffer(kCopiedBytes, nullptr, "copied bytes");
  double best = 0;
  for (int copy = 0; copy < kCopies; ++copy) {
    glFinish();
    Stopwatch watch;
    glCopyNamedBufferSubData(from, to, 0, 0, static_cast<GLsizeiptr>(kCopiedBytes));
    glFinish();
    best = std::max(best, 2 * static_cast<double>(kCopiedBytes) / (watch.lap() / 1000));
  }
  return best;
}

}  // namespace brindle::tool
