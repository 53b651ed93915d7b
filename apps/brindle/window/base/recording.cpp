#include "window/base/recording.h"

#include <chrono>
#include <span>
#include <utility>

namespace brindle::tool {

Recording::Recording(const std::filesystem::path& path, std::shared_ptr<const SessionFrame> first)
    : path_(path),
      format_{first->image.width, first->image.height},
      file_(path, format_),
      frame_(std::move(first)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

Recording::~Recording() = default;

bool Recording::show(std::shared_ptr<const SessionFrame> frame) {
  if (frame->image.width != format_.width || frame->image.height != format_.height) return false;
  const std::lock_guard lock(mutex_);
  frame_ = std::move(frame);
  return true;
}

bool Recording::failed() const {
  const std::lock_guard lock(mutex_);
  return failure_ != nullptr;
}

double Recording::seconds() const {
  const std::lock_guard lock(mutex_);
  return static_cast<double>(written_) / format_.frames_per_second;
}

void Recording::run(const std::stop_token& stop) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    const std::shared_ptr<const SessionFrame> frame = frame_;
    const std::size_t number = written_++;
    lock.unlock();
    try {
      file_.add(std::as_bytes(std::span(frame->image.pixels)));
    } catch (...) {
      lock.lock();
      failure_ = std::current_exception();
      return;
    }
    // Late frames are repeated.
    const std::chrono::duration<double> next(static_cast<double>(number + 1) /
                                             format_.frames_per_second);
    lock.lock();
    ending_.wait_until(lock, stop, start + std::chrono::duration_cast<Clock::duration>(next),
                       [] { return false; });
  }
}

void Recording::finish() {
  thread_.request_stop();
  thread_.join();
  if (failure_) std::rethrow_exception(failure_);
  file_.finish();
}

}  // namespace brindle::tool
