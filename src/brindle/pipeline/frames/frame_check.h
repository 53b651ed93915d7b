/// What no animator and no frame can have: what all animators refuse.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brindle/stripe_animator.h"

namespace brindle {

/// Throw Error for options out of range, and for input without one entry for each of so many
/// vertices. Values are not looked at.
void check_animator_options(const AnimatorOptions& options);
void check_frame_input(const FrameInput& input, std::size_t vertices);

/// What directions must be tangent to, as long as vertices stand where they stood.
struct NormalsInPlace {
  std::vector<Vec3> positions, normals;  ///< empty: nothing is known
};

/// Throws Error for what `check_waves` and `check_fineness` refuse, and for what `check_tangent`
/// does, where the input has normals or vertices stand in place.
void check_values(const FrameInput& input, const Adjacency& neighborhood,
                  const NormalsInPlace& in_place);

}  // namespace brindle
