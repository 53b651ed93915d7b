/// Text as XML has it.
#pragma once

#include <string>
#include <string_view>

namespace brindle {

/// The text as part of an XML document, also as the value of an attribute in double quotes.
inline std::string xml_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

}  // namespace brindle
