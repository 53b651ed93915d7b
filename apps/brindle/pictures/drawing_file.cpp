#include "pictures/drawing_file.h"

#include "brindle/base/file_names.h"

#ifdef BRINDLE_HAS_CAIRO
#include <memory>
#include <string>

#include <cairo-pdf.h>

#include "brindle/base/output_file.h"
#include "brindle/error.h"
#endif

namespace brindle::tool {
namespace {

bool is_pdf(const std::filesystem::path& path) { return lower_extension(path) == ".pdf"; }

#ifdef BRINDLE_HAS_CAIRO

constexpr double kPointsPerInch = 72;
constexpr double kPointsPerPixel = kPointsPerInch / kDrawingDpi;

using CairoSurface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Cairo = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

/// Buffered in memory: exceptions of file streams must not pass through Cairo.
cairo_status_t add_bytes(void* bytes, const unsigned char* more, unsigned int count) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(more), count);
  return CAIRO_STATUS_SUCCESS;
}

void add_path(cairo_t* cairo, const Pen& pen, const Stroke& stroke) {
  const auto x = [&](std::size_t i) { return static_cast<double>(stroke[i].x()); };
  const auto y = [&](std::size_t i) { return static_cast<double>(stroke[i].y()); };
  if (stroke.empty()) return;
  cairo_move_to(cairo, x(0), y(0));
  if (pen.curved) {
    for (std::size_t i = 1; i + 2 < stroke.size(); i += 3) {
      cairo_curve_to(cairo, x(i), y(i), x(i + 1), y(i + 1), x(i + 2), y(i + 2));
    }
  } else {
    for (std::size_t i = 1; i < stroke.size(); ++i) cairo_line_to(cairo, x(i), y(i));
  }
  if (pen.filled) cairo_close_path(cairo);
}

void draw_pen(cairo_t* cairo, const Pen& pen, const Progress& progress) {
  constexpr std::size_t kPerReport = 256;
  cairo_set_source_rgb(cairo, static_cast<double>(pen.color.red),
                       static_cast<double>(pen.color.green), static_cast<double>(pen.color.blue));
  cairo_set_line_width(cairo, static_cast<double>(pen.width));
  for (std::size_t i = 0; i < pen.strokes.size(); ++i) {
    if (i % kPerReport == 0) {
      progress.report(static_cast<double>(i) / static_cast<double>(pen.strokes.size()));
    }
    add_path(cairo, pen, pen.strokes[i]);
    if (!pen.filled) cairo_stroke(cairo);
  }
  if (pen.filled) cairo_fill(cairo);
}

std::string pdf_of(const PaperSize& paper, std::span<const Pen> pens, const Progress& progress) {
  constexpr double kPointsPerMillimetre = kPointsPerInch / kMillimetresPerInch;
  std::string bytes;
  const CairoSurface surface(
      cairo_pdf_surface_create_for_stream(add_bytes, &bytes, kPointsPerMillimetre * paper.width,
                                          kPointsPerMillimetre * paper.height),
      cairo_surface_destroy);
  // Without a date, the same drawing always gives the same file.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  {
    const Cairo cairo(cairo_create(surface.get()), cairo_destroy);
    cairo_scale(cairo.get(), kPointsPerPixel, kPointsPerPixel);
    cairo_set_fill_rule(cairo.get(), CAIRO_FILL_RULE_EVEN_ODD);
    cairo_set_line_cap(cairo.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo.get(), CAIRO_LINE_JOIN_ROUND);
    const auto count = static_cast<double>(pens.size());
    for (std::size_t i = 0; i < pens.size(); ++i) {
      const auto done = static_cast<double>(i);
      draw_pen(cairo.get(), pens[i], progress.part(done / count, (done + 1) / count));
    }
  }
  cairo_surface_finish(surface.get());
  const cairo_status_t status = cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS) {
    throw Error(std::string("Cairo cannot make a PDF of the drawing: ") +
                cairo_status_to_string(status));
  }
  return bytes;
}

void write_pdf(const std::filesystem::path& path, const PaperSize& paper, std::span<const Pen> pens,
               const Progress& progress) {
  const std::string bytes = pdf_of(paper, pens, progress.part(0, 0.5));
  write_file(
      path, [&](OutputStream& out) { out << bytes; }, progress.part(0.5, 1));
}

#endif

}  // namespace

bool is_drawing_file(const std::filesystem::path& path) {
  return lower_extension(path) == ".svg" || is_pdf(path);
}

std::string drawing_refusal([[maybe_unused]] const std::filesystem::path& path) {
#ifndef BRINDLE_HAS_CAIRO
  if (is_pdf(path)) {
    return "this build writes no .pdf; write .svg, or install Cairo (libcairo2-dev) and configure "
           "with -DBRINDLE_CAIRO=ON";
  }
#endif
  return "";
}

void write_drawing(const std::filesystem::path& path, int width, int height,
                   std::span<const Pen> pens, const std::optional<PaperSize>& paper,
                   const Progress& progress) {
#ifdef BRINDLE_HAS_CAIRO
  constexpr double kPixel = kMillimetresPerInch / kDrawingDpi;
  const PaperSize page = paper.value_or(PaperSize{kPixel * width, kPixel * height});
  if (is_pdf(path)) return write_pdf(path, page, pens, progress);
#endif
  write_svg(path, width, height, pens, progress, paper);
}

}  // namespace brindle::tool
