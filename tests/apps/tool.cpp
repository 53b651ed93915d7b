#include "tool.h"

#include <algorithm>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace brindle::test {
namespace fs = std::filesystem;

namespace {

fs::path fresh_path(const std::string& name) {
  return fs::path(testing::TempDir()) /
         ("brindle_" + name + std::to_string(std::random_device()()));
}

[[noreturn]] void become_tool(const std::vector<std::string>& arguments, const fs::path& folder,
                              const fs::path& out, const fs::path& err) {
  std::vector<char*> argv;
  std::string program = BRINDLE_TOOL;
  argv.push_back(program.data());
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const int flags = O_WRONLY | O_CREAT | O_TRUNC;
  if (dup2(open(out.c_str(), flags, 0600), STDOUT_FILENO) >= 0 &&
      dup2(open(err.c_str(), flags, 0600), STDERR_FILENO) >= 0 && chdir(folder.c_str()) == 0) {
    execv(argv[0], argv.data());
  }
  _exit(127);
}

}  // namespace

ToolResult run_tool(const std::vector<std::string>& arguments, const fs::path& folder) {
  const fs::path out = fresh_path("out");
  const fs::path err = fresh_path("err");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) become_tool(arguments, folder, out, err);
  int status = 0;
  waitpid(child, &status, 0);
  ToolResult result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(out), content(err)};
  fs::remove(out);
  fs::remove(err);
  return result;
}

std::string content(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void write_text(const fs::path& path, std::string_view text) {
  std::ofstream(path, std::ios::binary) << text;
}

void ToolTest::SetUp() {
  folder = fresh_path("folder");
  fs::create_directories(folder);
}

void ToolTest::TearDown() { fs::remove_all(folder); }

std::set<std::string> ToolTest::listing() const {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    names.insert(entry.path().lexically_relative(folder).string());
  }
  return names;
}

void ToolTest::expect_refusal(int exit_code, std::string_view message,
                              const std::vector<std::string>& arguments) const {
  const std::set<std::string> before = listing();
  const ToolResult result = run(arguments);
  std::string command;
  for (const std::string& argument : arguments) command += ' ' + argument;
  SCOPED_TRACE(command);
  EXPECT_EQ(result.exit_code, exit_code) << result.err;
  EXPECT_TRUE(result.err.starts_with("brindle: ")) << result.err;
  EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find("Sanitizer"), std::string::npos) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(listing(), before);
}

}  // namespace brindle::test
