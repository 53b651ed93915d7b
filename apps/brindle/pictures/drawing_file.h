/// Files of drawings: .svg, and .pdf where Cairo is.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "brindle/line_drawing.h"

namespace brindle::tool {

/// A pixel of a drawing is a 96th of an inch, as in browsers.
inline constexpr double kDrawingDpi = 96;

/// Whether a file of this name is a drawing: lines and areas, not pixels.
bool is_drawing_file(const std::filesystem::path& path);

/// Why this build cannot write a drawing of this name: a .pdf without Cairo; empty if it can.
std::string drawing_refusal(const std::filesystem::path& path);

/// Writes pens to an .svg or a .pdf, whole or not at all, with as many pixels an inch as above in
/// both. Throws what `write_svg` does.
void write_drawing(const std::filesystem::path& path, int width, int height,
                   std::span<const Pen> pens, const Progress& progress = {});

}  // namespace brindle::tool
