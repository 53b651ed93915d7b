#include "brindle/image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <png.h>

#include "brindle/base/checksum.h"
#include "brindle/base/file_names.h"
#include "brindle/base/input_file.h"
#include "brindle/base/output_file.h"
#include "brindle/base/parallel.h"
#include "brindle/base/text.h"
#include "brindle/error.h"

namespace brindle {
namespace {

static_assert(sizeof(Pixel) == 4 && std::is_standard_layout_v<Pixel>);

/// libpng's simplified interface: failures are return values, not longjmp.
struct PngSession {
  png_image image{};
  PngSession() { image.version = PNG_IMAGE_VERSION; }
  ~PngSession() { png_image_free(&image); }
  PngSession(const PngSession&) = delete;
  PngSession& operator=(const PngSession&) = delete;
};

[[noreturn]] void fail_to_read(const std::filesystem::path& path, const std::string& reason) {
  throw Error("cannot read '" + shown(path.string()) + "': " + reason +
              "; give a complete PNG file");
}

constexpr std::size_t kPixelsPerReport = 1 << 21;

std::vector<std::uint8_t> packed_rows(const Image& image, bool with_alpha,
                                      const Progress& progress) {
  std::vector<std::uint8_t> rows(image.pixels.size() * (with_alpha ? 4 : 3));
  std::uint8_t* next = rows.data();
  const auto pack = [&](std::size_t p) {
    const Pixel& pixel = image.pixels[p];
    *next++ = pixel.red;
    *next++ = pixel.green;
    *next++ = pixel.blue;
    if (with_alpha) *next++ = pixel.alpha;
  };
  reported_for(image.pixels.size(), progress, pack, kPixelsPerReport);
  return rows;
}

/// A file in memory that libpng writes in parts. It can stop in between without an exception
/// through C code.
class HeardFile {
 public:
  HeardFile(std::size_t expected, const Progress& progress)
      : expected_(static_cast<double>(expected)), progress_(progress) {}

  /// False to stop.
  bool append(const char* bytes, std::size_t count) {
    content_.append(bytes, count);
    try {
      const double done = static_cast<double>(content_.size()) / expected_;
      progress_.report(done / (1 + done));
    } catch (...) {
      thrown_ = std::current_exception();
    }
    return !thrown_;
  }

  std::string take() {
    if (thrown_) std::rethrow_exception(thrown_);
    return std::move(content_);
  }

 private:
  double expected_;
  const Progress& progress_;
  std::string content_;
  std::exception_ptr thrown_;
};

/// Packed rows as a PNG file. Written in one go if the C library has no custom streams.
std::string compressed(PngSession& png, const std::vector<std::uint8_t>& rows,
                       const Progress& progress) {
#ifdef __GLIBC__
  HeardFile file(rows.size() / 8, progress);
  cookie_io_functions_t functions{};
  functions.write = [](void* cookie, const char* bytes, std::size_t count) -> ssize_t {
    return static_cast<HeardFile*>(cookie)->append(bytes, count) ? static_cast<ssize_t>(count) : 0;
  };
  std::FILE* stream = fopencookie(&file, "w", functions);
  if (stream == nullptr) throw Error("there is no memory for a picture's file");
  const int written = png_image_write_to_stdio(&png.image, stream, 0, rows.data(), 0, nullptr);
  const int closed = std::fclose(stream);
  std::string content = file.take();
  if (!written) throw Error(png.image.message);
  if (closed != 0) throw Error("there is no memory for a picture's file");
  return content;
#else
  progress.report(0);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png.image);
  std::string file(size, '\0');
  if (!png_image_write_to_memory(&png.image, file.data(), &size, 0, rows.data(), 0, nullptr)) {
    throw Error(png.image.message);
  }
  file.resize(size);
  return file;
#endif
}

void append_number(std::uint32_t number, std::string& bytes) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
}

/// Adds the pHYs chunk (pixels per metre) after the header; libpng's simplified interface cannot
/// write it.
void set_density(double pixels_per_inch, std::string& file) {
  constexpr std::size_t kHeaderEnd = 8 + 25;  // signature and IHDR
  constexpr double kInchesPerMetre = 1 / 0.0254;
  const auto density = static_cast<std::uint32_t>(std::lround(pixels_per_inch * kInchesPerMetre));
  std::string content = "pHYs";
  append_number(density, content);
  append_number(density, content);
  content += '\1';  // the unit is the metre
  std::string chunk;
  append_number(static_cast<std::uint32_t>(content.size() - 4), chunk);
  chunk += content;
  append_number(crc32_of(content), chunk);
  file.insert(kHeaderEnd, chunk);
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

std::string png_of(const Image& image, const Progress& heard, double pixels_per_inch) {
  check_image_size(image.width, image.height);
  if (image.pixels.size() != static_cast<std::size_t>(image.width) * image.height) {
    throw Error("the picture's pixels do not match its size");
  }
  if (!(pixels_per_inch >= 0 && pixels_per_inch <= 1e6)) {
    throw Error("a picture has 0 to 1000000 pixels an inch, not " +
                std::to_string(pixels_per_inch));
  }
  const bool with_alpha = std::any_of(image.pixels.begin(), image.pixels.end(),
                                      [](const Pixel& pixel) { return pixel.alpha != 255; });
  JobStages stages(heard, {{"picture file", 1}});
  const Progress progress = stages.begin("picture file");
  const std::vector<std::uint8_t> rows = packed_rows(image, with_alpha, progress.part(0, 0.2));
  PngSession png;
  png.image.width = static_cast<png_uint_32>(image.width);
  png.image.height = static_cast<png_uint_32>(image.height);
  png.image.format = with_alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  // Filters would spread the dithered rounding of flat stripes. Without them, files are smaller and
  // written seven times as fast.
  png.image.flags |= PNG_IMAGE_FLAG_FAST;
  std::string file = compressed(png, rows, progress.part(0.2, 1));
  if (pixels_per_inch > 0) set_density(pixels_per_inch, file);
  stages.finish();
  return file;
}

void write_png(const std::filesystem::path& path, const Image& image, const Progress& progress,
               double pixels_per_inch) {
  if (lower_extension(path) != ".png") {
    throw Error("cannot write '" + path.string() + "': this is a PNG file; name it .png");
  }
  std::string file;
  try {
    file = png_of(image, progress, pixels_per_inch);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    throw Error("cannot write '" + shown(path.string()) + "': " + error.what());
  }
  write_file(path, [&](OutputStream& out) { out << file; });
}

Image read_png(const std::filesystem::path& path) {
  const std::string bytes = whole_input(path, "a PNG file");
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
