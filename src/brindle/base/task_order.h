/// What oneTBB guarantees of the order of tasks, in words that ThreadSanitizer understands. The
/// distribution's oneTBB is not instrumented; without this, every task seems to race with the one
/// that called it, and suppressing that would suppress true races, too.
#pragma once

#include <atomic>

#if defined(__SANITIZE_THREAD__)
#define BRINDLE_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define BRINDLE_THREAD_SANITIZER
#endif
#endif

namespace brindle {

/// All that came before `call` happens before every task, and every task before all that follows
/// `join`. Tasks know no order among each other. Costs nothing without
/// ThreadSanitizer.
class TaskOrder {
 public:
#ifdef BRINDLE_THREAD_SANITIZER
  static void call() { called_.fetch_add(1, std::memory_order_release); }
  static void begin_task() { called_.load(std::memory_order_acquire); }
  static void end_task() { done_.fetch_add(1, std::memory_order_release); }
  static void join() { done_.load(std::memory_order_acquire); }

 private:
  // Of all calls together: a task could not be told of a counter of its own call before it reads
  // what that call wrote.
  inline static std::atomic<unsigned> called_ = 0, done_ = 0;
#else
  static void call() {}
  static void begin_task() {}
  static void end_task() {}
  static void join() {}
#endif
};

}  // namespace brindle
