#include "pictures/video_file.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "brindle/base/text.h"
#include "brindle/error.h"

extern char** environ;

namespace brindle::tool {
namespace {

namespace fs = std::filesystem;

bool is_on_path(const std::string& program) {
  const char* folders = std::getenv("PATH");
  std::string_view rest = folders != nullptr ? folders : "";
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    const fs::path path = fs::path(folder) / program;
    std::error_code ignored;
    if (fs::is_regular_file(path, ignored) && access(path.c_str(), X_OK) == 0) return true;
    rest.remove_prefix(std::min(folder.size() + 1, rest.size()));
  }
  return false;
}

std::vector<std::string> ffmpeg_arguments(const VideoFormat& format, const fs::path& file) {
  return {"ffmpeg", "-nostdin", "-y", "-loglevel", "error",  //
          "-f", "rawvideo", "-pix_fmt", "rgba",              //
          "-s", std::to_string(format.width) + "x" + std::to_string(format.height), "-r",
          std::to_string(format.frames_per_second), "-i", "pipe:0",    //
          "-vf", "crop=trunc(iw/2)*2:trunc(ih/2)*2,format=yuv420p",    //
          "-c:v", "libx264", "-crf", "18", "-movflags", "+faststart",  //
          // ffmpeg would misread relative names with a colon or a leading dash.
          "-f", "mp4", "file:" + file.string()};
}

/// Starts ffmpeg in its own process group, so that Ctrl-C does not reach it.
int spawn(std::vector<std::string> arguments, int input, int messages, pid_t& program) {
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, messages, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, messages, STDERR_FILENO);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  const int failure = posix_spawnp(&program, argv[0], &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return failure;
}

std::string text_of(std::FILE* file) {
  std::string text(2000, '\0');
  std::rewind(file);
  text.resize(std::fread(text.data(), 1, text.size(), file));
  while (!text.empty() && (text.back() == '\n' || text.back() == '\0')) text.pop_back();
  return text;
}

}  // namespace

void check_video_available(const fs::path& path) {
  if (is_on_path("ffmpeg")) return;
  throw Error("cannot write '" + shown(path.native()) +
              "': the program ffmpeg is not installed; install the package 'ffmpeg', or write "
              "pictures, such as --output frames/%04d.png");
}

VideoFile::VideoFile(fs::path path, const VideoFormat& format)
    : path_(std::move(path)), file_(path_), messages_(std::tmpfile()) {
  std::signal(SIGPIPE,
              SIG_IGN);  // writing to an ended process must fail instead of ending this one
  std::array<int, 2> ends{};
  if (!messages_ || pipe2(ends.data(), O_CLOEXEC) != 0) fail(std::strerror(errno));
  frames_ = File(fdopen(ends[1], "wb"));
  const int failure =
      spawn(ffmpeg_arguments(format, file_.place()), ends[0], fileno(messages_.get()), program_);
  close(ends[0]);
  if (failure != 0) {
    program_ = -1;
    fail(std::string("cannot start ffmpeg: ") + std::strerror(failure));
  }
}

VideoFile::~VideoFile() {
  if (program_ > 0) {
    kill(program_, SIGKILL);
    close_and_wait();
  }
}

int VideoFile::close_and_wait() {
  frames_.reset();
  int status = 0;
  while (waitpid(program_, &status, 0) < 0 && errno == EINTR) {
  }
  program_ = -1;
  return status;
}

void VideoFile::fail(const std::string& reason) {
  throw Error("cannot write '" + shown(path_.native()) + "': " + reason);
}

void VideoFile::add(std::span<const std::byte> pixels) {
  if (std::fwrite(pixels.data(), 1, pixels.size(), frames_.get()) == pixels.size()) return;
  close_and_wait();
  fail("ffmpeg ended: " + text_of(messages_.get()));
}

void VideoFile::finish() {
  const bool all_read = std::fflush(frames_.get()) == 0;
  const int status = close_and_wait();
  if (!all_read || status != 0) fail("ffmpeg failed: " + text_of(messages_.get()));
  file_.finish();
}

}  // namespace brindle::tool
