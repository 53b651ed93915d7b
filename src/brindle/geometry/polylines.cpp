#include "brindle/polylines.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/memory.h"
#include "brindle/base/number_text.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"

namespace brindle {
namespace {

/// Points are numbered by Index.
constexpr double kMostPoints = 0xfffffff0;

std::string shortest_text(float number) {
  char text[32];
  return {text, write_number(text, text + sizeof text, number).ptr};
}

/// Marks the points to keep between `first` and `last` (Douglas-Peucker). `last` may be the number
/// of points, for the first point of a closed line.
void keep_farthest(std::span<const Vec3> points, std::size_t first, std::size_t last,
                   float tolerance, std::vector<std::uint8_t>& keep) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    float farthest = tolerance;
    std::size_t at = 0;
    for (std::size_t i = from + 1; i < to; ++i) {
      const float d = distance_to_segment(points[i], points[from], points[to % points.size()]);
      if (d > farthest) farthest = d, at = i;
    }
    if (at == 0) continue;
    keep[at] = 1;
    open.emplace_back(from, at);
    open.emplace_back(at, to);
  }
}

std::size_t farthest_from_first(std::span<const Vec3> points) {
  const auto farther = [&](const Vec3& a, const Vec3& b) {
    return (a - points[0]).squaredNorm() < (b - points[0]).squaredNorm();
  };
  return static_cast<std::size_t>(std::max_element(points.begin(), points.end(), farther) -
                                  points.begin());
}

/// Number of steps along a line: at least one, on closed lines three.
double steps_along(double length, double spacing, bool closed) {
  return std::max(std::round(length / spacing), closed ? 3.0 : 1.0);
}

/// The number of points at a spacing.
double points_at(const Polylines& lines, std::span<const double> lengths, double spacing) {
  double points = 0;
  for (std::size_t line = 0; line < lengths.size(); ++line) {
    const bool closed = lines.closed[line];
    points += steps_along(lengths[line], spacing, closed) + (closed ? 0 : 1);
  }
  return points;
}

/// The smallest spacing, to two digits, at which lines have at most `most` points.
std::string smallest_spacing(const Polylines& lines, std::span<const double> lengths, double most) {
  double length = 0;
  for (const double l : lengths) length += l;
  double spacing = length / most;
  // Every line has a minimum number of points, and steps are whole.
  while (spacing < length && points_at(lines, lengths, spacing) > most) spacing *= 1.05;
  if (points_at(lines, lengths, spacing) > most) return "no spacing would do for so many lines";
  return "the smallest spacing that would do is " + rounded_up(spacing);
}

/// The lengths of all lines. Throws TooLarge if memory cannot hold their points at this spacing.
std::vector<double> checked_lengths(const Polylines& lines, float spacing) {
  if (!(spacing > 0)) throw Error("the spacing of points along curves must be above zero");
  std::vector<double> lengths(lines.count());
  for (std::size_t line = 0; line < lengths.size(); ++line) lengths[line] = length_of(lines, line);
  // Includes the memory for writing files.
  constexpr double kBytes = 2 * (sizeof(Vec3) + sizeof(Vec3) + sizeof(TrianglePoint));
  const double points = points_at(lines, lengths, spacing);
  const auto remedy = [&](double most) {
    return smallest_spacing(lines, lengths, std::min(most, kMostPoints));
  };
  const std::string what = "curves with points every " + shortest_text(spacing);
  check_fits(points, kBytes, what, "points", remedy);
  if (points > kMostPoints) {
    throw TooLarge(what + " would be more points than brindle can number; " + remedy(kMostPoints),
                   kMostPoints / points);
  }
  return lengths;
}

}  // namespace

void Polylines::add(const Polylines& lines, std::size_t first, std::size_t end) {
  const auto append = [&](const auto& from, auto& to) {
    const auto begin = from.begin() + static_cast<std::ptrdiff_t>(first);
    if (!from.empty()) to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(end - first));
  };
  append(lines.points, points);
  append(lines.normals, normals);
  append(lines.places, places);
  append(lines.arrivals, arrivals);
}

TrianglePoint Polylines::place_on(std::size_t point, double share) const {
  TrianglePoint place = places[point];
  for (std::size_t m = 0; m < 3; ++m) {
    place.barycentric[m] += share * (arrivals[point][m] - place.barycentric[m]);
  }
  return place;
}

float distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const float square = along.squaredNorm();
  const float t = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0f, 1.0f) : 0.0f;
  return (p - a - t * along).norm();
}

double length_of(const Polylines& lines, std::size_t line) {
  const auto points = lines.points_of(line);
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  if (lines.closed[line] && !points.empty()) length += (points.front() - points.back()).norm();
  return length;
}

Polylines simplified(const Polylines& lines, float tolerance, const Progress& progress) {
  JobStages stages(progress, {{"simplify", 1}});
  Reporter reporter(stages.begin("simplify"), lines.points.size());
  Polylines result;
  result.origin = lines.origin;
  std::vector<std::uint8_t> keep;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    const auto points = lines.points_of(line);
    reporter.done(points.size());
    keep.assign(points.size(), 0);
    keep.front() = 1;
    if (lines.closed[line]) {
      const std::size_t far = farthest_from_first(points);
      keep[far] = 1;
      keep_farthest(points, 0, far, tolerance, keep);
      keep_farthest(points, far, points.size(), tolerance, keep);
    } else {
      keep.back() = 1;
      keep_farthest(points, 0, points.size() - 1, tolerance, keep);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!keep[i]) continue;
      result.add(points[i], lines.normals_of(line)[i]);
      if (!lines.places.empty()) result.places.push_back(lines.places[lines.offsets[line] + i]);
    }
    result.end_line(lines.closed[line]);
  }
  stages.finish();
  return result;
}

Polylines resampled(const Polylines& lines, float spacing, const Progress& progress) {
  const std::vector<double> lengths = checked_lengths(lines, spacing);
  JobStages stages(progress, {{"resample", 1}});
  Reporter reporter(stages.begin("resample"),
                    static_cast<std::size_t>(points_at(lines, lengths, spacing)));
  Polylines result;
  result.origin = lines.origin;
  const bool placed = !lines.arrivals.empty();
  for (std::size_t line = 0; line < lines.count(); ++line) {
    const auto points = lines.points_of(line);
    const auto normals = lines.normals_of(line);
    const double length = lengths[line];
    const bool closed = lines.closed[line];
    const auto steps = static_cast<std::size_t>(steps_along(length, spacing, closed));
    std::size_t segment = 0;
    double passed = 0;  // length up to the segment's start
    for (std::size_t step = 0; step < steps; ++step) {
      reporter.done(1);
      const double goal = length * static_cast<double>(step) / static_cast<double>(steps);
      const auto end = [&] { return (segment + 1) % points.size(); };
      double size = (points[end()] - points[segment]).norm();
      while (passed + size < goal && segment + 2 < points.size() + closed) {
        passed += size;
        ++segment;
        size = (points[end()] - points[segment]).norm();
      }
      const float t = size > 0 ? static_cast<float>(std::min((goal - passed) / size, 1.0)) : 0.0f;
      const Vec3 normal = (1 - t) * normals[segment] + t * normals[end()];
      result.add(points[segment] + t * (points[end()] - points[segment]),
                 normal.stableNormalized());
      if (placed) result.places.push_back(lines.place_on(lines.offsets[line] + segment, t));
    }
    if (!closed) {
      result.add(points.back(), normals.back());
      if (placed) result.places.push_back(lines.places[lines.offsets[line + 1] - 1]);
    }
    result.end_line(closed);
  }
  stages.finish();
  return result;
}

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
