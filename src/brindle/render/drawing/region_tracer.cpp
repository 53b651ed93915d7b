#include "brindle/render/drawing/region_tracer.h"

#include <algorithm>
#include <array>

#include "brindle/base/parallel.h"

namespace brindle {
namespace {

using Eigen::Vector2d;

constexpr int kPointsPerPixel = 2;  // along a side
constexpr int kHalvings = 11;       // of half a pixel: leaves a quarter of a thousandth
constexpr int kDeepest = 6;         // subdivisions of an outline segment
constexpr int kRowsAtOnce = 64;     // between two progress reports

/// Calls `body(i)` for all of [0, count) in parallel, with progress reports in between.
template <class Body>
void for_parts(std::size_t count, std::size_t part, std::size_t grain, const Progress& progress,
               const Body& body) {
  for (std::size_t first = 0; first < count; first += part) {
    progress.report(static_cast<double>(first) / static_cast<double>(count));
    const std::size_t length = std::min(part, count - first);
    parallel_for(
        length,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) body(first + i);
        },
        grain);
  }
}

}  // namespace

RegionTracer::RegionTracer(int width, int height, const CodeAt& code_at, const Progress& progress)
    : columns_(kPointsPerPixel * width + 2),
      rows_(kPointsPerPixel * height + 2),
      code_at_(code_at) {
  codes_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for_parts(static_cast<std::size_t>(rows_), kRowsAtOnce, 1, progress, [&](std::size_t row) {
    for (int column = 0; column < columns_; ++column) {
      const std::size_t point = point_number(column, static_cast<int>(row));
      const Vector2d place = place_of(point);
      codes_[point] = code_at_(place.x(), place.y());
    }
  });
}

/// The outermost points lie a quarter of a pixel outside the picture.
Vector2d RegionTracer::place_of(std::size_t point) const {
  const auto columns = static_cast<std::size_t>(columns_);
  return {(static_cast<double>(point % columns) - 0.5) / kPointsPerPixel,
          (static_cast<double>(point / columns) - 0.5) / kPointsPerPixel};
}

void RegionTracer::add_passages(const Region& region, int column, int row,
                                std::vector<Passage>& passages) const {
  const std::size_t corner = point_number(column, row);
  const std::size_t below = point_number(column, row + 1);
  // Corners and the edges after them, around the cell.
  const std::array<bool, 4> in{region.has(codes_[corner]), region.has(codes_[corner + 1]),
                               region.has(codes_[below + 1]), region.has(codes_[below])};
  if (in[0] == in[1] && in[1] == in[2] && in[2] == in[3]) return;
  const std::array<std::size_t, 4> edges{2 * corner, 2 * (corner + 1) + 1, 2 * below,
                                         2 * corner + 1};
  const bool saddle = in[0] == in[2] && in[1] == in[3];
  const bool middle =
      saddle && covered(region, place_of(corner) + Vector2d::Constant(0.5 / kPointsPerPixel));
  // A line enters where the corners change from outside to inside, and leaves where they change
  // back; if the cell's middle is inside, it passes through the middle.
  for (std::size_t k = 0; k < 4; ++k) {
    if (in[k] || !in[(k + 1) % 4]) continue;
    std::size_t leave = (k + 3) % 4;
    if (!middle) {
      for (leave = (k + 1) % 4; !(in[leave] && !in[(leave + 1) % 4]);) leave = (leave + 1) % 4;
    }
    passages.push_back({edges[k], edges[leave]});
  }
}

std::vector<RegionTracer::Passage> RegionTracer::passages_of(const Region& region,
                                                             const Progress& progress) const {
  std::vector<std::vector<Passage>> of_row(static_cast<std::size_t>(rows_ - 1));
  for_parts(of_row.size(), 8 * kRowsAtOnce, 8, progress, [&](std::size_t row) {
    for (int column = 0; column + 1 < columns_; ++column) {
      add_passages(region, column, static_cast<int>(row), of_row[row]);
    }
  });
  std::vector<Passage> passages;
  for (std::vector<Passage>& row : of_row) {
    passages.insert(passages.end(), row.begin(), row.end());
    row = {};
  }
  std::sort(passages.begin(), passages.end(),
            [](const Passage& a, const Passage& b) { return a.edge < b.edge; });
  return passages;
}

Vector2d RegionTracer::change_between(const Region& region, Vector2d in, Vector2d out) const {
  for (int i = 0; i < kHalvings; ++i) {
    const Vector2d middle = 0.5 * (in + out);
    (covered(region, middle) ? in : out) = middle;
  }
  return 0.5 * (in + out);
}

Vector2d RegionTracer::crossing(const Region& region, std::size_t edge) const {
  const std::size_t from = edge / 2;
  const std::size_t to = from + (edge % 2 == 1 ? static_cast<std::size_t>(columns_) : 1);
  const bool begins_in = region.has(codes_[from]);
  return begins_in ? change_between(region, place_of(from), place_of(to))
                   : change_between(region, place_of(to), place_of(from));
}

/// Adds points between two others where the outline leaves the straight line. The search goes to
/// both sides of the midpoint, up to a right angle.
void RegionTracer::refine(const Region& region, const Vector2d& from, const Vector2d& to,
                          double tolerance, int depth, OutlineLoop& loop) const {
  constexpr int kSteps = 8;
  const Vector2d way = to - from;
  const double length = way.norm();
  if (depth == kDeepest || length < 2 * tolerance) return;
  const Vector2d middle = 0.5 * (from + to);
  const Vector2d inwards = Vector2d(way.y(), -way.x()) / length;
  const bool inner = covered(region, middle + tolerance * inwards);
  const bool outer = covered(region, middle - tolerance * inwards);
  // Both or neither inside: another outline is as near.
  if (inner != outer) return;
  const Vector2d beyond = inner ? Vector2d(-inwards) : inwards;  // towards the outline
  Vector2d last = middle + tolerance * beyond;
  for (int k = 1; k <= kSteps; ++k) {
    const Vector2d next = middle + (tolerance + 0.6 * length * k / kSteps) * beyond;
    if (covered(region, next) == inner) {
      last = next;
      continue;
    }
    const Vector2d point =
        inner ? change_between(region, last, next) : change_between(region, next, last);
    refine(region, from, point, tolerance, depth + 1, loop);
    loop.push_back(point);
    refine(region, point, to, tolerance, depth + 1, loop);
    return;
  }
}

std::vector<OutlineLoop> RegionTracer::outlines(std::uint16_t first, std::uint16_t last,
                                                double tolerance, const Progress& progress) const {
  constexpr std::size_t kAtOnce = 1 << 14, kGrain = 256;
  const Region region{first, last};
  const std::vector<Passage> passages = passages_of(region, progress.part(0, 0.2));
  std::vector<std::size_t> next(passages.size());
  OutlineLoop places(passages.size());
  for_parts(passages.size(), kAtOnce, kGrain, progress.part(0.2, 0.6), [&](std::size_t i) {
    const auto found =
        std::lower_bound(passages.begin(), passages.end(), passages[i].next,
                         [](const Passage& p, std::size_t edge) { return p.edge < edge; });
    next[i] = static_cast<std::size_t>(found - passages.begin());
    places[i] = crossing(region, passages[i].edge);
  });
  std::vector<OutlineLoop> between(passages.size());
  for_parts(passages.size(), kAtOnce, kGrain, progress.part(0.6, 1), [&](std::size_t i) {
    refine(region, places[i], places[next[i]], tolerance, 0, between[i]);
  });
  std::vector<OutlineLoop> loops;
  std::vector<char> passed(passages.size(), 0);
  for (std::size_t start = 0; start < passages.size(); ++start) {
    if (passed[start] != 0) continue;
    OutlineLoop loop;
    for (std::size_t i = start; passed[i] == 0; i = next[i]) {
      passed[i] = 1;
      loop.push_back(places[i]);
      loop.insert(loop.end(), between[i].begin(), between[i].end());
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace brindle
