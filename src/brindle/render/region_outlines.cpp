#include "brindle/region_outlines.h"

#include <algorithm>
#include <array>
#include <string>

#include "brindle/error.h"
#include "brindle/render/simplified_stroke.h"

namespace brindle {
namespace {

using Eigen::Vector2f;

/// The middles of pixels and, around them, a border that nothing covers. Lines cross its edges:
/// edge 2 p leads from point p to the right, edge 2 p + 1 downwards.
class ShareGrid {
 public:
  ShareGrid(int width, int height, std::span<const float> shares)
      : width_(width), height_(height), shares_(shares) {}

  int columns() const { return width_ + 2; }
  int rows() const { return height_ + 2; }
  std::size_t edge_count() const {
    return 2 * static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows());
  }
  float share(int x, int y) const {
    if (x < 1 || y < 1 || x > width_ || y > height_) return 0;
    return shares_[static_cast<std::size_t>(y - 1) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x - 1)];
  }
  bool covered(int x, int y) const { return share(x, y) > 0.5f; }
  std::size_t right_of(int x, int y) const { return 2 * point(x, y); }
  std::size_t below(int x, int y) const { return 2 * point(x, y) + 1; }

  Vector2f crossing(std::size_t edge) const {
    const int x = static_cast<int>(edge / 2) % columns(),
              y = static_cast<int>(edge / 2) / columns();
    const bool down = edge % 2 == 1;
    const float a = share(x, y), b = down ? share(x, y + 1) : share(x + 1, y);
    const float t = (0.5f - a) / (b - a);
    const Vector2f middle(static_cast<float>(x) - 0.5f, static_cast<float>(y) - 0.5f);
    return middle + (down ? Vector2f(0, t) : Vector2f(t, 0));
  }

 private:
  std::size_t point(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns()) +
           static_cast<std::size_t>(x);
  }

  int width_, height_;
  std::span<const float> shares_;
};

constexpr std::size_t kNoEdge = static_cast<std::size_t>(-1);

/// For every crossed edge the one that the line crosses next.
std::vector<std::size_t> next_edges(const ShareGrid& grid) {
  std::vector<std::size_t> next(grid.edge_count(), kNoEdge);
  for (int y = 0; y + 1 < grid.rows(); ++y) {
    for (int x = 0; x + 1 < grid.columns(); ++x) {
      // Corners and the edges behind them, round the cell.
      const std::array<bool, 4> in{grid.covered(x, y), grid.covered(x + 1, y),
                                   grid.covered(x + 1, y + 1), grid.covered(x, y + 1)};
      const std::array<std::size_t, 4> edges{grid.right_of(x, y), grid.below(x + 1, y),
                                             grid.right_of(x, y + 1), grid.below(x, y)};
      const float mean = 0.25f * (grid.share(x, y) + grid.share(x + 1, y) +
                                  grid.share(x + 1, y + 1) + grid.share(x, y + 1));
      // A line enters where it goes from the outside in, round the cell, and leaves where it goes
      // out again: across the cell's middle if that is covered.
      for (std::size_t k = 0; k < 4; ++k) {
        if (in[k] || !in[(k + 1) % 4]) continue;
        const bool saddle = in[(k + 3) % 4] && !in[(k + 2) % 4];
        std::size_t leave = k;
        if (saddle && mean > 0.5f) {
          leave = (k + 3) % 4;
        } else {
          for (std::size_t step = 1; step < 4; ++step) {
            const std::size_t e = (k + step) % 4;
            if (in[e] && !in[(e + 1) % 4]) {
              leave = e;
              break;
            }
          }
        }
        next[edges[k]] = edges[leave];
      }
    }
  }
  return next;
}

}  // namespace

std::vector<Stroke> region_outlines(int width, int height, std::span<const float> shares,
                                    float tolerance) {
  if (width < 0 || height < 0 ||
      shares.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    throw Error("outlines need a share for each of " + std::to_string(width) + " x " +
                std::to_string(height) + " pixels, not " + std::to_string(shares.size()));
  }
  const ShareGrid grid(width, height, shares);
  std::vector<std::size_t> next = next_edges(grid);
  std::vector<Stroke> loops;
  for (std::size_t start = 0; start < next.size(); ++start) {
    if (next[start] == kNoEdge) continue;
    Stroke loop;
    for (std::size_t edge = start; next[edge] != kNoEdge;) {
      loop.push_back(grid.crossing(edge));
      const std::size_t after = next[edge];
      next[edge] = kNoEdge;
      edge = after;
    }
    loop = simplified_stroke(loop, true, tolerance);
    if (loop.size() > 2) loops.push_back(std::move(loop));
  }
  return loops;
}

std::vector<float> light_shares(const Image& image) {
  std::vector<float> shares;
  shares.reserve(image.pixels.size());
  for (const Pixel& pixel : image.pixels) {
    const float light = linear_light({static_cast<float>(pixel.red) / 255, 0, 0})[0];
    shares.push_back(light * static_cast<float>(pixel.alpha) / 255);
  }
  return shares;
}

}  // namespace brindle
