#include "brindle/waves/frequency_rows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "brindle/base/parallel.h"
#include "brindle/waves/circulation.h"

namespace brindle {
namespace {

constexpr float kSmoothness = 0.03f;  ///< eta
/// mu times the square of the radius of gyration. The radius is about 0.29 of the diagonal for
/// spheres and squares and does not depend on rotations.
constexpr double kFaithfulness = 0.25;

/// Area, its moments, and squares of circulations.
struct Moments {
  double area = 0, square = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  double circulation = 0;

  Moments operator+(const Moments& o) const {
    return {area + o.area, square + o.square, first + o.first, circulation + o.circulation};
  }
  void add(float triangle_area, const Vec3& at) {
    const double a = triangle_area;
    area += a;
    first += a * at.cast<double>();
    square += a * at.cast<double>().squaredNorm();
  }
  std::array<double, 5> numbers() const { return {area, square, first[0], first[1], first[2]}; }
  static Moments of(const std::array<double, 5>& n) { return {n[0], n[1], {n[2], n[3], n[4]}, 0}; }
  double square_of_gyration() const {
    return area > 0 ? std::max(0.0, (square - first.squaredNorm() / area) / area) : 0;
  }
};

/// The scale of frequencies and positions.
struct Scale {
  double squares = 0, count = 0;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< from one process; 0 in all others

  std::array<double, 5> numbers() const {
    return {squares, count, origin[0], origin[1], origin[2]};
  }
  static Scale of(const std::array<double, 5>& n) { return {n[0], n[1], {n[2], n[3], n[4]}}; }
  float unit() const {
    return count > 0 ? static_cast<float>(1 / std::sqrt(squares / count)) : 1.0f;
  }
};

/// `own` is the number of vertices with rows on this process.
Scale scale_of(const FrequencyInput& input, std::size_t own, MultigridPeers* peers) {
  Scale scale;
  scale.count = static_cast<double>(own);
  scale.squares = parallel_sum<double>(own, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) {
      sum += static_cast<double>(input.wanted[i]) * static_cast<double>(input.wanted[i]);
    }
    return sum;
  });
  const bool has_origin = peers == nullptr ? own > 0 : peers->has_first_node();
  if (has_origin) scale.origin = input.positions[0].cast<double>();
  return over_all(peers, scale);
}

/// Triangles, one per lane.
struct TriangleLanes {
  std::array<LaneVectors, 3> corners, directions;
  std::array<Lanes, 3> f;
  Lanes weight;
  std::array<bool, kTriangleLanes> has_waves{};
};

/// `count` triangles from `first` on; further lanes repeat the last.
TriangleLanes gathered(const FrequencyTriangles& triangles, std::size_t first, std::size_t count,
                       const FrequencyInput& input, float unit, const Vec3& origin) {
  const float scale = 1 / unit;  // lengths in periods: their squares stay in the range of floats
  TriangleLanes lanes;
  for (int l = 0; l < kTriangleLanes; ++l) {
    const std::size_t t = first + std::min<std::size_t>(static_cast<std::size_t>(l), count - 1);
    lanes.has_waves[l] = true;
    for (int m = 0; m < 3; ++m) {
      const Index vertex = triangles.corners[t][m];
      const Vec3 corner = scale * (input.positions[vertex] - origin);
      const Vec3& direction = input.directions[vertex];
      for (int k = 0; k < 3; ++k) {
        lanes.corners[m][k][l] = corner[k];
        lanes.directions[m][k][l] = direction[k];
      }
      lanes.f[m][l] = unit * input.wanted[vertex];
      lanes.has_waves[l] &= !direction.isZero(0);
    }
    lanes.weight[l] = triangles.weights.empty() ? 1 : triangles.weights[t];
  }
  return lanes;
}

/// Terms of triangles, one per lane.
struct TermLanes {
  std::array<Lanes, 3> beside, pull;
  Lanes area, weight, circulation;  ///< its square

  TriangleTerms at(int l) const {
    return {{beside[0][l], beside[1][l], beside[2][l]},
            {pull[0][l], pull[1][l], pull[2][l]},
            area[l] / 3,
            weight[l] * area[l] / 3};
  }
};

/// The circulation of g d over the triangle's mean g, to first order in the logarithms of g / f:
/// its value for g = f and its derivatives.
TermLanes terms_of(const TriangleLanes& lanes) {
  const TriangleShapes shapes = triangle_shapes(lanes.corners);
  const std::array<Lanes, 3> coefficient = circulation_coefficients(shapes, lanes.directions);
  const Lanes root = square_root(lanes.weight / divisor(shapes.area));
  std::array<Lanes, 3> c;
  for (int m = 0; m < 3; ++m) c[m] = root * coefficient[m] * lanes.f[m];
  const Lanes whole = c[0] + c[1] + c[2];
  for (int m = 0; m < 3; ++m) c[m] -= whole / 3;
  const std::array<Lanes, 3>& f = lanes.f;
  const Lanes stiffness = kSmoothness * (f[0] * f[0] + f[1] * f[1] + f[2] * f[2]) / 3;
  TermLanes terms;
  for (int m = 0; m < 3; ++m) {
    const int next = (m + 1) % 3, previous = (m + 2) % 3;
    terms.beside[m] = c[next] * c[previous] - stiffness * shapes.half_cotangent[m];
    terms.pull[m] = -whole * c[m];
  }
  terms.area = shapes.area;
  terms.weight = lanes.weight;
  terms.circulation = whole * whole;
  return terms;
}

Vec3 middle_of(const std::array<LaneVectors, 3>& corners, int l) {
  Vec3 sum = Vec3::Zero();
  for (const LaneVectors& corner : corners) sum += Vec3(corner[0][l], corner[1][l], corner[2][l]);
  return sum / 3;
}

bool has_three_vertices(const Triangle& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; }

/// Strengths for merging nodes: strong along stripes, weak across them.
std::vector<float> stripe_strengths(const Adjacency& adjacency, const FrequencyInput& input) {
  std::vector<float> strengths(adjacency.directed_edge_count());
  parallel_for(adjacency.node_count(), [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      for (Index e = adjacency.offsets[i]; e < adjacency.offsets[i + 1]; ++e) {
        const Index j = adjacency.neighbors[e];
        const Vec3 edge = (input.positions[j] - input.positions[i]).stableNormalized();
        const float from = edge.dot(input.directions[j]), to = edge.dot(input.directions[i]);
        strengths[e] = std::max(0.0f, 1 - (from * from + to * to) / 2) + kSmoothness;
      }
    }
  });
  return strengths;
}

Index entry_of(const RowLevel& rows, Index row, Index column) {
  const auto begin = rows.columns.begin() + rows.offsets[row];
  const auto end = rows.columns.begin() + rows.offsets[row + 1];
  return static_cast<Index>(std::find(begin, end, column) - rows.columns.begin());
}

RowLevels levels_for(const Adjacency& adjacency, const FrequencyInput& input, MultigridPeers* peers,
                     const Progress& progress) {
  const std::vector<float> strengths = stripe_strengths(adjacency, input);
  return peers == nullptr ? row_levels(adjacency, strengths, progress)
                          : peers->make_levels(adjacency, strengths);
}

}  // namespace

FrequencyRows::FrequencyRows(const FrequencyTriangles& triangles, const Adjacency& adjacency,
                             const FrequencyInput& input, MultigridPeers* peers,
                             const Progress& progress)
    : levels_(std::make_shared<const RowLevels>(levels_for(adjacency, input, peers, progress))) {
  set_triangles(triangles, progress);
  set_corners(progress);
}

void FrequencyRows::set_triangles(const FrequencyTriangles& triangles, const Progress& progress) {
  const std::vector<Index>& place_of = levels_->place_of;
  std::vector<Index> offsets(place_of.size() + 1);
  const auto first_place = [&](const Triangle& t) {
    return std::min({place_of[t[0]], place_of[t[1]], place_of[t[2]]});
  };
  for (std::size_t t = 0; t < triangles.corners.size(); ++t) {
    if (t % kReportSlice == 0) progress.tick();
    const Triangle& triangle = triangles.corners[t];
    if (has_three_vertices(triangle)) ++offsets[first_place(triangle) + 1];
  }
  for (std::size_t i = 1; i < offsets.size(); ++i) offsets[i] += offsets[i - 1];
  const Index count = offsets.back();
  triangles_.corners.resize(count);
  triangles_.weights.resize(triangles.weights.empty() ? 0 : count);
  triangles_.counted.resize(triangles.counted.empty() ? 0 : count);
  for (std::size_t t = 0; t < triangles.corners.size(); ++t) {
    if (t % kReportSlice == 0) progress.tick();
    if (!has_three_vertices(triangles.corners[t])) continue;
    const Index place = offsets[first_place(triangles.corners[t])]++;
    triangles_.corners[place] = triangles.corners[t];
    if (!triangles.weights.empty()) triangles_.weights[place] = triangles.weights[t];
    if (!triangles.counted.empty()) triangles_.counted[place] = triangles.counted[t];
  }
}

void FrequencyRows::set_corners(const Progress& progress) {
  const RowLevel& rows = levels_->levels[0];
  const std::vector<Index>& place_of = levels_->place_of;
  const auto& triangles = triangles_.corners;
  corners_ = compressed_rows<Corner>(rows.size(), [&](const auto& add) {
    for (Index t = 0; t < triangles.size(); ++t) {
      if (t % kReportSlice == 0) progress.tick();
      for (Index m = 0; m < 3; ++m) {
        const Index vertex = triangles[t][m];
        if (vertex < own()) add(place_of[vertex], {4 * t + m, 0, 0});
      }
    }
  });
  parallel_for(rows.size(), [&](std::size_t begin, std::size_t end) {
    for (auto row = static_cast<Index>(begin); row < end; ++row) {
      for (Corner& at : corners_.of(row)) {
        const Triangle& triangle = triangles[at.corner / 4];
        const Index m = at.corner % 4;
        at.next = entry_of(rows, row, place_of[triangle[(m + 1) % 3]]);
        at.previous = entry_of(rows, row, place_of[triangle[(m + 2) % 3]]);
      }
    }
  });
}

void FrequencyRows::set_terms(const FrequencyInput& input, MultigridPeers* peers,
                              FrequencyTerms& terms) const {
  const Scale scale = scale_of(input, own(), peers);
  const float unit = scale.unit();
  const Vec3 origin = scale.origin.cast<float>();
  const auto moments_of = [&](std::size_t begin, std::size_t end) {
    Moments moments;
    for (std::size_t first = begin; first < end; first += kTriangleLanes) {
      const std::size_t count = std::min<std::size_t>(kTriangleLanes, end - first);
      const TriangleLanes lanes = gathered(triangles_, first, count, input, unit, origin);
      const TermLanes found = terms_of(lanes);
      for (int l = 0; l < static_cast<int>(count); ++l) {
        const std::size_t t = first + static_cast<std::size_t>(l);
        const bool counts = lanes.has_waves[l] && found.area[l] > 0;
        terms.triangles[t] = counts ? found.at(l) : TriangleTerms{};
        if (!counts || (!triangles_.counted.empty() && !triangles_.counted[t])) continue;
        moments.add(found.area[l], middle_of(lanes.corners, l));
        moments.circulation += static_cast<double>(found.circulation[l]);
      }
    }
    return moments;
  };
  const auto own_moments = parallel_sum<Moments>(triangles_.corners.size(), moments_of);
  const double square = over_all(peers, own_moments).square_of_gyration();
  terms.unit = unit;
  terms.faithfulness = static_cast<float>(square > 0 ? kFaithfulness / square : 0);
  terms.constant = own_moments.circulation;
}

void FrequencyRows::set(const FrequencyTerms& terms, std::span<const float> wanted,
                        BoundedMultigrid& multigrid, std::span<RowMass> masses) const {
  const RowLevel& rows = levels_->levels[0];
  const std::span<float> values = multigrid.values(), diagonals = multigrid.diagonal();
  const std::span<float> right = multigrid.right();
  parallel_for(rows.size(), [&](std::size_t begin, std::size_t end) {
    std::fill(values.begin() + rows.offsets[begin], values.begin() + rows.offsets[end], 0.0f);
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      float diagonal = 0, area = 0, faith = 0, pull = 0;
      for (const Corner& at : corners_.of(i)) {
        const TriangleTerms& term = terms.triangles[at.corner / 4];
        const Index m = at.corner % 4;
        const float to_next = term.beside[m == 0 ? 2 : m - 1];
        const float to_previous = term.beside[m == 2 ? 0 : m + 1];
        diagonal -= to_next + to_previous;
        area += term.mass;
        faith += term.faith;
        pull += term.pull[m];
        values[at.next] += to_next;
        values[at.previous] += to_previous;
      }
      const float f = terms.unit * wanted[levels_->node_at[i]];
      masses[i] = {area, terms.faithfulness * faith * f * f};
      right[i] = pull + masses[i].pull;
      diagonals[i] = diagonal + masses[i].pull;
    }
  });
}

}  // namespace brindle
