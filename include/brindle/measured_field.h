/// Direction fields that were measured, noisy or with holes, seen at the scale of their stripes
/// (docs/data.md).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "brindle/direction_field.h"
#include "brindle/export.h"
#include "brindle/frequency_field.h"
#include "brindle/progress.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// Directions as they were measured.
struct MeasuredField {
  DirectionField directions;  ///< of any length; their tangent part counts. Zero, or what is not
                              ///< finite: there is no datum
  std::vector<float> confidence;  ///< how much each counts, 0 or above; their mean stands for 1, so
                                  ///< that units do not matter. Empty: all alike
  bool of_triangles = false;      ///< there is one for each triangle, not for each vertex
};

struct FieldDetailOptions {
  float periods = 1;  ///< P: the field is averaged over places whose root mean square distance is
                      ///< P periods of the stripes; above 0, up to 100
  int symmetry = 2;   ///< N: 1 arrows, 2 lines, 4 crosses
  float fill = 2;     ///< how far holes are filled from their border, in periods; 0: not at all
  /// Pairs of singularities are undone, the nearest first, by averaging over more around them,
  /// until at most so many are left, or those that no pair undoes; elsewhere the field stays.
  /// Nothing: all stay. Needs triangles.
  std::optional<std::size_t> singularities = {};
  float memory = 0;  ///< how much the last field counts beside the data: 0 not at all, 1 as much
};

/// What a field at the scale of its stripes has to do with its data.
struct FieldDetailFigures {
  std::size_t data = 0;      ///< vertices with a datum, of their own or of a triangle around them
  std::size_t filled = 0;    ///< vertices without a datum that have got a direction
  std::size_t unfilled = 0;  ///< vertices with neighbours that have none: too far from all data
  // By how many degrees the field was turned from its data, weighted by their areas.
  double turned_mean_deg = 0;
  double turned_median_deg = 0;
  double turned_p95_deg = 0;               ///< 95 % are turned by less
  double turned_share_over_20deg = 0;      ///< 0 to 1
  std::size_t singularities_of_data = 0;   ///< triangles that the data turn round, before and
  std::size_t singularities = 0;           ///< after
  std::size_t singularities_too_many = 0;  ///< beyond what the options ask for: no pair undoes them
};

/// One entry per vertex.
struct DetailedField {
  DirectionField directions;     ///< unit tangent vectors; zero beyond what is filled
  std::vector<float> agreement;  ///< how much the data around a vertex agree, from 0, not at all,
                                 ///< to 1; 0 where there is no direction
};

/// Measured fields on one surface, one after the other: what depends on the surface alone is made
/// once. As u = exp(i N theta), coupled by parallel transport R, the field is the minimum of
///
///     integral |grad u|^2 + c / l^2 |u - u0|^2,   l = P / (2 f),
///
/// with the data u0, their confidence c (0 in holes, which are filled by what is smoothest) and the
/// frequency f of the stripes, in finite elements. What decays as a screened field does over the
/// length l has a root mean square distance of 2 l = P / f: P periods. A mesh that is finer gives
/// the same field.
class FieldDetail {
 public:
  /// Throws Error for options out of range, for positions and normals that are not finite;
  /// Cancelled if `progress` asks for it. `surface` may go afterwards.
  explicit FieldDetail(const Surface& surface, const FieldDetailOptions& options = {},
                       const Progress& progress = {});
  ~FieldDetail();
  FieldDetail(FieldDetail&&) noexcept;
  FieldDetail& operator=(FieldDetail&&) noexcept;

  /// `frequencies` are stripes per unit length, one per vertex; where one is 0 there is no wave,
  /// and no direction. `last` is the field before, if any: at each vertex a direction, counting as
  /// much as the data times `memory` and its confidence. Directions of lines and crosses are signed
  /// to run like their neighbours, from the second frame on like the last frame's. Throws Error for
  /// other numbers of entries, for confidences and frequencies that are negative or not finite, and
  /// if there is no datum at all; Cancelled if `progress` asks for it.
  DetailedField frame(const MeasuredField& measured, std::span<const float> frequencies,
                      const MeasuredField& last = {}, const Progress& progress = {});

  /// Of the last frame. Throws Error before the first one.
  FieldDetailFigures figures() const;

 private:
  struct State;
  Pimpl<State> state_;
};

struct FrequencyDetailOptions {
  float periods = 1;  ///< as FieldDetailOptions has it
  float fill = 2;     ///< how far holes are filled from their border, in periods; 0: not at all
};

struct DetailedFrequencies {
  FrequencyField frequencies;  ///< one per vertex; NaN beyond what is filled
  std::size_t filled = 0;      ///< vertices that had none
  double changed_median = 0;   ///< by which share half of all data, by area, were changed at most
};

/// Frequencies that were measured, seen at the scale of their own stripes: their logarithms are
/// smoothed as a FieldDetail smooths directions, first over periods of the data, then over those
/// that were found. `frequencies` are stripes per unit length, one per vertex: NaN in holes, 0
/// where there is no wave, which stays so. Throws Error for options out of range, for other numbers
/// of entries and other frequencies, and if there is none above 0; Cancelled if `progress` asks for
/// it.
DetailedFrequencies detailed_frequencies(const Surface& surface, std::span<const float> frequencies,
                                         const FrequencyDetailOptions& options = {},
                                         const Progress& progress = {});

}  // namespace brindle
