/// Options of the solvers.
#pragma once

#include <CLI/CLI.hpp>

#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"
#include "input/preparation.h"
#include "input/slack_options.h"

namespace brindle::tool {

struct SolvingOptions {
  StripeOptions stripes;
  SlackOptions slack;
  int threads = 0;  ///< 0: all hardware threads
};

/// All options but --solver.
void add_solving_options(CLI::App& app, SolvingOptions& options);

/// The subset for frames: all but spacing tolerance and weights.
AnimatorOptions frame_options(const StripeOptions& stripes);

/// The options for this surface, including the spacing tolerance. Throws Error if the file of
/// --avoid-branches does not fit.
StripeOptions stripe_options(const SolvingOptions& options, const Preparation& prepared);

/// Throws CLI::ValidationError for options of solvers other than the chosen one.
void check_solving_options(const CLI::App& command, const SolvingOptions& options);

void add_solver_option(CLI::App& app, SolvingOptions& options);

}  // namespace brindle::tool
