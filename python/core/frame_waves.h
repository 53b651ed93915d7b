/// Waves of arrays, by the same rules for patterns and for frames.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "arrays.h"
#include "brindle/direction_field.h"
#include "brindle/pattern_frames.h"
#include "brindle/phase_graph.h"
#include "brindle/stripe_animator.h"
#include "surface_data.h"

namespace brindle::python {

/// The direction of a vector of any length; unit tangent vectors stay as they are, so that fields
/// that Brindle made are not rounded once more.
Vec3 direction_of(const Vec3& vector, const Vec3& normal);

/// A direction per vertex; zero where rows are zero, masked or not finite. The array is read where
/// it is if none of its rows changes.
class DirectionsIn {
 public:
  /// Rows become `direction_of` them. Without normals, unit vectors stay as they are, and others
  /// are projected by `otherwise`, which is called for these alone: it takes as long as a frame.
  DirectionsIn(py::handle given, const Mesh& mesh, std::span<const Vec3> normals,
               const std::function<std::span<const Vec3>()>& otherwise = {});

  std::span<const Vec3> rows() const { return own_.empty() ? given_.rows() : own_; }
  std::size_t nonfinite() const { return nonfinite_; }  ///< rows

 private:
  RowsIn<Vec3> given_;
  DirectionField own_;
  std::size_t nonfinite_ = 0;
};

/// Stripes per unit length: a number for all vertices, or a row per vertex, which is NaN where
/// there is no wave. Throws Error for other numbers where `directions` have a wave.
class FrequenciesIn {
 public:
  FrequenciesIn(py::handle given, const Mesh& mesh, const std::string& what,
                std::span<const Vec3> directions);

  std::span<const float> rows() const { return own_.empty() ? given_.rows() : own_; }
  bool is_number() const { return is_number_; }
  bool have_gaps() const;

 private:
  RowsIn<float> given_;
  FrequencyField own_;
  bool is_number_ = false;
};

/// A normal per vertex, for vertices at some positions; valid until the next call.
using NormalsAt = std::function<std::span<const Vec3>(std::span<const Vec3> positions)>;

/// Normals of a surface whose vertices move; points keep theirs.
class MovingNormals {
 public:
  /// The surface must stay.
  explicit MovingNormals(const Surface& surface) : surface_(surface) {}

  std::span<const Vec3> operator()(std::span<const Vec3> positions);

 private:
  const Surface& surface_;
  std::optional<PatternFrames> frames_;  ///< from the first move on
};

/// A row per vertex, or none of None.
RowsIn<Vec3> rows_if_given(py::handle given, const Mesh& mesh, const std::string& what);

/// Whether a frame's input has normals where vertices have moved and none are given.
enum class MovedNormals { left_out, computed };

/// The input of a frame, valid until the next call of `normals_at`.
class FrameIn {
 public:
  FrameIn(const Surface& surface, const NormalsAt& normals_at, MovedNormals moved,
          py::handle directions, py::handle frequencies, py::handle positions,
          py::handle normals = py::none());
  FrameIn(const FrameIn&) = delete;
  FrameIn& operator=(const FrameIn&) = delete;

  const FrameInput& input() const { return input_; }

 private:
  FrameInput places(const Surface& surface, const NormalsAt& normals_at, MovedNormals moved) const;
  void drop_gaps();

  RowsIn<Vec3> positions_, normals_;
  FrameInput input_;
  DirectionsIn directions_;
  FrequenciesIn frequencies_;
  DirectionField own_directions_;
  FrequencyField own_frequencies_;
};

}  // namespace brindle::python
