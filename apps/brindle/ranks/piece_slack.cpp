#include "ranks/piece_slack.h"

#include <vector>

#include "brindle/base/array_numbers.h"
#include "ranks/piece_rows.h"

namespace brindle::tool {
Slack piece_slack(Communicator& ranks, const SlackOptions& options, const ReadPiece& read,
                  std::size_t vertices_of_all) {
  Slack slack = options.slack;
  if (options.branch_penalty.empty()) return slack;
  const auto rows = piece_rows(ranks, read, "--avoid-branches", options.branch_penalty, [&] {
    const Slack whole = make_slack(options, vertices_of_all, read.vertex_of_row);
    return std::vector<DataArray>{make_data_array("avoid_branches", 1, whole.branch_penalty)};
  });
  for_each_number(rows[0].view(), [&](std::size_t, std::size_t, auto branch_penalty) {
    slack.branch_penalty.push_back(static_cast<float>(branch_penalty));
  });
  return slack;
}

}  // namespace brindle::tool
