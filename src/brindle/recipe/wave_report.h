/// Metrics and warnings of waves, in terms of options.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "brindle/broken_tiles.h"
#include "brindle/carried_phases.h"
#include "brindle/measured_field.h"
#include "brindle/quality.h"
#include "brindle/wave_metrics.h"
#include "brindle/waves_of.h"

namespace brindle {

/// Vertices without a wave only because they are too far from all data of a field with filled
/// holes, not for a reason in `missing`.
std::size_t unfilled_alone(const FieldSmoothingMetrics& smoothing, const MissingWaves& missing);

/// The library's metrics, and reasons for missing waves.
struct WaveReport : WaveMetrics {
  MissingWaves missing;
  std::size_t turned_apart = 0;                         ///< as in WaveResult
  bool measured = false;                                ///< the field may be noisy
  std::optional<int> subdivided = 0;                    ///< times so far; nullopt: points cannot be
  std::optional<FieldSmoothingMetrics> smoothing = {};  ///< of a smoothed field
  std::optional<FrequencySmoothingReport> frequency_smoothing = {};  ///< of smoothed frequencies
};

/// Metrics of waves and of their field.
struct FieldMetrics {
  WaveReport metrics;                               ///< of the waves
  std::optional<std::size_t> field_rows_nonfinite;  ///< of a field file or array
  std::optional<FieldStep> field_step;  ///< of a smooth field that continued a previous one
  float turn_deg = 0;                   ///< rotation of the waves from their field
  FieldSupport support;                 ///< of smoothed waves
  double field_milliseconds = 0;        ///< directions and frequencies
};

/// Metrics of a run before its stripes are solved.
struct PreparationMetrics : FieldMetrics {
  std::size_t vertices_joined = 0;   ///< with others at their position
  double load_milliseconds = 0;      ///< reading or making the mesh
  double topology_milliseconds = 0;  ///< neighbourhood and normals
};

/// Option names for the library's warnings; `source` is "the field 'wind.csv'".
WarningWords words_of_options(const std::string& source, std::optional<int> subdivided = 0);

/// Throws Error if there is no wave at all, or waves are too fine for any number.
void check_wave_report(const WaveReport& metrics, const std::string& source);

/// Lines of text on waves that are missing for a known reason, and warnings: waves missing for
/// other reasons at over 1 % of the vertices, and those of turned and smoothed fields. May be
/// empty.
std::string warnings(const WaveReport& metrics, const std::string& source);

/// `tile_warnings`.
std::string tile_warning(const BrokenTiles& broken, std::size_t triangles);

/// `quality_warnings`; and those of noise, for a measured field without smoothing.
std::string quality_warning(const WaveReport& metrics, const PatternQuality& quality,
                            std::size_t triangles);

}  // namespace brindle
