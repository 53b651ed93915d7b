/// The stages of `brindle stripe`, shared with the window.
#pragma once

#include <memory>
#include <optional>

#include "brindle/recipe/report.h"
#include "input/preparation.h"
#include "jobs/stripe_arguments.h"
#include "outputs/mesh_output.h"
#include "pictures/styled_output.h"

namespace brindle::tool {

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
