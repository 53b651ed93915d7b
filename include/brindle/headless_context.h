/// OpenGL without a window.
#pragma once

#include <string>
#include <string_view>

#include "brindle/export.h"

namespace BRINDLE_EXPORT brindle {

/// An OpenGL 4.5 core context on a GPU or, if there is none, on a software renderer. It belongs to
/// the thread that creates it and is current there until destroyed.
class HeadlessContext {
 public:
  /// Tries the GPUs that EGL lists, then Mesa's surfaceless platform, then software devices. Throws
  /// Error, naming all attempts and their results, if none provides a context.
  HeadlessContext();
  ~HeadlessContext();
  HeadlessContext(HeadlessContext&&) noexcept;
  HeadlessContext& operator=(HeadlessContext&&) noexcept;

  /// Makes the context current again on its thread.
  void make_current() const;

  /// The renderer, e.g. "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 (Core Profile) Mesa 22.3.6".
  const std::string& renderer() const;

  /// Throws Error with all OpenGL errors since the last call, prefixed with `job`, if there are
  /// any.
  void check_errors(std::string_view job) const;

 private:
  struct State;
  Pimpl<State> state_;
};

}  // namespace brindle
