/// The crossing wave pattern V, for curves and samples.
#pragma once

#include <optional>
#include <span>
#include <string>

#include <CLI/CLI.hpp>

#include "brindle/windings.h"
#include "input/preparation.h"

namespace brindle::tool {

struct SecondWaveOptions {
  std::string field;               ///< a file; empty: U's field turned by 90 degrees
  std::optional<float> stripes;    ///< along the diagonal of the bounding box
  std::optional<float> frequency;  ///< stripes per unit length, instead of `stripes`
  WantedWinding wales;             ///< stripes around a loop, instead of both; 0: none

  /// Calls `add("--option", field)` for each option that sets a field.
  template <class Add>
  void visit(const Add& add) {
    add("--field-v", field);
    add("--stripes-v", stripes);
    add("--frequency-v", frequency);
  }
};

/// Whether V differs from U turned by 90 degrees.
inline bool is_other(const SecondWaveOptions& options) {
  return !options.field.empty() || options.stripes || options.frequency;
}

/// Sources of V besides its options, by reference.
struct FirstWaves {
  const Surface& surface;
  const WaveSet& waves;                 ///< U's
  const FrequencyField& frequencies_v;  ///< V's frequencies in U's file; empty: none
  std::span<const Index> vertex_of_row;
  std::optional<int> subdivided;  ///< as WaveReport has it
};

FirstWaves first_waves(const Preparation& prepared);

/// One wave per vertex, without phases. Frequencies are those of the options, V's file, V's columns
/// in U's file, or U's. V's file may have the rows of the mesh's file. Notes likely mistakes.
/// Throws Error if the file does not fit.
WaveSet make_second_waves(const FirstWaves& first, const SecondWaveOptions& options,
                          JobListener& listener);

}  // namespace brindle::tool
