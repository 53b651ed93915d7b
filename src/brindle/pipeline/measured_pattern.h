/// What follows from a pattern's phases.
#pragma once

#include <cstddef>
#include <span>

#include "brindle/pipeline/texture_orientation.h"
#include "brindle/stripe_animator.h"
#include "brindle/texture_pattern.h"

namespace brindle {

/// How many stripes begin or end in triangles where that is unwelcome; `calm` is by vertex.
std::size_t count_in_calm(std::span<const Triangle> triangles,
                          std::span<const CornerPhases> corners, std::span<const float> calm);

/// The two halves of `measure_pattern`: `corners`, in the memory that they have, and `quality`.
void set_corners(std::span<const Triangle> triangles, StripePattern& pattern,
                 const Progress& progress = {});
void set_quality(const Surface& surface, std::span<const float> calm, StripePattern& pattern,
                 const Progress& progress = {});

/// As of a pattern that is made at once.
StripeMilliseconds times_of(const FrameMilliseconds& frame);

/// Fills in what a frame was solved for, `waves`, and what it has come to, but for the energy.
void set_frame(WaveSet waves, const FrameResult& frame, StripePattern& pattern);

/// The texture's waves, as its triangles are oriented now; and its seams.
void set_oriented_waves(std::span<const Triangle> triangles, const TextureOrientation& orientation,
                        TexturePattern& pattern, const Progress& progress = {});

/// Distortion, from the corner phases of both patterns.
TextureQuality texture_quality(const Mesh& mesh, const TexturePattern& pattern,
                               const Progress& progress = {});

/// Orients the triangles, unless directions are vectors `as_given`, and fills in waves, seams and
/// quality from both patterns, whatever phases these have.
void orient_texture(const Mesh& mesh, bool as_given, const Progress& progress,
                    TexturePattern& pattern);

}  // namespace brindle
