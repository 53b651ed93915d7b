#include "brindle/pattern/sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/memory.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "brindle/mesh_data.h"
#include "brindle/points/point_tree.h"
#include "brindle/texture_waves.h"

namespace brindle {
namespace {

using Barycentric2 = Eigen::Vector2d;  // the second and third barycentric coordinate

/// The offset of V's edge crossings along the edge, away from its lower vertex. Crossings of U and
/// V then never coincide, and the triangles of the edge agree on their order.
constexpr double kNudge = 1e-10;

/// Triangles per block, and the most crossings in it: more must be a mistake and exhaust memory.
constexpr std::size_t kBlock = 4096;
constexpr double kMostCrossings = 1 << 24;

constexpr std::size_t kBlocksPerReport = 8;

/// The number of lines in a triangle, or one more.
double line_count(const LiftedTriangle& triangle) {
  double peaks = 0;
  for (const EdgeLift& edge : triangle.edges) peaks += std::abs(static_cast<double>(edge.peaks));
  return peaks / 2 + 1;
}

double cross(const Barycentric2& a, const Barycentric2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The position of an edge crossing around the triangle: the edge's number plus the share along it.
double place_around(const PieceEnd& end, double nudge) {
  return end.side + end.barycentric[(end.side + 1) % 3] + nudge;
}

struct Segment {
  std::array<Barycentric2, 2> ends;
  std::array<double, 2> around;  ///< `place_around`; set for ends on edges
  bool from_edge_to_edge;
};

/// The pieces of one pattern in a triangle, nudged forward along the edges by `nudge`.
void make_segments(const LiftedTriangle& triangle, double nudge, std::vector<StripePiece>& pieces,
                   std::vector<Segment>& segments) {
  stripe_pieces(triangle, false, pieces);
  segments.clear();
  for (const StripePiece& piece : pieces) {
    Segment segment;
    segment.from_edge_to_edge = true;
    for (int e = 0; e < 2; ++e) {
      const PieceEnd& end = piece.ends[e];
      std::array<double, 3> b = end.barycentric;
      const bool on_edge = end.side < 3;
      if (on_edge) {
        const double way = triangle.forward[end.side] ? nudge : -nudge;
        segment.around[e] = place_around(end, way);
        b[(end.side + 1) % 3] += way;
        b[end.side] -= way;
      }
      segment.from_edge_to_edge &= on_edge;
      segment.ends[e] = {b[1], b[2]};
    }
    segments.push_back(segment);
  }
}

/// Points exactly on a line count as left of it, for both pieces that meet there.
bool left_of(const Barycentric2& p, const Segment& line) {
  return cross(line.ends[1] - line.ends[0], p - line.ends[0]) >= 0;
}

bool segments_cross(const Segment& u, const Segment& v) {
  if (u.from_edge_to_edge && v.from_edge_to_edge) {
    const auto [low, high] = std::minmax(u.around[0], u.around[1]);
    const auto between = [low = low, high = high](double p) { return p > low && p < high; };
    return between(v.around[0]) != between(v.around[1]);
  }
  return left_of(u.ends[0], v) != left_of(u.ends[1], v) &&
         left_of(v.ends[0], u) != left_of(v.ends[1], u);
}

/// The crossing of two segments that cross.
Barycentric2 crossing_of(const Segment& u, const Segment& v) {
  const Barycentric2 along = u.ends[1] - u.ends[0];
  const Barycentric2 other = v.ends[1] - v.ends[0];
  const double area = cross(along, other);
  const double t = area == 0 ? 0.5 : cross(v.ends[0] - u.ends[0], other) / area;
  return u.ends[0] + std::clamp(t, 0.0, 1.0) * along;
}

Vec3 inside_triangle(const Barycentric2& p) {
  Vec3 b(static_cast<float>(1 - p.x() - p.y()), static_cast<float>(p.x()),
         static_cast<float>(p.y()));
  b = b.cwiseMax(0.0f);
  return b / b.sum();
}

/// Interpolated direction and frequency; corners are oriented like the one of largest weight.
std::pair<Vec3, float> blended(const CornerWaves& corners, const Vec3& barycentric,
                               const Vec3& normal) {
  int first = 0;
  barycentric.maxCoeff(&first);
  Vec3 direction = Vec3::Zero();
  float frequency = 0;
  for (int m = 0; m < 3; ++m) {
    const Wave& wave = corners[m].wave;
    const float sign = wave.direction.dot(corners[first].wave.direction) < 0 ? -1.0f : 1.0f;
    direction += barycentric[m] * sign * wave.direction;
    frequency += barycentric[m] * wave.frequency;
  }
  direction -= direction.dot(normal) * normal;
  return {direction.stableNormalized(), frequency};
}

CornerWaves corner_waves_of(const LiftedWaves& waves, std::size_t t) {
  const WavePattern& pattern = waves.pattern();
  return corner_waves(pattern.mesh.triangles[t], pattern.waves, pattern.z);
}

class Sampler {
 public:
  Sampler(const LiftedWaves& u, const LiftedWaves& v) : u_(u), v_(v) {}

  void begin_block() { crossings_ = 0; }

  void sample(std::size_t t, std::vector<Sample>& samples) {
    const LiftedTriangle lifted_u = u_.triangle(t);
    if (!has_lines(lifted_u)) return;
    const LiftedTriangle lifted_v = v_.triangle(t);
    if (!has_lines(lifted_v)) return;
    crossings_ += line_count(lifted_u) * line_count(lifted_v);
    if (crossings_ > kMostCrossings) throw_too_many();
    make_segments(lifted_u, 0, pieces_, segments_u_);
    make_segments(lifted_v, kNudge, pieces_, segments_v_);
    for (const Segment& u : segments_u_) {
      for (const Segment& v : segments_v_) {
        if (segments_cross(u, v)) samples.push_back(make(t, inside_triangle(crossing_of(u, v))));
      }
    }
  }

 private:
  [[noreturn]] static void throw_too_many() {
    throw Error("stripes would cross more than " +
                std::to_string(static_cast<std::size_t>(kMostCrossings)) + " times in " +
                std::to_string(kBlock) + " triangles; ask for fewer");
  }

  /// Field singularities are skipped, because samples there would have no direction.
  static bool has_lines(const LiftedTriangle& triangle) {
    if (triangle.kind != TriangleKind::regular && triangle.kind != TriangleKind::branch) {
      return false;
    }
    return std::any_of(triangle.edges.begin(), triangle.edges.end(),
                       [](const EdgeLift& edge) { return edge.peaks != 0; });
  }

  Sample make(std::size_t t, const Vec3& barycentric) const {
    const Mesh& mesh = u_.pattern().mesh;
    const Triangle& corners = mesh.triangles[t];
    Sample sample;
    sample.triangle = static_cast<Index>(t);
    sample.barycentric = barycentric;
    const Vec3& first = mesh.positions[corners[0]];
    sample.position = first;
    sample.normal = Vec3::Zero();
    for (int m = 0; m < 3; ++m) {
      sample.position += barycentric[m] * (mesh.positions[corners[m]] - first);
      const Vec3& normal = u_.pattern().normals[corners[m]];
      sample.normal += (sample.normal.dot(normal) < 0 ? -1 : 1) * barycentric[m] * normal;
    }
    sample.normal.stableNormalize();
    const auto [direction_u, frequency_u] =
        blended(corner_waves_of(u_, t), barycentric, sample.normal);
    const auto [direction_v, frequency_v] =
        blended(corner_waves_of(v_, t), barycentric, sample.normal);
    sample.direction_u = direction_u;
    sample.direction_v = direction_v;
    sample.spacing_u = 1 / frequency_u;
    sample.spacing_v = 1 / frequency_v;
    return sample;
  }

  const LiftedWaves& u_;
  const LiftedWaves& v_;
  std::vector<StripePiece> pieces_;
  std::vector<Segment> segments_u_, segments_v_;
  double crossings_ = 0;  // upper bound in this block
};

float mean_frequency(const CornerWaves& corners) {
  return (corners[0].wave.frequency + corners[1].wave.frequency + corners[2].wave.frequency) / 3;
}

/// Checks memory for as many samples as a perfect grid on the surface would have.
void check_memory(const LiftedWaves& u, const LiftedWaves& v) {
  const Mesh& mesh = u.pattern().mesh;
  const auto count =
      parallel_sum<double>(mesh.triangle_count(), [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t t = begin; t < end; ++t) {
          sum += static_cast<double>(triangle_area(mesh, mesh.triangles[t])) *
                 static_cast<double>(mean_frequency(corner_waves_of(u, t))) *
                 static_cast<double>(mean_frequency(corner_waves_of(v, t)));
        }
        return sum;
      });
  // Samples by block, all samples, and copies for files and images.
  constexpr double kBytes = 3 * sizeof(Sample);
  check_fits(count, kBytes, "samples where these stripes cross", "points", [&](double most) {
    return "ask for fewer stripes: " + rounded_down(std::sqrt(most / count)) +
           " times as many of both would do";
  });
}

std::vector<Vec3> positions_of(std::span<const Sample> samples) {
  std::vector<Vec3> positions;
  positions.reserve(samples.size());
  for (const Sample& sample : samples) positions.push_back(sample.position);
  return positions;
}

float smaller_spacing(const Sample& sample) { return std::min(sample.spacing_u, sample.spacing_v); }

bool face_alike(const Sample& a, const Sample& b) { return a.normal.dot(b.normal) > 0; }

/// The nearest other sample within `reach` on the same side of the surface.
std::optional<Index> nearest_other(std::span<const Sample> samples, const PointTree& tree, Index i,
                                   float reach, std::vector<Index>& found) {
  tree.within(samples[i].position, reach, found);
  for (const Index other : found) {
    if (other != i && face_alike(samples[i], samples[other])) return other;
  }
  return {};
}

struct SpacingSums {
  PowerSums ratio;
  double doubles = 0;

  SpacingSums operator+(const SpacingSums& other) const {
    return {ratio + other.ratio, doubles + other.doubles};
  }
};

}  // namespace

std::vector<Sample> wave_samples(const LiftedWaves& u, const LiftedWaves& v,
                                 const Progress& progress) {
  check_memory(u, v);
  const std::size_t triangles = u.pattern().mesh.triangle_count();
  const std::size_t blocks = (triangles + kBlock - 1) / kBlock;
  std::vector<std::vector<Sample>> parts(blocks);
  parallel_for(
      blocks, progress,
      [&](std::size_t begin, std::size_t end) {
        Sampler sampler(u, v);
        for (std::size_t block = begin; block < end; ++block) {
          const std::size_t last = std::min((block + 1) * kBlock, triangles);
          sampler.begin_block();
          for (std::size_t t = block * kBlock; t < last; ++t) sampler.sample(t, parts[block]);
        }
      },
      1, kBlocksPerReport);
  std::size_t count = 0;
  for (const auto& part : parts) count += part.size();
  std::vector<Sample> samples;
  samples.reserve(count);
  for (auto& part : parts) {
    samples.insert(samples.end(), part.begin(), part.end());
    part = {};
  }
  return samples;
}

std::size_t drop_doubles(std::vector<Sample>& samples, float share, const Progress& progress) {
  if (samples.empty() || !(share > 0)) return 0;
  JobStages stages(progress, {{"nearby samples", 1}, {"double samples", 2}});
  const std::vector<Vec3> positions = positions_of(samples);
  const PointTree tree(positions, stages.begin("nearby samples"));
  std::vector<std::uint8_t> dropped(samples.size());
  std::vector<Index> found;
  const auto look_at = [&](std::size_t i) {
    const float own = smaller_spacing(samples[i]);
    tree.within(samples[i].position, share * own, found);
    dropped[i] = std::any_of(found.begin(), found.end(), [&](Index other) {
      const float distance = (positions[other] - positions[i]).norm();
      return other < i && !dropped[other] && face_alike(samples[i], samples[other]) &&
             distance < share * smaller_spacing(samples[other]);
    });
  };
  reported_for(samples.size(), stages.begin("double samples"), look_at);
  stages.finish();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!dropped[i]) samples[kept++] = samples[i];
  }
  const std::size_t count = samples.size() - kept;
  samples.resize(kept);
  return count;
}

SampleSpacing measure_sample_spacing(std::span<const Sample> samples, const Progress& progress) {
  JobStages stages(progress, {{"nearby samples", 1}, {"sample spacing", 2}});
  const std::vector<Vec3> positions = positions_of(samples);
  const PointTree tree(positions, stages.begin("nearby samples"));
  const auto sums = parallel_sum<SpacingSums>(
      samples.size(), stages.begin("sample spacing"), [&](std::size_t begin, std::size_t end) {
        SpacingSums part;
        std::vector<Index> found;
        for (std::size_t i = begin; i < end; ++i) {
          const float ideal = smaller_spacing(samples[i]);
          const auto other = nearest_other(samples, tree, static_cast<Index>(i), 2 * ideal, found);
          if (!other) continue;
          const double ratio = (positions[*other] - positions[i]).norm() / ideal;
          part.ratio.add(ratio);
          part.doubles += ratio < 0.1;
        }
        return part;
      });
  stages.finish();
  SampleSpacing spacing;
  spacing.samples = static_cast<std::size_t>(sums.ratio.count);
  if (spacing.samples == 0) return spacing;
  spacing.mean = sums.ratio.mean();
  spacing.deviation = sums.ratio.deviation();
  spacing.double_share = sums.doubles / sums.ratio.count;
  return spacing;
}

std::vector<DataArray> arrays_at(std::span<const Sample> samples,
                                 std::span<const Triangle> triangles, const DataArrays& arrays) {
  std::vector<TrianglePoint> places;
  std::vector<Index> rows;
  for (const Sample& sample : samples) {
    const Eigen::Vector3d shares = sample.barycentric.cast<double>();
    const Eigen::Vector3d b = shares / shares.sum();
    places.push_back({sample.triangle, {b[0], b[1], b[2]}});
    rows.push_back(sample.triangle);
  }
  return triangles.empty() ? rows_of(arrays.points, rows) : arrays_at(places, triangles, arrays);
}

namespace {

/// The search radius over the mean distance to the neighbours.
constexpr float kReach = 0.75f;
/// Sine of the angle between U and V below which they do not cross.
constexpr float kParallel = 0.1f;
/// A crossing may be farther from its point than from a neighbour by this factor.
constexpr float kFarther = 1.1f;

/// The distance along a wave to a peak; all others are at multiples of 1 / frequency from it.
float first_peak(const PointWaves& waves, Index i) {
  const float turns = elementary::arg(waves.z[i]) / (2 * std::numbers::pi_v<float>);
  return (0.25f - turns) / waves.waves.frequencies[i];
}

/// Calls `use(distance)` for every peak no farther than `reach`.
template <class Use>
void for_peaks(const PointWaves& waves, Index i, float reach, const Use& use) {
  const float frequency = waves.waves.frequencies[i];
  const float first = first_peak(waves, i);
  const float last = std::floor((reach - first) * frequency);
  for (float k = std::ceil((-reach - first) * frequency); k <= last; ++k) {
    use(first + k / frequency);
  }
}

class PointSampler {
 public:
  PointSampler(const Adjacency& neighborhood, std::span<const Vec3> normals, const PointWaves& u,
               const PointWaves& v)
      : neighborhood_(neighborhood), normals_(normals), u_(u), v_(v) {}

  void add_samples(Index i, std::vector<Sample>& samples) const {
    const Vec3& d_u = u_.waves.directions[i];
    const Vec3& d_v = v_.waves.directions[i];
    const Vec3 across = normals_[i].cross(d_u);
    const float sine = d_v.dot(across);
    if (d_u.isZero(0) || std::abs(sine) < kParallel || neighborhood_.of(i).empty()) return;
    const float cosine = d_v.dot(d_u), reach = reach_of(i);
    for_peaks(u_, i, reach, [&](float along) {
      // Where U's peak crosses V's: <x, d_v> = distance.
      const float widest = std::abs(cosine * along) + std::abs(sine) * reach;
      for_peaks(v_, i, widest, [&](float distance) {
        const Vec3 x = along * d_u + (distance - cosine * along) / sine * across;
        if (x.norm() <= reach && is_nearest(i, x)) samples.push_back(sample_at(i, x));
      });
    });
  }

 private:
  float reach_of(Index i) const {
    float sum = 0;
    for (const Index j : neighborhood_.of(i)) sum += offset(i, j).norm();
    return kReach * sum / static_cast<float>(neighborhood_.of(i).size());
  }

  Vec3 offset(Index i, Index j) const { return u_.waves.positions[j] - u_.waves.positions[i]; }

  bool is_nearest(Index i, const Vec3& x) const {
    const float distance = x.norm();
    return ranges::all_of(neighborhood_.of(i), [&](Index j) {
      return distance <= kFarther * (x - offset(i, j)).norm();
    });
  }

  Sample sample_at(Index i, const Vec3& x) const {
    return {u_.waves.positions[i] + x,
            normals_[i],
            u_.waves.directions[i],
            v_.waves.directions[i],
            1 / u_.waves.frequencies[i],
            1 / v_.waves.frequencies[i],
            i,
            Vec3(1, 0, 0)};
  }

  const Adjacency& neighborhood_;
  std::span<const Vec3> normals_;
  const PointWaves& u_;
  const PointWaves& v_;
};

}  // namespace

std::vector<Sample> point_samples(const Adjacency& neighborhood, std::span<const Vec3> normals,
                                  const PointWaves& u, const PointWaves& v) {
  const PointSampler sampler(neighborhood, normals, u, v);
  std::vector<Sample> samples;
  for (Index i = 0; i < neighborhood.node_count(); ++i) sampler.add_samples(i, samples);
  drop_doubles(samples);
  return samples;
}

}  // namespace brindle
