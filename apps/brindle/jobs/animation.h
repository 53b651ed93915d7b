/// Plays a scene frame by frame and reports its metrics.
#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "brindle/data_arrays.h"
#include "brindle/progress.h"
#include "brindle/quality.h"
#include "brindle/recipe/report.h"
#include "brindle/recipe/wave_report.h"
#include "brindle/stripe_animator.h"
#include "cli/progress_display.h"
#include "device/device.h"
#include "input/carried_pattern.h"
#include "scenes/scene.h"

namespace brindle::tool {

/// The quality of a frame's phases.
struct FrameQuality {
  double energy = 0;
  PatternQuality quality;
  double phase_step = 0;  ///< mean over vertices with a wave, radians; 0 in the first frame
};

/// Further metrics of a frame in a series.
struct SeriesFrameReport {
  std::string file;  ///< empty between two steps
  double time = 0;
  std::optional<Matching> matched_by;  ///< empty in the first frame
  std::size_t vertices_unmatched = 0;  ///< waves without a last phase
  std::optional<double> field_turned_deg =
      {};  ///< mean, of smooth fields that continued the last step's
};

struct FrameReport {
  FrameQuality metrics;
  std::optional<SeriesFrameReport> series;
  bool unchanged = false;  ///< whether the input equals that of the last frame
  double scene_milliseconds = 0;
  FrameMilliseconds milliseconds;
  double render_milliseconds = 0;            ///< drawing and writing
  std::optional<FrequencyReport> frequency;  ///< with a spacing tolerance
  std::optional<FrameQuality> from_scratch;  ///< the same input, solved without the last frame
};

struct SeriesReport {
  std::string name;
  std::size_t steps = 0;
  int between = 0;  ///< frames between two steps
};

struct AnimationReport {
  nlohmann::ordered_json invocation = nlohmann::ordered_json::object();  ///< from `invocation_of`
  SceneKind scene = SceneKind::zoom;
  std::optional<SeriesReport> series;  ///< instead of a scene
  AnimatorOptions options;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  int threads = 0;
  WaveReport waves;  ///< of the first frame
  double topology_milliseconds = 0;
  nlohmann::ordered_json device;  ///< from Device::description
  std::vector<FrameReport> frames;
  nlohmann::ordered_json picture;  ///< keys on pictures; null if nothing is drawn
};

/// The source of a frame: a surface as in its file, and the file's other data.
struct FrameData {
  const Surface& surface;  ///< with the triangles of the frame; its vertices may have moved since
  const DataArrays& arrays;
  std::string file;                      ///< for messages
  std::span<const Index> vertex_of_row;  ///< as in Preparation
  std::size_t step = 0;                  ///< index of the file in a series
  float share = 1;                       ///< position between the last file (0) and this one (1)
};

/// A solved frame.
struct SolvedFrame {
  const FrameData& data;
  const SceneFrame& scene;
  std::span<const Complex> z;
  unsigned phase_buffer;  ///< name of an OpenGL buffer with a copy of z; 0 for none
  std::span<const CornerPhases> corners;
  std::span<const float>
      frequencies_wanted;  ///< with a spacing tolerance, besides those of the scene's waves
};

/// Receives every frame.
using ShowFrame = std::function<void(const SolvedFrame& frame)>;

struct AnimationOptions {
  SceneOptions scene;
  AnimatorOptions animator;
  int frames = 121;
  int subdivided = 0;  ///< subdivisions, for warnings
  bool along = false;  ///< stripes along the scene's field: waves are turned by 90 degrees
  bool compare_from_scratch = false;
};

/// Solves and measures all frames of the surface; `show` may be empty. Notes likely mistakes.
/// Throws what the animator and `show` throw, Error if the first frame has no waves, and Cancelled.
AnimationReport play(const FrameData& data, const AnimationOptions& options, const Device& device,
                     const ShowFrame& show, ProgressDisplay& display);

/// A frame's lifted and measured phases.
struct MeasuredFrame {
  FrameQuality metrics;
  std::vector<CornerPhases> corners;
};

MeasuredFrame measure(const SceneFrame& frame, const PhaseGraph& graph, const FrameResult& result,
                      PhaseShiftKind kind);

class RelaxedFrame;

/// The metrics alone.
FrameQuality measure_relaxed(const RelaxedFrame& relaxed,
                             std::shared_ptr<const Adjacency> neighborhood,
                             const FrameResult& result, PhaseShiftKind kind);

/// A frame with the frequencies that it was solved for, which the spacing tolerance may have
/// changed.
class RelaxedFrame {
 public:
  RelaxedFrame(const SceneFrame& wanted, const FrameResult& result);
  RelaxedFrame(const RelaxedFrame&) = delete;
  RelaxedFrame& operator=(const RelaxedFrame&) = delete;

  const SceneFrame& frame() const { return relaxed_ ? *relaxed_ : wanted_; }

  /// Empty without a spacing tolerance.
  std::span<const float> frequencies_wanted() const;
  std::optional<FrequencyReport> report(std::span<const CornerPhases> corners,
                                        const FrameResult& result) const;

 private:
  const SceneFrame& wanted_;
  std::optional<SceneFrame> relaxed_;
};

nlohmann::ordered_json to_json(const AnimationReport& report);

/// Prints every few frames, the means, and a comparison of the last frame with its from-scratch
/// solution, if there is one.
void print_report(std::ostream& out, const AnimationReport& report);

}  // namespace brindle::tool
