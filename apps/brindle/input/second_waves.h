/// The wave pattern V that crosses U: for curves and samples.
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
  WantedWinding wales;             ///< stripes round a loop, instead of both; 0: none

  /// Calls `add("--option", field)` for the options that set a field.
  template <class Add>
  void visit(const Add& add) {
    add("--field-v", field);
    add("--stripes-v", stripes);
    add("--frequency-v", frequency);
  }
};

/// Whether V is more than U turned by 90 degrees.
inline bool is_other(const SecondWaveOptions& options) {
  return !options.field.empty() || options.stripes || options.frequency;
}

/// What V is made of beside its options; all of it lives elsewhere.
struct FirstWaves {
  const Surface& surface;
  const WaveSet& waves;                 ///< U's
  const FrequencyField& frequencies_v;  ///< that U's file has of V; empty: none
  std::span<const Index> vertex_of_row;
  std::optional<int> subdivided;  ///< as WaveReport has it
};

FirstWaves first_waves(const Preparation& prepared);

/// One wave per vertex, without phases. Its frequencies are those of the options, or of the file
/// for V, or what U's file says of V, or U's. Rows of the file may stand for those of the mesh's
/// file. Notes what is probably not meant. Throws Error if the file does not fit.
WaveSet make_second_waves(const FirstWaves& first, const SecondWaveOptions& options,
                          JobListener& listener);

}  // namespace brindle::tool
