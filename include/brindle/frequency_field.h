/// Frequencies of waves, in stripes per unit length.
#pragma once

#include <cstddef>
#include <vector>

#include "brindle/export.h"

namespace BRINDLE_EXPORT brindle {

/// One frequency per vertex, in stripes per unit length, above zero and finite.
using FrequencyField = std::vector<float>;

/// The same frequency everywhere. Throws Error if it is not above zero and finite.
FrequencyField constant_frequency_field(float frequency, std::size_t vertex_count);

/// The frequency with `stripes` stripes along a length of `diagonal`: stripes / diagonal.
/// Throws Error if either is not above zero and finite.
float frequency_of_stripes(float stripes, float diagonal);

/// The frequency of stripes with this distance: 1 / spacing. Throws Error if it is not above zero
/// and finite.
float frequency_of_spacing(float spacing);

/// 1 over the mean frequency.
double mean_spacing(const FrequencyField& frequencies);

}  // namespace brindle
