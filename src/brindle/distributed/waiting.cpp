#include "brindle/distributed/waiting.h"

#include <atomic>

namespace brindle {
namespace {

using Clock = std::chrono::steady_clock;

// A watcher that reads between the two stores sees a wait that has just begun or just ended.
std::atomic<const char*> waited_for{nullptr};
std::atomic<Clock::rep> waiting_since{0};

}  // namespace

std::optional<Waiting> waiting_now() {
  const char* what = waited_for.load(std::memory_order_acquire);
  if (what == nullptr) return std::nullopt;
  const Clock::duration since(waiting_since.load(std::memory_order_relaxed));
  return Waiting{what, Clock::now().time_since_epoch() - since};
}

WaitMark::WaitMark(const char* what) {
  waiting_since.store(Clock::now().time_since_epoch().count(), std::memory_order_relaxed);
  waited_for.store(what, std::memory_order_release);
}

WaitMark::~WaitMark() { waited_for.store(nullptr, std::memory_order_release); }

}  // namespace brindle
