/// Options of the solvers, the spacing tolerance and fabrication.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/pattern_of.h"
#include "brindle/spacing_tolerance.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"
#include "brindle/surface.h"
#include "input/preparation.h"
#include "input/used_files.h"

namespace brindle::tool {

void add_fabrication_options(CLI::App& app, FabricationOptions& options);

/// An integer, or a loop's name and an integer: "boundary-1:2". Throws CLI::ValidationError for
/// other text.
WantedWinding parse_winding(const std::string& option, const std::string& text);

/// Throws CLI::ValidationError for options that contradict each other or the solver.
void check_fabrication_options(const FabricationOptions& options, Solver solver);

/// Options of the spacing tolerance.
struct SlackOptions {
  float slack = 0;
  std::string branch_penalty;  ///< a file; empty: none

  /// Calls `add("--option", field)` for each option that sets a field.
  template <class Add>
  void visit(const Add& add) {
    add("--slack", slack);
    add("--avoid-branches", branch_penalty);
  }
};

/// Throws CLI::ValidationError for --avoid-branches without --slack.
void check_slack_options(const CLI::App& command, const SlackOptions& options);

/// Adds the file of --avoid-branches.
void add_slack_files(const SlackOptions& options, std::vector<UsedFile>& inputs);

/// Reads the file of --avoid-branches, if any: a number from 0 to 1 per row, in the only column or
/// in the one named avoid_branches. Rows are those of the vertices or, if there are as many as
/// `vertex_of_row` has, of the mesh's file; joined vertices take the largest. Throws Error with the
/// file, the line and the remedy.
Slack make_slack(const SlackOptions& options, std::size_t vertex_count,
                 std::span<const Index> vertex_of_row);

/// The same for a surface that may be split at creases.
Slack make_slack(const SlackOptions& options, const Surface& surface,
                 std::span<const Index> vertex_of_row);

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
