#include "frame_output.h"

#include <cctype>
#include <optional>

#include "brindle/base/output_file.h"
#include "option_values.h"
#include "video_file.h"

namespace brindle::tool {
namespace {

constexpr const char* kExpected =
    "a name.mp4, or a PNG name with one number in it such as frames/%04d.png";

// "d", "4d", "04d": the number's digits, and how long the text is.
struct Conversion {
  int digits = 0;
  std::size_t length = 0;
};

std::optional<Conversion> conversion_at(const std::string& name, std::size_t at) {
  Conversion result;
  while (at + result.length < name.size() &&
         std::isdigit(static_cast<unsigned char>(name[at + result.length])) != 0) {
    result.digits = 10 * result.digits + (name[at + result.length++] - '0');
    if (result.digits > 20) return std::nullopt;
  }
  const bool filled_with_zeros = result.length == 0 || name[at] == '0';
  if (!filled_with_zeros || at + result.length >= name.size()) return std::nullopt;
  if (name[at + result.length++] != 'd') return std::nullopt;
  return result;
}

// Splits the name at its number; nothing if it has not exactly one.
bool split_name(const std::string& name, FrameOutput& output) {
  bool has_number = false;
  for (std::size_t at = 0; at < name.size(); ++at) {
    std::string& text = has_number ? output.after : output.before;
    if (name[at] != '%') {
      text += name[at];
    } else if (at + 1 < name.size() && name[at + 1] == '%') {
      text += name[at++];
    } else {
      const auto conversion = conversion_at(name, at + 1);
      if (!conversion || has_number) return false;
      has_number = true;
      output.digits = conversion->digits;
      at += conversion->length;
    }
  }
  return has_number;
}

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

FrameOutput parse_frame_output(const std::string& option, const std::string& text) {
  const std::filesystem::path path(text);
  const std::string extension = lower(path.extension().string());
  FrameOutput output;
  if (extension == ".mp4") {
    output.video = path;
    return output;
  }
  output.folder = path.parent_path();
  if (extension != ".png" || !split_name(path.filename().string(), output) ||
      output.folder.string().find('%') != std::string::npos) {
    wrong_usage(option, kExpected, text);
  }
  return output;
}

std::filesystem::path picture_path(const FrameOutput& output, int number) {
  std::string digits = std::to_string(number);
  const auto wanted = static_cast<std::size_t>(output.digits);
  if (digits.size() < wanted) digits.insert(0, wanted - digits.size(), '0');
  return output.folder / (output.before + digits + output.after);
}

std::vector<std::filesystem::path> frame_files(const FrameOutput& output, int frames) {
  if (output.is_video()) return {output.video};
  std::vector<std::filesystem::path> files;
  for (int number = 0; number < frames; ++number) files.push_back(picture_path(output, number));
  return files;
}

void check_frame_output(const FrameOutput& output) {
  check_output_path(output.is_video() ? output.video : picture_path(output, 0));
  if (output.is_video()) check_video_available(output.video);
}

}  // namespace brindle::tool
