/// Files read as bytes: at any position, whole, or in one pass by lines or blocks.
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

/// Reads the bytes of a file, or of memory, at any position. After a system error it returns none.
class InputStream {
 public:
  explicit InputStream(system::Descriptor descriptor) : descriptor_(descriptor) {}
  explicit InputStream(std::string_view memory) : memory_(memory) {}
  ~InputStream();
  InputStream(InputStream&& other) noexcept;
  InputStream& operator=(InputStream&&) = delete;

  /// Reads up to `count` bytes and returns their number: fewer at the file's end, or if `bad`.
  std::size_t read(void* bytes, std::size_t count);

  /// Position of the next byte.
  std::uint64_t place() const { return place_; }
  void seek(std::uint64_t place);

  /// Whether the system reported an error.
  bool bad() const { return bad_; }

 private:
  system::Descriptor descriptor_ = -1;
  std::optional<std::string_view> memory_;
  std::uint64_t place_ = 0;
  bool bad_ = false;
};

/// The lines of a file, from the stream's position on.
class InputLines {
 public:
  explicit InputLines(InputStream stream) : stream_(std::move(stream)) {}

  /// Replaces `line` by the next one, without its end; false if there is none.
  bool next(std::string& line);

  bool bad() const { return stream_.bad(); }

 private:
  InputStream stream_;
  std::string buffer_;
  std::size_t begin_ = 0;  ///< start of the unread part of the buffer
};

/// Opens a regular file for reading bytes. Throws Error, naming the file and the remedy, if it does
/// not exist, may not be read, or is a folder, device or pipe: these have no size, and some never
/// end. `kind` describes the expected file: "a mesh file".
InputStream open_input(const std::filesystem::path& path, const std::string& kind);

/// The whole content of the file. Throws Error as `open_input` does, and where reading fails.
std::string whole_input(const std::filesystem::path& path, const std::string& kind);

/// An optional mark at the start of UTF-8 text.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

class InputFile {
 public:
  /// Throws Error, with the remedy, if the file does not exist, is a folder or not a regular file,
  /// cannot be read, or is empty. `progress` reports "loading PATH" with the fraction read.
  explicit InputFile(const std::filesystem::path& path, Progress progress = {});

  /// Throws Error if the file does not begin as UTF-8 or ASCII text. `kind` describes the expected
  /// text: "an OBJ file".
  void check_text(const std::string& kind);

  /// The next line, without its end and, for the first, without a byte-order mark; nullopt after
  /// the last. Valid until the next call.
  std::optional<std::string_view> next_line();

  /// The next `count` bytes; valid until the next call. Throws Error if the file ends before.
  const char* take(std::size_t count);

  /// Fills `bytes` from `place` in the file on, independently of the lines read in order. Throws
  /// Error if the file ends before.
  void read_at(std::uint64_t place, std::span<std::byte> bytes);

  /// Bytes of the whole file.
  std::uint64_t size() const { return size_; }

  /// Number of lines read.
  std::size_t line() const { return line_; }

  /// Bytes not returned yet.
  std::uint64_t remaining() const { return remaining_; }

  /// The path, for messages.
  std::string name() const;

  /// Throws Error("path:line: message") or, where no line has been read, Error("path: message").
  [[noreturn]] void fail(const std::string& message) const;

  /// The same for an earlier line.
  [[noreturn]] void fail_at(std::size_t line, const std::string& message) const;

  /// As `fail`, but without a line: for errors of the whole file.
  [[noreturn]] void fail_whole(const std::string& message) const;

 private:
  /// Moves the unread bytes to the front of the buffer and reads more behind them.
  bool fill();

  /// Adds `count` bytes to the progress.
  void report(std::uint64_t count);

  std::filesystem::path path_;
  Progress progress_;
  std::string stage_;
  std::uint64_t read_ = 0;  ///< bytes
  InputStream stream_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  ///< unread part of the buffer
  std::uint64_t size_ = 0;
  std::uint64_t remaining_ = 0;
  std::size_t line_ = 0;
};

/// Removes the first word, between spaces or tabs, from a line; empty if none is left.
std::string_view take_word(std::string_view& line);

/// Parses a whole word as a number; a leading +, nan and inf are allowed. Rounding the result to
/// float gives the float nearest to the word. Numbers beyond the range of double become infinite or
/// zero.
std::optional<double> parse_number(std::string_view word);

/// The nearest double instead, which rounded to float may be one step off.
std::optional<double> parse_double(std::string_view word);
std::optional<std::int64_t> parse_integer(std::string_view word);

}  // namespace brindle
