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

/// The data of a field as they were read.
struct FieldData {
  DataArray array;            ///< vectors or tensors; no rows if the field is neither
  bool of_triangles = false;  ///< a row per triangle, not per vertex
};

/// Weights of a field's data.
struct FieldWeight {
  std::string word;  ///< "length" or "anisotropy", of the data themselves; or empty
  /// Otherwise one per vertex, or per triangle where the data are; not finite: no datum. Empty:
  /// tensors by their anisotropy, others alike.
  std::vector<float> values;
};

/// The data of a field with their weights, for `WaveInput::measured`; `directions` are those at
/// vertices. Throws Error for weights below zero, and for words that the data have no such thing
/// for.
MeasuredField measured_field(const FieldData& data, const DirectionField& directions,
                             const FieldWeight& weight);

/// Numbers of triangles, such as weights: those of their corners on average.
std::vector<float> corner_means(const Mesh& mesh, const std::vector<float>& of_vertices);

/// Vertices without a wave, by what a tensor's axis is to them.
struct MissingTensorWaves {
  std::size_t near_normal = 0;  ///< too near to the normal
  std::size_t isotropic = 0;    ///< not the only one with its eigenvalue
};

/// Vertices without a wave, by reasons that are known; each counts once.
struct MissingWaves {
  std::optional<MissingTensorWaves> tensor;      ///< of a field that is a tensor
  std::optional<std::size_t> without_frequency;  ///< of frequencies that are an array
  std::optional<std::size_t> too_far;            ///< of a field on another mesh
  /// Of a field whose holes were filled, whatever they came of: too far from its data.
  std::optional<std::size_t> unfilled = {};

  std::size_t total() const {
    const std::size_t holes = unfilled ? *unfilled
                              : tensor ? tensor->near_normal + tensor->isotropic
                                       : 0;
    return holes + without_frequency.value_or(0) + too_far.value_or(0);
  }
};

/// Figures of smoothed frequencies.
struct FrequencyDetailReport {
  double changed_median = 0;  ///< as DetailedFrequencies has it
  std::size_t filled = 0;     ///< the same
};

/// Options of waves.
struct WaveRequest {
  float turn_deg = 0;                                        ///< of waves against their field
  FieldDetailOptions detail = {.periods = 0};                ///< periods 0: the field as it is
  FrequencyDetailOptions frequency_detail = {.periods = 0};  ///< periods 0: as they are
};

/// A field and frequencies, with a row per vertex.
struct WaveInput {
  DirectionField directions;          ///< unit tangent vectors before they are turned; 0: no wave
  FrequencyField frequencies;         ///< stripes per unit length; not finite in gaps
  FrequencyField frequencies_v = {};  ///< of crossing stripes; empty: the same
  bool may_have_gaps = false;         ///< a vertex without a frequency then has no wave
  /// Whether a vertex is near enough to what the field was taken from; empty: all are.
  std::function<bool(Index)> is_near = {};
  MeasuredField measured = {};  ///< what the field was made of, if it is to be seen at detail
  DirectionField last = {};     ///< of the step before, which counts beside the data; or empty
  MissingWaves missing = {};    ///< reasons that are known so far
};

/// Waves without phases.
struct WaveResult {
  WaveSet waves;                 ///< one wave per vertex
  FrequencyField frequencies_v;  ///< as WaveInput has them
  MissingWaves missing;
  std::optional<FieldDetailFigures> detail = {};  ///< of a field seen at detail
  std::optional<FrequencyDetailReport> frequency_detail = {};
  std::vector<float> agreement = {};  ///< of its data: one per vertex; empty without detail
  DirectionField seen_field = {};     ///< at detail, before it was turned; empty without detail
};

/// The surface that waves are on: of one process, or a piece of one that many processes share,
/// whose functions are collective then.
class WaveSurface {
 public:
  virtual ~WaveSurface() = default;
  virtual std::vector<Vec3> positions() const = 0;
  virtual std::span<const Vec3> normals() const = 0;
  /// Whether `here` is true on any process.
  virtual bool any(bool here) const = 0;
  /// `drop_waves_without_frequency` of array_field.h for the whole surface.
  virtual std::size_t drop_waves(DirectionField& directions, FrequencyField& frequencies) const = 0;
  /// As `detailed_frequencies` of measured_field.h.
  virtual DetailedFrequencies frequencies_at_detail(std::span<const float> frequencies,
                                                    const FrequencyDetailOptions& options,
                                                    const Progress& progress) const = 0;
  /// A frame of a `FieldDetail`; `places` are frequencies, and 0 where there is no wave.
  virtual std::pair<DetailedField, FieldDetailFigures> field_at_detail(
      const MeasuredField& measured, std::span<const float> places, const DirectionField& last,
      const FieldDetailOptions& options, const Progress& progress) const = 0;
};

/// The surface of one process.
class WholeSurface final : public WaveSurface {
 public:
  /// Refers to the surface.
  explicit WholeSurface(const Surface& surface) : surface_(surface) {}

  std::vector<Vec3> positions() const override { return surface_.mesh.positions; }
  std::span<const Vec3> normals() const override { return surface_.normals; }
  bool any(bool here) const override { return here; }
  std::size_t drop_waves(DirectionField& directions, FrequencyField& frequencies) const override;
  DetailedFrequencies frequencies_at_detail(std::span<const float> frequencies,
                                            const FrequencyDetailOptions& options,
                                            const Progress& progress) const override;
  std::pair<DetailedField, FieldDetailFigures> field_at_detail(
      const MeasuredField& measured, std::span<const float> places, const DirectionField& last,
      const FieldDetailOptions& options, const Progress& progress) const override;

 private:
  const Surface& surface_;
};

/// The same waves turned by 90 degrees about the normals: those of V beside U, of strokes that
/// cross. `frequencies` are theirs; empty: those of `waves`.
WaveSet waves_across(const WaveSet& waves, std::span<const Vec3> normals,
                     std::span<const float> frequencies = {});

/// Smooths the frequencies, drops waves without a frequency, smooths the field with those
/// frequencies, and turns it. Throws the errors of these steps.
WaveResult waves_of(const WaveSurface& surface, const WaveRequest& request, WaveInput found,
                    const Progress& progress = {});

}  // namespace brindle
