/// Figures and warnings of waves, in the words of options.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "brindle/carried_field.h"
#include "brindle/measured_field.h"
#include "brindle/quality.h"
#include "brindle/wave_figures.h"
#include "brindle/waves_of.h"

namespace brindle {

/// Vertices without a wave because they are too far from all data of a field whose holes were
/// filled, and for no other reason in `missing`.
std::size_t unfilled_alone(const FieldDetailFigures& detail, const MissingWaves& missing);

/// The library's figures, and why waves are missing.
struct WaveReport : WaveFigures {
  MissingWaves missing;
  bool measured = false;                          ///< the field may have noise
  std::optional<int> subdivided = 0;              ///< times so far; nothing: points cannot be
  std::optional<FieldDetailFigures> detail = {};  ///< of one seen at the scale of its stripes
  std::optional<FrequencyDetailReport> frequency_detail = {};  ///< of frequencies seen so
};

/// Figures of a run before its stripes.
struct PreparationFigures {
  WaveReport figures;                               ///< of the waves
  std::optional<std::size_t> field_rows_nonfinite;  ///< of a field file or array
  std::optional<FieldStep> field_step;  ///< of a smooth field that went on from a last one
  float turn_deg = 0;                   ///< by which waves are turned from their field
  std::vector<float> agreement;         ///< of a measured field's data, per vertex; mostly empty
  std::size_t vertices_joined = 0;      ///< with others at their place
  double load_milliseconds = 0;         ///< reading or making the mesh
  double field_milliseconds = 0;        ///< directions and frequencies
  double topology_milliseconds = 0;     ///< neighbourhood and normals
};

/// The names of options for the library's warnings; `source` is "the field 'wind.csv'".
WarningWords words_of_options(const std::string& source, std::optional<int> subdivided = 0);

/// Throws Error if there is no wave at all, or waves are too fine for any number.
void check_wave_report(const WaveReport& figures, const std::string& source);

/// Lines for people on waves that are missing for a known reason, and warnings: waves missing for
/// another reason at more than a vertex in a hundred, stripes too fine for the mesh. May be empty.
std::string warnings(const WaveReport& figures, const std::string& source);

/// `quality_warnings`; and those of noise, of a measured field without smoothing.
std::string quality_warning(const WaveReport& figures, const PatternQuality& quality,
                            std::size_t triangles);

}  // namespace brindle
