#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/memory.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/polylines.h"

namespace brindle {
namespace {

struct TubePoint {
  Vec3 position;
  Vec3 normal;
};

/// The points of a line without near duplicates.
std::vector<TubePoint> distinct_points(const Polylines& lines, std::size_t line, float gap) {
  std::vector<TubePoint> result;
  const auto points = lines.points_of(line);
  const auto normals = lines.normals_of(line);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool last = i + 1 == points.size() && !lines.closed[line];
    const bool near = !result.empty() && (points[i] - result.back().position).norm() < gap;
    // Keeps the last point of an open line and drops the one before it instead.
    if (near && last && result.size() > 1) result.pop_back();
    if (!near || last) result.push_back({points[i], normals[i]});
  }
  while (lines.closed[line] && result.size() > 1 &&
         (result.back().position - result.front().position).norm() < gap) {
    result.pop_back();
  }
  return result;
}

/// The axes of a ring: along the line, and two across.
struct Frame {
  Vec3 along, up, aside;

  Frame turned_over() const { return {along, -up, -aside}; }
};

/// Whether a tube would twist by more than a quarter turn between two rings, as where the normals
/// of a one-sided surface flip.
bool is_twisted(const Frame& before, const Frame& behind) {
  return before.along.dot(behind.along) > 0 && before.aside.dot(behind.aside) < 0;
}

Frame frame_at(const Vec3& normal, const Vec3& arriving, const Vec3& leaving) {
  Vec3 along = (arriving + leaving).stableNormalized();
  if (along.isZero(0)) along = arriving;
  Vec3 up = normal - normal.dot(along) * along;
  if (up.norm() < 1e-3f) up = along.unitOrthogonal();
  up.normalize();
  return {along, up, along.cross(up)};
}

std::vector<Frame> frames_along(const std::vector<TubePoint>& points, bool closed) {
  const std::size_t count = points.size();
  std::vector<Frame> frames;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& here = points[i].position;
    const Vec3& before = points[i > 0 ? i - 1 : closed ? count - 1 : i].position;
    const Vec3& behind = points[i + 1 < count ? i + 1 : closed ? 0 : i].position;
    const Frame frame = frame_at(points[i].normal, (here - before).stableNormalized(),
                                 (behind - here).stableNormalized());
    const bool over = i > 0 && is_twisted(frames.back(), frame);
    frames.push_back(over ? frame.turned_over() : frame);
  }
  return frames;
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
    const std::vector<Frame> frames = frames_along(points, closed);
    for (std::size_t i = 0; i < count; ++i) add_ring(points[i].position, frames[i]);
    for (std::size_t i = 0; i + 1 < count; ++i) join(first + ring(i), first + ring(i + 1), 0);
    if (closed) {
      const bool half_turn = is_twisted(frames.back(), frames.front());
      return join(first + ring(count - 1), first, half_turn ? options_.sides / 2 : 0);
    }
    cap(first, true);
    cap(first + ring(count - 1), false);
  }

  Mesh take() { return std::move(mesh_); }

 private:
  Index ring(std::size_t i) const { return static_cast<Index>(i * options_.sides); }

  void add_ring(const Vec3& centre, const Frame& frame) {
    for (int k = 0; k < options_.sides; ++k) {
      const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k) /
                          static_cast<float>(options_.sides);
      mesh_.positions.push_back(centre + options_.radius * (elementary::cos(angle) * frame.up +
                                                            elementary::sin(angle) * frame.aside));
    }
  }

  /// Joins vertex k of ring a to vertex k + `turn` of ring b.
  void join(Index a, Index b, int turn) {
    const auto sides = static_cast<Index>(options_.sides);
    const auto shift = static_cast<Index>(turn);
    for (Index k = 0; k < sides; ++k) {
      const Index next = (k + 1) % sides;
      const Index there = b + (k + shift) % sides, next_there = b + (next + shift) % sides;
      mesh_.triangles.push_back({a + k, a + next, there});
      mesh_.triangles.push_back({a + next, next_there, there});
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

void check_memory(const Polylines& lines, const TubeOptions& options) {
  // Vertices, two triangles for each, and the normals that are drawn; vectors grow by doubling.
  constexpr double kBytes = 2 * (2 * sizeof(Vec3) + 2 * sizeof(Triangle));
  const auto points = static_cast<double>(lines.points.size());
  check_fits(points * options.sides, kBytes, "tubes of " + std::to_string(options.sides) + " sides",
             "vertices", [&](double most) {
               if (points * 3 <= most) {
                 return "there is room for " + std::to_string(static_cast<int>(most / points)) +
                        " sides";
               }
               return std::string("ask for fewer stripes, or points farther apart");
             });
}

}  // namespace

Mesh tubes(const Polylines& lines, const TubeOptions& options, const Progress& progress) {
  if (!(options.radius > 0) || !std::isfinite(options.radius)) {
    throw Error("the radius of tubes must be above zero");
  }
  if (options.sides < 3 || options.sides > 64) throw Error("tubes have 3 to 64 sides");
  check_memory(lines, options);
  JobStages stages(progress, {{"tubes", 1}});
  Reporter reporter(stages.begin("tubes"), lines.points.size());
  TubeMaker maker(options);
  for (std::size_t line = 0; line < lines.count(); ++line) {
    reporter.done(lines.points_of(line).size());
    const auto points = distinct_points(lines, line, 0.1f * options.radius);
    const bool closed = lines.closed[line] && points.size() > 2;
    if (points.size() > 1) maker.add(points, closed);
  }
  Mesh mesh = maker.take();
  mesh.origin = lines.origin;
  stages.finish();
  return mesh;
}

}  // namespace brindle
