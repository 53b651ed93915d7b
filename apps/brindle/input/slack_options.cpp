#include "input/slack_options.h"

#include "brindle/files.h"
#include "cli/command_line.h"

namespace brindle::tool {

void check_slack_options(const CLI::App& command, const SlackOptions& options) {
  refuse_usage(command,
               [&](const IsGiven& given) { check_avoid_branches(given, options.slack > 0); });
}

void add_slack_files(const SlackOptions& options, std::vector<UsedFile>& inputs) {
  if (!options.branch_penalty.empty())
    inputs.push_back({"--avoid-branches", options.branch_penalty});
}

Slack make_slack(const SlackOptions& options, std::size_t vertex_count,
                 std::span<const Index> vertex_of_row) {
  Slack slack = options.slack;
  if (!options.branch_penalty.empty()) {
    slack.branch_penalty =
        read_branch_penalty_csv(options.branch_penalty, vertex_count, vertex_of_row);
  }
  return slack;
}

Slack make_slack(const SlackOptions& options, const Surface& surface,
                 std::span<const Index> vertex_of_row) {
  Slack slack = make_slack(options, surface.own_vertex_count(), vertex_of_row);
  add_rows_of_copies(surface.creases, slack.branch_penalty);
  return slack;
}

}  // namespace brindle::tool
