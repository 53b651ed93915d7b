/// What JavaScript holds: a surface, a pattern on it, an animator. Each keeps what it needs alive.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/direction_field.h"
#include "brindle/pattern_frames.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"
#include "brindle/surface.h"
#include "brindle/texture_pattern.h"
#include "brindle/wave_figures.h"
#include "values.h"

namespace brindle::web {

struct SurfaceObject {
  Surface surface;
  std::vector<std::string> notes;  ///< what was repaired, joined or left out
  std::vector<Index> vertex_of_row;
  DataArrays arrays;         ///< of the file that it was read from
  float crease_angle = 180;  ///< of the creases that have split it
  int subdivided = 0;        ///< times
};

using SurfacePointer = std::shared_ptr<const SurfaceObject>;

struct PatternObject {
  SurfacePointer surface;
  StripePattern pattern;
};

struct TextureObject {
  std::shared_ptr<SurfaceObject> surface;  ///< that it is drawn on
  TexturePattern pattern;
  bool crosses = false;  ///< U's figures are those of both waves
};

struct AnimatorObject {
  SurfacePointer surface;
  StripeAnimator animator;
  std::optional<PatternFrames> frames;  ///< once somebody draws
  std::vector<PatternVertex> vertices;  ///< of the last frame that somebody drew
};

/// Words for warnings of patterns on the surface.
WarningWords words_for(const SurfaceObject& object);

/// A surface that is split at creases, with what is to be said of it; `notes` may have more.
std::shared_ptr<SurfaceObject> surface_object(Mesh mesh, float crease_angle,
                                              std::vector<std::string> notes);

/// Appends what stands on the lines, without empty ones.
void add_lines(std::vector<std::string>& notes, const std::string& lines);

/// A frame's input, and what it points to.
class GivenFrame {
 public:
  GivenFrame(const Mesh& mesh, const val& given);
  GivenFrame(const GivenFrame&) = delete;
  GivenFrame& operator=(const GivenFrame&) = delete;

  FrameInput input;
  WaveSet waves() const;  ///< that it is of

 private:
  std::vector<Vec3> positions_, normals_, directions_;
  std::vector<float> frequencies_;
};

AnimatorOptions animator_options(const val& given);
StripeOptions stripe_options(const val& given);
CurvatureDirection curvature_direction(const std::string& name);
val kinds_of(std::span<const CornerPhases> corners);

/// Each says what its functions are called, and to whom they belong. The first four are what
/// stripes in real time need.
void bind_surfaces();
void bind_fields();
void bind_patterns();
void bind_animators();
void bind_shapes();
void bind_files();
void bind_measured_fields();
void bind_lines();
void bind_cameras();
void bind_textures();

}  // namespace brindle::web
