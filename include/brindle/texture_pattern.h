/// Periodic texture coordinates: two stripe patterns along orthogonal fields (paper, 3.5).
#pragma once

#include "brindle/export.h"
#include "brindle/frequency_field.h"
#include "brindle/stripe_pattern.h"
#include "brindle/texture_coordinates.h"
#include "brindle/texture_waves.h"

namespace BRINDLE_EXPORT brindle {

/// Options of `texture_pattern`.
struct TextureOptions {
  /// Stripes per unit length of V, one per vertex; empty: those of U.
  FrequencyField frequencies_v = {};
  /// Whether the signs of directions count: textures then point along them. Otherwise the
  /// orientation is chosen that reverses at as few edges as possible.
  bool oriented = false;
  StripeOptions stripes = {};
};

/// A texture: two stripe patterns along orthogonal fields.
struct TexturePattern {
  StripePattern u;     ///< along the given field
  StripePattern v;     ///< along the field turned by 90 degrees about the normals
  TextureWaves waves;  ///< both at the corners of every triangle, oriented
  TextureSeams seams;
  TextureQuality quality;
  PhaseShiftKind phase_shift = PhaseShiftKind::aligned;  ///< as in the options
  double orientation_milliseconds = 0;                   ///< all stages after both stripe patterns
};

/// Couples and solves both fields and orients the result. `waves` has one entry per vertex and
/// becomes U. Throws Error if sizes do not match, and what `check_tangent_waves` and
/// `stripe_pattern` throw.
TexturePattern texture_pattern(const Surface& surface, WaveSet waves,
                               const TextureOptions& options = {}, const Progress& progress = {});

/// The same along a direction field, with `frequency` tiles per unit length along it.
TexturePattern texture_pattern(const Surface& surface, DirectionField field, float frequency,
                               const TextureOptions& options = {}, const Progress& progress = {});

/// The surface with texture coordinates, for files and other programs. Throws Error for a pattern
/// of another surface, and Cancelled if `progress` cancels.
TexturedMesh texture_coordinates(const Surface& surface, const TexturePattern& pattern,
                                 const Progress& progress = {});

/// As above for stripes alone: U runs across the stripes, and V is 1/2 everywhere, the middle of
/// the tile. `oriented` is as in TextureOptions. Orienting vectors, or directions whose signs agree
/// already, takes a third of the time. Throws Error for a pattern of another surface, and Cancelled
/// if `progress` cancels.
TexturedMesh texture_coordinates(const Surface& surface, const StripePattern& pattern,
                                 PhaseShiftKind phase_shift = PhaseShiftKind::aligned,
                                 bool oriented = false, const Progress& progress = {});

}  // namespace brindle
