/// What a shared library shows of its classes, and what these keep behind their headers.
#pragma once

#include <memory>
#include <utility>

// On Windows a namespace has no such attribute: there CMake exports all symbols.
#if defined(__GNUC__) && !defined(_WIN32)
#define BRINDLE_EXPORT [[gnu::visibility("default")]]
#else
#define BRINDLE_EXPORT
#endif

namespace BRINDLE_EXPORT brindle {

/// Throws Error: an object that was moved from can be assigned to and destroyed, nothing else.
[[noreturn]] void refuse_moved_from();

/// The one owner of an object's state. An object that was moved from has none, and using it throws
/// Error.
template <class State>
class Pimpl {
 public:
  Pimpl() = default;
  Pimpl(std::unique_ptr<State> state)  // NOLINT(google-explicit-constructor)
      : state_(std::move(state)) {}

  State& operator*() const {
    if (state_ == nullptr) refuse_moved_from();
    return *state_;
  }
  State* operator->() const { return &**this; }

 private:
  std::unique_ptr<State> state_;
};

}  // namespace brindle
