/// Warnings of likely mistakes in a pattern, in the same words in every program.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "brindle/broken_tiles.h"
#include "brindle/export.h"
#include "brindle/measured_field.h"
#include "brindle/quality.h"
#include "brindle/stripe_pattern.h"
#include "brindle/texture_pattern.h"
#include "brindle/wave_metrics.h"

namespace BRINDLE_EXPORT brindle {

/// All warnings of a pattern, one sentence each without a full stop: `surface_warnings`,
/// `wave_warnings` of the requested waves, and `quality_warnings`. `surface` is the pattern's.
std::vector<std::string> pattern_warnings(const Surface& surface, const StripePattern& pattern,
                                          const WarningWords& words = {});

/// The same of a texture, with the larger numbers of its two patterns.
std::vector<std::string> pattern_warnings(const Surface& surface, const TexturePattern& texture,
                                          const WarningWords& words = {});

/// Warns of branches in triangles with more than 10 % of the area; otherwise of stripes that run
/// more than 5 degrees off their field on more than a quarter of the area, in triangles longer than
/// half a period. Remedies name the subdivisions that give two mesh edges per period.
std::vector<std::string> quality_warnings(const WaveMetrics& motifs, const PatternQuality& quality,
                                          std::size_t triangles, const WarningWords& words = {});

/// The larger numbers and shares of the area of two patterns on one surface, for warnings.
PatternQuality worse_of(const PatternQuality& u, const PatternQuality& v);

/// Warns of a measured field, used without smoothing, that is singular in more than 1 % of the
/// triangles.
std::vector<std::string> noise_warnings(std::size_t field_singularities, std::size_t triangles,
                                        const WarningWords& words = {});

/// Warns of motifs that are left out in more than 90 % of the triangles.
std::vector<std::string> tile_warnings(const BrokenTiles& broken, std::size_t triangles,
                                       const WarningWords& words = {});

/// Warns of `WaveResult::turned_apart`.
std::vector<std::string> turn_warnings(std::size_t turned_apart);

/// Warns of more singularities than `FieldSmoothingOptions::singularities` allows.
std::vector<std::string> smoothing_warnings(const FieldSmoothingMetrics& motifs,
                                            const WarningWords& words = {});

}  // namespace brindle
