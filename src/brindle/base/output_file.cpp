#include "brindle/base/output_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ostream>
#include <random>
#include <streambuf>
#include <string>
#include <utility>
#include <vector>

#include "brindle/base/printable.h"
#include "brindle/base/system.h"
#include "brindle/base/text_output.h"
#include "brindle/error.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// Where links lead, whether or not a file is there; no further than the system would follow them.
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

/// Of what `followed` has given: links that lead in a circle.
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

/// What goes into an open file, and reports how much that is. Keeps the system's reason for a
/// failure, which streams forget. Once cancelled it takes no more.
class DescriptorBuffer : public std::streambuf {
 public:
  DescriptorBuffer(system::Descriptor descriptor, const Progress& progress)
      : descriptor_(descriptor), buffer_(kSize), progress_(progress) {
    setp(buffer_.data(), buffer_.data() + buffer_.size());
  }

  /// 0, or the reason for the first failure.
  int reason() const { return reason_; }
  bool is_cancelled() const { return cancelled_; }

 protected:
  int_type overflow(int_type letter) override {
    if (!empty()) return traits_type::eof();
    if (!traits_type::eq_int_type(letter, traits_type::eof())) sputc(static_cast<char>(letter));
    return traits_type::not_eof(letter);
  }

  std::streamsize xsputn(const char* text, std::streamsize count) override {
    if (count < epptr() - pptr()) {
      std::memcpy(pptr(), text, static_cast<std::size_t>(count));
      pbump(static_cast<int>(count));
      return count;
    }
    return empty() && write_all(text, static_cast<std::size_t>(count)) ? count : 0;
  }

  int sync() override { return empty() ? 0 : -1; }

 private:
  static constexpr std::size_t kSize = std::size_t{1} << 16;

  bool empty() {
    const bool good = write_all(pbase(), static_cast<std::size_t>(pptr() - pbase()));
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    return good;
  }

  bool write_all(const char* text, std::size_t count) {
    while (count > 0 && reason_ == 0 && may_go_on()) {
      const auto written = system::write_some(descriptor_, text, std::min(count, kPart));
      if (written > 0) {
        text += written;
        count -= static_cast<std::size_t>(written);
        passed_ += static_cast<std::size_t>(written);
        since_report_ += static_cast<std::size_t>(written);
      } else if (written == 0 || errno != EINTR) {
        reason_ = written == 0 ? EIO : errno;
      }
    }
    return reason_ == 0 && !cancelled_;
  }

  bool may_go_on() {
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

  static constexpr std::size_t kPart = std::size_t{4} << 20;

  system::Descriptor descriptor_;
  int reason_ = 0;
  std::vector<char> buffer_;
  Progress progress_;
  std::size_t passed_ = 0, since_report_ = 0;
  bool cancelled_ = false;
};

void write_to(system::Descriptor descriptor, const fs::path& path,
              const std::function<void(std::ostream&)>& write, const Progress& progress) {
  DescriptorBuffer buffer(descriptor, progress.step("writing " + shown(path.string())));
  std::ostream out(&buffer);
  try {
    write(out);
  } catch (const OutputStopped&) {
    // The stream is bad, as below.
  }
  out.flush();
  if (buffer.is_cancelled()) throw Cancelled("cancelled");
  if (!out) fail(path, buffer.reason());
}

void write_device(const fs::path& path, const std::function<void(std::ostream&)>& write,
                  const Progress& progress) {
  const system::Descriptor descriptor = system::open_device(path);
  if (descriptor < 0) fail(path, errno);
  try {
    write_to(descriptor, path, write, progress);
  } catch (...) {
    system::close_file(descriptor);
    throw;
  }
  if (!system::close_file(descriptor)) fail(path, errno);
}

/// Short, whatever the file will be called: it may have as long a name as the system allows.
fs::path temporary_name(const fs::path& target) {
  return folder_of(target) / (".brindle-" + std::to_string(std::random_device()()) + ".tmp");
}

}  // namespace

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

void UnfinishedFile::write(const std::function<void(std::ostream&)>& write,
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
  // Some file systems say only now that the last bytes did not fit.
  if (!system::close_file(std::exchange(descriptor_, -1))) fail(path_, errno);
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) fail(path_, error.default_error_condition().value());
  temporary_.clear();
}

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& write,
                const Progress& progress) {
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
