#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tool.h"

namespace brindle::test {
namespace {

namespace fs = std::filesystem;

struct Ending : ToolTest {
  /// The tool at work in the folder, for far longer than a test takes.
  pid_t start(void (*prepare)() = nullptr) const {
    const pid_t child = fork();
    if (child != 0) return child;
    if (prepare != nullptr) prepare();
    const int messages = open((folder / "messages").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(messages, STDOUT_FILENO);
    dup2(messages, STDERR_FILENO);
    if (chdir(folder.c_str()) == 0) {
      execl(BRINDLE_TOOL, BRINDLE_TOOL, "stripe", "shape:sphere,resolution=200", "--solver",
            "multilevel,sweeps=10000,cycles=1000", "--output", "a.vtp", nullptr);
    }
    _exit(127);
  }

  /// Waits until the job runs, which it says after a second, and no longer handles signals as a
  /// program does that has just begun.
  void wait_for_work() const {
    while (content(folder / "messages").empty()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
};

TEST_F(Ending, BySignalsIsAsByCtrlCAndLeavesNothing) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const pid_t tool = start();
    wait_for_work();
    kill(tool, signal);
    int status = 0;
    waitpid(tool, &status, 0);
    ASSERT_TRUE(WIFEXITED(status)) << signal;
    EXPECT_EQ(WEXITSTATUS(status), 128 + signal);
    EXPECT_NE(content(folder / "messages").find("cancelled"), std::string::npos);
    EXPECT_EQ(listing(), std::set<std::string>{"messages"});
    fs::remove(folder / "messages");
  }
}

TEST_F(Ending, OfTheTerminalDoesNotEndWhatNohupStarted) {
  const pid_t tool = start([] { std::signal(SIGHUP, SIG_IGN); });
  wait_for_work();
  kill(tool, SIGHUP);
  kill(tool, SIGTERM);
  int status = 0;
  waitpid(tool, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 128 + SIGTERM);
}

TEST_F(Ending, OfAJobWhosePipeNobodyReads) {
  for (const std::string name : {"pipe.ply", "pipe.json"}) {
    ASSERT_EQ(mkfifo((folder / name).c_str(), 0600), 0);
    const pid_t tool = fork();
    if (tool == 0) {
      const int messages = open((folder / "messages").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
      dup2(messages, STDERR_FILENO);
      const std::string path = (folder / name).string();
      execl(BRINDLE_TOOL, BRINDLE_TOOL, "stripe", "shape:torus,resolution=12", "--quiet",
            name == "pipe.ply" ? "--output" : "--report", path.c_str(), nullptr);
      _exit(127);
    }
    std::this_thread::sleep_for(std::chrono::seconds(1));
    int status = 0;
    EXPECT_EQ(waitpid(tool, &status, WNOHANG), 0) << "it waits for a reader";
    kill(tool, SIGTERM);
    waitpid(tool, &status, 0);
    ASSERT_TRUE(WIFEXITED(status)) << name;
    EXPECT_EQ(WEXITSTATUS(status), 128 + SIGTERM);
    EXPECT_EQ(content(folder / "messages"), "brindle: cancelled\n");
  }
}

TEST_F(Ending, AtTheLimitOfSizesIsAMessage) {
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit limit{20000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &limit);
  const auto refused = [&](const std::string& output) {
    expect_refusal(1, output + "': File too large; raise the limit",
                   {"stripe", "shape:sphere,resolution=40", "-q", "--output", output});
  };
  for (const char* name : {"a.vtp", "a.ply", "a.obj", "a.glb", "a.gltf"}) refused(name);
  setrlimit(RLIMIT_FSIZE, &before);
}

TEST_F(Ending, InAFolderThatMayNotBeWrittenToLeavesNothing) {
  fs::create_directory(folder / "kept");
  fs::permissions(folder / "kept", fs::perms::owner_read | fs::perms::owner_exec);
  if (access((folder / "kept").c_str(), W_OK) == 0) GTEST_SKIP() << "this user may write anywhere";
  expect_refusal(1, "kept/a.vtp': Permission denied",
                 {"stripe", "shape:sphere", "--output", "kept/a.vtp"});
}

}  // namespace
}  // namespace brindle::test
