#include "brindle/base/output_file.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "test_folder.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

struct OutputFile : TestFolder {
  static std::string content(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }
};

TEST_F(OutputFile, HoldsWhatWasWritten) {
  write_file(folder / "a", [](std::ostream& out) { out << "stripes"; });
  EXPECT_EQ(content(folder / "a"), "stripes");
  EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFile, FailureLeavesTheOldFileAndNoOther) {
  write_file(folder / "a", [](std::ostream& out) { out << "old"; });
  EXPECT_THROW(write_file(folder / "a",
                          [](std::ostream& out) {
                            out << "half";
                            throw Error("stopped");
                          }),
               Error);
  EXPECT_EQ(content(folder / "a"), "old");
  EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFile, MissingFolderIsNamedWithTheRemedy) {
  try {
    write_file(folder / "none" / "a", [](std::ostream&) {});
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("none' does not exist"), std::string::npos);
  }
}

TEST_F(OutputFile, FolderIsRefused) {
  EXPECT_THROW(write_file(folder, [](std::ostream&) {}), Error);
}

TEST_F(OutputFile, PathIsCheckedWithoutTouchingIt) {
  check_output_path(folder / "a");
  EXPECT_EQ(files(), 0u);
  EXPECT_THROW(check_output_path(folder), Error);
  EXPECT_THROW(check_output_path(folder / "none" / "a"), Error);
  write_file(folder / "a", [](std::ostream& out) { out << "old"; });
  check_output_path(folder / "a");
  EXPECT_EQ(content(folder / "a"), "old");
  EXPECT_THROW(check_output_path(folder / "a" / "b"), Error);
}

TEST(OutputFileDevice, FullDiskIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  try {
    write_file("/dev/full", [](std::ostream& out) { out << std::string(1 << 20, 'x'); });
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("No space left"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(fs::is_regular_file("/dev/full"));
}

}  // namespace
}  // namespace brindle
