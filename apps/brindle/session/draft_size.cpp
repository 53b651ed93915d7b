#include "session/draft_size.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "brindle/base/parallel.h"

namespace brindle::tool {
namespace {

constexpr std::array kReductions = {1.0f, 1.5f, 2.0f, 3.0f, 4.0f};
static_assert(DraftSize::kFirst < kReductions.size());

// Milliseconds per frame. The cost of a finer picture grows at most with its pixels.
constexpr double kLongest = 60;
constexpr double kGoal = 46;

constexpr std::size_t kRowsOfTask = 32;

/// Four 8-bit channels in 16-bit fields, mixed in one operation.
using Channels = std::uint64_t;

Channels spread(const Pixel& pixel) {
  Channels c = std::bit_cast<std::uint32_t>(pixel);
  c = (c | c << 16) & 0x0000ffff0000ffffu;
  return (c | c << 8) & 0x00ff00ff00ff00ffu;
}

Pixel gathered(Channels c) {
  c = (c | c >> 8) & 0x0000ffff0000ffffu;
  return std::bit_cast<Pixel>(static_cast<std::uint32_t>(c | c >> 16));
}

/// `share` of 256 parts of `b`.
Channels mixed(Channels a, Channels b, Channels share) {
  return ((256 - share) * a + share * b + 0x0080008000800080u) >> 8 & 0x00ff00ff00ff00ffu;
}

/// The first of the two source pixels to mix, and the share of the second one in 256 parts.
struct Place {
  int first, second;
  Channels share;
};

std::vector<Place> places(int source, int count) {
  std::vector<Place> result;
  for (int i = 0; i < count; ++i) {
    const double at = std::clamp((i + 0.5) * source / count - 0.5, 0.0, source - 1.0);
    const int first = static_cast<int>(at);
    result.push_back({first, std::min(first + 1, source - 1),
                      static_cast<Channels>(std::lround(256 * (at - first)))});
  }
  return result;
}

}  // namespace

float DraftSize::reduction() const { return kReductions[step_]; }

void DraftSize::note(double drawing, double before) {
  const std::size_t now = step_;
  const auto expected = [&](std::size_t step) {
    const double shorter = kReductions[now] / kReductions[step];
    return before + drawing * shorter * shorter;
  };
  while (step_ > 0 && expected(step_ - 1) < kGoal) --step_;
  while (step_ + 1 < kReductions.size() && expected(step_) > kLongest) ++step_;
}

int reduced_side(int side, float reduction) {
  return std::max(1, static_cast<int>(std::lround(static_cast<float>(side) / reduction)));
}

Image enlarged(const Image& image, int width, int height) {
  Image result(width, height);
  const std::vector<Place> columns = places(image.width, width);
  const std::vector<Place> rows = places(image.height, height);
  parallel_for(
      rows.size(),
      [&](std::size_t begin, std::size_t end) {
        std::vector<Channels> row(static_cast<std::size_t>(image.width));
        for (std::size_t y = begin; y < end; ++y) {
          const Pixel* upper = &image.at(0, rows[y].first);
          const Pixel* lower = &image.at(0, rows[y].second);
          for (std::size_t x = 0; x < row.size(); ++x) {
            row[x] = mixed(spread(upper[x]), spread(lower[x]), rows[y].share);
          }
          Pixel* out = &result.at(0, static_cast<int>(y));
          for (const Place& place : columns) {
            *out++ = gathered(mixed(row[place.first], row[place.second], place.share));
          }
        }
      },
      kRowsOfTask);
  return result;
}

}  // namespace brindle::tool
