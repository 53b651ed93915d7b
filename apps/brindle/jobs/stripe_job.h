/// What `brindle stripe` does, stage by stage, for whoever has its arguments.
#pragma once

#include <memory>
#include <optional>

#include "brindle/recipe/report.h"
#include "input/preparation.h"
#include "jobs/stripe_arguments.h"
#include "outputs/mesh_output.h"
#include "pictures/styled_output.h"

namespace brindle::tool {

/// What was made, and its report.
struct StripeJob {
  std::shared_ptr<const Surface> surface;  ///< that the result lies on: of crosses, a covering
  StripeResult result;
  Report report;
  InputData data;
  MakingFigures making = {};  ///< that the report has
};

/// What the smooth field of these stripes goes on from: the field of the previous pattern, which
/// `prepared` then keeps. Nothing if no pattern is followed. `arguments` must live as long.
FindLastDirections previous_directions(const StripeArguments& arguments);

/// Solves on the device that the arguments name, which is given back before anything is drawn.
/// Throws what solving throws, and Error for a previous pattern that does not fit.
StripeJob make_stripe_job(StripeArguments arguments, Preparation prepared,
                          std::optional<TextureTile> tile, const Progress& progress);

/// What a picture's style needs beside a job.
struct StyleJob {
  StyleInput input;
  StylePatterns patterns;
};

}  // namespace brindle::tool
