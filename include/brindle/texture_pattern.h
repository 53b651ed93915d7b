/// Periodic texture coordinates: two stripe patterns along orthogonal fields (paper, 3.5).
#pragma once

#include "brindle/export.h"
#include "brindle/frequency_field.h"
#include "brindle/stripe_pattern.h"
#include "brindle/texture_coordinates.h"
#include "brindle/texture_waves.h"

namespace BRINDLE_EXPORT brindle {

struct TextureOptions {
  /// Stripes per unit length of V, one per vertex; empty: those of U.
  FrequencyField frequencies_v = {};
  /// Whether the directions are vectors, whose signs are meant: textures then point along them.
  /// Otherwise an orientation is looked for that turns round at as few edges as possible.
  bool oriented = false;
  StripeOptions stripes = {};
};

struct TexturePattern {
  StripePattern u;     ///< along the given field
  StripePattern v;     ///< along the field turned by 90 degrees about the normals
  TextureWaves waves;  ///< both at the corners of every triangle, oriented
  TextureSeams seams;
  TextureQuality quality;
  PhaseShiftKind phase_shift = PhaseShiftKind::aligned;  ///< as in the options
  double orientation_milliseconds = 0;  ///< all that comes after both stripe patterns
};

/// Couples and solves both fields and orients the result. `waves` has one entry per vertex and
/// becomes U. Throws Error if sizes do not match, and what `stripe_pattern` throws.
TexturePattern texture_pattern(const Surface& surface, WaveSet waves,
                               const TextureOptions& options = {}, const Progress& progress = {});

/// The same along a direction field, with `frequency` tiles per unit length along it.
TexturePattern texture_pattern(const Surface& surface, DirectionField field, float frequency,
                               const TextureOptions& options = {}, const Progress& progress = {});

/// The surface with texture coordinates, for files and other programs. Throws Error for a pattern
/// of another surface, and Cancelled if `progress` asks for it.
TexturedMesh texture_coordinates(const Surface& surface, const TexturePattern& pattern,
                                 const Progress& progress = {});

/// The same of stripes alone: U is across the stripes, as a texture's, and V 1/2 everywhere, the
/// middle of the tile. Triangles are oriented as those of a texture that is `oriented` or not; an
/// orientation of vectors, or of directions whose signs agree already, takes a third of the time.
/// Throws Error for a pattern of another surface, and Cancelled if `progress` asks for it.
TexturedMesh texture_coordinates(const Surface& surface, const StripePattern& pattern,
                                 PhaseShiftKind phase_shift = PhaseShiftKind::aligned,
                                 bool oriented = false, const Progress& progress = {});

}  // namespace brindle
