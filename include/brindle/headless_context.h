/// OpenGL without a window.
#pragma once

#include <string>
#include <string_view>

#include "brindle/export.h"

namespace BRINDLE_EXPORT brindle {

/// An OpenGL 4.5 core context on a GPU or, where there is none, on a software renderer. It belongs
/// to the thread that makes it and is current there until destroyed.
class HeadlessContext {
 public:
  /// Tries the GPUs that EGL lists, then Mesa's surfaceless platform, then software devices.
  /// Throws Error, naming everything that was tried and what it answered, if none gives a context.
  HeadlessContext();
  ~HeadlessContext();
  HeadlessContext(HeadlessContext&&) noexcept;
  HeadlessContext& operator=(HeadlessContext&&) noexcept;

  /// Makes the context current again on its thread, after another one was.
  void make_current() const;

  /// What draws, e.g. "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 (Core Profile) Mesa 22.3.6".
  const std::string& renderer() const;

  /// Throws Error with everything that OpenGL has complained of since the last call, prefixed with
  /// `job`; does nothing if there were no errors.
  void check_errors(std::string_view job) const;

 private:
  struct State;
  Pimpl<State> state_;
};

}  // namespace brindle
