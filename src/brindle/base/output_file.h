/// Files that are written completely or not at all, and the streams that fill them.
#pragma once

#include <concepts>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "brindle/base/number_text.h"
#include "brindle/base/output_file.h"
#include "brindle/base/system.h"
#include "brindle/error.h"
#include "brindle/progress.h"

namespace brindle {

/// Writes into an open file in large blocks, or into a string. Unlike standard streams, it keeps
/// the system's reason for a failure and needs no locales, a twelfth of a module for browsers.
/// Ignores all output after a failure or cancellation.
class OutputStream {
 public:
  /// `progress` reports every few megabytes.
  OutputStream(system::Descriptor descriptor, const Progress& progress);
  /// Into a string, unbuffered.
  explicit OutputStream(std::string& text) : text_(&text) {}
  OutputStream(const OutputStream&) = delete;
  OutputStream& operator=(const OutputStream&) = delete;

  OutputStream& write(const void* bytes, std::size_t count);

  OutputStream& operator<<(std::string_view text) { return write(text.data(), text.size()); }
  OutputStream& operator<<(const char* text) { return *this << std::string_view(text); }
  OutputStream& operator<<(char letter) { return write(&letter, 1); }
  OutputStream& operator<<(std::integral auto number) {
    char digits[24];
    const auto end = write_number(digits, digits + sizeof digits, number).ptr;
    return write(digits, static_cast<std::size_t>(end - digits));
  }

  /// Writes what was buffered.
  void flush();

  /// Whether a write failed or was cancelled; all later output is lost.
  bool bad() const { return reason_ != 0 || cancelled_; }

  /// 0, or the system's reason for the first failure.
  int reason() const { return reason_; }
  bool is_cancelled() const { return cancelled_; }

 private:
  void write_all(const char* bytes, std::size_t count);
  bool may_go_on();

  std::string* text_ = nullptr;
  system::Descriptor descriptor_ = -1;
  int reason_ = 0;
  std::vector<char> gathered_;
  Progress progress_;
  std::size_t passed_ = 0, since_report_ = 0;
  bool cancelled_ = false;
};

/// Thrown by long writers once the file takes no more; `write_file` reports the reason.
class OutputStopped : public Error {
 public:
  OutputStopped() : Error("the output takes no more") {}
};

inline void stop_if_bad(const OutputStream& out) {
  if (out.bad()) throw OutputStopped();
}

/// Fast output of numbers and words; floats in the shortest form that reads back the same.
class TextOutput {
 public:
  explicit TextOutput(OutputStream& out) : out_(out) {}
  TextOutput(const TextOutput&) = delete;
  TextOutput& operator=(const TextOutput&) = delete;
  ~TextOutput() { flush(); }

  TextOutput& operator<<(std::string_view text) {
    buffer_ += text;
    if (buffer_.size() > kFull) flush_on();
    return *this;
  }
  TextOutput& operator<<(const char* text) { return *this << std::string_view(text); }
  TextOutput& operator<<(char c) { return *this << std::string_view(&c, 1); }

  template <class Number>
  requires(std::is_arithmetic_v<Number>) TextOutput& operator<<(Number number) {
    char digits[32];
    const auto end = write_number(digits, digits + sizeof digits, number).ptr;
    return *this << std::string_view(digits, static_cast<std::size_t>(end - digits));
  }

 private:
  static constexpr std::size_t kFull = 1 << 16;

  void flush_on() {
    flush();
    stop_if_bad(out_);
  }

  void flush() {
    out_.write(buffer_.data(), buffer_.size());
    buffer_.clear();
  }

  OutputStream& out_;
  std::string buffer_;
};

/// Lets `write` fill an unnamed file, then names it `path`. A failed, cancelled or killed write
/// leaves no file; an earlier file at `path` is unchanged. (File systems without unnamed files use
/// .brindle-NUMBER.tmp until the file is complete; killing the process leaves that.) A replaced
/// file passes on its owner and permissions; links are followed and stay. A `path` that is not a
/// regular file (a device, a pipe) is written directly; a MemoryFile of that name instead. Throws
/// Error, with the path, the system's reason and the remedy, if the folder does not exist, is not
/// writable or is full; passes on what `write` throws. `progress` reports "writing PATH" every few
/// megabytes. The final size is unknown, so the fraction approaches 1 ever more slowly.
void write_file(const std::filesystem::path& path, const std::function<void(OutputStream&)>& write,
                const Progress& progress = {});

/// The same in two steps: an unnamed file, for writers that need its descriptor, or that complete
/// other files before this one gets its name.
class UnfinishedFile {
 public:
  /// Throws Error as `write_file` does. `path` must not be a device.
  explicit UnfinishedFile(const std::filesystem::path& path);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  int descriptor() const { return descriptor_; }

  /// Lets `write` fill the file, as `write_file` does.
  void write(const std::function<void(OutputStream&)>& write, const Progress& progress = {});

  /// A path by which other programs can open the file while this object lives.
  std::filesystem::path place() const;

  /// Gives the file its name. Throws Error as `write_file` does.
  void finish();

 private:
  std::filesystem::path path_, target_;
  std::filesystem::path temporary_;  ///< its present name; empty if it has none
  int descriptor_ = -1;
};

/// Throws the Error of `write_file` if `path` is a folder or has too long a name, or if its folder
/// does not exist or is not writable. For checks before a long job, whose result would be lost.
void check_output_path(const std::filesystem::path& path);

/// Whether `path` exists but is no regular file: devices and pipes are written directly.
bool is_device(const std::filesystem::path& path);

}  // namespace brindle
