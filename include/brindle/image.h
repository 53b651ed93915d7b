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

/// The colour in linear light, for mixing and shading.
Vec3 linear_light(const Color& color);

/// A colour map for errors: from pale sand (0) through orange and red to dark violet (1). Lightness
/// falls evenly (Oklab, Ottosson 2020), so equal steps look equal, also in grey and to colour-blind
/// readers. Values are clamped to 0 .. 1.
Color error_color(float value);

/// The largest side and area, in pixels, of a picture that is read, drawn or written.
inline constexpr int kMaxImageSide = 32768;
inline constexpr std::int64_t kMaxImagePixels = std::int64_t{1} << 28;

/// A pixel in sRGB, not premultiplied by alpha.
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
  /// An opaque black picture. Throws Error if a side is not above zero or the picture is beyond the
  /// limits above.
  Image(int width, int height);

  Pixel& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
  const Pixel& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

/// Throws Error, naming the size and the limit, unless the size is within the limits.
void check_image_size(std::int64_t width, std::int64_t height);

/// The content of a PNG file, with an alpha channel only if a pixel is not opaque.
/// `pixels_per_inch`, 0 to a million, sets the size on paper and is stored as pixels per metre; 0:
/// not stored. Throws Error if it is out of range, if the picture is empty or its pixels do not
/// match its size. Throws Cancelled if `progress` cancels. The file's size is unknown, so the
/// fraction nears 1 ever more slowly.
std::string png_of(const Image& image, const Progress& progress = {}, double pixels_per_inch = 0);

/// Writes a PNG file, as in `png_of`. Throws Error if the file is not named .png, if the picture is
/// empty or its pixels do not match its size, and what `write_file` throws; Cancelled if `progress`
/// cancels.
void write_png(const std::filesystem::path& path, const Image& image, const Progress& progress = {},
               double pixels_per_inch = 0);

/// Reads any PNG file and converts it to 8 bits a channel. Throws Error, naming the file and the
/// reason, if it cannot be read, is no PNG file, is cut off or is beyond the limits above.
Image read_png(const std::filesystem::path& path);

// Colour maps for values.

/// Perceptually uniform maps, also for colour-blind readers. The first three grow lighter from the
/// lowest value to the highest (van der Walt and Smith 2015; Nuñez et al. 2018); coolwarm is
/// lightest in the middle (Moreland 2009).
enum class ColorMap { viridis, magma, cividis, coolwarm };

/// The colour at `place`, 0 (lowest) to 1 (highest). Other places are clamped; NaN gives the lowest
/// colour.
Color map_color(ColorMap map, float place);

}  // namespace brindle
