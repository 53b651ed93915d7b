/// What `brindle stripe` is asked for.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "input/carried_pattern.h"
#include "input/device.h"
#include "input/making_options.h"
#include "input/solving_options.h"
#include "input/surface_options.h"
#include "input/used_files.h"
#include "input/wave_options.h"
#include "outputs/outputs.h"
#include "pictures/picture.h"
#include "pictures/style_options.h"
#include "pictures/texture_options.h"

namespace brindle::tool {

struct StripeArguments {
  SurfaceOptions surface;
  WaveOptions waves;
  SolvingOptions solving;
  MakingOptions making;
  DeviceKind device = DeviceKind::cpu;
  std::string previous;  ///< file of the pattern to stay near to; empty: none
  MatchOptions match;
  TextureChoice texture;
  std::shared_ptr<PictureOptions> picture;
  StyleOptions style;
  bool uv = false;
  std::vector<std::string> outputs;
  std::string report;
  bool quiet = false;
};

void add_stripe_options(CLI::App& command, StripeArguments& arguments);

/// All files that are read.
std::vector<UsedFile> stripe_inputs(const StripeArguments& arguments);

/// Whether a texture is drawn, or crosses, rather than stripes.
bool has_tiles(const StripeArguments& arguments);

/// Whether one of the pictures has a style.
bool has_style(const CLI::App& command, const std::vector<Output>& outputs);

/// Throws CLI::ValidationError for options that have no effect on these outputs, or leave each
/// other without one. Reads no files.
void check_stripe_options(const CLI::App& command, const StripeArguments& arguments,
                          const std::vector<Output>& outputs);

/// The same for what points cannot have, if the mesh's file holds nothing else, which is read for
/// that.
void check_stripe_points(const CLI::App& command, const StripeArguments& arguments,
                         const std::vector<Output>& outputs);

/// Everything that can be said before a long job: the outputs, and both checks.
std::vector<Output> checked_outputs(const CLI::App& command, const StripeArguments& arguments);

}  // namespace brindle::tool
