/// `brindle stripe`: its arguments, and the stages that it shares with the window.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/recipe/report.h"
#include "device/device.h"
#include "input/carried_pattern.h"
#include "input/preparation.h"
#include "input/solving_options.h"
#include "outputs/mesh_output.h"
#include "outputs/outputs.h"
#include "pictures/style_options.h"
#include "pictures/styled_output.h"
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

/// A result and its report.
struct StripeJob {
  std::shared_ptr<const Surface> surface;  ///< of the result: for crosses, the double cover
  StripeResult result;
  Report report;
  InputData data;
  FabricationMetrics fabrication = {};  ///< of the report
};

/// Finds the field that this smooth field starts from: that of the previous pattern, which
/// `prepared` then keeps. Empty without a previous pattern. `arguments` must outlive the result.
FindLastDirections previous_directions(const StripeArguments& arguments);

/// Solves on the device of the arguments, which is released before drawing. Throws what solving
/// throws, and Error for a previous pattern that does not fit.
StripeJob make_stripe_job(StripeArguments arguments, Preparation prepared,
                          std::optional<TextureTile> tile, const Progress& progress);

/// The part of a picture's style that is solved for.
struct StyleJob {
  StyleInput input;
  StylePatterns patterns;
};

/// Writes a file of `brindle stripe`. Null: pictures have no style.
void write_stripes(const Output& output, const CLI::App& command, const StripeArguments& arguments,
                   const StripeJob& job, const StyleJob* styled, JobListener& listener);

}  // namespace brindle::tool
