#include "brindle/base/input_file.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <system_error>
#include <utility>

#include "brindle/base/memory_file.h"
#include "brindle/base/number_text.h"
#include "brindle/base/text.h"
#include "brindle/error.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

/// Small, so that reading only a header reads little more.
constexpr std::size_t kFirstSize = std::size_t{1} << 14;
constexpr std::size_t kBufferSize = std::size_t{1} << 20;
constexpr std::size_t kReportedSize = std::size_t{1} << 24;

constexpr std::string_view kTruncated = "ends too early: it is truncated; copy or export it again";

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw Error(shown(path.string()) + ": " + why);
}

std::string_view without_plus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

/// Whether the value is exactly halfway between two floats.
bool halfway_between_floats(double value) {
  if (!(std::abs(value) <= std::numeric_limits<float>::max())) return false;
  const double nearest = static_cast<float>(value);
  const double other = 2 * value - nearest;
  return other != nearest && static_cast<double>(static_cast<float>(other)) == other;
}

/// Rounding a word to double and then to float may go the wrong way at a midpoint. Moves the value
/// off the midpoint, towards the float nearest to the word.
double towards_nearest_float(double value, std::string_view word) {
  float nearest = 0;
  const auto read = read_number(word.data(), word.data() + word.size(), nearest);
  if (read.ec != std::errc() || static_cast<float>(value) == nearest) return value;
  return std::nextafter(value, static_cast<double>(nearest));
}

}  // namespace

InputStream::~InputStream() {
  if (descriptor_ >= 0) system::close_file(descriptor_);
}

InputStream::InputStream(InputStream&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      memory_(other.memory_),
      place_(other.place_),
      bad_(other.bad_) {}

std::size_t InputStream::read(void* bytes, std::size_t count) {
  auto* const begin = static_cast<char*>(bytes);
  std::size_t done = 0;
  if (memory_) {
    const auto place = static_cast<std::size_t>(std::min<std::uint64_t>(place_, memory_->size()));
    done = memory_->copy(begin, count, place);
    place_ += done;
    return done;
  }
  while (done < count && !bad_) {
    const auto read = system::read_some(descriptor_, begin + done, count - done);
    if (read == 0) break;
    if (read > 0) {
      done += static_cast<std::size_t>(read);
    } else {
      bad_ = errno != EINTR;
    }
  }
  place_ += done;
  return done;
}

void InputStream::seek(std::uint64_t place) {
  bad_ = bad_ || (!memory_ && !system::go_to(descriptor_, place));
  place_ = place;
}

bool InputLines::next(std::string& line) {
  constexpr std::size_t kPart = std::size_t{1} << 16;
  std::size_t searched = begin_;
  while (true) {
    const std::size_t end = buffer_.find('\n', searched);
    if (end != std::string::npos) {
      line.assign(buffer_, begin_, end - begin_);
      begin_ = end + 1;
      return true;
    }
    buffer_.erase(0, std::exchange(begin_, 0));
    searched = buffer_.size();
    buffer_.resize(searched + kPart);
    buffer_.resize(searched + stream_.read(buffer_.data() + searched, kPart));
    if (buffer_.size() == searched) break;
  }
  line = std::exchange(buffer_, {});
  return !line.empty();
}

InputStream open_input(const fs::path& path, const std::string& kind) {
  if (const MemoryFile* file = MemoryFile::find(path)) return InputStream(file->content);
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    refuse(path, "there is no such file; check the path's spelling");
  }
  if (error) refuse(path, "cannot be read: " + error.message());
  if (fs::is_directory(status)) refuse(path, "is a folder; name " + kind + " in it");
  if (!fs::is_regular_file(status)) {
    refuse(path,
           "is not a regular file but a device or a pipe; save " + kind + " first and name that");
  }
  errno = 0;
  const system::Descriptor descriptor = system::open_existing(path);
  if (descriptor >= 0) return InputStream(descriptor);
  const std::string reason = errno == 0 || errno == EACCES ? "" : std::strerror(errno);
  refuse(path,
         "cannot be opened" + (reason.empty() ? "" : ": " + reason) + "; check its permissions");
}

std::string whole_input(const fs::path& path, const std::string& kind) {
  constexpr std::size_t kPart = std::size_t{1} << 16;
  InputStream stream = open_input(path, kind);
  std::string content;
  for (std::size_t size = 0, read = kPart; read == kPart; content.resize(size)) {
    content.resize(size + kPart);
    read = stream.read(content.data() + size, kPart);
    size += read;
  }
  if (stream.bad()) refuse(path, "cannot be read: input error");
  return content;
}

InputFile::InputFile(const fs::path& path, Progress progress)
    : path_(path),
      progress_(std::move(progress)),
      stage_("loading " + shown(path.string())),
      stream_(open_input(path, "a mesh file")) {
  std::error_code error;
  const MemoryFile* const memory = MemoryFile::find(path);
  remaining_ = memory != nullptr ? memory->content.size() : fs::file_size(path, error);
  if (error) fail("cannot be read: " + error.message());
  size_ = remaining_;
  if (remaining_ == 0) fail("is empty; write it again");
  buffer_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kFirstSize, remaining_)));
}

bool InputFile::fill() {
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  if (end_ == buffer_.size()) buffer_.resize(2 * buffer_.size());
  if (read_ > 0 && buffer_.size() < kBufferSize) {
    buffer_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kBufferSize, size_)));
  }
  const std::size_t read = stream_.read(buffer_.data() + end_, buffer_.size() - end_);
  end_ += read;
  if (stream_.bad()) fail_whole("cannot be read: input error");
  report(read);
  return read > 0;
}

void InputFile::report(std::uint64_t count) {
  read_ += count;
  // Clamped, since bytes may be read twice.
  progress_.report(stage_, std::min(1.0, static_cast<double>(read_) / static_cast<double>(size_)));
}

void InputFile::check_text(const std::string& kind) {
  constexpr std::uint64_t kLooked = 1024;
  std::string begin(static_cast<std::size_t>(std::min(kLooked, size_)), '\0');
  read_at(0, std::as_writable_bytes(std::span(begin)));
  if (begin.starts_with("\xff\xff\xfe")) {
    fail_whole("is no text, as " + kind +
               " is, but a binary surface of FreeSurfer; convert it with mris_convert");
  }
  if (begin.starts_with("\xff\xfe") || begin.starts_with("\xfe\xff")) {
    fail_whole("is text in UTF-16; save it in UTF-8, which " + kind + " is written in");
  }
  if (begin.find('\0') != std::string::npos) {
    fail_whole("is binary and no text, as " + kind +
               " is; name it by its format, or export it again");
  }
}

std::optional<std::string_view> InputFile::next_line() {
  std::size_t searched = 0;
  const char* line_end = nullptr;
  while (true) {
    const std::size_t left = end_ - begin_ - searched;
    line_end = static_cast<const char*>(
        left > 0 ? std::memchr(buffer_.data() + begin_ + searched, '\n', left) : nullptr);
    if (line_end) break;
    searched = end_ - begin_;
    if (!fill()) break;
  }
  if (!line_end && begin_ == end_) return std::nullopt;
  const char* start = buffer_.data() + begin_;
  const std::size_t taken =
      line_end ? static_cast<std::size_t>(line_end - start) + 1 : end_ - begin_;
  begin_ += taken;
  remaining_ -= std::min<std::uint64_t>(remaining_, taken);
  ++line_;
  std::string_view line(start, line_end ? taken - 1 : taken);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  if (line_ == 1 && line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
  return line;
}

const char* InputFile::take(std::size_t count) {
  while (end_ - begin_ < count) {
    if (!fill()) fail_whole(std::string(kTruncated));
  }
  const char* start = buffer_.data() + begin_;
  begin_ += count;
  remaining_ -= std::min<std::uint64_t>(remaining_, count);
  return start;
}

void InputFile::read_at(std::uint64_t place, std::span<std::byte> bytes) {
  if (bytes.size() > size_ || place > size_ - bytes.size()) fail_whole(std::string(kTruncated));
  const std::uint64_t here = stream_.place();
  stream_.seek(place);
  while (!bytes.empty()) {
    const std::span<std::byte> piece = bytes.first(std::min(bytes.size(), kReportedSize));
    const std::size_t read = stream_.read(piece.data(), piece.size());
    if (stream_.bad()) fail_whole("cannot be read: input error");
    if (read < piece.size()) fail_whole(std::string(kTruncated));
    report(piece.size());
    bytes = bytes.subspan(piece.size());
  }
  stream_.seek(here);
}

void InputFile::fail(const std::string& message) const {
  if (line_ == 0) fail_whole(message);
  fail_at(line_, message);
}

std::string InputFile::name() const { return shown(path_.string()); }

void InputFile::fail_at(std::size_t line, const std::string& message) const {
  throw Error(name() + ":" + std::to_string(line) + ": " + message);
}

void InputFile::fail_whole(const std::string& message) const {
  throw Error(name() + ": " + message);
}

std::string_view take_word(std::string_view& line) {
  constexpr std::string_view kBetween = " \t\r\v\f";
  const std::size_t begin = line.find_first_not_of(kBetween);
  if (begin == std::string_view::npos) {
    line = {};
    return {};
  }
  const std::size_t end = std::min(line.find_first_of(kBetween, begin), line.size());
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

std::optional<double> parse_number(std::string_view word) {
  const std::optional<double> value = parse_double(word);
  if (!value || !halfway_between_floats(*value)) return value;
  return towards_nearest_float(*value, without_plus(word));
}

std::optional<double> parse_double(std::string_view word) {
  word = without_plus(word);
  double value = 0;
  const auto [end, error] = read_number(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error == std::errc::invalid_argument) return std::nullopt;
  // Out of range: strtod returns infinity or zero.
  if (error == std::errc::result_out_of_range)
    return std::strtod(std::string(word).c_str(), nullptr);
  return value;
}

std::optional<std::int64_t> parse_integer(std::string_view word) {
  word = without_plus(word);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error != std::errc()) return std::nullopt;
  return value;
}

}  // namespace brindle
