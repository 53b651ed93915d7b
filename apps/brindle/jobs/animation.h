/// A scene played frame by frame, and its figures.
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
#include "input/carried_pattern.h"
#include "input/device.h"
#include "scenes/scene.h"

namespace brindle::tool {

/// What a frame's phases are worth.
struct FrameQuality {
  double energy = 0;
  PatternQuality quality;
  double phase_step = 0;  ///< mean over vertices with a wave, radians; 0 in the first frame
};

/// What a frame of a series has besides.
struct SeriesFrameReport {
  std::string file;  ///< empty between two steps
  double time = 0;
  std::optional<Matching> matched_by;           ///< not in the first frame
  std::size_t vertices_unmatched = 0;           ///< waves without a last phase
  std::optional<double> field_turned_deg = {};  ///< mean, of a step's smooth field, which followed
};

struct FrameReport {
  FrameQuality figures;
  std::optional<SeriesFrameReport> series;
  bool unchanged = false;  ///< the input was that of the last frame
  double scene_milliseconds = 0;
  FrameMilliseconds milliseconds;
  double render_milliseconds = 0;            ///< drawing and writing
  std::optional<FrequencyReport> frequency;  ///< with slack
  std::optional<FrameQuality> from_scratch;  ///< the same input, solved without the last frame
};

struct SeriesReport {
  std::string name;
  std::size_t steps = 0;
  int between = 0;  ///< frames between two steps
};

struct AnimationReport {
  nlohmann::ordered_json invocation = nlohmann::ordered_json::object();  ///< as `invocation_of`
  SceneKind scene = SceneKind::zoom;
  std::optional<SeriesReport> series;  ///< instead of a scene
  AnimatorOptions options;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  int threads = 0;
  WaveReport waves;  ///< of the first frame
  double topology_milliseconds = 0;
  nlohmann::ordered_json device;  ///< as Device::description gives it
  std::vector<FrameReport> frames;
  nlohmann::ordered_json picture;  ///< keys on pictures; null if nothing is drawn
};

/// What a frame comes from: a surface as its file has it, and what else the file says.
struct FrameData {
  const Surface& surface;  ///< has the triangles of the frame; its vertices may have moved since
  const DataArrays& arrays;
  std::string file;                      ///< for messages
  std::span<const Index> vertex_of_row;  ///< as Preparation has it
  std::size_t step = 0;                  ///< number of the file in a series
  float share = 1;                       ///< of the way to it from the file before
};

/// A frame as it is solved.
struct SolvedFrame {
  const FrameData& data;
  const SceneFrame& scene;
  std::span<const Complex> z;
  unsigned phase_buffer;  ///< name of the OpenGL buffer that z lies in, too; 0 for none
  std::span<const CornerPhases> corners;
  std::span<const float> frequencies_wanted;  ///< with slack, beside those of the scene's waves
};

/// Receives every frame.
using ShowFrame = std::function<void(const SolvedFrame& frame)>;

struct AnimationOptions {
  SceneOptions scene;
  AnimatorOptions animator;
  int frames = 121;
  int subdivided = 0;  ///< times that triangles were split, for warnings
  bool along = false;  ///< waves are turned by 90 degrees: stripes run along the scene's field
  bool compare_from_scratch = false;
};

/// Solves and measures all frames of the surface; `show` may be empty. Notes on the display what is
/// probably not meant. Throws what the animator and `show` do, Error if the first frame has no wave
/// at all, and Cancelled if the display asks for it.
AnimationReport play(const FrameData& data, const AnimationOptions& options, const Device& device,
                     const ShowFrame& show, ProgressDisplay& display);

/// A frame's phases, lifted and measured.
struct MeasuredFrame {
  FrameQuality figures;
  std::vector<CornerPhases> corners;
};

MeasuredFrame measure(const SceneFrame& frame, const PhaseGraph& graph, const FrameResult& result,
                      PhaseShiftKind kind);

class YieldedFrame;

/// The figures alone.
FrameQuality measure_yielded(const YieldedFrame& yielded,
                             std::shared_ptr<const Adjacency> neighborhood,
                             const FrameResult& result, PhaseShiftKind kind);

/// A frame with the frequencies that it was solved for, which may have yielded.
class YieldedFrame {
 public:
  YieldedFrame(const SceneFrame& wanted, const FrameResult& result);
  YieldedFrame(const YieldedFrame&) = delete;
  YieldedFrame& operator=(const YieldedFrame&) = delete;

  const SceneFrame& frame() const { return yielded_ ? *yielded_ : wanted_; }

  /// Empty where nothing yields.
  std::span<const float> frequencies_wanted() const;
  std::optional<FrequencyReport> report(std::span<const CornerPhases> corners,
                                        const FrameResult& result) const;

 private:
  const SceneFrame& wanted_;
  std::optional<SceneFrame> yielded_;
};

nlohmann::ordered_json to_json(const AnimationReport& report);

/// A row every few frames, the means, and the last frame against from-scratch if that was solved.
void print_report(std::ostream& out, const AnimationReport& report);

}  // namespace brindle::tool
