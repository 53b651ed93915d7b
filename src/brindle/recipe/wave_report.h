/// How dense waves are on their surface, and where there are none, in the words of options.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "brindle/measured_field.h"
#include "brindle/wave_figures.h"
#include "brindle/waves_of.h"

namespace brindle {

/// Those that are too far from all data of a field whose holes were filled, and not without a wave
/// for another reason that `missing` knows.
std::size_t unfilled_alone(const FieldDetailFigures& detail, const MissingWaves& missing);

/// The library's figures, and why waves are missing.
struct WaveReport : WaveFigures {
  MissingWaves missing;
  bool measured = false;                          ///< the field may have noise
  std::optional<FieldDetailFigures> detail = {};  ///< of one seen at the scale of its stripes
  std::optional<FrequencyDetailReport> frequency_detail = {};  ///< of frequencies seen so
};

/// What options are called, for waves that come from `source`: "the field 'wind.csv'".
WarningWords words_of_options(const std::string& source);

/// Throws Error if there is no wave at all, or waves are too fine for any number; `source` says
/// where the waves come from: "the field 'wind.csv'".
void check_wave_report(const WaveReport& figures, const std::string& source);

/// Lines for people: where waves are missing for a reason that is known; and what is probably not
/// meant: waves missing for another reason at more than a vertex in a hundred, stripes too fine for
/// the mesh. Empty if there is nothing to say.
std::string warnings(const WaveReport& figures, const std::string& source);

/// The same of more branches than a triangle in ten, unless stripes are too fine anyway; and of a
/// measured field, taken as it is, that turns round more than a triangle in a hundred.
std::string branch_warning(const WaveReport& figures, std::size_t branches,
                           std::size_t field_singularities, std::size_t triangles);

}  // namespace brindle
