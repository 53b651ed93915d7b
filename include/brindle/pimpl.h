/// What a class keeps behind its header.
#pragma once

#include <memory>
#include <utility>

#include "brindle/export.h"

namespace BRINDLE_EXPORT brindle {

/// Throws Error: an object that was moved from can be assigned to and destroyed, nothing else.
[[noreturn]] void refuse_moved_from();

/// The one owner of an object's state. Moving leaves the other object without any, and whoever
/// calls it then gets an Error.
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
