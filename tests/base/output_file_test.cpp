#include "brindle/base/output_file.h"

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

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
  write_file(folder / "a", [](OutputStream& out) { out << "stripes"; });
  EXPECT_EQ(content(folder / "a"), "stripes");
  EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFile, FailureLeavesTheOldFileAndNoOther) {
  write_file(folder / "a", [](OutputStream& out) { out << "old"; });
  EXPECT_THROW(write_file(folder / "a",
                          [](OutputStream& out) {
                            out << "half";
                            throw Error("stopped");
                          }),
               Error);
  EXPECT_EQ(content(folder / "a"), "old");
  EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFile, MissingFolderIsNamedWithTheRemedy) {
  try {
    write_file(folder / "none" / "a", [](OutputStream&) {});
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("none' does not exist"), std::string::npos);
  }
}

TEST_F(OutputFile, FolderIsRefused) {
  EXPECT_THROW(write_file(folder, [](OutputStream&) {}), Error);
}

TEST_F(OutputFile, PathIsCheckedWithoutTouchingIt) {
  check_output_path(folder / "a");
  EXPECT_EQ(files(), 0u);
  EXPECT_THROW(check_output_path(folder), Error);
  EXPECT_THROW(check_output_path(folder / "none" / "a"), Error);
  write_file(folder / "a", [](OutputStream& out) { out << "old"; });
  check_output_path(folder / "a");
  EXPECT_EQ(content(folder / "a"), "old");
  EXPECT_THROW(check_output_path(folder / "a" / "b"), Error);
}

TEST_F(OutputFile, KeepsThePermissionsOfWhatItReplaces) {
  const auto mode = [](const fs::path& path) { return fs::status(path).permissions(); };
  for (const unsigned bits : {0600U, 0640U, 0664U, 0755U}) {
    const auto wanted = static_cast<fs::perms>(bits);
    write_file(folder / "a", [](OutputStream& out) { out << "old"; });
    fs::permissions(folder / "a", wanted);
    write_file(folder / "a", [](OutputStream& out) { out << "new"; });
    EXPECT_EQ(mode(folder / "a"), wanted);
    EXPECT_EQ(content(folder / "a"), "new");
  }
  const mode_t mask = umask(027);
  write_file(folder / "b", [](OutputStream& out) { out << "new"; });
  umask(mask);
  EXPECT_EQ(mode(folder / "b"), static_cast<fs::perms>(0640)) << "as of any new file";
  EXPECT_EQ(files(), 2u);
}

TEST_F(OutputFile, FollowsLinks) {
  fs::create_directory(folder / "far");
  write_file(folder / "far" / "a", [](OutputStream& out) { out << "old"; });
  fs::create_symlink("far/a", folder / "near");
  fs::create_symlink("near", folder / "nearer");
  fs::create_symlink("far/none", folder / "dangling");
  write_file(folder / "nearer", [](OutputStream& out) { out << "new"; });
  write_file(folder / "dangling", [](OutputStream& out) { out << "made"; });
  EXPECT_TRUE(fs::is_symlink(folder / "nearer") && fs::is_symlink(folder / "near"));
  EXPECT_TRUE(fs::is_symlink(folder / "dangling"));
  EXPECT_EQ(content(folder / "far" / "a"), "new");
  EXPECT_EQ(content(folder / "far" / "none"), "made");
  fs::create_symlink("nowhere/a", folder / "lost");
  EXPECT_THROW(check_output_path(folder / "lost"), Error);
  EXPECT_THROW(write_file(folder / "lost", [](OutputStream&) {}), Error);
  fs::create_symlink("round", folder / "round");
  EXPECT_THROW(write_file(folder / "round", [](OutputStream&) {}), Error);
}

TEST_F(OutputFile, MayHaveTheLongestNameThereIs) {
  const fs::path longest = folder / std::string(255, 'n');
  for (int times = 0; times < 2; ++times) {
    write_file(longest, [](OutputStream& out) { out << "stripes"; });
    EXPECT_EQ(content(longest), "stripes");
  }
  EXPECT_EQ(files(), 1u);
  EXPECT_THROW(check_output_path(folder / std::string(256, 'n')), Error);
  EXPECT_THROW(write_file(folder / std::string(256, 'n'), [](OutputStream&) {}), Error);
}

TEST_F(OutputFile, HoldsWritesOfAllSizes) {
  std::string expected;
  write_file(folder / "a", [&](OutputStream& out) {
    for (std::size_t size = 1; size < 300000; size = 3 * size + 1) {
      const std::string text(size, static_cast<char>('a' + size % 26));
      out << text;
      out << '.';
      expected += text + '.';
    }
  });
  EXPECT_EQ(content(folder / "a"), expected);
}

TEST(OutputText, HoldsWhatAFileWouldHold) {
  std::string text = "before ";
  OutputStream out(text);
  out << "stripes" << ' ' << 40 << ' ' << std::uint64_t{18446744073709551615u} << ' ' << -7;
  out.write("\0a", 2);
  EXPECT_EQ(text, std::string("before stripes 40 18446744073709551615 -7") + std::string("\0a", 2));
  EXPECT_FALSE(out.bad());
}

/// What a process leaves that is killed while it writes.
TEST_F(OutputFile, BeingKilledLeavesTheOldFileAndNoOther) {
  const int unnamed = open(folder.c_str(), O_TMPFILE | O_WRONLY, 0600);
  if (unnamed < 0) GTEST_SKIP() << "this file system knows no files without names";
  close(unnamed);
  write_file(folder / "a", [](OutputStream& out) { out << "old"; });
  for (const char* name : {"a", "b"}) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      write_file(folder / name, [](OutputStream& out) {
        out << std::string(200000, 'x');
        out.flush();
        kill(getpid(), SIGKILL);
      });
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(content(folder / "a"), "old");
    EXPECT_EQ(files(), 1u);
  }
}

TEST_F(OutputFile, BeyondTheLimitOfSizesIsAnErrorWithTheRemedy) {
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{100000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &limit);
  std::string message;
  try {
    write_file(folder / "a", [](OutputStream& out) { out << std::string(200000, 'x'); });
  } catch (const Error& error) {
    message = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(message.find("ulimit -f"), std::string::npos) << message;
  EXPECT_EQ(files(), 0u);
}

TEST_F(OutputFile, PipeIsWrittenTo) {
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  write_file(pipe, [](OutputStream& out) { out << "stripes"; });
  std::string text(20, ' ');
  text.resize(static_cast<std::size_t>(read(reader, text.data(), text.size())));
  close(reader);
  EXPECT_EQ(text, "stripes");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

// Of a pipe that nobody reads, and of one whose reader stands still.
TEST_F(OutputFile, PipeMayBeCancelled) {
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const bool is_read : {false, true}) {
    const int reader = is_read ? open(pipe.c_str(), O_RDONLY | O_NONBLOCK) : -1;
    int reports = 0;
    const Progress progress([&](const ProgressReport&) { return ++reports < 3; });
    const std::string much(1 << 22, 'x');  // more than the system keeps of a pipe
    EXPECT_THROW(write_file(
                     pipe, [&](OutputStream& out) { out << much; }, progress),
                 Cancelled);
    EXPECT_EQ(reports, 3);
    if (is_read) close(reader);
  }
}

TEST(OutputFileDevice, FullDiskIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  try {
    write_file("/dev/full", [](OutputStream& out) { out << std::string(1 << 20, 'x'); });
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("No space left"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(fs::is_regular_file("/dev/full"));
}

TEST(OutputFileDevice, FullDiskStopsThoseWhoWriteMuch) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  std::size_t numbers = 0;
  EXPECT_THROW(write_file("/dev/full",
                          [&](OutputStream& out) {
                            TextOutput text(out);
                            for (; numbers < 1'000'000; ++numbers) text << numbers << ' ';
                          }),
               Error);
  EXPECT_LT(numbers, 100'000u);
}

TEST_F(OutputFile, ReportsEveryFewMegabytesAndMayBeCancelledAtEach) {
  write_file(folder / "a", [](OutputStream& out) { out << "old"; });
  const auto write = [](OutputStream& out) {
    TextOutput text(out);
    for (int line = 0; line < 200; ++line) text << std::string(100'000, 'x') << '\n';
    out << std::string(9 << 20, 'y');
  };
  std::vector<double> fractions;
  write_file(folder / "b", write, Progress([&](std::string_view step, double fraction) {
               EXPECT_EQ(step, "writing " + (folder / "b").string());
               fractions.push_back(fraction);
               return true;
             }));
  EXPECT_EQ(fs::file_size(folder / "b"), 200u * 100'001 + (9u << 20));
  EXPECT_GE(fractions.size(), 5u);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_LT(fractions.back(), 1);
  for (std::size_t last = 0; last < fractions.size(); ++last) {
    std::size_t heard = 0;
    const Progress progress([&](std::string_view, double) { return heard++ < last; });
    EXPECT_THROW(write_file(folder / "a", write, progress), Cancelled);
    EXPECT_EQ(content(folder / "a"), "old");
    EXPECT_EQ(files(), 2u);
  }
}

}  // namespace
}  // namespace brindle
