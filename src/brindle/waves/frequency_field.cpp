#include "brindle/frequency_field.h"

#include <cmath>
#include <numeric>
#include <string>

#include "brindle/error.h"

namespace brindle {
namespace {

void require_positive(float value, const char* what) {
  if (!(value > 0) || !std::isfinite(value)) {
    throw Error(std::string(what) + " must be a finite number above zero, not " +
                std::to_string(value));
  }
}

}  // namespace

FrequencyField constant_frequency_field(float frequency, std::size_t vertex_count) {
  require_positive(frequency, "frequency");
  return FrequencyField(vertex_count, frequency);
}

float frequency_of_stripes(float stripes, float diagonal) {
  require_positive(stripes, "number of stripes");
  require_positive(diagonal, "bounding box diagonal");
  return stripes / diagonal;
}

float frequency_of_spacing(float spacing) {
  require_positive(spacing, "spacing");
  return 1 / spacing;
}

double mean_spacing(const FrequencyField& frequencies) {
  const double sum = std::accumulate(frequencies.begin(), frequencies.end(), 0.0);
  return static_cast<double>(frequencies.size()) / sum;
}

}  // namespace brindle
