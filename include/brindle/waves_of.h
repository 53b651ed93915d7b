/// Waves of a field and frequencies, in the same steps for every program. Experimental: fields may
/// still be added.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/direction_field.h"
#include "brindle/export.h"
#include "brindle/frequency_field.h"
#include "brindle/measured_field.h"
#include "brindle/mesh.h"
#include "brindle/phase_graph.h"
#include "brindle/progress.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// The data of a field, as read.
struct FieldData {
  DataArray array;            ///< vectors or tensors; no rows if the field is neither
  bool of_triangles = false;  ///< a row per triangle, not per vertex
};

/// Weights of a field's data.
struct FieldWeight {
  std::string word;  ///< "length" or "anisotropy", of the data themselves; or empty
  /// Otherwise one per vertex or, as the data, per triangle; not finite: no datum. Empty: tensors
  /// by their anisotropy, others alike.
  std::vector<float> values;
};

/// The data of a field with their weights, for `WaveInput::measured`; `directions` are those at
/// vertices. Throws Error for weights below zero, and for words that do not apply to the data.
MeasuredField measured_field(const FieldData& data, const DirectionField& directions,
                             const FieldWeight& weight);

/// One number per triangle, such as a weight: the mean of its corners' numbers.
std::vector<float> corner_means(const Mesh& mesh, const std::vector<float>& of_vertices);

/// Vertices without a wave in tensor fields, by the reason.
struct MissingTensorWaves {
  std::size_t near_normal = 0;  ///< the axis is too near to the normal
  std::size_t isotropic = 0;    ///< several axes share the eigenvalue
};

/// Vertices without a wave, by known reason; each counts once.
struct MissingWaves {
  std::optional<MissingTensorWaves> tensor;      ///< in tensor fields
  std::optional<std::size_t> without_frequency;  ///< with frequencies from an array
  std::optional<std::size_t> too_far;            ///< in fields from another mesh
  /// In fields with filled holes, whatever their cause: too far from the data.
  std::optional<std::size_t> unfilled = {};

  std::size_t total() const {
    const std::size_t holes = unfilled ? *unfilled
                              : tensor ? tensor->near_normal + tensor->isotropic
                                       : 0;
    return holes + without_frequency.value_or(0) + too_far.value_or(0);
  }
};

/// Metrics of smoothed frequencies.
struct FrequencySmoothingReport {
  double changed_median = 0;  ///< as in SmoothedFrequencies
  std::size_t filled = 0;     ///< as in SmoothedFrequencies
};

/// Options of waves.
struct WaveRequest {
  float turn_deg = 0;                                              ///< of waves against their field
  FieldSmoothingOptions smoothing = {.periods = 0};                ///< periods 0: no smoothing
  FrequencySmoothingOptions frequency_smoothing = {.periods = 0};  ///< periods 0: no smoothing
};

/// A field and frequencies, with a row per vertex.
struct WaveInput {
  DirectionField directions;          ///< unit tangent vectors before they are turned; 0: no wave
  FrequencyField frequencies;         ///< stripes per unit length; not finite in gaps
  FrequencyField frequencies_v = {};  ///< of V; empty: the same
  bool may_have_gaps = false;         ///< a vertex without a frequency then has no wave
  /// Whether a vertex is near enough to the source of the field; empty: all are.
  std::function<bool(Index)> is_near = {};
  MeasuredField measured = {};  ///< the field's data, if it is to be smoothed
  DirectionField last = {};     ///< of the previous step, for temporal smoothing; or empty
  MissingWaves missing = {};    ///< known so far
};

/// What smoothed waves rest on, one entry per vertex.
struct FieldSupport {
  std::vector<float> coherence;  ///< `SmoothedField::coherence`; empty without a smoothed field
  /// 1 where the direction or the frequency fills a hole, else 0; empty without smoothing.
  std::vector<float> filled;
};

/// Waves without phases.
struct WaveResult {
  WaveSet waves;                 ///< one wave per vertex
  FrequencyField frequencies_v;  ///< as in WaveInput
  MissingWaves missing;
  /// Edges whose ends the turn rotates in opposite senses, as their normals point to opposite sides
  /// of the surface. 0 for turns that give the same waves in both senses.
  std::size_t turned_apart = 0;
  std::optional<FieldSmoothingMetrics> smoothing = {};  ///< of a smoothed field
  std::optional<FrequencySmoothingReport> frequency_smoothing = {};
  FieldSupport support = {};  ///< of smoothed fields and frequencies
  /// The smoothed field before it is turned; empty without smoothing.
  DirectionField seen_field = {};
};

/// The surface of waves: of one process, or a partition of one that several processes share.
/// Functions of a partition are collective.
class WaveSurface {
 public:
  virtual ~WaveSurface() = default;
  virtual std::vector<Vec3> positions() const = 0;
  virtual std::span<const Vec3> normals() const = 0;
  /// Whether `here` is true on any process.
  virtual bool any(bool here) const = 0;
  /// Edges between normals that point to opposite sides (`count_opposite_edges`).
  virtual std::size_t opposite_edges() const = 0;
  /// `drop_waves_without_frequency` of array_field.h for the whole surface.
  virtual std::size_t drop_waves(DirectionField& directions, FrequencyField& frequencies) const = 0;
  /// As `smoothed_frequencies` of measured_field.h.
  virtual SmoothedFrequencies smooth_frequencies(std::span<const float> frequencies,
                                                 const FrequencySmoothingOptions& options,
                                                 const Progress& progress) const = 0;
  /// A frame of a `FieldSmoothing`; `places` are frequencies, 0 where there is no wave.
  virtual std::pair<SmoothedField, FieldSmoothingMetrics> smooth_field(
      const MeasuredField& measured, std::span<const float> places, const DirectionField& last,
      const FieldSmoothingOptions& options, const Progress& progress) const = 0;
};

/// The surface of one process.
class WholeSurface final : public WaveSurface {
 public:
  /// Keeps a reference to the surface.
  explicit WholeSurface(const Surface& surface) : surface_(surface) {}

  std::vector<Vec3> positions() const override { return surface_.mesh.positions; }
  std::span<const Vec3> normals() const override { return surface_.normals; }
  bool any(bool here) const override { return here; }
  std::size_t opposite_edges() const override;
  std::size_t drop_waves(DirectionField& directions, FrequencyField& frequencies) const override;
  SmoothedFrequencies smooth_frequencies(std::span<const float> frequencies,
                                         const FrequencySmoothingOptions& options,
                                         const Progress& progress) const override;
  std::pair<SmoothedField, FieldSmoothingMetrics> smooth_field(
      const MeasuredField& measured, std::span<const float> places, const DirectionField& last,
      const FieldSmoothingOptions& options, const Progress& progress) const override;

 private:
  const Surface& surface_;
};

/// The waves turned by 90 degrees about the normals: V beside U, or cross-hatching. `frequencies`
/// are theirs; empty: those of `waves`.
WaveSet waves_across(const WaveSet& waves, std::span<const Vec3> normals,
                     std::span<const float> frequencies = {});

/// Smooths the frequencies, drops waves without a frequency, smooths the field with those
/// frequencies, and turns it. Throws the errors of these steps.
WaveResult waves_of(const WaveSurface& surface, const WaveRequest& request, WaveInput found,
                    const Progress& progress = {});

}  // namespace brindle
