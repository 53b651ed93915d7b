/// Symbol visibility in shared libraries, and private state of classes.
#pragma once

#include <memory>
#include <utility>

// Windows has no such attribute for namespaces, and Clang does not apply it to definitions; there
// all symbols are exported.
#if defined(__GNUC__) && !defined(_WIN32)
#define BRINDLE_EXPORT [[gnu::visibility("default")]]
#else
#define BRINDLE_EXPORT
#endif

namespace BRINDLE_EXPORT brindle {

/// Throws Error: a moved-from object can only be assigned to or destroyed.
[[noreturn]] void refuse_moved_from();

/// The sole owner of an object's state. A moved-from object has none; using it throws Error.
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
