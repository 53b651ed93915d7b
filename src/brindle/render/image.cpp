#include "brindle/image.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>
#include <type_traits>

#include <png.h>

#include "brindle/base/output_file.h"
#include "brindle/error.h"

namespace brindle {
namespace {

static_assert(sizeof(Pixel) == 4 && std::is_standard_layout_v<Pixel>);

/// libpng's simplified interface, which reports failures instead of jumping out of them.
struct PngSession {
  png_image image{};
  PngSession() { image.version = PNG_IMAGE_VERSION; }
  ~PngSession() { png_image_free(&image); }
  PngSession(const PngSession&) = delete;
  PngSession& operator=(const PngSession&) = delete;
};

[[noreturn]] void fail_to_read(const std::filesystem::path& path, const std::string& reason) {
  throw Error("cannot read '" + path.string() + "': " + reason + "; give a complete PNG file");
}

std::vector<char> bytes_of(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) fail_to_read(path, "it is a folder");
  std::ifstream in(path, std::ios::binary);
  if (!in) fail_to_read(path, "it does not exist or may not be read");
  std::vector<char> bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (in.bad()) fail_to_read(path, "reading failed");
  return bytes;
}

std::vector<std::uint8_t> packed_rows(const Image& image, bool with_alpha) {
  std::vector<std::uint8_t> rows(image.pixels.size() * (with_alpha ? 4 : 3));
  std::uint8_t* next = rows.data();
  for (const Pixel& pixel : image.pixels) {
    *next++ = pixel.red;
    *next++ = pixel.green;
    *next++ = pixel.blue;
    if (with_alpha) *next++ = pixel.alpha;
  }
  return rows;
}

}  // namespace

void check_image_size(std::int64_t width, std::int64_t height) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height);
  if (width < 1 || height < 1) {
    throw Error("a picture of " + size + " pixels is empty; both sides must be at least 1");
  }
  if (width > kMaxImageSide || height > kMaxImageSide || width * height > kMaxImagePixels) {
    throw Error("a picture of " + size + " pixels is too large; the limit is " +
                std::to_string(kMaxImageSide) + " a side and " + std::to_string(kMaxImagePixels) +
                " in all");
  }
}

Image::Image(int image_width, int image_height) : width(image_width), height(image_height) {
  check_image_size(width, height);
  pixels.resize(static_cast<std::size_t>(width) * height);
}

std::string png_of(const Image& image) {
  check_image_size(image.width, image.height);
  if (image.pixels.size() != static_cast<std::size_t>(image.width) * image.height) {
    throw Error("the picture's pixels do not match its size");
  }
  const bool with_alpha = std::any_of(image.pixels.begin(), image.pixels.end(),
                                      [](const Pixel& pixel) { return pixel.alpha != 255; });
  const std::vector<std::uint8_t> rows = packed_rows(image, with_alpha);
  PngSession png;
  png.image.width = static_cast<png_uint_32>(image.width);
  png.image.height = static_cast<png_uint_32>(image.height);
  png.image.format = with_alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  // No filters: stripes are flat but for the dithered rounding, which filters would spread. Files
  // are smaller, and written seven times as fast.
  png.image.flags |= PNG_IMAGE_FLAG_FAST;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png.image);
  std::string file(size, '\0');
  if (!png_image_write_to_memory(&png.image, file.data(), &size, 0, rows.data(), 0, nullptr)) {
    throw Error(png.image.message);
  }
  file.resize(size);
  return file;
}

void write_png(const std::filesystem::path& path, const Image& image) {
  std::string file;
  try {
    file = png_of(image);
  } catch (const Error& error) {
    throw Error("cannot write '" + path.string() + "': " + error.what());
  }
  write_file(path, [&](std::ostream& out) { out << file; });
}

Image read_png(const std::filesystem::path& path) {
  const std::vector<char> bytes = bytes_of(path);
  PngSession png;
  if (!png_image_begin_read_from_memory(&png.image, bytes.data(), bytes.size())) {
    fail_to_read(path, png.image.message);
  }
  png.image.format = PNG_FORMAT_RGBA;
  try {
    check_image_size(png.image.width, png.image.height);
  } catch (const Error& error) {
    fail_to_read(path, error.what());
  }
  Image image(static_cast<int>(png.image.width), static_cast<int>(png.image.height));
  if (!png_image_finish_read(&png.image, nullptr, image.pixels.data(), 0, nullptr)) {
    fail_to_read(path, png.image.message);
  }
  return image;
}

}  // namespace brindle
