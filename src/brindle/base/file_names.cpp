#include "brindle/base/file_names.h"

#include <algorithm>
#include <cctype>

#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/error.h"

namespace brindle {
namespace {

[[noreturn]] void refuse_name(const std::filesystem::path& file, const char* why) {
  throw Error("cannot write '" + shown(file.string()) + "': other files will name it, and " + why +
              "; choose another name");
}

}  // namespace

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void check_name_in_text(const std::filesystem::path& file) {
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  if (ranges::any_of(file.filename().string(), is_control)) {
    refuse_name(file, "a name with control characters would break their lines");
  }
}

void check_name_in_xml(const std::filesystem::path& file) {
  check_name_in_text(file);
  const std::string name = file.filename().string();
  if (utf8_text(name) != name) refuse_name(file, "XML has names in UTF-8 alone");
}

}  // namespace brindle
