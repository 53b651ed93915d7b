/// Derived data of a pattern with known phases.
#pragma once

#include <cstddef>
#include <span>

#include "brindle/pipeline/texture_orientation.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"
#include "brindle/texture_pattern.h"

namespace brindle {

/// Number of branches in triangles with branch avoidance; `branch_penalty` is per vertex.
std::size_t count_in_avoided_area(std::span<const Triangle> triangles,
                                  std::span<const CornerPhases> corners,
                                  std::span<const float> branch_penalty);

/// The two halves of `measure_pattern`: `corners`, reusing its memory, and `quality`.
void set_corners(std::span<const Triangle> triangles, StripePattern& pattern,
                 const Progress& progress = {});
void set_quality(const Surface& surface, std::span<const float> branch_penalty,
                 StripePattern& pattern, const Progress& progress = {});

/// Timings of a frame as those of a static pattern.
StripeMilliseconds times_of(const FrameMilliseconds& frame);

/// Stores a frame's `waves` and result in `pattern`, except for the energy.
void set_frame(WaveSet waves, const FrameResult& frame, StripePattern& pattern);

/// Sets the texture's waves and seams from the current orientation.
void set_oriented_waves(std::span<const Triangle> triangles, const TextureOrientation& orientation,
                        TexturePattern& pattern, const Progress& progress = {});

/// Texture distortion, from the corner phases of both patterns.
TextureQuality texture_quality(const Mesh& mesh, const TexturePattern& pattern,
                               const Progress& progress = {});

/// Orients the triangles, unless the input is vectors (`as_given`). Sets waves, seams and quality
/// from both patterns.
void orient_texture(const Mesh& mesh, bool as_given, const Progress& progress,
                    TexturePattern& pattern);

// Solves again for waves that changed after the frequency relaxation.

/// As `stripe_pattern`, but with fixed frequencies. Those of `waves` come from the pattern
/// `before`, which has the requested frequencies and the relaxation's change.
StripePattern resolve_with_frequencies(const Surface& surface, WaveSet waves,
                                       const StripePattern& before, const StripeOptions& options,
                                       const Progress& progress = {});

}  // namespace brindle
