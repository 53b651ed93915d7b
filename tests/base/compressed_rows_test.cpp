#include "brindle/base/compressed_rows.h"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace brindle {
namespace {

using Added = std::vector<std::pair<Index, char>>;

CompressedRows<char> rows_of(std::size_t count, const Added& all) {
  return compressed_rows<char>(count, [&](const auto& add) {
    for (const auto& [row, entry] : all) add(row, entry);
  });
}

TEST(CompressedRows, HaveTheirEntriesInTheOrderOfAdding) {
  const CompressedRows<char> rows = rows_of(4, {{3, 'x'}, {0, 'b'}, {3, 'a'}, {1, 'c'}, {3, 'x'}});
  EXPECT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows.offsets, (std::vector<Index>{0, 1, 2, 2, 5}));
  EXPECT_EQ(rows.entries, (std::vector<char>{'b', 'c', 'x', 'a', 'x'}));
  EXPECT_TRUE(rows.of(2).empty());
  EXPECT_EQ(rows.of(3)[1], 'a');
}

TEST(CompressedRows, MayBeEmptyOrNone) {
  EXPECT_EQ(rows_of(2, {}).offsets, (std::vector<Index>{0, 0, 0}));
  EXPECT_EQ(rows_of(0, {}).offsets, std::vector<Index>{0});
  EXPECT_EQ(CompressedRows<char>().size(), 0u);
}

}  // namespace
}  // namespace brindle
