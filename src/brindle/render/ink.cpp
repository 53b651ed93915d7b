#include "brindle/ink.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "brindle/render/surface_light.h"
#include "brindle/renderer.h"

namespace brindle {
namespace {

/// Blends light over a pixel of which it covers `share`.
void cover(Pixel& pixel, const Vec3& light, float share) {
  if (!(share > 0)) return;
  const Eigen::Vector4f below = premultiplied_light(pixel);
  const Vec3 sum = share * light + (1 - share) * below.head<3>();
  pixel = pixel_of({sum.x(), sum.y(), sum.z(), share + (1 - share) * below.w()});
}

float distance_to(const Eigen::Vector2f& point, const Eigen::Vector2f& a,
                  const Eigen::Vector2f& b) {
  const Eigen::Vector2f along = b - a;
  const float length = along.squaredNorm();
  const float t = length > 0 ? std::clamp((point - a).dot(along) / length, 0.0f, 1.0f) : 0.0f;
  return (point - a - t * along).norm();
}

/// Coverage of all pixels by strokes.
class Coverage {
 public:
  Coverage(int width, int height)
      : width_(width),
        height_(height),
        shares_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  void add(const Eigen::Vector2f& a, const Eigen::Vector2f& b, float radius) {
    if (!a.allFinite() || !b.allFinite()) return;
    const Eigen::Vector2f lower = a.cwiseMin(b).array() - radius - 1;
    const Eigen::Vector2f upper = a.cwiseMax(b).array() + radius + 1;
    const auto within = [](float value, int size) {
      return static_cast<int>(std::clamp(value, 0.0f, static_cast<float>(size)));
    };
    for (int y = within(lower.y(), height_); y < within(upper.y() + 1, height_); ++y) {
      for (int x = within(lower.x(), width_); x < within(upper.x() + 1, width_); ++x) {
        const Eigen::Vector2f middle(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        // A line thinner than a pixel covers a part of it.
        const float share =
            std::clamp(radius + 0.5f - distance_to(middle, a, b), 0.0f, std::min(1.0f, 2 * radius));
        float& most = shares_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                              static_cast<std::size_t>(x)];
        most = std::max(most, share);
      }
    }
  }

  std::span<const float> shares() const { return shares_; }

 private:
  int width_, height_;
  std::vector<float> shares_;
};

}  // namespace

void ink(Image& image, std::span<const Stroke> strokes, float width, const Color& color,
         float opacity) {
  if (strokes.empty()) return;
  Coverage coverage(image.width, image.height);
  for (const Stroke& stroke : strokes) {
    for (std::size_t i = 0; i < stroke.size(); ++i) {
      coverage.add(stroke[i], stroke[std::min(i + 1, stroke.size() - 1)], 0.5f * width);
    }
  }
  const Vec3 light = linear_light(color);
  for (std::size_t p = 0; p < image.pixels.size(); ++p) {
    cover(image.pixels[p], light, opacity * coverage.shares()[p]);
  }
}

void fill(Image& image, const Eigen::Vector2f& lower, const Eigen::Vector2f& upper,
          const Color& color, float opacity) {
  const auto overlap = [](float from, float to, int cell) {
    const auto begin = static_cast<float>(cell);
    return std::clamp(std::min(to, begin + 1) - std::max(from, begin), 0.0f, 1.0f);
  };
  const Vec3 light = linear_light(color);
  const int last_y = std::min(image.height - 1, static_cast<int>(upper.y()));
  const int last_x = std::min(image.width - 1, static_cast<int>(upper.x()));
  for (int y = std::max(0, static_cast<int>(lower.y())); y <= last_y; ++y) {
    for (int x = std::max(0, static_cast<int>(lower.x())); x <= last_x; ++x) {
      const float share = overlap(lower.x(), upper.x(), x) * overlap(lower.y(), upper.y(), y);
      cover(image.at(x, y), light, opacity * share);
    }
  }
}

}  // namespace brindle
