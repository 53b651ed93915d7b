/// Arrays of VTK's XML files in all encodings. Only in builds with BRINDLE_VTK.
#pragma once

#ifdef BRINDLE_HAS_VTK

#include <cstdint>
#include <string>
#include <vector>

#include <pugixml.hpp>

#include "brindle/base/input_file.h"
#include "brindle/data_arrays.h"

namespace brindle {

/// The encoding of a file's arrays.
struct VtkXmlEncoding {
  bool foreign_order = false;  ///< the byte order is not that of this machine
  bool wide_sizes = false;     ///< sizes of blocks are UInt64 instead of UInt32
  bool zlib = false;           ///< blocks are compressed
  /// The position of the data appended to the XML, or 0; and whether they are base64.
  std::uint64_t appended = 0;
  bool appended_base64 = false;
};

/// An element's attribute as an integer from 0 to 2^53; `standard` if it is missing. Throws Error
/// for anything else.
std::uint64_t vtk_number(const InputFile& file, const pugi::xml_node& element, const char* name,
                         std::uint64_t standard = 0);

class VtkXmlArrays {
 public:
  /// `file` must outlive this object.
  VtkXmlArrays(InputFile& file, const VtkXmlEncoding& encoding);

  /// Whether an array is numeric, neither text nor bits.
  static bool holds_numbers(const pugi::xml_node& element);

  /// The array in the file's type. Throws Error with the array's name if it is damaged or truncated
  /// or has not `rows` rows, before it allocates more memory than the file can fill.
  DataArray read(const pugi::xml_node& element, std::uint64_t rows);

 private:
  class Bytes;
  class FileBytes;
  class LetterBytes;

  [[noreturn]] void fail(const std::string& what) const;
  std::vector<std::byte> decode(const pugi::xml_node& element, NumberType type,
                                std::uint64_t count);
  std::vector<std::byte> decode_appended(const pugi::xml_node& element, std::uint64_t size);
  std::vector<std::byte> decode_block(Bytes& bytes, std::uint64_t size);
  std::vector<std::byte> inflate_blocks(Bytes& bytes, std::uint64_t size);
  std::uint64_t read_size(Bytes& bytes) const;
  /// Takes bytes from the budget. Throws if the budget or `bytes` has too few.
  void take_from_budget(const Bytes& bytes, std::uint64_t size);

  InputFile& file_;
  VtkXmlEncoding encoding_;
  std::string appended_letters_;  ///< data appended as base64
  std::uint64_t budget_;          ///< bytes of the file that arrays may still use
  std::string name_;              ///< of the current array, for messages
};

}  // namespace brindle

#endif  // BRINDLE_HAS_VTK
