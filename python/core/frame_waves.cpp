#include "frame_waves.h"

#include <algorithm>
#include <cmath>

#include "brindle/array_field.h"
#include "brindle/error.h"
#include "brindle/recipe/refusals.h"
#include "words.h"

namespace brindle::python {

void check_numbers(float lambda, int sweeps, int cycles) {
  saying_in_pythons_words([&] {
    check_number("--lambda", lambda);
    check_number("--sweeps", sweeps);
    check_number("--cycles", cycles);
  });
}

FrameWaves::FrameWaves(std::span<const Vec3> directions, std::span<const float> frequencies)
    : directions_(directions), frequencies_(frequencies) {
  if (directions.size() != frequencies.size() ||
      std::ranges::none_of(frequencies, [](float f) { return std::isnan(f); })) {
    return;
  }
  if (std::ranges::all_of(frequencies, [](float f) { return std::isnan(f); })) {
    throw Error("frequencies: all are nan; give stripes per unit length where there is a wave");
  }
  own_directions_.assign(directions.begin(), directions.end());
  own_frequencies_.assign(frequencies.begin(), frequencies.end());
  drop_waves_without_frequency(own_directions_, own_frequencies_);
  directions_ = own_directions_;
  frequencies_ = own_frequencies_;
}

FrequenciesIn::FrequenciesIn(py::handle given, std::size_t vertices, const std::string& what) {
  if (given.is_none()) return;
  const Table table = table_of(given, what);
  if (table.is_number) {
    everywhere_.assign(vertices, numbers_of(table.view, what).front());
  } else {
    check_not_empty(table.view.rows(), what);
    rows_ = RowsIn<float>(table.array, what);
  }
}

RowsIn<Vec3> rows_if_given(py::handle given, const std::string& what) {
  if (given.is_none()) return {};
  RowsIn<Vec3> in(given, what);
  check_not_empty(in.rows().size(), what);
  return in;
}

}  // namespace brindle::python
