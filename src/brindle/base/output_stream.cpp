#include "brindle/base/output_file.h"

#include <algorithm>
#include <cerrno>

#include "brindle/error.h"

namespace brindle {
namespace {

constexpr std::size_t kGathered = std::size_t{1} << 16;
/// Written at once, and between two reports.
constexpr std::size_t kPart = std::size_t{4} << 20;

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
      since_report_ = kPart;  // so that who waits can cancel
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

}  // namespace brindle
