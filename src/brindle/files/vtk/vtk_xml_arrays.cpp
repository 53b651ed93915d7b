#ifdef BRINDLE_HAS_VTK

#include "brindle/files/vtk/vtk_xml_arrays.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include <zlib.h>

#include "brindle/base/base64.h"
#include "brindle/base/parallel.h"
#include "brindle/base/text.h"
#include "brindle/files/binary_numbers.h"
#include "brindle/files/text/text_words.h"
#include "brindle/files/vtk/vtp_file.h"

namespace brindle {
namespace {

/// The largest compression factor of zlib.
constexpr std::uint64_t kMostInflation = 1100;
/// Blocks per task: fewer do not pay for a thread.
constexpr std::size_t kBlockGrain = 8;

std::optional<NumberType> number_type_of(const pugi::xml_node& element) {
  const std::string_view type = element.attribute("type").value();
  for (int kind = 0; kind <= static_cast<int>(NumberType::uint64); ++kind) {
    if (vtk_type(static_cast<NumberType>(kind)) == type) return static_cast<NumberType>(kind);
  }
  return std::nullopt;
}

/// The position of a block among compressed and uncompressed bytes.
struct PackedBlock {
  std::uint64_t begin, size;
  std::uint64_t unpacked_begin, unpacked_size;
};

bool inflate_block(const PackedBlock& block, std::span<const std::byte> packed,
                   std::span<std::byte> unpacked) {
  uLongf size = block.unpacked_size;
  // A block may be empty and start at the end of the bytes.
  const int result =
      uncompress(reinterpret_cast<Bytef*>(unpacked.data() + block.unpacked_begin), &size,
                 reinterpret_cast<const Bytef*>(packed.data() + block.begin), block.size);
  return result == Z_OK && size == block.unpacked_size;
}

}  // namespace

/// A stream of bytes of the file.
class VtkXmlArrays::Bytes {
 public:
  virtual ~Bytes() = default;
  /// An upper bound on the bytes that are left.
  virtual std::uint64_t most_left() const = 0;
  /// False if there are too few.
  virtual bool read(std::span<std::byte> bytes) = 0;
};

class VtkXmlArrays::FileBytes : public Bytes {
 public:
  FileBytes(InputFile& file, std::uint64_t place) : file_(file), place_(place) {}
  std::uint64_t most_left() const override { return file_.size() - place_; }
  bool read(std::span<std::byte> bytes) override {
    if (bytes.size() > most_left()) return false;
    file_.read_at(place_, bytes);
    place_ += bytes.size();
    return true;
  }

 private:
  InputFile& file_;
  std::uint64_t place_;
};

class VtkXmlArrays::LetterBytes : public Bytes {
 public:
  explicit LetterBytes(std::string_view letters) : reader_(letters) {}
  std::uint64_t most_left() const override { return reader_.most_left(); }
  bool read(std::span<std::byte> bytes) override {
    return reader_.read_some(bytes) == bytes.size();
  }

 private:
  Base64Reader reader_;
};

std::uint64_t vtk_number(const InputFile& file, const pugi::xml_node& element, const char* name,
                         std::uint64_t standard) {
  constexpr std::int64_t kMost = std::int64_t{1} << 53;
  const pugi::xml_attribute attribute = element.attribute(name);
  if (!attribute) return standard;
  std::string_view text = attribute.value();
  const auto number = parse_integer(take_word(text));
  if (!number || *number < 0 || *number > kMost) {
    file.fail_whole("says " + in_quotes(attribute.value()) + " for the number " + name +
                    "; the file is damaged, export it again");
  }
  return static_cast<std::uint64_t>(*number);
}

VtkXmlArrays::VtkXmlArrays(InputFile& file, const VtkXmlEncoding& encoding)
    : file_(file), encoding_(encoding), budget_(2 * file.size()) {
  if (!encoding.appended_base64) return;
  appended_letters_.resize(file.size() - encoding.appended);
  file_.read_at(encoding.appended, std::as_writable_bytes(std::span(appended_letters_)));
  appended_letters_.resize(std::min(appended_letters_.size(), appended_letters_.find('<')));
}

bool VtkXmlArrays::holds_numbers(const pugi::xml_node& element) {
  return std::string_view(element.name()) == "DataArray" && number_type_of(element);
}

void VtkXmlArrays::fail(const std::string& what) const {
  file_.fail_whole((name_.empty() ? "an array without a name" : "array " + in_quotes(name_)) + " " +
                   what + "; the file is damaged or truncated, copy or export it again");
}

DataArray VtkXmlArrays::read(const pugi::xml_node& element, std::uint64_t rows) {
  name_ = element.attribute("Name").value();
  const auto type = number_type_of(element);
  if (!type) fail("has numbers of an unknown type");
  const std::uint64_t components =
      std::max<std::uint64_t>(1, vtk_number(file_, element, "NumberOfComponents", 1));
  constexpr std::uint64_t kMostComponents = 1u << 30;
  if (components > kMostComponents || rows > std::numeric_limits<std::uint32_t>::max()) {
    fail("has an impossible size");
  }
  DataArray array{name_, *type, static_cast<int>(components), {}};
  if (rows > 0) array.bytes = decode(element, *type, rows * components);
  return array;
}

std::vector<std::byte> VtkXmlArrays::decode(const pugi::xml_node& element, NumberType type,
                                            std::uint64_t count) {
  constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 53;
  if (count > kMostBytes / size_of(type)) fail("has an impossible size");
  const std::string_view format = element.attribute("format").value();
  std::vector<std::byte> numbers;
  if (format == "ascii") {
    std::string_view text = element.child_value();
    numbers = take_numbers(text, type, count, [&](const std::string& what) { fail(what); });
    if (!take_word_of_lines(text).empty()) {
      fail("has more than " + std::to_string(count) + " numbers");
    }
    return numbers;
  }
  if (format == "binary") {
    LetterBytes bytes(element.child_value());
    numbers = decode_block(bytes, count * size_of(type));
  } else if (format == "appended") {
    numbers = decode_appended(element, count * size_of(type));
  } else {
    fail("is in the unknown format " + in_quotes(format));
  }
  if (encoding_.foreign_order) reverse_bytes(numbers, size_of(type));
  return numbers;
}

std::vector<std::byte> VtkXmlArrays::decode_appended(const pugi::xml_node& element,
                                                     std::uint64_t size) {
  if (encoding_.appended == 0) fail("is appended to the file, but nothing is there");
  const std::uint64_t offset = vtk_number(file_, element, "offset");
  if (offset > file_.size() - encoding_.appended) fail("begins behind the file's end");
  if (!encoding_.appended_base64) {
    FileBytes bytes(file_, encoding_.appended + offset);
    return decode_block(bytes, size);
  }
  LetterBytes bytes(
      std::string_view(appended_letters_).substr(std::min(offset, appended_letters_.size())));
  return decode_block(bytes, size);
}

std::uint64_t VtkXmlArrays::read_size(Bytes& bytes) const {
  std::array<std::byte, 8> word{};
  const std::span<std::byte> used = std::span(word).first(encoding_.wide_sizes ? 8 : 4);
  if (!bytes.read(used)) fail("is not whole");
  if (encoding_.foreign_order) reverse_bytes(used, used.size());
  std::uint32_t narrow = 0;
  std::uint64_t wide = 0;
  std::memcpy(&narrow, word.data(), sizeof narrow);
  std::memcpy(&wide, word.data(), sizeof wide);
  return encoding_.wide_sizes ? wide : narrow;
}

void VtkXmlArrays::take_from_budget(const Bytes& bytes, std::uint64_t size) {
  if (size > bytes.most_left()) fail("is not whole");
  if (size > budget_) fail("is, with others, larger than the file");
  budget_ -= size;
}

std::vector<std::byte> VtkXmlArrays::decode_block(Bytes& bytes, std::uint64_t size) {
  if (encoding_.zlib) return inflate_blocks(bytes, size);
  const std::uint64_t stored = read_size(bytes);
  if (stored != size) {
    fail("has " + std::to_string(stored) + " bytes instead of " + std::to_string(size));
  }
  take_from_budget(bytes, size);
  std::vector<std::byte> block(size);
  if (!bytes.read(block)) fail("is not whole");
  return block;
}

std::vector<std::byte> VtkXmlArrays::inflate_blocks(Bytes& bytes, std::uint64_t size) {
  const std::uint64_t count = read_size(bytes), full = read_size(bytes), rest = read_size(bytes);
  const bool possible = count > 0 && count <= bytes.most_left() && full > 0 && rest <= full &&
                        (count - 1) <= size / full &&
                        (count - 1) * full + (rest > 0 ? rest : full) == size;
  if (!possible) fail("has not the " + std::to_string(size) + " bytes that it should have");
  std::vector<PackedBlock> blocks;
  std::uint64_t packed_size = 0;
  for (std::uint64_t b = 0; b < count; ++b) {
    const std::uint64_t one = read_size(bytes);
    if (one > bytes.most_left()) fail("is not whole");
    blocks.push_back({packed_size, one, b * full, b + 1 == count && rest > 0 ? rest : full});
    packed_size += one;
  }
  take_from_budget(bytes, packed_size);
  if (size / kMostInflation > packed_size) fail("is not compressed by zlib");
  std::vector<std::byte> packed(packed_size), unpacked(size);
  if (!bytes.read(packed)) fail("is not whole");
  std::atomic<bool> good = true;
  parallel_for(
      blocks.size(),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
          if (!inflate_block(blocks[b], packed, unpacked)) good = false;
        }
      },
      kBlockGrain);
  if (!good) fail("cannot be decompressed");
  return unpacked;
}

}  // namespace brindle

#endif  // BRINDLE_HAS_VTK
