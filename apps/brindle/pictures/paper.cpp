#include "pictures/paper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/error.h"
#include "brindle/image.h"
#include "cli/command_line.h"
#include "cli/option_values.h"
#include "pictures/picture.h"

namespace brindle::tool {
namespace {

void check_pixels(const std::string& option, int width, int height) {
  try {
    check_image_size(width, height);
  } catch (const Error& error) {
    throw CLI::ValidationError(option, error.what());
  }
}

/// Returns false for text that is no size in pixels.
bool set_pixels(RenderOptions& render, const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = split(text, 'x');
  const auto width = number_in<int>(parts.front());
  const auto height = number_in<int>(parts.back());
  if (parts.size() != 2 || !width || !height) return false;
  check_pixels(option, *width, *height);
  render.width = *width;
  render.height = *height;
  return true;
}

/// Of "297mm", "29.7cm" or "11in".
std::optional<double> millimetres(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, double>, 3> kUnits = {
      {{"mm", 1}, {"cm", 10}, {"in", kMillimetresPerInch}}};
  for (const auto& [unit, size] : kUnits) {
    if (!text.ends_with(unit)) continue;
    const auto number = number_in<double>(text.substr(0, text.size() - unit.size()));
    if (number && *number > 0) return *number * size;
  }
  return std::nullopt;
}

std::optional<PaperSize> paper_size(const std::string& text) {
  const std::vector<std::string> parts = split(text, 'x');
  const auto width = millimetres(parts.front());
  const auto height = millimetres(parts.back());
  if (parts.size() != 2 || !width || !height) return std::nullopt;
  return PaperSize{*width, *height};
}

/// Pixels per inch of paper.
double resolution_of(const PictureOptions& options) {
  return options.dpi > 0 ? options.dpi : kDrawingDpi;
}

/// Pixels of a side; large numbers are rejected later.
int pixels_of(double side, const PictureOptions& options) {
  constexpr double kMost = 1e6;
  const double pixels = side * resolution_of(options) / kMillimetresPerInch;
  return static_cast<int>(std::lround(std::min(pixels, kMost)));
}

}  // namespace

void set_pixel_size(RenderOptions& render, const std::string& option, const std::string& text) {
  if (!set_pixels(render, option, text)) wrong_usage(option, "WIDTHxHEIGHT in pixels", text);
}

void set_size(const CLI::App& command, PictureOptions& options, const std::string& option,
              const std::string& text) {
  if (command.get_option_no_throw("--dpi") == nullptr) {
    return set_pixel_size(options.render, option, text);
  }
  options.paper = paper_size(text);
  if (options.paper || set_pixels(options.render, option, text)) return;
  wrong_usage(option, "WIDTHxHEIGHT in pixels, or both in mm, cm or in such as 297mmx210mm", text);
}

float parse_scale(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = split(text, ':');
  const auto paper = number_in<float>(parts.front());
  const auto units = number_in<float>(parts.back());
  const bool positive = paper && units && *paper > 0 && *units > 0;
  const float scale = positive ? *paper / *units : 0;
  if (parts.size() != 2 || !std::isfinite(scale) || !(scale > 0)) {
    wrong_usage(option, "MM:UNITS such as 1:1, 1:2 or 25.4:1, both above zero", text);
  }
  return scale;
}

void set_paper(RenderOptions& render, const PictureOptions& options) {
  if (options.paper) {
    render.width = pixels_of(options.paper->width, options);
    render.height = pixels_of(options.paper->height, options);
  }
  if (!options.scale) return;
  const double pixel = kMillimetresPerInch / resolution_of(options);
  render.camera.visible_height =
      static_cast<float>(render.height * pixel / static_cast<double>(*options.scale));
}

void check_paper_options(const CLI::App& command, const PictureOptions& options, bool pictures,
                         bool drawings) {
  const auto refuse = [](const char* option, const char* why) {
    throw CLI::ValidationError(option, why);
  };
  if (options.scale && options.projection != Projection::orthographic) {
    refuse("--scale", "a picture in perspective has no scale; add ',orthographic' to --camera");
  }
  if (options.scale && options.render.camera.zoom != 1) {
    refuse("--scale", "the zoom of --camera gives another scale; leave out one of them");
  }
  if (!pictures) {
    refuse_given(command, {"--dpi"}, "it is for pixels; add --output FILE.png");
  } else if (options.paper || options.scale) {
    const char* option = options.paper ? "--size" : "--scale";
    if (options.dpi == 0) refuse(option, "a .png has pixels; add --dpi, such as --dpi 300");
    if (drawings && options.dpi != kDrawingDpi) {
      refuse("--dpi", "a drawing has 96 pixels an inch; write the .png by a command of its own");
    }
  }
  if (!options.paper) return;
  check_pixels("--size", pixels_of(options.paper->width, options),
               pixels_of(options.paper->height, options));
}

}  // namespace brindle::tool
