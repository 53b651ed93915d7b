/// What OpenGL runs on.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "brindle/export.h"

namespace BRINDLE_EXPORT brindle {

struct GlDevice {
  std::string renderer;  ///< e.g. "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string vendor;
  std::string version;  ///< of OpenGL and the driver, e.g. "4.5 (Core Profile) Mesa 22.3.6"
  /// The limits that decide which meshes and pictures fit, by OpenGL's names for them in lower
  /// case, such as "max_shader_storage_block_size".
  std::vector<std::pair<std::string, std::int64_t>> limits;
};

/// The device of the current context.
GlDevice gl_device();

/// "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 (Core Profile) Mesa 22.3.6"
std::string describe(const GlDevice& device);

}  // namespace brindle
