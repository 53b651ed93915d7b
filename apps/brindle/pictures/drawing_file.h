/// Drawing files: .svg, and .pdf with Cairo.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "brindle/line_drawing.h"

namespace brindle::tool {

/// Whether a file of this name is a drawing (vector graphics).
bool is_drawing_file(const std::filesystem::path& path);

/// The reason why this build cannot write a drawing of this name (.pdf without Cairo); else empty.
std::string drawing_refusal(const std::filesystem::path& path);

/// Writes pens to an .svg or a .pdf at `kDrawingDpi`, atomically, as `write_svg` does.
void write_drawing(const std::filesystem::path& path, int width, int height,
                   std::span<const Pen> pens, const std::optional<PaperSize>& paper,
                   const Progress& progress = {});

}  // namespace brindle::tool
