/// Arguments of `brindle stripe`.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "device/device.h"
#include "input/carried_pattern.h"
#include "input/fabrication_options.h"
#include "outputs/outputs.h"
#include "pictures/style_options.h"
#include "pictures/texture_options.h"

namespace brindle::tool {

struct StripeArguments : JobArguments {
  FabricationOptions fabrication;
  DeviceKind device = DeviceKind::cpu;
  std::string previous;  ///< file of the pattern to continue; empty: none
  MatchOptions match;
  TextureChoice texture;
  StyleOptions style;
  bool uv = false;
};

void add_stripe_options(CLI::App& command, StripeArguments& arguments);

/// All input files.
std::vector<UsedFile> stripe_inputs(const StripeArguments& arguments);

/// Whether a texture or crosses are drawn instead of stripes.
bool has_tiles(const StripeArguments& arguments);

/// Throws CLI::ValidationError for options without effect on these outputs or beside other options.
/// Reads no files.
void check_stripe_options(const CLI::App& command, const StripeArguments& arguments,
                          const Outputs& outputs);

/// The same for options that point clouds do not support; reads the mesh's file if necessary.
void check_stripe_points(const CLI::App& command, const StripeArguments& arguments,
                         const Outputs& outputs);

/// All checks before a long job: outputs and options.
Outputs checked_outputs(const CLI::App& command, const StripeArguments& arguments);

}  // namespace brindle::tool
