#include "brindle/surface/tubes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/error.h"

namespace brindle {
namespace {

struct TubePoint {
  Vec3 position;
  Vec3 normal;
};

/// The points of a line, without those that nearly repeat the one before.
std::vector<TubePoint> distinct_points(const Polylines& lines, std::size_t line, float gap) {
  std::vector<TubePoint> result;
  const auto points = lines.points_of(line);
  const auto normals = lines.normals_of(line);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool last = i + 1 == points.size() && !lines.closed[line];
    const bool near = !result.empty() && (points[i] - result.back().position).norm() < gap;
    // The last point of an open line is where it ends: the one before gives way.
    if (near && last && result.size() > 1) result.pop_back();
    if (!near || last) result.push_back({points[i], normals[i]});
  }
  while (lines.closed[line] && result.size() > 1 &&
         (result.back().position - result.front().position).norm() < gap) {
    result.pop_back();
  }
  return result;
}

class TubeMaker {
 public:
  explicit TubeMaker(const TubeOptions& options) : options_(options) {}

  void add(const std::vector<TubePoint>& points, bool closed) {
    const std::size_t count = points.size();
    const auto first = static_cast<Index>(mesh_.positions.size());
    if (first + count * options_.sides > 0xfffffff0) {
      throw Error("the tubes would have too many vertices; ask for fewer sides or stripes");
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3& before = points[i > 0 ? i - 1 : closed ? count - 1 : i].position;
      const Vec3& behind = points[i + 1 < count ? i + 1 : closed ? 0 : i].position;
      add_ring(points[i], (points[i].position - before).stableNormalized(),
               (behind - points[i].position).stableNormalized());
    }
    const std::size_t spans = closed ? count : count - 1;
    for (std::size_t i = 0; i < spans; ++i) {
      join(first + ring(i), first + ring((i + 1) % count));
    }
    if (closed) return;
    cap(first, true);
    cap(first + ring(count - 1), false);
  }

  Mesh take() { return std::move(mesh_); }

 private:
  Index ring(std::size_t i) const { return static_cast<Index>(i * options_.sides); }

  void add_ring(const TubePoint& point, const Vec3& arriving, const Vec3& leaving) {
    Vec3 along = (arriving + leaving).stableNormalized();
    if (along.isZero(0)) along = arriving;
    Vec3 up = point.normal - point.normal.dot(along) * along;
    if (up.norm() < 1e-3f) up = along.unitOrthogonal();
    up.normalize();
    const Vec3 aside = along.cross(up);
    for (int k = 0; k < options_.sides; ++k) {
      const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k) /
                          static_cast<float>(options_.sides);
      mesh_.positions.push_back(point.position +
                                options_.radius * (std::cos(angle) * up + std::sin(angle) * aside));
    }
  }

  void join(Index a, Index b) {
    const auto sides = static_cast<Index>(options_.sides);
    for (Index k = 0; k < sides; ++k) {
      const Index next = (k + 1) % sides;
      mesh_.triangles.push_back({a + k, a + next, b + k});
      mesh_.triangles.push_back({a + next, b + next, b + k});
    }
  }

  void cap(Index first, bool start) {
    for (Index k = 1; k + 1 < static_cast<Index>(options_.sides); ++k) {
      mesh_.triangles.push_back(start ? Triangle{first, first + k + 1, first + k}
                                      : Triangle{first, first + k, first + k + 1});
    }
  }

  const TubeOptions& options_;
  Mesh mesh_;
};

}  // namespace

Mesh tubes(const Polylines& lines, const TubeOptions& options) {
  if (!(options.radius > 0) || !std::isfinite(options.radius)) {
    throw Error("the radius of tubes must be above zero");
  }
  if (options.sides < 3 || options.sides > 64) throw Error("tubes have 3 to 64 sides");
  TubeMaker maker(options);
  for (std::size_t line = 0; line < lines.count(); ++line) {
    const auto points = distinct_points(lines, line, 0.1f * options.radius);
    const bool closed = lines.closed[line] && points.size() > 2;
    if (points.size() > 1) maker.add(points, closed);
  }
  Mesh mesh = maker.take();
  mesh.origin = lines.origin;
  return mesh;
}

}  // namespace brindle
