/// Patterns and their inputs.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include "brindle/branch_pairs.h"
#include "brindle/cross_texture.h"
#include "brindle/curves.h"
#include "brindle/recipe/field_data.h"
#include "brindle/recipe/report.h"
#include "brindle/recipe/wave_report.h"
#include "brindle/stripe_pattern.h"
#include "brindle/texture_pattern.h"
#include "brindle/windings.h"
#include "surface_data.h"

namespace brindle::python {

/// Options of solving.
struct Solving {
  StripeOptions stripes;
  int threads = 0;
  brindle::FabricationOptions fabrication;
};

/// A number or an array of one per vertex, and where branches are unwelcome; None for nothing.
Slack slack_of(py::handle slack, py::handle branch_penalty, const Mesh& mesh);

/// A dict, or None without cancelled branch pairs.
pybind11::object cancelled_branches_of(const std::optional<brindle::CancelledBranches>& merged);

/// Shared by Python objects; immutable.
struct StripesData {
  SurfacePointer surface;
  StripePattern pattern;
  brindle::PreparationMetrics prepared;
  Solver solver = Solver::multilevel;
  int threads = 0;  ///< threads used
  std::optional<brindle::FollowedReport> followed;
  brindle::FabricationMetrics fabrication;
};
using StripesPointer = std::shared_ptr<StripesData>;

StripesPointer stripes_data(const SurfacePointer& surface, StripePattern&& pattern,
                            const brindle::PreparationMetrics& prepared, Solver solver);

/// Texture coordinates along two stripe patterns, or along the waves of a cross field.
struct TextureData {
  SurfacePointer surface;  ///< of the corners
  StripesPointer u, v;     ///< for a cross field: its waves as far as they can be separated
  StripesPointer cover;    ///< for a cross field: both waves, on its double cover
  TextureWaves waves;
  PhaseShiftKind phase_shift = PhaseShiftKind::aligned;
  std::vector<Index> triangle_origins;  ///< for a cross field: in the given surface
  std::vector<Index> singular;          ///< for a cross field: triangles of the given surface
  brindle::WaveReport metrics;
  brindle::PatternQuality quality;  ///< for warnings
  std::optional<brindle::CancelledBranches> cancelled_branches;
  nlohmann::ordered_json report;  ///< without the invocation

  bool is_cross() const { return cover != nullptr; }
};
using TexturePointer = std::shared_ptr<TextureData>;

/// Centre lines of stripes.
struct CurvesData {
  SurfacePointer surface;
  StripeCurves curves;
  std::array<std::size_t, kCurveEndKinds> ends{};  ///< before short curves were left out
  std::size_t short_curves = 0;                    ///< number left out
  std::size_t jogs = 0;                            ///< edges at which moved curves have a jog
  std::optional<StripeCurves> traced;              ///< all, if some were left out or reshaped
  std::optional<Polylines> unshaped;               ///< the remaining ones, if they were reshaped

  static constexpr int kMembers = 7;
};
using CurvesPointer = std::shared_ptr<CurvesData>;

/// Waves from arrays.
struct WavesIn {
  WaveSet waves;
  brindle::PreparationMetrics prepared;
};

/// The origin of waves, for messages, and properties of their array.
struct FieldOrigin {
  std::string source;  ///< "the array 'velocity'"
  std::optional<std::size_t> rows_nonfinite;
  std::optional<std::pair<std::size_t, std::size_t>> tensor;  ///< near the normal, isotropic
  double milliseconds = 0;                                    ///< time of making the field
  float turn_deg = 0;                      ///< turn of the waves from their field
  std::optional<double> field_turned_deg;  ///< of a smooth field that continues the last one
  bool measured = false;                   ///< given by the caller
  /// Smoothing of the field; 0: none. `turn_deg` is then applied later.
  brindle::FieldSmoothingOptions smoothing = {.periods = 0};
  /// Smoothing of frequencies from arrays.
  brindle::FrequencySmoothingOptions frequency_smoothing = {.periods = 0};
  brindle::FieldData data = {};
  brindle::FieldWeight weight = {};
};

/// `directions` have a row per vertex (`DirectionsIn`). One of `stripes` and `frequency`, a number
/// or one per vertex where not finite means no wave, is given. Where `phases`, if there are any,
/// are 0, there is no wave. Throws Error, as the tool does, if there is no wave at all.
WavesIn waves_of_arrays(const SurfaceData& surface, py::handle directions, py::handle stripes,
                        py::handle frequency, const FieldOrigin& origin,
                        std::span<const Complex> phases = {});

/// Frequencies of an array at the scale that the origin asks for, those that are not finite filled.
brindle::SmoothedFrequencies seen_frequencies(const Surface& surface, FrequencyField frequencies,
                                              const FieldOrigin& origin);

void bind_solving(py::module_& module);
void bind_patterns(py::module_& module);
void bind_textures(py::module_& module);
void bind_curves(py::module_& module);
void bind_paths(py::module_& module);
void bind_animators(py::module_& module);
void bind_field_animators(py::module_& module);
void bind_pattern_frames(py::module_& module);
void bind_loops(py::module_& module);
void bind_files(py::module_& module);
void bind_pictures(py::module_& module);

}  // namespace brindle::python
