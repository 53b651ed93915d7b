#include "brindle/files/gltf/percent_decoded.h"

namespace brindle {
namespace {

int hexadecimal(char letter) {
  if (letter >= '0' && letter <= '9') return letter - '0';
  if (letter >= 'a' && letter <= 'f') return letter - 'a' + 10;
  if (letter >= 'A' && letter <= 'F') return letter - 'A' + 10;
  return -1;
}

}  // namespace

std::string percent_decoded(std::string_view name) {
  std::string decoded;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool escape = name[i] == '%' && i + 2 < name.size() && hexadecimal(name[i + 1]) >= 0 &&
                        hexadecimal(name[i + 2]) >= 0;
    if (escape) {
      decoded.push_back(
          static_cast<char>(16 * hexadecimal(name[i + 1]) + hexadecimal(name[i + 2])));
      i += 2;
    } else {
      decoded.push_back(name[i]);
    }
  }
  return decoded;
}

}  // namespace brindle
