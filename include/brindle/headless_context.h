/// OpenGL without a window.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/export.h"

namespace BRINDLE_EXPORT brindle {

// The device that OpenGL runs on.

/// A device with its driver and limits.
struct GlDevice {
  std::string renderer;  ///< e.g. "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string vendor;
  std::string version;  ///< of OpenGL and the driver, e.g. "4.5 (Core Profile) Mesa 22.3.6"
  /// Limits on the size of meshes and pictures, by OpenGL's names in lower case, such as
  /// "max_shader_storage_block_size".
  std::vector<std::pair<std::string, std::int64_t>> limits;
};

/// The device of the current context.
GlDevice gl_device();

/// Such as "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 (Core Profile) Mesa 22.3.6".
std::string describe(const GlDevice& device);

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
