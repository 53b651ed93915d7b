#include "brindle/export.h"

#include <utility>

#include <gtest/gtest.h>

#include "brindle/error.h"

namespace brindle {
namespace {

TEST(Pimpl, HandsItsStateOnAndThenHasNone) {
  Pimpl<int> first(std::make_unique<int>(3));
  Pimpl<int> second = std::move(first);
  EXPECT_EQ(*second, 3);
  EXPECT_THROW(static_cast<void>(*first), Error);  // NOLINT(bugprone-use-after-move)
  first = std::make_unique<int>(4);
  EXPECT_EQ(*first, 4);
  second = std::move(first);
  EXPECT_EQ(*second, 4);
  EXPECT_THROW(static_cast<void>(*Pimpl<int>()), Error);
}

}  // namespace
}  // namespace brindle
