/// The wave pattern V that crosses U: for curves and samples.
#pragma once

#include <optional>
#include <span>
#include <string>

#include <CLI/CLI.hpp>

#include "brindle/pipeline/surface.h"
#include "brindle/waves/phase_graph.h"

namespace brindle::tool {

struct SecondWaveOptions {
  std::string field;               ///< a file; empty: U's field turned by 90 degrees
  std::optional<float> stripes;    ///< along the diagonal of the bounding box
  std::optional<float> frequency;  ///< stripes per unit length, instead of `stripes`
};

/// --field-v, --stripes-v and --frequency-v.
void add_second_wave_options(CLI::App& app, SecondWaveOptions& options);

/// One wave per vertex, without phases: with U's frequencies unless the options or the file name
/// others. Rows of the file may stand for those of the mesh's file (`Preparation`). Throws Error if
/// the file does not fit.
WaveSet make_second_waves(const Surface& surface, const WaveSet& first,
                          const SecondWaveOptions& options,
                          std::span<const Index> vertex_of_row = {});

}  // namespace brindle::tool
