/// Objects held by JavaScript: a surface, a pattern, an animator. Each keeps what it refers to
/// alive.
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
#include "brindle/wave_metrics.h"
#include "values.h"

namespace brindle::web {

struct SurfaceObject {
  Surface surface;
  std::vector<std::string> notes;  ///< repairs, joined vertices and left-out parts
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
  std::shared_ptr<SurfaceObject> surface;  ///< of the pattern
  TexturePattern pattern;
  bool crosses = false;  ///< U's metrics are those of both waves
};

struct AnimatorObject {
  SurfacePointer surface;
  StripeAnimator animator;
  std::optional<PatternFrames> frames;  ///< created on demand
  std::vector<PatternVertex> vertices;  ///< of the last drawn frame
};

/// Words for warnings of patterns on the surface.
WarningWords words_for(const SurfaceObject& object);

/// A surface that is split at creases, with what is to be said of it; `notes` may have more.
std::shared_ptr<SurfaceObject> surface_object(Mesh mesh, float crease_angle,
                                              std::vector<std::string> notes);

/// Appends the non-empty lines.
void add_lines(std::vector<std::string>& notes, const std::string& lines);

/// A frame's input, with the storage that it refers to.
class GivenFrame {
 public:
  GivenFrame(const Mesh& mesh, const val& given);
  GivenFrame(const GivenFrame&) = delete;
  GivenFrame& operator=(const GivenFrame&) = delete;

  FrameInput input;

 private:
  std::vector<Vec3> positions_, normals_, directions_;
  std::vector<float> frequencies_;
};

AnimatorOptions animator_options(const val& given);
StripeOptions stripe_options(const val& given);
CurvatureDirection curvature_direction(const std::string& name);
val kinds_of(std::span<const CornerPhases> corners);

/// Register functions and classes. Stripes in real time need the first four.
void bind_surfaces();
void bind_fields();
void bind_patterns();
void bind_animators();
void bind_meshes();
void bind_lines();
void bind_cameras();
void bind_textures();

}  // namespace brindle::web
