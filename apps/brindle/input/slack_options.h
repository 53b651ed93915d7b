/// Options of the spacing tolerance.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/spacing_tolerance.h"
#include "brindle/surface.h"
#include "input/used_files.h"

namespace brindle::tool {

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

}  // namespace brindle::tool
