#include "brindle/base/base64.h"

#include <algorithm>
#include <cstdint>

namespace brindle {
namespace {

constexpr std::uint8_t kNoDigit = 255;

constexpr std::array<std::uint8_t, 256> make_digits() {
  std::array<std::uint8_t, 256> digits{};
  digits.fill(kNoDigit);
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < kLetters.size(); ++i) {
    digits[static_cast<unsigned char>(kLetters[i])] = static_cast<std::uint8_t>(i);
  }
  return digits;
}

constexpr std::array<std::uint8_t, 256> kDigitsOfLetters = make_digits();

std::uint8_t digit(char letter) { return kDigitsOfLetters[static_cast<unsigned char>(letter)]; }

bool is_space(char letter) {
  return letter == ' ' || letter == '\n' || letter == '\r' || letter == '\t';
}

void put_group(std::uint32_t group, std::byte* bytes) {
  bytes[0] = static_cast<std::byte>(group >> 16);
  bytes[1] = static_cast<std::byte>(group >> 8);
  bytes[2] = static_cast<std::byte>(group);
}

}  // namespace

std::size_t Base64Reader::read_plain(std::span<std::byte> bytes) {
  std::size_t done = 0;
  const char* letters = text_.data();
  for (const char* end = letters + text_.size(); end - letters >= 4 && bytes.size() - done >= 3;
       letters += 4, done += 3) {
    const std::uint32_t a = digit(letters[0]), b = digit(letters[1]), c = digit(letters[2]),
                        d = digit(letters[3]);
    if ((a | b | c | d) >= 64) break;
    put_group(a << 18 | b << 12 | c << 6 | d, &bytes[done]);
  }
  text_.remove_prefix(static_cast<std::size_t>(letters - text_.data()));
  return done;
}

bool Base64Reader::next_group() {
  std::uint32_t group = 0;
  std::size_t letters = 0, padding = 0;
  for (; letters + padding < 4 && !text_.empty(); text_.remove_prefix(1)) {
    const char letter = text_.front();
    if (is_space(letter)) continue;
    if (letter == '=') {
      ++padding;
    } else if (padding == 0 && digit(letter) != kNoDigit) {
      group = group << 6 | digit(letter);
      ++letters;
    } else {
      damaged_ = true;
      return false;
    }
  }
  if (letters + padding == 0) return true;  // space alone
  if (letters < 2) {
    damaged_ = true;
    return false;
  }
  put_group(group << 6 * (4 - letters), group_.data());
  group_size_ = left_over_ = letters - 1;
  return true;
}

std::size_t Base64Reader::read_some(std::span<std::byte> bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    if (left_over_ == 0) done += read_plain(bytes.subspan(done));
    if (done == bytes.size()) break;
    if (left_over_ == 0 && (text_.empty() || !next_group())) break;
    const std::size_t taken = std::min(left_over_, bytes.size() - done);
    std::copy_n(group_.data() + (group_size_ - left_over_), taken, bytes.data() + done);
    left_over_ -= taken;
    done += taken;
  }
  return done;
}

std::optional<std::string> base64_decoded(std::string_view text) {
  Base64Reader reader(text);
  std::string bytes(reader.most_left(), '\0');
  bytes.resize(reader.read_some(std::as_writable_bytes(std::span(bytes))));
  if (!reader.at_end()) return std::nullopt;
  return bytes;
}

void Base64Writer::put(const void* data, std::uint64_t size) {
  const auto* bytes = static_cast<const unsigned char*>(data);
  for (std::uint64_t i = 0; i < size; ++i) {
    group_ = group_ << 8 | bytes[i];
    if (++filled_ == 3) put_group(4);
  }
}

void Base64Writer::finish() {
  if (filled_ == 0) return;
  const int letters = filled_ + 1;
  group_ <<= 8 * (3 - filled_);
  put_group(letters);
  for (int i = letters; i < 4; ++i) out_ << '=';
}

void Base64Writer::put_group(int letters) {
  constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<char, 4> text{};
  for (int i = 0; i < 4; ++i) text[i] = kLetters[group_ >> (18 - 6 * i) & 63];
  out_.write(text.data(), static_cast<std::size_t>(letters));
  group_ = 0;
  filled_ = 0;
}

}  // namespace brindle
