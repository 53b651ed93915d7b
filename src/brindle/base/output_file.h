/// Files that are either written whole or not at all, and the streams that fill them.
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

/// Writes into an open file in large blocks, or into a text. It keeps the system's reason for a
/// failure, unlike streams of the standard library, and needs none of their locales, a twelfth of a
/// module for browsers. After a failure, and once cancelled, it ignores what follows.
class OutputStream {
 public:
  /// `progress` reports after every few megabytes.
  OutputStream(system::Descriptor descriptor, const Progress& progress);
  /// Into a text, at once.
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

  /// Whether something could not be written; everything after that is lost.
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

/// Numbers and words written fast, floats in the shortest form that reads back the same.
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

/// Lets `write` fill a file that has no name yet, then gives it the name `path`. On any failure,
/// and if the process is killed meanwhile, nothing is left behind, and an earlier file at `path`
/// stays as it was. (Where the file system knows no files without names, the file is called
/// .brindle-NUMBER.tmp until it is whole, and being killed leaves that.) A file that is replaced
/// hands its owner and permissions on; a link is followed, and stays. A `path` that is not a
/// regular file (a device, a pipe) is written to directly. Throws Error, naming the path, the
/// system's reason and the remedy, if the folder does not exist, cannot be written to or is full;
/// passes on what `write` throws. `progress` reports "writing PATH" after every few megabytes; the
/// size of the file is not known, so the fraction approaches 1 ever more slowly. Cancelled leaves
/// the path as any failure does.
void write_file(const std::filesystem::path& path, const std::function<void(OutputStream&)>& write,
                const Progress& progress = {});

/// The same in two steps: a file without a name, for writers that need its descriptor, and for
/// those that complete other files before this one gets its name.
class UnfinishedFile {
 public:
  /// Throws Error as `write_file` does. `path` is no device.
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
  std::filesystem::path temporary_;  ///< its name now; empty if it has none
  int descriptor_ = -1;
};

/// Throws the Error that `write_file` would throw for a `path` that is a folder, lies in a folder
/// that does not exist or may not be written to, or has too long a name. For checks before a long
/// job, whose result would be lost.
void check_output_path(const std::filesystem::path& path);

/// Whether something is there that is no regular file: a device or a pipe, written to directly.
bool is_device(const std::filesystem::path& path);

}  // namespace brindle
