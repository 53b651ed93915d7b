#include "brindle/distributed_pattern.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include <gtest/gtest.h>

#include "brindle/distributed/gathered_pattern.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/error.h"
#include "brindle/geometry/topology.h"
#include "brindle/pattern/sampling.h"
#include "brindle/pattern/stripe_curves.h"
#include "brindle/stripe_pattern.h"
#include "ranks.h"
#include "test_meshes.h"

namespace brindle {
namespace {

using namespace testing_support;

/// A surface with phases that one process solved, the same on all ranks.
struct Solved {
  WavySurface whole;
  std::vector<Complex> z;
  MeshEdges edges;

  explicit Solved(WavySurface surface) : whole(std::move(surface)) {
    z = stripe_pattern(make_surface(whole.mesh), whole.waves).solution.z;
    edges = mesh_edges(whole.mesh, *whole.neighborhood);
  }

  WavePattern pattern() const { return {whole.mesh, edges, whole.normals, whole.waves, z}; }
};

/// The same phases on the piece of a rank.
struct SolvedPiece {
  Parts parts;
  DistributedSurface surface;
  WaveSet waves;
  std::vector<Complex> z;

  SolvedPiece(const Solved& solved, const std::vector<int>& rank_of_triangle)
      : parts(solved.whole, rank_of_triangle),
        surface(parts.surface()),
        waves(parts.of_piece(solved.whole.waves)),
        z(parts.of_piece(solved.z)) {}

  PiecePattern pattern() const { return {surface, waves, z}; }
};

/// Waves of every vertex in a ball are taken away.
WavySurface with_hole(WavySurface surface, float radius) {
  const Vec3 centre = surface.mesh.positions[0];
  for (std::size_t v = 0; v < surface.mesh.vertex_count(); ++v) {
    if ((surface.mesh.positions[v] - centre).norm() < radius) {
      surface.waves.directions[v].setZero();
    }
  }
  return surface;
}

std::vector<Solved> solve_surfaces() {
  std::vector<Solved> surfaces;
  for (const char* shape :
       {"torus,resolution=40", "trefoil,resolution=20", "molecule,resolution=18",
        "pieces,resolution=8", "sheets,resolution=20", "mobius,resolution=12"}) {
    surfaces.emplace_back(wavy_surface(shape, kAxis, 24));
  }
  surfaces.emplace_back(with_hole(wavy_surface("sphere,resolution=16", kAxis, 24), 0.5f));
  surfaces.emplace_back(wavy_surface("plane,resolution=30", kAxis, 60));  // several peaks an edge
  return surfaces;
}

/// For all tests.
const std::vector<Solved>& solved_surfaces() {
  static const std::vector<Solved> surfaces = solve_surfaces();
  return surfaces;
}

/// Waves that are dense here and sparse there, and missing in a ball.
WavySurface with_uneven_waves(const char* shape, float stripes) {
  WavySurface surface = with_hole(wavy_surface(shape, kAxis, stripes), 0.3f);
  for (std::size_t v = 0; v < surface.mesh.vertex_count(); ++v) {
    surface.waves.frequencies[v] *= 1.5f + surface.mesh.positions[v].normalized().x();
  }
  return surface;
}

void expect_metrics(const WaveMetrics& found, const WaveMetrics& expected) {
  EXPECT_EQ(found.used, expected.used);
  EXPECT_EQ(found.without_wave, expected.without_wave);
  EXPECT_EQ(found.frequency_min, expected.frequency_min);
  EXPECT_EQ(found.frequency_max, expected.frequency_max);
  const auto expect_same = [](double a, double b) { EXPECT_NEAR(a, b, 1e-6 * b); };
  expect_same(found.stripes, expected.stripes);
  expect_same(found.edges_per_period_min, expected.edges_per_period_min);
  expect_same(found.edges_per_period_median, expected.edges_per_period_median);
}

// A vertex counts once, with all its edges, and what a rank that does not own it says is not heard.
TEST(DistributedWaves, AreMeasuredAsTheWholesHoweverItIsCut) {
  for (const char* shape :
       {"torus,resolution=30", "mobius,resolution=12", "sphere,resolution=16"}) {
    for (const float stripes : {8.0f, 200.0f}) {
      const WavySurface whole = with_uneven_waves(shape, stripes);
      const WaveMetrics expected = measure_waves(make_surface(whole.mesh), whole.waves);
      ASSERT_GT(expected.without_wave, 0u);
      for (const Cut& cut : cuts()) {
        SCOPED_TRACE(std::string(shape) + ", " + cut.name);
        const Parts parts(whole, cut.rank_of_triangle(whole.mesh));
        const DistributedSurface surface = parts.surface();
        WaveSet waves = parts.of_piece(whole.waves);
        waves.positions.clear();
        for (std::size_t p = 0; p < waves.directions.size(); ++p) {
          if (!surface.is_own()[p]) waves.frequencies[p] = 1e6f;
        }
        const WaveMetrics found = measure_waves(surface, waves);
        expect_metrics(found, expected);
        EXPECT_EQ(wave_warnings(found), wave_warnings(expected));
      }
    }
  }
}

TEST(DistributedWaves, OfNoWaveHaveNoMetrics) {
  const WavySurface whole = with_hole(wavy_surface("torus,resolution=12", kAxis, 8), 100);
  const Parts parts(whole);
  const WaveMetrics found = measure_waves(parts.surface(), parts.of_piece(whole.waves));
  EXPECT_EQ(found.without_wave, whole.mesh.vertex_count());
  EXPECT_EQ(found.stripes, 0);
  EXPECT_EQ(found.edges_per_period_median, 0);
}

TEST(DistributedWaves, ThatDoNotMatchThePieceAreRefusedByAll) {
  const Parts parts(wavy_surface("torus,resolution=12", kAxis, 8));
  WaveSet waves = parts.of_piece(parts.whole.waves);
  if (rank() == rank_count() - 1) waves.frequencies.push_back(1);
  EXPECT_THROW(measure_waves(parts.surface(), waves), Error);
}

struct Line {
  bool closed;
  double length;

  auto operator<=>(const Line&) const = default;
};

std::vector<Line> sorted_lines(const StripeCurves& curves) {
  std::vector<Line> lines;
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    lines.push_back({curves.lines.closed[line] != 0, length_of(curves.lines, line)});
  }
  std::ranges::sort(lines);
  return lines;
}

/// Points and normals, to the bit, in whatever order.
std::multiset<std::array<float, 6>> points_of(const Polylines& lines) {
  std::multiset<std::array<float, 6>> points;
  for (std::size_t i = 0; i < lines.points.size(); ++i) {
    const Vec3 &p = lines.points[i], &n = lines.normals[i];
    points.insert({p.x(), p.y(), p.z(), n.x(), n.y(), n.z()});
  }
  return points;
}

/// Parts of lines by where they cross borders.
class Joiner {
 public:
  /// Of all ranks, on rank 0.
  Joiner(Communicator& ranks, const PieceCurves& own) {
    std::vector<std::uint64_t> counts;
    for (std::size_t line = 0; line < own.lines.count(); ++line) {
      counts.push_back(own.lines.points_of(line).size());
    }
    all_.lines.points = gathered(ranks, own.lines.points);
    all_.lines.normals = gathered(ranks, own.lines.normals);
    all_.lines.closed = gathered(ranks, own.lines.closed);
    for (const std::uint64_t count : gathered(ranks, counts)) {
      all_.lines.offsets.push_back(all_.lines.offsets.back() + static_cast<Index>(count));
    }
    all_.ends = gathered(ranks, own.ends);
    all_.borders = gathered(ranks, own.borders);
    for (std::size_t line = 0; line < all_.borders.size(); ++line) {
      for (std::size_t e = 0; e < 2; ++e) {
        if (all_.borders[line][e]) at_[*all_.borders[line][e]].push_back({line, e});
      }
    }
  }

  /// Whole lines, which run from where they have ends.
  StripeCurves join() {
    visited_.resize(all_.lines.count());
    StripeCurves result;
    for (const bool with_end : {true, false}) {
      for (std::size_t line = 0; line < visited_.size(); ++line) {
        for (std::size_t e = 0; e < 2; ++e) {
          if (!visited_[line] && all_.borders[line][e].has_value() != with_end) {
            follow({line, e}, with_end && all_.lines.closed[line] == 0, result);
          }
        }
      }
    }
    return result;
  }

 private:
  using LineEnd = std::pair<std::size_t, std::size_t>;

  template <class T>
  static std::vector<T> gathered(Communicator& ranks, const std::vector<T>& own) {
    std::vector<T> all;
    PartsOnFirst(ranks, own.size()).gather(std::span<const T>(own), all);
    return all;
  }

  void follow(LineEnd from, bool open, StripeCurves& result) {
    std::array<CurveEnd, 2> ends{};
    if (open) ends[0] = all_.ends[from.first][from.second];
    bool first = true;
    while (!visited_[from.first]) {
      const auto [line, e] = from;
      visited_[line] = 1;
      const auto points = all_.lines.points_of(line), normals = all_.lines.normals_of(line);
      for (std::size_t i = first ? 0 : 1; i < points.size(); ++i) {
        const std::size_t at = e == 0 ? i : points.size() - 1 - i;
        result.lines.points.push_back(points[at]);
        result.lines.normals.push_back(normals[at]);
      }
      first = false;
      if (open) ends[1] = all_.ends[line][1 - e];
      if (!all_.borders[line][1 - e]) break;
      const std::vector<LineEnd>& both = at_.at(*all_.borders[line][1 - e]);
      ASSERT_EQ(both.size(), 2u);
      from = both[0] == LineEnd(line, 1 - e) ? both[1] : both[0];
      if (!open && visited_[from.first]) {  // round: the first point is there twice
        result.lines.points.pop_back();
        result.lines.normals.pop_back();
      }
    }
    result.lines.offsets.push_back(static_cast<Index>(result.lines.points.size()));
    result.lines.closed.push_back(open ? 0 : 1);
    result.ends.push_back(ends);
  }

  PieceCurves all_;
  std::map<BorderCrossing, std::vector<LineEnd>> at_;
  std::vector<std::uint8_t> visited_;
};

/// All ranks' lines, put together on rank 0.
StripeCurves joined_lines(const DistributedSurface& surface, const PieceCurves& own) {
  return Joiner(*surface.rank_surface().ranks, own).join();
}

void expect_same_curves(const StripeCurves& joined, const StripeCurves& expected) {
  ASSERT_EQ(joined.lines.count(), expected.lines.count());
  EXPECT_EQ(joined.end_counts(), expected.end_counts());
  const auto lines = sorted_lines(joined), others = sorted_lines(expected);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].closed, others[i].closed);
    EXPECT_NEAR(lines[i].length, others[i].length, 1e-6 * others[i].length);
  }
  EXPECT_EQ(points_of(joined.lines), points_of(expected.lines));
}

/// As they are, with ends joined, and trimmed.
constexpr std::array<CurveOptions, 3> kCurveOptions = {{{.trim = 0}, {.join = true}, {}}};

/// Parts of lines, put together where they cross borders, are the lines of the whole.
TEST(DistributedCurves, AreThoseOfTheWholeHoweverItIsCut) {
  std::array<std::size_t, kCurveEndKinds> ends{};
  for (const Solved& solved : solved_surfaces()) {
    std::vector<StripeCurves> wholes;
    for (const CurveOptions& options : kCurveOptions) {
      wholes.push_back(stripe_curves(LiftedWaves(solved.pattern()), options));
      ASSERT_GT(wholes.back().lines.count(), 0u);
      for (std::size_t kind = 0; kind < ends.size(); ++kind) {
        ends[kind] += wholes.back().end_counts()[kind];
      }
    }
    for (const Cut& cut : cuts()) {
      const SolvedPiece piece(solved, cut.rank_of_triangle(solved.whole.mesh));
      for (std::size_t i = 0; i < kCurveOptions.size(); ++i) {
        const CurveOptions& options = kCurveOptions[i];
        const StripeCurves& expected = wholes[i];
        SCOPED_TRACE(std::string(cut.name) + ", " + std::to_string(solved.z.size()) + " vertices" +
                     (options.join              ? ", joined"
                      : options.least_gap() > 0 ? ", trimmed"
                                                : ""));
        const PieceCurves curves = piece_curves(piece.pattern(), options);
        const StripeCurves joined = joined_lines(piece.surface, curves);
        if (rank() == 0) expect_same_curves(joined, expected);
        if (rank_count() > 1) continue;
        EXPECT_EQ(curves.lines.points, expected.lines.points);
        EXPECT_EQ(curves.lines.normals, expected.lines.normals);
        EXPECT_EQ(curves.lines.offsets, expected.lines.offsets);
        EXPECT_EQ(curves.lines.closed, expected.lines.closed);
        EXPECT_EQ(curves.ends, expected.ends);
      }
    }
  }
  // All sorts of ends have been there, but those at creases, which ranks do not have.
  EXPECT_EQ(std::ranges::count(std::span(ends).subspan(1, 5), 0u), 0);
}

TEST(DistributedCurves, RefuseOptionsThatContradictEachOther) {
  const Solved solved(wavy_surface("torus,resolution=20", kAxis, 10));
  const SolvedPiece piece(solved, partition_by_curve(solved.whole.mesh, rank_count()));
  EXPECT_THROW(piece_curves(piece.pattern(), {.join = true, .trim = 0.6f}), Error);
  EXPECT_THROW(piece_curves(piece.pattern(), {.trim = 2}), Error);
}

/// A crossing of a border as ranks compare it.
struct ComparedEnd {
  BorderCrossing crossing;
  std::array<float, 3> point;
  int rank;
};

/// Every end at a border has one partner, on another rank, at the same place to the bit.
TEST(DistributedCurves, BalanceAtBorders) {
  std::size_t crossings = 0;
  for (const Solved& solved : solved_surfaces()) {
    for (const Cut& cut : cuts()) {
      SCOPED_TRACE(std::string(cut.name) + ", " + std::to_string(solved.z.size()) + " vertices");
      const SolvedPiece piece(solved, cut.rank_of_triangle(solved.whole.mesh));
      const PieceCurves curves = piece_curves(piece.pattern());
      std::vector<ComparedEnd> ends;
      for (std::size_t line = 0; line < curves.lines.count(); ++line) {
        const auto points = curves.lines.points_of(line);
        for (std::size_t e = 0; e < 2; ++e) {
          if (!curves.borders[line][e]) continue;
          const Vec3& p = e == 0 ? points.front() : points.back();
          ends.push_back({*curves.borders[line][e], {p.x(), p.y(), p.z()}, rank()});
        }
      }
      Communicator& ranks = *piece.surface.rank_surface().ranks;
      const auto lists = ranks.gather(std::as_bytes(std::span(ends)));
      std::map<BorderCrossing, std::vector<ComparedEnd>> all;
      for (const auto& bytes : lists) {
        std::vector<ComparedEnd> list(bytes.size() / sizeof(ComparedEnd));
        if (!list.empty()) std::memcpy(list.data(), bytes.data(), bytes.size());
        for (const ComparedEnd& end : list) all[end.crossing].push_back(end);
      }
      std::size_t unbalanced = 0;
      for (const auto& [crossing, both] : all) {
        unbalanced +=
            both.size() != 2 || both[0].rank == both[1].rank || both[0].point != both[1].point;
      }
      EXPECT_EQ(unbalanced, 0u);
      crossings += all.size();
    }
  }
  if (rank() == 0) {
    EXPECT_EQ(crossings > 1000, rank_count() > 1);
  }
}

/// How far the point of a triangle is from where it should be.
float distance_in(const Mesh& mesh, Index triangle, const std::array<double, 3>& barycentric,
                  const Vec3& point) {
  Eigen::Vector3d there = Eigen::Vector3d::Zero();
  for (std::size_t m = 0; m < 3; ++m) {
    there += barycentric[m] * mesh.positions[mesh.triangles[triangle][m]].cast<double>();
  }
  return static_cast<float>((there - point.cast<double>()).norm());
}

/// The farthest that the ends of segments are from the triangles in which they are said to run;
/// all of them this rank's.
float farthest_from_places(const Polylines& lines, const SurfacePiece& piece) {
  float worst = 0;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    for (Index i = lines.offsets[line]; i < lines.offsets[line + 1]; ++i) {
      const bool last = i + 1 == lines.offsets[line + 1];
      const Index next = !last ? i + 1 : lines.closed[line] ? lines.offsets[line] : i;
      const auto& [triangle, barycentric] = lines.places[i];
      EXPECT_EQ(piece.ghost_triangles.empty() ? 0 : piece.ghost_triangles[triangle], 0);
      worst = std::max({worst, distance_in(piece.mesh, triangle, barycentric, lines.points[i]),
                        distance_in(piece.mesh, triangle, lines.arrivals[i], lines.points[next])});
    }
  }
  return worst;
}

TEST(DistributedCurves, HavePlacesInTheTrianglesOfThePiece) {
  for (const Solved& solved : solved_surfaces()) {
    for (const Cut& cut : cuts()) {
      SCOPED_TRACE(std::string(cut.name) + ", " + std::to_string(solved.z.size()) + " vertices");
      const SolvedPiece piece(solved, cut.rank_of_triangle(solved.whole.mesh));
      const Polylines lines = piece_curves(piece.pattern()).lines;
      ASSERT_EQ(lines.places.size(), lines.points.size());
      ASSERT_EQ(lines.arrivals.size(), lines.points.size());
      EXPECT_LT(farthest_from_places(lines, piece.parts.piece), 1e-5f);
    }
  }
}

/// How far points are from where their ranks' pieces have them.
float farthest_from_places(const WholeCurves& curves, std::span<const SurfacePiece> pieces) {
  const Polylines& lines = curves.curves.lines;
  float worst = 0;
  for (std::size_t i = 0; i < lines.points.size(); ++i) {
    const Mesh& of_rank = pieces[static_cast<std::size_t>(curves.rank_of_point[i])].mesh;
    const auto& [triangle, barycentric] = lines.places[i];
    worst = std::max(worst, distance_in(of_rank, triangle, barycentric, lines.points[i]));
  }
  return worst;
}

// Rank 0 makes them of the whole: to the bit those of one process, however it is cut.
TEST(DistributedCurves, OfTheWholeSurfaceAreThoseOfOneProcess) {
  const CurveOptions ways[] = {{}, {.join = true, .fair = 0.25f}, {.trim = 0, .fair = 0.5f}};
  std::size_t forks = 0;
  for (const Solved& solved : solved_surfaces()) {
    std::vector<StripeCurves> wholes;
    for (const CurveOptions& options : ways) {
      if (rank() > 0) continue;
      wholes.push_back(stripe_curves(LiftedWaves(solved.pattern()), options));
      ASSERT_EQ(wholes.back().largest_move > 0, options.fair > 0);
      forks += wholes.back().smooth_forks;
    }
    for (const Cut& cut : cuts()) {
      SCOPED_TRACE(std::string(cut.name) + ", " + std::to_string(solved.z.size()) + " vertices");
      const std::vector<int> ranks = cut.rank_of_triangle(solved.whole.mesh);
      const SolvedPiece piece(solved, ranks);
      std::vector<SurfacePiece> pieces;
      for (int r = 0; rank() == 0 && r < rank_count(); ++r) {
        pieces.push_back(piece_of(solved.whole.mesh, ranks, r));
      }
      for (std::size_t i = 0; i < std::size(ways); ++i) {
        const WholeCurves found = whole_curves(piece.pattern(), ways[i]);
        const Polylines& lines = found.curves.lines;
        if (rank() > 0) {
          EXPECT_EQ(lines.points.size() + found.rank_of_point.size(), 0u);
          continue;
        }
        const StripeCurves& expected = wholes[i];
        EXPECT_EQ(lines.points, expected.lines.points);
        EXPECT_EQ(lines.normals, expected.lines.normals);
        EXPECT_EQ(lines.offsets, expected.lines.offsets);
        EXPECT_EQ(lines.closed, expected.lines.closed);
        EXPECT_EQ(found.curves.ends, expected.ends);
        EXPECT_EQ(found.curves.smooth_forks, expected.smooth_forks);
        EXPECT_EQ(found.curves.largest_move, expected.largest_move);
        EXPECT_LT(farthest_from_places(found, pieces), 1e-5f);
      }
    }
  }
  if (rank() == 0) {
    EXPECT_GT(forks, 10u);
  }
}

TEST(DistributedCurves, AreNotFairedInPieces) {
  const Solved solved(wavy_surface("torus,resolution=20", kAxis, 12));
  const SolvedPiece piece(solved, partition_by_curve(solved.whole.mesh, rank_count()));
  EXPECT_THROW(piece_curves(piece.pattern(), {.fair = 0.25f}), Error);
  EXPECT_THROW(whole_curves(piece.pattern(), {.fair = 2}), Error);
  if (!Progress().is_heard()) return;
  EXPECT_THROW(whole_curves(piece.pattern(), {.fair = 0.25f}, Progress([](const ProgressReport&) {
                              return rank() < rank_count() - 1;
                            })),
               Cancelled);
}

TEST(DistributedCurves, RefuseOnAllRanksAPatternThatDoesNotMatch) {
  const Solved solved(wavy_surface("torus,resolution=20", kAxis, 12));
  const SolvedPiece piece(solved, partition_by_curve(solved.whole.mesh, rank_count()));
  std::vector<Complex> z = piece.z;
  if (rank() == rank_count() - 1) z.pop_back();
  EXPECT_THROW(piece_curves({piece.surface, piece.waves, z}), Error);
  EXPECT_THROW(whole_curves({piece.surface, piece.waves, z}), Error);
}

/// V crosses U.
Solved turned_by_90(const Solved& solved) {
  WavySurface other = solved.whole;
  other.waves.directions = rotated(other.waves.directions, other.normals, 1.5707964f);
  return Solved(std::move(other));
}

/// What does not depend on which rank a sample is of.
struct ComparedSample {
  std::array<float, 3> position, barycentric;

  auto operator<=>(const ComparedSample&) const = default;
};

std::vector<ComparedSample> compared(std::span<const Sample> samples) {
  std::vector<ComparedSample> result;
  for (const Sample& s : samples) {
    result.push_back({{s.position.x(), s.position.y(), s.position.z()},
                      {s.barycentric.x(), s.barycentric.y(), s.barycentric.z()}});
  }
  std::ranges::sort(result);
  return result;
}

TEST(DistributedSamples, AreThoseOfTheWholeEachOnOneRank) {
  for (const Solved& u : solved_surfaces()) {
    const Solved v = turned_by_90(u);
    std::vector<Sample> expected;
    if (rank() == 0) {
      const LiftedWaves lifted_u(u.pattern()), lifted_v(v.pattern());
      expected = wave_samples(lifted_u, lifted_v);
      ASSERT_GT(expected.size(), 0u);
    }
    for (const Cut& cut : cuts()) {
      SCOPED_TRACE(std::string(cut.name) + ", " + std::to_string(u.z.size()) + " vertices");
      const SolvedPiece piece(u, cut.rank_of_triangle(u.whole.mesh));
      const WaveSet waves_v = piece.parts.of_piece(v.whole.waves);
      const std::vector<Complex> z_v = piece.parts.of_piece(v.z);
      const std::vector<Sample> own = wave_samples(piece.pattern(), {piece.surface, waves_v, z_v});
      for (const Sample& sample : own) {
        ASSERT_LT(sample.triangle, piece.parts.piece.mesh.triangle_count());
        const auto& corners = piece.parts.piece.mesh.triangles[sample.triangle];
        Vec3 there = Vec3::Zero();
        for (int m = 0; m < 3; ++m) {
          there += sample.barycentric[m] * piece.parts.piece.mesh.positions[corners[m]];
        }
        EXPECT_LT((there - sample.position).norm(), 1e-5f);
      }
      const std::vector<Sample> all = gathered_samples(piece.surface, own);
      if (rank() != 0) continue;
      EXPECT_EQ(compared(all), compared(expected));
      if (rank_count() == 1) {
        EXPECT_EQ(all.size(), expected.size());
        EXPECT_EQ(all.front().normal, expected.front().normal);
      }
    }
  }
}

/// Pieces that have all other triangles as ghosts, as visualisation programs give some.
TEST(DistributedSamples, AndCurvesMindNoGhosts) {
  const Solved u(wavy_surface("sheets,resolution=16", kAxis, 20)), v = turned_by_90(u);
  const std::vector<int> ranks = partition_by_curve(u.whole.mesh, rank_count());
  SurfacePiece piece;
  piece.mesh = u.whole.mesh;
  for (std::size_t n = 0; n < u.z.size(); ++n) piece.vertex_ids.push_back(n);
  for (const int r : ranks) piece.ghost_triangles.push_back(r == rank() ? 0 : 1);
  for (std::size_t t = 0; t < ranks.size(); ++t) piece.triangle_ids.push_back(t);
  const DistributedSurface surface(piece, MPI_COMM_WORLD);
  const PiecePattern pattern_u{surface, u.whole.waves, u.z}, pattern_v{surface, v.whole.waves, v.z};
  const PieceCurves curves = piece_curves(pattern_u);
  EXPECT_LT(farthest_from_places(curves.lines, piece), 1e-5f);
  const StripeCurves joined = joined_lines(surface, curves);
  const std::vector<Sample> own = wave_samples(pattern_u, pattern_v);
  for (const Sample& sample : own) EXPECT_EQ(ranks[sample.triangle], rank());
  const std::vector<Sample> all = gathered_samples(surface, own);
  if (rank() != 0) return;
  expect_same_curves(joined, stripe_curves(LiftedWaves(u.pattern())));
  const LiftedWaves lifted_u(u.pattern()), lifted_v(v.pattern());
  EXPECT_EQ(compared(all), compared(wave_samples(lifted_u, lifted_v)));
}

TEST(DistributedSamples, DropDoublesAsOneProcessDoes) {
  const Solved u(wavy_surface("molecule,resolution=25", kAxis, 40)), v = turned_by_90(u);
  const SolvedPiece piece(u, partition_by_curve(u.whole.mesh, rank_count()));
  const WaveSet waves_v = piece.parts.of_piece(v.whole.waves);
  const std::vector<Complex> z_v = piece.parts.of_piece(v.z);
  std::vector<Sample> own = wave_samples(piece.pattern(), {piece.surface, waves_v, z_v});
  std::vector<Sample> expected = gathered_samples(piece.surface, own);
  const std::size_t dropped = drop_doubles(piece.surface, own);
  const std::vector<Sample> left = gathered_samples(piece.surface, own);
  EXPECT_GT(dropped, 0u);
  if (rank() != 0) return;
  EXPECT_EQ(drop_doubles(expected), dropped);
  EXPECT_EQ(compared(left), compared(expected));
}

}  // namespace
}  // namespace brindle
