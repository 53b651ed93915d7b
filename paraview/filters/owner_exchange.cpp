#include "owner_exchange.h"

#include <unordered_map>

namespace brindle::paraview {
namespace {

struct Mention {
  std::uint64_t number;
  std::uint64_t is_own;
};

/// The owner of every vertex, found by rank (number mod ranks).
std::vector<int> owners_of(const Ranks& ranks, std::span<const std::uint64_t> numbers,
                           std::span<const std::uint8_t> is_own) {
  const auto size = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<Mention>> mentions(size);
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    mentions[numbers[v] % size].push_back({numbers[v], is_own[v]});
  }
  const auto heard = ranks.swap_lists(mentions);
  std::unordered_map<std::uint64_t, int> owner;
  for (std::size_t r = 0; r < size; ++r) {
    for (const Mention& mention : heard[r]) {
      if (mention.is_own != 0) owner[mention.number] = static_cast<int>(r);
    }
  }
  std::vector<std::vector<int>> answers(size);
  for (std::size_t r = 0; r < size; ++r) {
    for (const Mention& mention : heard[r]) answers[r].push_back(owner.at(mention.number));
  }
  const auto answered = ranks.swap_lists(answers);
  std::vector<std::size_t> next(size);
  std::vector<int> result;
  for (const std::uint64_t number : numbers) {
    const std::size_t knows = number % size;
    result.push_back(answered[knows][next[knows]++]);
  }
  return result;
}

}  // namespace

OwnerExchange::OwnerExchange(const Ranks& ranks, std::span<const std::uint64_t> numbers,
                             std::span<const std::uint8_t> is_own)
    : ranks_(ranks), others_(static_cast<std::size_t>(ranks.size())) {
  const std::vector<int> owner = owners_of(ranks, numbers, is_own);
  std::vector<std::vector<std::uint64_t>> asked(others_.size());
  std::unordered_map<std::uint64_t, Index> own_vertex;
  for (Index v = 0; v < numbers.size(); ++v) {
    if (is_own[v] != 0) {
      own_vertex[numbers[v]] = v;
    } else {
      others_[static_cast<std::size_t>(owner[v])].push_back(v);
      asked[static_cast<std::size_t>(owner[v])].push_back(numbers[v]);
    }
  }
  for (const auto& list : ranks.swap_lists(asked)) {
    auto& vertices = own_.emplace_back();
    for (const std::uint64_t number : list) vertices.push_back(own_vertex.at(number));
  }
}

}  // namespace brindle::paraview
