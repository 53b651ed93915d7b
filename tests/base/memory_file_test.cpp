#include "brindle/base/memory_file.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "brindle/base/input_file.h"
#include "brindle/base/output_file.h"
#include "brindle/error.h"

namespace brindle {
namespace {

TEST(MemoryFile, IsReadByLinesAndAtAnyPlace) {
  const MemoryFile memory("lines.txt", "first\nsecond\nthird");
  InputFile file("lines.txt");
  EXPECT_EQ(file.size(), 18);
  EXPECT_EQ(file.next_line(), "first");
  std::array<std::byte, 6> bytes{};
  file.read_at(6, bytes);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), "second");
  EXPECT_EQ(file.next_line(), "second");
  EXPECT_EQ(file.next_line(), "third");
  EXPECT_EQ(file.next_line(), std::nullopt);
  EXPECT_THROW(file.read_at(13, bytes), Error);
  EXPECT_EQ(whole_input("lines.txt", "a file"), memory.content);
}

TEST(MemoryFile, IsWrittenInsteadOfAFile) {
  MemoryFile memory("written.txt", "earlier");
  write_file("written.txt", [](OutputStream& out) { out << "text " << 7; });
  EXPECT_EQ(memory.content, "text 7");
  EXPECT_FALSE(std::filesystem::exists("written.txt"));
}

TEST(MemoryFile, ThatIsEmptyIsRejectedAsFilesAre) {
  const MemoryFile memory("empty.txt");
  EXPECT_THROW(InputFile("empty.txt"), Error);
}

TEST(MemoryFile, HidesOthersOfItsNameWhileItLives) {
  const MemoryFile outer("name.txt", "outer");
  {
    const MemoryFile inner("name.txt", "inner");
    EXPECT_EQ(whole_input("name.txt", "a file"), "inner");
  }
  EXPECT_EQ(whole_input("name.txt", "a file"), "outer");
  EXPECT_THROW(whole_input("other.txt", "a file"), Error);
}

}  // namespace
}  // namespace brindle
