#include "brindle/base/parallel.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace brindle {
namespace {

/// A sum whose bits depend on the order of the additions.
double part(std::size_t begin, std::size_t end) {
  double sum = 0;
  for (std::size_t i = begin; i < end; ++i) sum += std::sin(static_cast<double>(i)) * 1e3;
  return sum;
}

TEST(Parallel, SumsAddInTheSameOrderWithAndWithoutThreads) {
  for (const std::size_t count : {0u, 1u, 7u, 2048u, 2049u, 100'000u, 123'457u}) {
    for (const std::size_t grain : {1u, 64u, 2048u}) {
      const double expected = halving_sum<double>(0, count, part, grain);
      EXPECT_EQ(parallel_sum<double>(count, part, grain), expected) << count << ", " << grain;
      const ThreadLimit one(1);
      EXPECT_EQ(parallel_sum<double>(count, part, grain), expected) << count << ", " << grain;
    }
  }
}

TEST(Parallel, OrderOfAdditionsMattersToTheTestAbove) {
  EXPECT_NE(halving_sum<double>(0, 123'457, part, 64), part(0, 123'457));
}

TEST(Parallel, ForVisitsEveryNumberOnce) {
  for (const std::size_t count : {0u, 1u, 5000u, 100'001u}) {
    std::vector<int> visits(count, 0);
    parallel_for(count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
    EXPECT_EQ(visits, std::vector<int>(count, 1));
  }
}

TEST(Parallel, ThreadsHaveNumbersBelowTheCapacity) {
  std::vector<std::size_t> numbers(100'000);
  parallel_for(numbers.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) numbers[i] = thread_number();
  });
  for (const std::size_t number : numbers) EXPECT_LT(number, thread_capacity());
}

TEST(ThreadLimit, HoldsWhileItLives) {
  const int before = ThreadLimit::current();
  {
    const ThreadLimit one(1);
    EXPECT_EQ(ThreadLimit::current(), 1);
  }
  EXPECT_EQ(ThreadLimit::current(), before);
}

}  // namespace
}  // namespace brindle
