/// Files read as bytes from anywhere, whole, or in one pass, line by line or byte by byte.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/base/input_file.h"
#include "brindle/base/system.h"
#include "brindle/progress.h"

namespace brindle {

/// A file's bytes, from anywhere. After an error of the system it gives none.
class InputStream {
 public:
  explicit InputStream(system::Descriptor descriptor) : descriptor_(descriptor) {}
  ~InputStream();
  InputStream(InputStream&& other) noexcept;
  InputStream& operator=(InputStream&&) = delete;

  /// Reads up to `count` bytes and returns how many: fewer at the file's end, and if it is `bad`.
  std::size_t read(void* bytes, std::size_t count);

  /// Where the next byte is read.
  std::uint64_t place() const { return place_; }
  void seek(std::uint64_t place);

  /// Whether the system could not read.
  bool bad() const { return bad_; }

 private:
  system::Descriptor descriptor_;
  std::uint64_t place_ = 0;
  bool bad_ = false;
};

/// The lines of a file, from the stream's place on.
class InputLines {
 public:
  explicit InputLines(InputStream stream) : stream_(std::move(stream)) {}

  /// Replaces `line` by the next one, without its end; false if there is none.
  bool next(std::string& line);

  bool bad() const { return stream_.bad(); }

 private:
  InputStream stream_;
  std::string buffer_;
  std::size_t begin_ = 0;  ///< what of the buffer has not been handed out
};

/// Opens a regular file, as bytes. Throws Error, naming the file and the remedy, for a file that
/// does not exist or may not be read, for a folder, and for devices and pipes: these have no size,
/// and some never end. `kind` is what the file should be: "a mesh file".
InputStream open_input(const std::filesystem::path& path, const std::string& kind);

/// The whole content of the file. Throws Error as `open_input` does, and where reading fails.
std::string whole_input(const std::filesystem::path& path, const std::string& kind);

/// An optional mark before the first line of a text in UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

class InputFile {
 public:
  /// Throws Error, with the remedy, if there is no such file, it is a folder or no regular file,
  /// cannot be read, or is empty. `progress` reports "loading PATH" with the fraction of the file
  /// that was read.
  explicit InputFile(const std::filesystem::path& path, Progress progress = {});

  /// Throws Error if the file begins with what no text in UTF-8 or ASCII has. `kind` is what the
  /// text should be: "an OBJ file".
  void check_text(const std::string& kind);

  /// The next line without its end and, of the first, a byte-order mark; nothing after the last.
  /// Valid until the next call.
  std::optional<std::string_view> next_line();

  /// The next `count` bytes; valid until the next call. Throws Error if the file ends before.
  const char* take(std::size_t count);

  /// Fills `bytes` from that place in the file on, apart from the lines read in order. Throws Error
  /// if the file ends before.
  void read_at(std::uint64_t place, std::span<std::byte> bytes);

  /// Bytes of the whole file.
  std::uint64_t size() const { return size_; }

  /// How many lines have been read.
  std::size_t line() const { return line_; }

  /// Bytes that have not been handed out yet.
  std::uint64_t remaining() const { return remaining_; }

  /// Throws Error("path:line: message") or, where no line has been read, Error("path: message").
  [[noreturn]] void fail(const std::string& message) const;

  /// The same for an earlier line.
  [[noreturn]] void fail_at(std::size_t line, const std::string& message) const;

  /// As `fail`, but never names a line: for what is wrong with the whole file.
  [[noreturn]] void fail_whole(const std::string& message) const;

 private:
  /// Moves what is left to the front of the buffer and reads more behind it.
  bool fill();

  /// `count` more bytes have been read.
  void report(std::uint64_t count);

  std::filesystem::path path_;
  Progress progress_;
  std::string stage_;
  std::uint64_t read_ = 0;  ///< bytes
  InputStream stream_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  ///< what of the buffer has not been handed out
  std::uint64_t size_ = 0;
  std::uint64_t remaining_ = 0;
  std::size_t line_ = 0;
};

/// Takes the first word, between spaces or tabs, off a line; empty if there is none left.
std::string_view take_word(std::string_view& line);

/// The number that `word` is, and nothing else; a leading + is allowed, and nan and inf are read.
/// Rounded to float it is the float nearest to what `word` says. Numbers beyond the range of double
/// become infinite or zero.
std::optional<double> parse_number(std::string_view word);

/// The same as the nearest double, which rounded to float once more may be one step off.
std::optional<double> parse_double(std::string_view word);
std::optional<std::int64_t> parse_integer(std::string_view word);

}  // namespace brindle
