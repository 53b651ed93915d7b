#include "piece_slack.h"

#include <string>
#include <vector>

#include "brindle/error.h"

namespace brindle::tool {
namespace {

/// On rank 0: what the rows say of the vertices that each rank asked for.
std::vector<std::vector<float>> answers_of(const std::vector<float>& calm, const std::string& path,
                                           const std::vector<std::vector<std::uint64_t>>& asked) {
  std::vector<std::vector<float>> answers;
  for (const auto& ids : asked) {
    std::vector<float>& answer = answers.emplace_back();
    for (const std::uint64_t id : ids) {
      if (id >= calm.size()) {
        throw Error("'" + path + "' has " + std::to_string(calm.size()) +
                    " rows, but a vertex of the pieces has the number " + std::to_string(id) +
                    "; number them from 0 on, without gaps");
      }
      answer.push_back(calm[id]);
    }
  }
  return answers;
}

}  // namespace

Slack piece_slack(Communicator& ranks, const SlackOptions& options, const ReadPiece& read,
                  std::size_t vertices_of_all) {
  Slack slack = options.slack;
  if (options.calm.empty()) return slack;
  const auto size = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<std::uint64_t>> ids(size);
  ids[0] = read.piece.vertex_ids;
  const auto asked = ranks.swap_lists(ids);
  std::vector<std::vector<float>> answers(size);
  ranks.together([&] {
    if (ranks.rank() != 0) return;
    const Slack whole = make_slack(options, vertices_of_all, read.vertex_of_row);
    answers = answers_of(whole.calm, options.calm, asked);
  });
  slack.calm = ranks.swap_lists(answers)[0];
  return slack;
}

}  // namespace brindle::tool
