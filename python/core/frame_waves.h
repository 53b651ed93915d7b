/// Waves of frames.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "arrays.h"
#include "brindle/direction_field.h"
#include "brindle/phase_graph.h"

namespace brindle::python {

/// Throws Error for numbers outside the tool's bounds.
void check_numbers(float lambda, int sweeps, int cycles);

/// NaN frequencies mean no wave, as in patterns.
class FrameWaves {
 public:
  /// The arrays must outlive this object; `frequencies` may be empty.
  FrameWaves(std::span<const Vec3> directions, std::span<const float> frequencies);
  FrameWaves(const FrameWaves&) = delete;
  FrameWaves& operator=(const FrameWaves&) = delete;

  std::span<const Vec3> directions() const { return directions_; }
  std::span<const float> frequencies() const { return frequencies_; }

 private:
  DirectionField own_directions_;
  FrequencyField own_frequencies_;
  std::span<const Vec3> directions_;
  std::span<const float> frequencies_;
};

/// A single frequency, or an array.
class FrequenciesIn {
 public:
  FrequenciesIn(py::handle given, std::size_t vertices, const std::string& what);

  std::span<const float> rows() const { return everywhere_.empty() ? rows_.rows() : everywhere_; }
  std::span<const float> array() const { return rows_.rows(); }  ///< empty for a single frequency

 private:
  std::vector<float> everywhere_;
  RowsIn<float> rows_;
};

/// No rows for None.
RowsIn<Vec3> rows_if_given(py::handle given, const std::string& what);

}  // namespace brindle::python
