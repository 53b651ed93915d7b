// What stands in for std::ranges where the library has none, compared with it.
#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <ranges>
#include <vector>
#include <version>

#include <gtest/gtest.h>

#undef __cpp_lib_ranges
#include "brindle/base/standard.h"

namespace brindle {
namespace {

struct Item {
  int key;
  int number;
  bool operator==(const Item&) const = default;
};

std::vector<Item> items() {
  std::vector<Item> list;
  for (int i = 0; i < 200; ++i) list.push_back({(i * 37) % 23, i});
  return list;
}

TEST(Ranges, SortAsTheLibraryDoes) {
  std::vector<Item> ours = items(), theirs = ours;
  ranges::stable_sort(ours, {}, &Item::key);
  std::ranges::stable_sort(theirs, {}, &Item::key);
  EXPECT_EQ(ours, theirs);
  ranges::sort(ours, std::greater<>(), &Item::number);
  std::ranges::sort(theirs, std::greater<>(), &Item::number);
  EXPECT_EQ(ours, theirs);
  ranges::reverse(ours);
  std::ranges::reverse(theirs);
  EXPECT_EQ(ours, theirs);
}

TEST(Ranges, FindAndCountAsTheLibraryDoes) {
  std::vector<Item> list = items();
  const auto odd = [](int key) { return key % 2 == 1; };
  EXPECT_EQ(ranges::find(list, 22, &Item::key), std::ranges::find(list, 22, &Item::key));
  EXPECT_EQ(ranges::find(list, 99, &Item::key), list.end());
  EXPECT_EQ(ranges::find_if(list, odd, &Item::key), std::ranges::find_if(list, odd, &Item::key));
  EXPECT_EQ(ranges::count(list, 5, &Item::key), std::ranges::count(list, 5, &Item::key));
  EXPECT_EQ(ranges::count_if(list, odd, &Item::key), std::ranges::count_if(list, odd, &Item::key));
  EXPECT_EQ(ranges::max_element(list, {}, &Item::key),
            std::ranges::max_element(list, {}, &Item::key));
  EXPECT_TRUE(ranges::any_of(list, odd, &Item::key));
  EXPECT_FALSE(ranges::all_of(list, odd, &Item::key));
  EXPECT_FALSE(ranges::none_of(list, odd, &Item::key));
  ranges::sort(list, {}, &Item::key);
  EXPECT_EQ(ranges::lower_bound(list, 7, {}, &Item::key),
            std::ranges::lower_bound(list, 7, {}, &Item::key));
  const std::array<int, 4> sorted{1, 3, 5, 7};
  EXPECT_TRUE(ranges::binary_search(sorted, 5));
  EXPECT_FALSE(ranges::binary_search(sorted, 4));
}

TEST(Ranges, ChangeAsTheLibraryDoes) {
  const std::vector<int> from{1, 2, 3, 2, 1};
  std::vector<int> ours = from, theirs = from;
  ranges::replace(ours, 2, 7);
  std::ranges::replace(theirs, 2, 7);
  EXPECT_EQ(ours, theirs);
  ranges::transform(from, ours.begin(), std::negate<>());
  std::ranges::transform(from, theirs.begin(), std::negate<>());
  EXPECT_EQ(ours, theirs);
  const std::vector<int> shorter{10, 20, 30};
  ranges::transform(from, shorter, ours.begin(), std::plus<>());
  std::ranges::transform(from, shorter, theirs.begin(), std::plus<>());
  EXPECT_EQ(ours, theirs);
  ranges::copy(shorter, ours.begin() + 1);
  std::ranges::copy(shorter, theirs.begin() + 1);
  EXPECT_EQ(ours, theirs);
  EXPECT_TRUE(ranges::equal(ours, theirs));
  EXPECT_FALSE(ranges::equal(ours, shorter));
  EXPECT_TRUE(ranges::equal(from, from, [](int a, int b) { return a == b; }));
  ranges::fill(ours, 4);
  EXPECT_EQ(ranges::count(ours, 4), std::ssize(ours));
}

}  // namespace
}  // namespace brindle
