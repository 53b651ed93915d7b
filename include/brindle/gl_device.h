/// The device that OpenGL runs on.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "brindle/export.h"

namespace BRINDLE_EXPORT brindle {

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

}  // namespace brindle
