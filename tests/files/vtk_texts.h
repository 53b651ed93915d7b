/// VTK files in all encodings, as texts, for tests.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#ifdef BRINDLE_HAS_VTK
#include <zlib.h>
#endif

#include "brindle/base/array_numbers.h"
#include "brindle/data_arrays.h"

namespace brindle {

template <class Number>
std::string bytes_of(Number number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

inline std::string base64_of(const std::string& bytes) {
  constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t b = 0; b < 3; ++b) {
      group = group << 8 | (b < count ? static_cast<unsigned char>(bytes[i + b]) : 0u);
    }
    for (std::size_t l = 0; l < 4; ++l) {
      text += l <= count ? kLetters[group >> (18 - 6 * l) & 63] : '=';
    }
  }
  return text;
}

/// The numbers of an array, in the byte order of the machine or the other.
inline std::string raw_numbers(const DataArray& array, bool big_endian) {
  std::string bytes(reinterpret_cast<const char*>(array.bytes.data()), array.bytes.size());
  const auto size = static_cast<std::ptrdiff_t>(size_of(array.type));
  for (auto at = bytes.begin(); big_endian && at != bytes.end(); at += size) {
    std::reverse(at, at + size);
  }
  return bytes;
}

inline std::string numbers_as_text(const DataArray& array) {
  std::ostringstream text;
  text.precision(17);
  for_each_number(array.view(), [&](std::size_t, std::size_t column, auto number) {
    text << +number << (column + 1 == static_cast<std::size_t>(array.components) ? '\n' : ' ');
  });
  return text.str();
}

struct VtkXmlStyle {
  std::string format = "ascii";  ///< "ascii", "binary", "appended raw", "appended base64"
  bool zlib = false, wide = false, big_endian = false;
};

inline std::vector<VtkXmlStyle> vtk_xml_styles() {
  std::vector<VtkXmlStyle> styles = {{}};
  for (const char* format : {"binary", "appended raw", "appended base64"}) {
    for (const bool zlib : {false, true}) {
      for (const bool wide : {false, true}) {
        for (const bool big : {false, true}) styles.push_back({format, zlib, wide, big});
      }
    }
  }
  return styles;
}

/// Puts a file together, array by array.
class VtkXmlText {
 public:
  explicit VtkXmlText(VtkXmlStyle style) : style_(std::move(style)) {}

  std::string array(const DataArray& array) {
    const bool appended = style_.format.starts_with("appended");
    std::string tag = "<DataArray type=\"" + type_name(array.type) + "\" Name=\"" + array.name +
                      "\" NumberOfComponents=\"" + std::to_string(array.components) +
                      "\" format=\"" + (appended ? "appended" : style_.format) + '"';
    if (appended) {
      tag += " offset=\"" + std::to_string(appended_.size()) + "\"/>\n";
      const std::string raw = block(raw_numbers(array, style_.big_endian));
      appended_ += raw;
      return tag;
    }
    return tag + ">\n" +
           (style_.format == "ascii" ? numbers_as_text(array)
                                     : block(raw_numbers(array, style_.big_endian))) +
           "\n</DataArray>\n";
  }

  std::string arrays(const std::string& element, const std::vector<DataArray>& all) {
    std::string text = "<" + element + ">\n";
    for (const DataArray& one : all) text += array(one);
    return text + "</" + element + ">\n";
  }

  /// The whole file; `pieces` are elements Piece.
  std::string file(const std::string& type, const std::string& pieces) const {
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type +
                       "\" version=\"1.0\" byte_order=\"" +
                       (style_.big_endian ? "BigEndian" : "LittleEndian") + "\" header_type=\"" +
                       (style_.wide ? "UInt64" : "UInt32") + '"';
    if (style_.zlib) text += " compressor=\"vtkZLibDataCompressor\"";
    text += ">\n<" + type + ">\n" + pieces + "</" + type + ">\n";
    if (style_.format.starts_with("appended")) {
      text += "<AppendedData encoding=\"" + style_.format.substr(9) + "\">\n_" + appended_ +
              "\n</AppendedData>\n";
    }
    return text + "</VTKFile>\n";
  }

 private:
  static std::string type_name(NumberType type) {
    std::string name(name_of(type));  // "uint8" is "UInt8"
    name[0] = static_cast<char>(std::toupper(name[0]));
    if (name[0] == 'U') name[1] = 'I';
    return name;
  }

  std::string size_word(std::uint64_t size) const {
    std::string bytes = style_.wide ? bytes_of(size) : bytes_of(static_cast<std::uint32_t>(size));
    if (style_.big_endian) std::reverse(bytes.begin(), bytes.end());
    return bytes;
  }

  std::string encoded(const std::string& bytes) const {
    return style_.format == "appended raw" ? bytes : base64_of(bytes);
  }

  std::string block(const std::string& bytes) const {
    if (!style_.zlib) return encoded(size_word(bytes.size()) + bytes);
#ifdef BRINDLE_HAS_VTK
    constexpr std::size_t kBlock = 64;
    const std::size_t whole = bytes.size() / kBlock, rest = bytes.size() % kBlock;
    std::string header = size_word(whole + (rest > 0)) + size_word(kBlock) + size_word(rest), all;
    for (std::size_t at = 0; at < bytes.size(); at += kBlock) {
      const std::string part = bytes.substr(at, kBlock);
      uLongf size = compressBound(part.size());
      std::string packed(size, '\0');
      compress(reinterpret_cast<Bytef*>(packed.data()), &size,
               reinterpret_cast<const Bytef*>(part.data()), part.size());
      packed.resize(size);
      header += size_word(size);
      all += packed;
    }
    return encoded(header) + encoded(all);
#else
    return {};
#endif
  }

  VtkXmlStyle style_;
  std::string appended_;
};

/// An array of every type, with the smallest and the largest number and, if `nan`, one that is no
/// number.
inline std::vector<DataArray> arrays_of_every_type(std::size_t rows, bool nan = true) {
  std::vector<DataArray> arrays;
  for (int type = 0; type <= static_cast<int>(NumberType::uint64); ++type) {
    const int components = std::vector{1, 3, 2, 9, 6, 1, 3, 1, 1, 4}[type];
    with_number_type(static_cast<NumberType>(type), [&]<class Number>(Number) {
      std::vector<Number> numbers(rows * components);
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        numbers[i] =
            static_cast<Number>(std::is_floating_point_v<Number> ? 1 / (3 + static_cast<double>(i))
                                                                 : static_cast<double>(i));
      }
      numbers[0] = std::numeric_limits<Number>::lowest();
      numbers[1] = std::numeric_limits<Number>::max();
      // 0 of whole numbers.
      if (nan && numbers.size() > 2) numbers[2] = std::numeric_limits<Number>::quiet_NaN();
      arrays.push_back(make_data_array("of " + std::string(name_of(static_cast<NumberType>(type))),
                                       components, numbers));
    });
  }
  return arrays;
}

}  // namespace brindle
