/// Smoothing of measured direction fields, noisy or with holes, at the scale of their stripes
/// (docs/data.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "brindle/direction_field.h"
#include "brindle/export.h"
#include "brindle/frequency_field.h"
#include "brindle/progress.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// A measured direction field.
struct MeasuredField {
  /// Of any length; the tangent part counts. Zero or not finite: no datum.
  DirectionField directions;
  std::vector<float> confidence;  ///< weights, 0 or above, relative to their mean; empty: all equal
  bool of_triangles = false;      ///< one datum per triangle rather than per vertex
};

/// Options of FieldSmoothing.
struct FieldSmoothingOptions {
  float periods = 1;  ///< P: the field is averaged over a root mean square distance of P periods of
                      ///< the stripes; above 0, up to 100
  int symmetry = 2;   ///< N: 1 arrows, 2 lines, 4 crosses
  float fill = 2;     ///< how far holes are filled from their border, in periods; 0: not at all
  /// The largest number of singularities. Cancels the nearest pairs first, by more averaging around
  /// them, until at most this number is left, or those that no pair cancels; elsewhere the field
  /// stays. Empty: all stay. Needs triangles.
  std::optional<std::size_t> singularities = {};
  /// Temporal smoothing: weight of the last field beside the data; 0: none, 1: equal.
  float memory = 0;
  /// A share of the data, from 0 to below 1, at pseudo-random places. A second solve without them
  /// measures how well `periods` predicts data; the field itself uses all. 0: no second solve.
  float hold_out = 0;
};

/// Statistics of a smoothed field and its data.
struct FieldSmoothingMetrics {
  std::size_t data = 0;    ///< vertices with a datum, of their own or of a triangle around them
  std::size_t filled = 0;  ///< vertices without a datum that got a direction
  /// Vertices with neighbours but without a direction: too far from all data.
  std::size_t unfilled = 0;
  // Degrees between the field and its data, weighted by their areas.
  double turned_mean_deg = 0;
  double turned_median_deg = 0;
  double turned_p95_deg = 0;               ///< 95 % are turned by less
  double turned_share_over_20deg = 0;      ///< 0 to 1
  std::size_t singularities_of_data = 0;   ///< singular triangles of the data, before smoothing
  std::size_t singularities = 0;           ///< after smoothing
  std::size_t singularities_too_many = 0;  ///< above the requested number: no pair cancels them
  // Mean coherence, weighted by area, of the vertices with a datum and of those filled.
  double coherence_mean = 0;
  double coherence_filled_mean = 0;
  /// With `FieldSmoothingOptions::hold_out`: hidden data where the second solve has a direction,
  /// and their mean angle to it.
  std::size_t held_out = 0;
  double held_out_turned_mean_deg = 0;
};

/// A smoothed field, one entry per vertex.
struct SmoothedField {
  DirectionField directions;     ///< unit tangent vectors; zero in unfilled holes
  std::vector<float> coherence;  ///< directional coherence of the data around a vertex, 0 to 1; 0
                                 ///< without a direction
  std::vector<std::uint8_t> filled;  ///< 1 for directions that fill a hole, else 0
};

/// Smooths measured fields on one surface, frame by frame; computes once what depends only on the
/// surface. With u = exp(i N theta), coupled by parallel transport, the field minimises
///
///     integral |grad u|^2 + c / l^2 |u - u0|^2,   l = P / (2 f),
///
/// in finite elements, with the data u0, their confidence c (0 in holes, which get the smoothest
/// filling) and the frequency f of the stripes. The decay of a screened field over the length l has
/// a root mean square distance of 2 l = P / f: P periods. A finer mesh gives the same field.
class FieldSmoothing {
 public:
  /// Throws Error for options out of range and for positions and normals that are not finite;
  /// Cancelled if `progress` cancels. Does not refer to `surface` afterwards.
  explicit FieldSmoothing(const Surface& surface, const FieldSmoothingOptions& options = {},
                          const Progress& progress = {});
  ~FieldSmoothing();
  FieldSmoothing(FieldSmoothing&&) noexcept;
  FieldSmoothing& operator=(FieldSmoothing&&) noexcept;

  /// `frequencies` are stripes per unit length, one per vertex; 0 means no wave and no direction.
  /// `last`, if any, is the previous field: one direction per vertex, weighted by `memory` and its
  /// confidence. Signs of lines and crosses follow their neighbours and, from the second frame on,
  /// the last frame. Throws Error for other numbers of entries, for confidences and frequencies
  /// that are negative or not finite, and without any datum; Cancelled if `progress` cancels.
  SmoothedField frame(const MeasuredField& measured, std::span<const float> frequencies,
                      const MeasuredField& last = {}, const Progress& progress = {});

  /// Statistics of the last frame. Throws Error before the first one.
  FieldSmoothingMetrics metrics() const;

 private:
  struct State;
  Pimpl<State> state_;
};

/// Options of `smoothed_frequencies`.
struct FrequencySmoothingOptions {
  float periods = 1;  ///< as in FieldSmoothingOptions
  float fill = 2;     ///< how far holes are filled from their border, in periods; 0: not at all
};

/// Smoothed frequencies.
struct SmoothedFrequencies {
  FrequencyField frequencies;  ///< one per vertex; NaN in unfilled holes
  std::size_t filled = 0;      ///< vertices that had none
  double changed_median = 0;   ///< median relative change of the data, by area
};

/// Smooths measured frequencies at the scale of their own stripes. Their logarithms are smoothed as
/// a FieldSmoothing smooths directions, first over periods of the data, then over the resulting
/// periods. `frequencies` are stripes per unit length, one per vertex: NaN in holes, 0 where there
/// is no wave, which stays so. Throws Error for options out of range, for other numbers of entries
/// and invalid frequencies, and if none is above 0; Cancelled if `progress` cancels.
SmoothedFrequencies smoothed_frequencies(const Surface& surface, std::span<const float> frequencies,
                                         const FrequencySmoothingOptions& options = {},
                                         const Progress& progress = {});

}  // namespace brindle
