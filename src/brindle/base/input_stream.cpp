#include "brindle/base/input_file.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include "brindle/base/text.h"
#include "brindle/error.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw Error(shown(path.string()) + ": " + why);
}

}  // namespace

InputStream::~InputStream() {
  if (descriptor_ >= 0) system::close_file(descriptor_);
}

InputStream::InputStream(InputStream&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), place_(other.place_), bad_(other.bad_) {}

std::size_t InputStream::read(void* bytes, std::size_t count) {
  auto* const begin = static_cast<char*>(bytes);
  std::size_t done = 0;
  while (done < count && !bad_) {
    const auto read = system::read_some(descriptor_, begin + done, count - done);
    if (read == 0) break;
    if (read > 0) {
      done += static_cast<std::size_t>(read);
    } else {
      bad_ = errno != EINTR;
    }
  }
  place_ += done;
  return done;
}

void InputStream::seek(std::uint64_t place) {
  bad_ = bad_ || !system::go_to(descriptor_, place);
  place_ = place;
}

bool InputLines::next(std::string& line) {
  constexpr std::size_t kPart = std::size_t{1} << 16;
  std::size_t searched = begin_;
  while (true) {
    const std::size_t end = buffer_.find('\n', searched);
    if (end != std::string::npos) {
      line.assign(buffer_, begin_, end - begin_);
      begin_ = end + 1;
      return true;
    }
    buffer_.erase(0, std::exchange(begin_, 0));
    searched = buffer_.size();
    buffer_.resize(searched + kPart);
    buffer_.resize(searched + stream_.read(buffer_.data() + searched, kPart));
    if (buffer_.size() == searched) break;
  }
  line = std::exchange(buffer_, {});
  return !line.empty();
}

InputStream open_input(const fs::path& path, const std::string& kind) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    refuse(path, "there is no such file; check the path's spelling");
  }
  if (error) refuse(path, "cannot be read: " + error.message());
  if (fs::is_directory(status)) refuse(path, "is a folder; name " + kind + " in it");
  if (!fs::is_regular_file(status)) {
    refuse(path,
           "is not a regular file but a device or a pipe; save " + kind + " first and name that");
  }
  errno = 0;
  const system::Descriptor descriptor = system::open_existing(path);
  if (descriptor >= 0) return InputStream(descriptor);
  const std::string reason = errno == 0 || errno == EACCES ? "" : std::strerror(errno);
  refuse(path,
         "cannot be opened" + (reason.empty() ? "" : ": " + reason) + "; check its permissions");
}

std::string whole_input(const fs::path& path, const std::string& kind) {
  constexpr std::size_t kPart = std::size_t{1} << 16;
  InputStream stream = open_input(path, kind);
  std::string content;
  for (std::size_t size = 0, read = kPart; read == kPart; content.resize(size)) {
    content.resize(size + kPart);
    read = stream.read(content.data() + size, kPart);
    size += read;
  }
  if (stream.bad()) refuse(path, "cannot be read: input error");
  return content;
}

}  // namespace brindle
