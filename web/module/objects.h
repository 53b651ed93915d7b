/// What JavaScript holds: a surface, a pattern on it, an animator. Each keeps what it needs alive.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/pattern_frames.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"
#include "brindle/surface.h"
#include "brindle/texture_pattern.h"
#include "values.h"

namespace brindle::web {

struct SurfaceObject {
  Surface surface;
  std::vector<std::string> notes;  ///< what was repaired, joined or left out
  std::vector<Index> vertex_of_row;
  DataArrays arrays;  ///< of the file that it was read from
};

/// The array of that name, a row per vertex: of triangles, their mean around it. Throws Error for a
/// name that is none, saying which there are.
DataArray array_at_vertices(const SurfaceObject& object, const std::string& name);

using SurfacePointer = std::shared_ptr<const SurfaceObject>;

struct PatternObject {
  SurfacePointer surface;
  StripePattern pattern;
};

struct TextureObject {
  SurfacePointer surface;
  TexturePattern pattern;
};

struct AnimatorObject {
  SurfacePointer surface;
  StripeAnimator animator;
  std::optional<PatternFrames> frames;  ///< once somebody draws
  std::vector<PatternVertex> vertices;  ///< of the last frame that somebody drew
};

/// Each says what its functions are called, and to whom they belong.
void bind_surfaces();
void bind_fields();
void bind_patterns();
void bind_animators();
void bind_files();

}  // namespace brindle::web
