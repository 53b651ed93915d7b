#include "brindle/texture_coordinates.h"

#include <cmath>
#include <limits>
#include <optional>

#include "brindle/base/compressed_rows.h"
#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/corner_phases.h"
#include "brindle/fragment_phase.h"
#include "brindle/geometry/topology.h"

namespace brindle {
namespace {

/// A coordinate as the value of the phase plus whole tiles. Triangles of the same orientation have
/// bit for bit the same `base` at a shared vertex.
struct Coordinate {
  float base = 0;
  int tiles = 0;
};

/// A triangle of the textured mesh.
struct Piece {
  Triangle vertices;
  std::array<Coordinate, 3> u;
  std::array<Coordinate, 3> v;
  Index origin;  ///< the triangle that it is part of
};

Coordinate coordinate(Complex z, float lifted_phase) {
  const float base = texture_coordinate(z);
  return {base, static_cast<int>(std::lround(lifted_phase / kTwoPi + 0.25f - base))};
}

std::array<Coordinate, 3> coordinates_of(const CornerWaves& corners, const CornerPhases& phases) {
  std::array<Coordinate, 3> result;
  for (int m = 0; m < 3; ++m) {
    const CornerWave& corner = corners[m];
    result[m] = coordinate(phases.sign[m] < 0 ? flipped(corner).z : corner.z, phases.phase[m]);
  }
  return result;
}

/// The triangle of corners a, b and the barycentre, whose wave is `centre`. The phase at the
/// barycentre is lifted to be closest to the extrapolation from a and b.
std::array<Coordinate, 3> split_coordinates(const CornerWave& a, CornerWave b, FragmentWave centre,
                                            const Vec3& barycentre, PhaseShiftKind kind) {
  const auto runs_against_a = [&](const Vec3& d) { return a.wave.direction.dot(d) < 0; };
  if (runs_against_a(b.wave.direction)) b = flipped(b);
  if (runs_against_a(centre.direction)) centre.z = -std::conj(centre.z);
  const float phase_a = elementary::arg(a.z);
  const float phase_b = phase_a + lifted_step(a, b, kind);
  const auto led_to = [&](const Wave& wave) {
    return kTwoPi * wave.frequency * wave.direction.dot(barycentre - wave.position);
  };
  const float led = 0.5f * (phase_a + led_to(a.wave) + phase_b + led_to(b.wave));
  if (centre.z == Complex(0)) centre.z = elementary::polar(1.0f, led);
  const float remainder = elementary::arg(centre.z) - led;
  const float phase = led + remainder - kTwoPi * std::round(remainder / kTwoPi);
  return {coordinate(a.z, phase_a), coordinate(b.z, phase_b), coordinate(centre.z, phase)};
}

/// All pieces, and the vertices that splitting adds.
class Pieces {
 public:
  Pieces(const Mesh& mesh, const TextureWaves& waves, PhaseShiftKind kind, const Progress& progress)
      : mesh_(mesh), waves_(waves), kind_(kind) {
    pieces.reserve(mesh.triangle_count());
    reported_for(mesh.triangle_count(), progress, [&](std::size_t t) { add(t); });
  }

  std::vector<Piece> pieces;
  std::vector<Index> split;  ///< triangles whose barycentre is a new vertex

 private:
  void add(std::size_t t) {
    const CornerPhases u = corner_phases(waves_.u[t], kind_);
    const CornerPhases v = corner_phases(waves_.v[t], kind_);
    const auto is = [&](TriangleKind kind) { return u.kind == kind && v.kind == kind; };
    if (is(TriangleKind::regular)) {
      pieces.push_back({mesh_.triangles[t], coordinates_of(waves_.u[t], u),
                        coordinates_of(waves_.v[t], v), static_cast<Index>(t)});
    } else if (u.kind == TriangleKind::no_wave || v.kind == TriangleKind::no_wave) {
      pieces.push_back({mesh_.triangles[t], {}, {}, static_cast<Index>(t)});
    } else {
      add_split(t);
    }
  }

  void add_split(std::size_t t) {
    const Triangle& triangle = mesh_.triangles[t];
    const auto centre = static_cast<Index>(mesh_.vertex_count() + split.size());
    split.push_back(static_cast<Index>(t));
    const Vec3 middle = Vec3::Constant(1.0f / 3);
    const CornerWaves& u = waves_.u[t];
    const CornerWaves& v = waves_.v[t];
    const Vec3 barycentre = (u[0].wave.position + u[1].wave.position + u[2].wave.position) / 3;
    const TextureFragment centre_wave = texture_fragment(u, v, middle);
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      pieces.push_back({{triangle[a], triangle[b], centre},
                        split_coordinates(u[a], u[b], centre_wave.u, barycentre, kind_),
                        split_coordinates(v[a], v[b], centre_wave.v, barycentre, kind_),
                        static_cast<Index>(t)});
    }
  }

  const Mesh& mesh_;
  const TextureWaves& waves_;
  PhaseShiftKind kind_;
};

using Tiles = std::array<int, 2>;

/// Whole tiles between two corners at one vertex; nullopt if they differ otherwise.
std::optional<Tiles> tiles_between(const Piece& a, Index corner_a, const Piece& b, Index corner_b) {
  const Coordinate &ua = a.u[corner_a], &ub = b.u[corner_b];
  const Coordinate &va = a.v[corner_a], &vb = b.v[corner_b];
  if (ua.base != ub.base || va.base != vb.base) return std::nullopt;
  return Tiles{ua.tiles - ub.tiles, va.tiles - vb.tiles};
}

/// A step to a neighbouring piece whose coordinates along the edge differ by `tiles`.
struct Step {
  Index from, to;
  Tiles tiles;
};

/// The steps by the piece at which they start.
CompressedRows<Step> steps_between(const std::vector<Piece>& pieces, const Progress& progress) {
  std::vector<Triangle> triangles;
  triangles.reserve(pieces.size());
  for (const Piece& piece : pieces) triangles.push_back(piece.vertices);
  std::vector<Step> steps;
  progress.report(0.1);
  const std::vector<SharedEdge> edges = shared_edges(triangles);
  reported_for(edges.size(), progress.part(0.5, 0.8), [&](std::size_t e) {
    const SharedEdge& edge = edges[e];
    const Index a = edge.from[0] / 3, b = edge.from[1] / 3;
    const auto at_from = tiles_between(pieces[a], edge.from[0] % 3, pieces[b], edge.from[1] % 3);
    const auto at_to = tiles_between(pieces[a], edge.to[0] % 3, pieces[b], edge.to[1] % 3);
    if (!at_from || at_from != at_to) return;
    steps.push_back({a, b, *at_from});
    steps.push_back({b, a, {-(*at_from)[0], -(*at_from)[1]}});
  });
  progress.report(0.8);
  return compressed_rows<Step>(pieces.size(), [&](const auto& add) {
    for (const Step& step : steps) add(step.from, step);
  });
}

void add_tiles(Piece& piece, const Tiles& tiles) {
  for (int m = 0; m < 3; ++m) {
    piece.u[m].tiles += tiles[0];
    piece.v[m].tiles += tiles[1];
  }
}

/// Adds whole tiles to pieces, breadth-first, so that each agrees with its predecessor.
void align(std::vector<Piece>& pieces, const Progress& progress) {
  const CompressedRows<Step> steps = steps_between(pieces, progress.part(0, 0.6));
  const Progress visiting = progress.part(0.6, 1);
  std::vector<Tiles> added(pieces.size());
  std::vector<std::uint8_t> reached(pieces.size());
  std::vector<Index> queue;
  queue.reserve(pieces.size());
  for (Index start = 0; start < pieces.size(); ++start) {
    if (reached[start]) continue;
    reached[start] = 1;
    std::size_t next = queue.size();
    queue.push_back(start);
    for (; next < queue.size(); ++next) {
      if (next % kReportSlice == 0) {
        visiting.report(static_cast<double>(next) / static_cast<double>(pieces.size()));
      }
      const Index p = queue[next];
      for (const auto& [from, to, tiles] : steps.of(p)) {
        if (reached[to]) continue;
        reached[to] = 1;
        added[to] = {added[p][0] + tiles[0], added[p][1] + tiles[1]};
        queue.push_back(to);
      }
    }
  }
  for (std::size_t p = 0; p < pieces.size(); ++p) add_tiles(pieces[p], added[p]);
}

/// Gives each pair of vertex and coordinates its own vertex.
class Splitter {
 public:
  explicit Splitter(TexturedMesh& textured)
      : textured_(textured),
        next_copy_(textured.mesh.vertex_count(), kNone),
        used_(textured.mesh.vertex_count()) {}

  Index vertex_with(Index vertex, const Eigen::Vector2f& coordinates) {
    if (!used_[vertex]) {
      used_[vertex] = 1;
      textured_.coordinates[vertex] = coordinates;
      return vertex;
    }
    Index copy = vertex;
    while (textured_.coordinates[copy] != coordinates) {
      if (next_copy_[copy] == kNone) return next_copy_[copy] = added_copy(vertex, coordinates);
      copy = next_copy_[copy];
    }
    return copy;
  }

 private:
  static constexpr Index kNone = 0xffffffff;

  Index added_copy(Index vertex, const Eigen::Vector2f& coordinates) {
    const auto number = static_cast<Index>(textured_.mesh.vertex_count());
    textured_.mesh.positions.push_back(Vec3(textured_.mesh.positions[vertex]));
    textured_.origins.push_back(std::array<Index, 3>(textured_.origins[vertex]));
    textured_.coordinates.push_back(coordinates);
    next_copy_.push_back(kNone);
    return number;
  }

  TexturedMesh& textured_;
  std::vector<Index> next_copy_;
  std::vector<std::uint8_t> used_;
};

float value(const Coordinate& c) { return c.base + static_cast<float>(c.tiles); }

}  // namespace

TexturedMesh texture_coordinates(const Mesh& mesh, const TextureWaves& waves, PhaseShiftKind kind,
                                 const Progress& progress) {
  JobStages stages(progress, {{"lift corners", 5}, {"align tiles", 8}, {"split vertices", 3}});
  Pieces all(mesh, waves, kind, stages.begin("lift corners"));
  align(all.pieces, stages.begin("align tiles"));
  const Progress splitting = stages.begin("split vertices");
  TexturedMesh textured;
  textured.split_triangles = all.split.size();
  textured.mesh.positions = mesh.positions;
  textured.mesh.origin = mesh.origin;
  for (Index v = 0; v < mesh.vertex_count(); ++v) textured.origins.push_back({v, v, v});
  for (const Index t : all.split) {
    const Triangle& triangle = mesh.triangles[t];
    textured.mesh.positions.push_back(
        (mesh.positions[triangle[0]] + mesh.positions[triangle[1]] + mesh.positions[triangle[2]]) /
        3);
    textured.origins.push_back(triangle);
  }
  textured.coordinates.assign(textured.mesh.vertex_count(), Eigen::Vector2f::Zero());
  Splitter splitter(textured);
  textured.mesh.triangles.reserve(all.pieces.size());
  reported_for(all.pieces.size(), splitting, [&](std::size_t p) {
    const Piece& piece = all.pieces[p];
    Triangle triangle;
    for (int m = 0; m < 3; ++m) {
      triangle[m] = splitter.vertex_with(piece.vertices[m], {value(piece.u[m]), value(piece.v[m])});
    }
    textured.mesh.triangles.push_back(triangle);
    textured.triangle_origins.push_back(piece.origin);
  });
  stages.finish();
  return textured;
}

std::vector<float> corner_texture_coordinates(const TextureWaves& waves, PhaseShiftKind kind) {
  std::vector<float> uv(6 * waves.triangle_count(), std::numeric_limits<float>::quiet_NaN());
  const std::vector<CornerPhases> u = corner_phases(waves.u, kind);
  const std::vector<CornerPhases> v = corner_phases(waves.v, kind);
  const auto value = [](const Coordinate& c) { return c.base + static_cast<float>(c.tiles); };
  for (std::size_t t = 0; t < waves.triangle_count(); ++t) {
    if (!is_lifted(u[t].kind) || !is_lifted(v[t].kind)) continue;
    const auto along_u = coordinates_of(waves.u[t], u[t]);
    const auto along_v = coordinates_of(waves.v[t], v[t]);
    for (std::size_t m = 0; m < 3; ++m) {
      uv[6 * t + 2 * m] = value(along_u[m]);
      uv[6 * t + 2 * m + 1] = value(along_v[m]);
    }
  }
  return uv;
}

std::vector<float> carried_values(const TexturedMesh& textured, std::span<const float> values,
                                  int components) {
  const auto n = static_cast<std::size_t>(components);
  std::vector<float> carried;
  carried.reserve(n * textured.origins.size());
  for (const auto& [a, b, c] : textured.origins) {
    for (std::size_t i = 0; i < n; ++i) {
      const float first = values[n * a + i];
      carried.push_back(a == b ? first : (first + values[n * b + i] + values[n * c + i]) / 3);
    }
  }
  return carried;
}

DataArrays carried_arrays(const TexturedMesh& textured, const DataArrays& arrays) {
  std::vector<RowBlend> blends;
  blends.reserve(textured.origins.size());
  for (const std::array<Index, 3>& origin : textured.origins) {
    constexpr double kThird = 1.0 / 3;
    const bool whole = origin[0] == origin[1];
    blends.push_back({origin, whole ? std::array<double, 3>{1, 0, 0}
                                    : std::array<double, 3>{kThird, kThird, kThird}});
  }
  return {blended(arrays.points, blends), rows_of(arrays.cells, textured.triangle_origins)};
}

CarriedWaves carried_waves(const TexturedMesh& textured, const WaveSet& waves,
                           std::span<const Complex> z) {
  CarriedWaves carried;
  carried.waves.positions = textured.mesh.positions;
  const std::size_t count = textured.origins.size();
  carried.waves.directions.resize(count);
  carried.z.resize(count);
  for (std::size_t v = 0; v < count; ++v) {
    const std::array<Index, 3>& origin = textured.origins[v];
    FragmentWave wave{waves.directions[origin[0]], waves.frequencies[origin[0]], z[origin[0]]};
    if (origin[0] != origin[1]) {
      const std::array<CornerWave, 3> corners = corner_waves(origin, waves, z);
      wave = fragment_phase(corners, Vec3::Constant(1.0f / 3));
      if (!common_orientation(
              {corners[0].wave.direction, corners[1].wave.direction, corners[2].wave.direction})) {
        wave.direction.setZero();
      }
    }
    carried.waves.directions[v] = wave.direction;
    carried.z[v] = wave.z;
  }
  carried.waves.frequencies = carried_values(textured, waves.frequencies, 1);
  return carried;
}

}  // namespace brindle
