/// Files that are opened for reading.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

#include "brindle/base/system.h"

namespace brindle {

/// A file's bytes, from anywhere. After an error of the system it gives none.
class InputStream {
 public:
  explicit InputStream(system::Descriptor descriptor) : descriptor_(descriptor) {}
  ~InputStream();
  InputStream(InputStream&& other) noexcept;
  InputStream& operator=(InputStream&&) = delete;

  /// How many bytes there were: fewer than `count` at the file's end, and if it is `bad`.
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

/// The lines of a file, from here on.
class InputLines {
 public:
  explicit InputLines(InputStream stream) : stream_(std::move(stream)) {}

  /// Whether there is one more, which takes the place of `line`, without its end.
  bool next(std::string& line);

  bool bad() const { return stream_.bad(); }

 private:
  InputStream stream_;
  std::string buffer_;
  std::size_t begin_ = 0;  ///< what of the buffer has not been handed out
};

/// Opens a regular file, as bytes. Devices and pipes are refused: they have no size, and some never
/// end. Throws Error, naming the file and the remedy, for these, for a folder, and for what is not
/// there or may not be read. `kind` is what the file should be: "a mesh file".
InputStream open_input(const std::filesystem::path& path, const std::string& kind);

/// All that is in the file. Throws Error as `open_input` does, and where reading fails.
std::string whole_input(const std::filesystem::path& path, const std::string& kind);

}  // namespace brindle
