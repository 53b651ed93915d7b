#include "brindle/distributed/surface/shared_vertices.h"

#include <algorithm>
#include <tuple>

namespace brindle {
namespace {

struct Mention {
  std::uint64_t id;
  std::uint64_t unused;  // 0 where a triangle uses it: those go first
};

}  // namespace

std::vector<int> find_owners(Communicator& ranks, std::span<const std::uint64_t> ids,
                             std::span<const std::uint8_t> used) {
  const auto size = static_cast<std::size_t>(ranks.size());
  if (size == 1) return std::vector<int>(ids.size(), 0);
  std::vector<std::vector<Mention>> mentions(size);
  for (std::size_t v = 0; v < ids.size(); ++v) {
    mentions[ids[v] % size].push_back({ids[v], used[v] ? 0u : 1u});
  }
  const auto asked = ranks.swap_lists(mentions);

  std::vector<std::tuple<std::uint64_t, std::uint64_t, int>> known;
  for (std::size_t r = 0; r < size; ++r) {
    for (const auto& [id, unused] : asked[r]) known.emplace_back(id, unused, static_cast<int>(r));
  }
  std::ranges::sort(known);
  std::vector<std::vector<int>> answers(size);
  for (std::size_t r = 0; r < size; ++r) {
    for (const Mention& mention : asked[r]) {
      const auto first = std::ranges::lower_bound(known, std::tuple(mention.id, 0ul, 0));
      answers[r].push_back(std::get<2>(*first));
    }
  }
  const auto owners = ranks.swap_lists(answers);

  std::vector<std::size_t> next(size);
  std::vector<int> owner;
  for (const std::uint64_t id : ids) owner.push_back(owners[id % size][next[id % size]++]);
  return owner;
}

}  // namespace brindle
