/// What a VTP file of Brindle's holds, for tests.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace brindle {

struct WrittenVtp {
  std::string text;

  /// The tag of an array in a section of the file, `element`; the name as XML has it.
  std::string tag(const std::string& element, const std::string& name) const {
    const std::size_t section = text.find("<" + element);
    const std::size_t end = text.find("</" + element, section);
    const std::size_t at = text.find("Name=\"" + name + "\"", section);
    if (at >= end) return "";
    const std::size_t begin = text.rfind('<', at);
    return text.substr(begin, text.find("/>", at) - begin);
  }

  /// The bytes of an array, found as a reader finds them: by its offset.
  std::string bytes(const std::string& element, const std::string& name) const {
    const std::string found = tag(element, name);
    if (found.empty()) throw std::runtime_error("no array " + name + " in " + element);
    const std::size_t offset = std::stoul(found.substr(found.find("offset=\"") + 8));
    const std::size_t begin = text.find("<AppendedData encoding=\"raw\">\n_") + 31;
    std::uint64_t size = 0;
    std::memcpy(&size, text.data() + begin + offset, sizeof size);
    return text.substr(begin + offset + sizeof size, size);
  }

  template <class Number>
  std::vector<Number> array(const std::string& element, const std::string& name) const {
    const std::string block = bytes(element, name);
    std::vector<Number> numbers(block.size() / sizeof(Number));
    if (!numbers.empty()) std::memcpy(numbers.data(), block.data(), block.size());
    return numbers;
  }
};

}  // namespace brindle
