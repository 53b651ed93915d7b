#include "brindle/base/output_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <random>
#include <string>
#include <utility>

#include "brindle/base/memory_file.h"
#include "brindle/base/system.h"
#include "brindle/base/text.h"
#include "brindle/error.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kGathered = std::size_t{1} << 16;
/// Bytes per write, and between two reports.
constexpr std::size_t kPart = std::size_t{4} << 20;

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// Follows links, also to missing files, but no further than the system would.
fs::path followed(fs::path path) {
  constexpr int kMostLinks = 40;
  std::error_code error;
  for (int links = 0; links < kMostLinks; ++links) {
    const fs::path next = fs::read_symlink(path, error);
    if (error) return path;
    path = next.is_absolute() ? next : folder_of(path) / next;
  }
  return path;
}

/// Whether `followed` stopped at a cycle of links.
bool is_link(const fs::path& followed) {
  std::error_code ignored;
  return fs::is_symlink(followed, ignored);
}

std::string remedy_for(int reason) {
  switch (reason) {
    case ENOSPC:
#ifdef EDQUOT
    case EDQUOT:
#endif
      return "; free some space or choose another folder";
    case EFBIG:
      return "; raise the limit on the size of files (ulimit -f) or choose another folder";
    case ENAMETOOLONG:
      return "; choose a shorter name";
    default:
      return "; check the folder's permissions or choose another path";
  }
}

[[noreturn]] void fail(const fs::path& path, int reason) {
  std::string message = "cannot write '" + shown(path.string()) + "'";
  if (reason != 0) message += std::string(": ") + std::strerror(reason);
  const fs::path folder = folder_of(followed(path));
  std::error_code ignored;
  if (reason != ENAMETOOLONG && !fs::is_directory(folder, ignored)) {
    message += "; the folder '" + shown(folder.string()) + "' does not exist, create it first";
  } else {
    message += remedy_for(reason);
  }
  throw Error(message);
}

void refuse_folder(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return;
  throw Error("cannot write '" + shown(path.string()) + "': it is a folder; name a file in it");
}

void write_to(system::Descriptor descriptor, const fs::path& path,
              const std::function<void(OutputStream&)>& write, const Progress& progress) {
  OutputStream out(descriptor, progress.step("writing " + shown(path.string())));
  try {
    write(out);
  } catch (const OutputStopped&) {
    // The stream is bad, which is handled below.
  }
  out.flush();
  if (out.is_cancelled()) throw Cancelled("cancelled");
  if (out.bad()) fail(path, out.reason());
}

/// Waits until a pipe has a reader; can be cancelled.
system::Descriptor open_device(const fs::path& path, const Progress& progress) {
  std::error_code ignored;
  const bool is_pipe = fs::is_fifo(path, ignored);
  for (;;) {
    const system::Descriptor descriptor = system::open_device(path);
    if (descriptor >= 0) return descriptor;
    if (!is_pipe || !system::is_not_ready(errno)) fail(path, errno);
    progress.report("waiting for a reader of " + shown(path.string()), 0);
    system::wait_a_moment();
  }
}

void write_device(const fs::path& path, const std::function<void(OutputStream&)>& write,
                  const Progress& progress) {
  const system::Descriptor descriptor = open_device(path, progress);
  try {
    write_to(descriptor, path, write, progress);
  } catch (...) {
    system::close_file(descriptor);
    throw;
  }
  if (!system::close_file(descriptor)) fail(path, errno);
}

/// Short and independent of the target's name, which may be as long as the system allows.
fs::path temporary_name(const fs::path& target) {
  return folder_of(target) / (".brindle-" + std::to_string(std::random_device()()) + ".tmp");
}

}  // namespace

OutputStream::OutputStream(system::Descriptor descriptor, const Progress& progress)
    : descriptor_(descriptor), progress_(progress) {
  gathered_.reserve(kGathered);
}

OutputStream& OutputStream::write(const void* bytes, std::size_t count) {
  const auto* const begin = static_cast<const char*>(bytes);
  if (text_) {
    text_->append(begin, count);
    return *this;
  }
  if (gathered_.size() + count > kGathered) flush();
  if (count > kGathered) {
    write_all(begin, count);
  } else {
    gathered_.insert(gathered_.end(), begin, begin + count);
  }
  return *this;
}

void OutputStream::flush() {
  write_all(gathered_.data(), gathered_.size());
  gathered_.clear();
}

void OutputStream::write_all(const char* bytes, std::size_t count) {
  while (count > 0 && reason_ == 0 && may_go_on()) {
    const auto written = system::write_some(descriptor_, bytes, std::min(count, kPart));
    if (written > 0) {
      bytes += written;
      count -= static_cast<std::size_t>(written);
      passed_ += static_cast<std::size_t>(written);
      since_report_ += static_cast<std::size_t>(written);
    } else if (written < 0 && system::is_not_ready(errno)) {
      system::wait_a_moment();
      since_report_ = kPart;  // so that the wait can be cancelled
    } else if (written == 0 || errno != EINTR) {
      reason_ = written == 0 ? EIO : errno;
    }
  }
}

bool OutputStream::may_go_on() {
  if (cancelled_ || since_report_ < kPart) return !cancelled_;
  since_report_ = 0;
  const auto parts = static_cast<double>(passed_) / static_cast<double>(kPart);
  try {
    progress_.report(parts / (parts + 4));
  } catch (const Cancelled&) {
    cancelled_ = true;
  }
  return !cancelled_;
}

bool is_device(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
}

UnfinishedFile::UnfinishedFile(const fs::path& path) : path_(path), target_(followed(path)) {
  refuse_folder(path);
  if (is_link(target_)) fail(path_, ELOOP);
  descriptor_ = system::open_unnamed(folder_of(target_));
  if (descriptor_ >= 0) return;
  temporary_ = temporary_name(target_);
  descriptor_ = system::open_new(temporary_);
  if (descriptor_ < 0) fail(path_, errno);
}

UnfinishedFile::~UnfinishedFile() {
  if (descriptor_ >= 0) system::close_file(descriptor_);
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void UnfinishedFile::write(const std::function<void(OutputStream&)>& write,
                           const Progress& progress) {
  write_to(descriptor_, path_, write, progress);
}

fs::path UnfinishedFile::place() const {
  return temporary_.empty() ? system::place_of(descriptor_) : temporary_;
}

void UnfinishedFile::finish() {
  system::take_over(descriptor_, target_);
  if (temporary_.empty()) {
    const fs::path unnamed = place();
    if (system::link_to(unnamed, target_)) return;
    if (errno != EEXIST) fail(path_, errno);
    fs::path name = temporary_name(target_);
    if (!system::link_to(unnamed, name)) fail(path_, errno);
    temporary_ = std::move(name);
  }
  // Some file systems report only now that the last bytes did not fit.
  if (!system::close_file(std::exchange(descriptor_, -1))) fail(path_, errno);
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) fail(path_, error.default_error_condition().value());
  temporary_.clear();
}

void write_file(const fs::path& path, const std::function<void(OutputStream&)>& write,
                const Progress& progress) {
  if (MemoryFile* file = MemoryFile::find(path)) {
    std::string content;
    OutputStream out(content);
    write(out);
    file->content = std::move(content);
    return;
  }
  refuse_folder(path);
  if (is_device(path)) return write_device(path, write, progress);
  UnfinishedFile file(path);
  file.write(write, progress);
  file.finish();
}

void check_output_path(const fs::path& path) {
  refuse_folder(path);
  if (system::is_name_too_long(path)) fail(path, ENAMETOOLONG);
  const fs::path target = followed(path);
  if (is_link(target)) fail(path, ELOOP);
  const fs::path written = is_device(path) ? path : folder_of(target) / ".";
  if (!system::may_write(written)) fail(path, errno);
}

}  // namespace brindle
