/// Pictures, their colours and their PNG files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "brindle/export.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// An sRGB colour, each channel from 0 to 1.
struct Color {
  float red = 0;
  float green = 0;
  float blue = 0;

  bool operator==(const Color&) const = default;
};

/// The colour's light, in which mixing and shading are done.
Vec3 linear_light(const Color& color);

/// A colour map for errors: from pale sand (0) through orange and red to dark violet (1). Lightness
/// falls evenly (Oklab, Ottosson 2020), so equal steps look equal, in grey and to colour-blind eyes
/// too. Values outside 0 .. 1 are clamped.
Color error_color(float value);

/// The longest side and the largest area, in pixels, of a picture that is read, drawn or written.
inline constexpr int kMaxImageSide = 32768;
inline constexpr std::int64_t kMaxImagePixels = std::int64_t{1} << 28;

/// Red, green, blue and alpha of a pixel: sRGB values, alpha not multiplied in.
struct Pixel {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  std::uint8_t alpha = 255;

  bool operator==(const Pixel&) const = default;
};

/// `width` x `height` pixels, row by row from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Pixel> pixels;

  Image() = default;
  /// All pixels black and opaque.
  /// Throws Error if a side is not above zero or the picture is beyond the limits above.
  Image(int width, int height);

  Pixel& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
  const Pixel& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

/// Throws Error, naming the size and the limit, unless a picture of this size is within the limits.
void check_image_size(std::int64_t width, std::int64_t height);

/// The content of a PNG file: with an alpha channel only if a pixel is not opaque.
/// Throws Error if the picture is empty or its pixels do not match its size, and Cancelled if
/// `progress` asks for it: how large a file will be is not known, so that the fraction nears 1 ever
/// more slowly. `pixels_per_inch` is written as pixels a metre, which is how large the picture is
/// on paper; 0: the file says nothing of it. Throws Error, too, unless it is from 0 to a million.
std::string png_of(const Image& image, const Progress& progress = {}, double pixels_per_inch = 0);

/// Writes a PNG file: with an alpha channel only if a pixel is not opaque.
/// Throws Error if the file is not named .png, if the picture is empty or its pixels do not match
/// its size, and what `write_file` throws; Cancelled if `progress` asks for it.
void write_png(const std::filesystem::path& path, const Image& image, const Progress& progress = {},
               double pixels_per_inch = 0);

/// Reads any PNG file and converts it to 8 bits a channel.
/// Throws Error, naming the file and the reason, if it cannot be read, is no PNG file, is cut off
/// or is beyond the limits above.
Image read_png(const std::filesystem::path& path);

}  // namespace brindle
