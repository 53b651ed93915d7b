#include "brindle/distributed/surface/partition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/subdivide.h"
#include "brindle/mesh_data.h"

namespace brindle {
namespace {

constexpr int kBits = 16;

std::array<std::uint32_t, 3> cell_of(const Vec3& p, const BoundingBox& box, float scale) {
  std::array<std::uint32_t, 3> cell;
  for (int k = 0; k < 3; ++k) {
    const float place = (p[k] - box.lower[k]) * scale;
    constexpr float kLast = (1 << kBits) - 1;
    cell[static_cast<std::size_t>(k)] =
        static_cast<std::uint32_t>(std::clamp(std::floor(place), 0.0f, kLast));
  }
  return cell;
}

}  // namespace

std::uint64_t hilbert_place(std::array<std::uint32_t, 3> x) {
  constexpr std::uint32_t kTop = 1u << (kBits - 1);
  for (std::uint32_t q = kTop; q > 1; q >>= 1) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (x[i] & q) {
        x[0] ^= q - 1;
      } else {
        const std::uint32_t t = (x[0] ^ x[i]) & (q - 1);
        x[0] ^= t;
        x[i] ^= t;
      }
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t turned = 0;
  for (std::uint32_t q = kTop; q > 1; q >>= 1) {
    if (x[2] & q) turned ^= q - 1;
  }
  for (std::uint32_t& axis : x) axis ^= turned;
  std::uint64_t place = 0;
  for (int bit = kBits; bit-- > 0;) {
    for (const std::uint32_t axis : x) place = place << 1 | (axis >> bit & 1u);
  }
  return place;
}

std::vector<int> partition_by_curve(const Mesh& mesh, int parts) {
  const std::size_t count = mesh.triangle_count();
  const BoundingBox box = bounding_box(mesh);
  const float widest = (box.upper - box.lower).maxCoeff();
  const float scale = widest > 0 ? static_cast<float>(1 << kBits) / widest : 0;
  std::vector<std::pair<std::uint64_t, Index>> places(count);
  parallel_for(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      const Vec3 center = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
      places[t] = {hilbert_place(cell_of(center, box, scale)), static_cast<Index>(t)};
    }
  });
  std::ranges::sort(places);
  std::vector<int> rank(count);
  for (std::size_t n = 0; n < count; ++n) {
    rank[places[n].second] = static_cast<int>(n * static_cast<std::size_t>(parts) / count);
  }
  return rank;
}

SurfacePiece piece_of(const Mesh& mesh, std::span<const int> rank_of_triangle, int rank) {
  std::vector<std::uint8_t> used(mesh.vertex_count()), wanted(mesh.vertex_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (const Index v : mesh.triangles[t]) {
      used[v] = 1;
      if (rank_of_triangle[t] == rank) wanted[v] = 1;
    }
  }
  SurfacePiece piece;
  piece.mesh.origin = mesh.origin;
  std::vector<Index> number(mesh.vertex_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!wanted[v] && (used[v] || rank != 0)) continue;
    number[v] = static_cast<Index>(piece.vertex_ids.size());
    piece.vertex_ids.push_back(v);
    piece.mesh.positions.push_back(mesh.positions[v]);
  }
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (rank_of_triangle[t] != rank) continue;
    const auto& [a, b, c] = mesh.triangles[t];
    piece.mesh.triangles.push_back({number[a], number[b], number[c]});
    piece.triangle_ids.push_back(t);
  }
  return piece;
}

namespace {

/// The global numbers of an edge's ends, the lower one first.
using EdgeIds = std::pair<std::uint64_t, std::uint64_t>;

/// As EdgeIds, for messages.
struct SentEdge {
  std::uint64_t low, high;

  EdgeIds ids() const { return {low, high}; }
};

/// The edges of a partition, sorted by their ends.
struct PieceEdges {
  std::vector<SentEdge> edges;
  std::vector<Index> of_corner;                ///< of corner 3 t + c, the edge to the next corner
  std::vector<std::array<Index, 2>> vertices;  ///< in the partition, parallel to `edges`
};

PieceEdges edges_of(const SurfacePiece& piece) {
  struct Side {
    EdgeIds ids;
    std::size_t corner;
  };
  std::vector<Side> sides;
  sides.reserve(3 * piece.mesh.triangle_count());
  const auto end_of = [&](std::size_t corner, std::size_t step) {
    return piece.mesh.triangles[corner / 3][(corner % 3 + step) % 3];
  };
  for (std::size_t corner = 0; corner < 3 * piece.mesh.triangle_count(); ++corner) {
    const std::uint64_t a = piece.vertex_ids[end_of(corner, 0)],
                        b = piece.vertex_ids[end_of(corner, 1)];
    sides.push_back({std::minmax(a, b), corner});
  }
  std::ranges::sort(sides, {}, [](const Side& side) { return std::pair(side.ids, side.corner); });
  PieceEdges result;
  result.of_corner.resize(sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i == 0 || sides[i].ids != sides[i - 1].ids) {
      result.edges.push_back({sides[i].ids.first, sides[i].ids.second});
      result.vertices.push_back({end_of(sides[i].corner, 0), end_of(sides[i].corner, 1)});
    }
    result.of_corner[sides[i].corner] = static_cast<Index>(result.edges.size() - 1);
  }
  return result;
}

/// The global edge numbers from 0 on, in ascending order of their ends, whose numbers are below
/// `end`.
std::vector<std::uint64_t> numbers_in_whole(Communicator& ranks, std::span<const SentEdge> edges,
                                            std::uint64_t end) {
  const auto size = static_cast<std::size_t>(ranks.size());
  const std::uint64_t block = end / size + 1;
  std::vector<std::vector<SentEdge>> asked(size);
  for (const SentEdge& edge : edges) asked[edge.low / block].push_back(edge);
  const auto wanted = ranks.swap_lists(asked);
  std::vector<EdgeIds> known;
  for (const auto& list : wanted) {
    for (const SentEdge& edge : list) known.push_back(edge.ids());
  }
  std::ranges::sort(known);
  known.erase(std::unique(known.begin(), known.end()), known.end());
  const std::vector<std::size_t> counts = ranks.all(known.size());
  std::uint64_t first = 0;
  for (int r = 0; r < ranks.rank(); ++r) first += counts[static_cast<std::size_t>(r)];
  std::vector<std::vector<std::uint64_t>> answers(size);
  for (std::size_t r = 0; r < size; ++r) {
    // The lists are sorted, too.
    auto place = known.begin();
    for (const SentEdge& edge : wanted[r]) {
      place = std::lower_bound(place, known.end(), edge.ids());
      answers[r].push_back(first + static_cast<std::uint64_t>(place - known.begin()));
    }
  }
  std::vector<std::uint64_t> numbers;
  for (const auto& list : ranks.swap_lists(answers)) {
    numbers.insert(numbers.end(), list.begin(), list.end());
  }
  return numbers;
}

/// Source rows of the finer partition's vertices and triangles.
DataArrays finer_arrays(const DataArrays& arrays, const SurfacePiece& coarse,
                        const PieceEdges& edges) {
  if (arrays == DataArrays{}) return {};
  std::vector<RowBlend> points;
  for (Index v = 0; v < coarse.mesh.vertex_count(); ++v) points.push_back({{v, v, v}, {1, 0, 0}});
  for (auto [a, b] : edges.vertices) {
    // For integers, ties go to the vertex with the lower number.
    if (coarse.vertex_ids[b] < coarse.vertex_ids[a]) std::swap(a, b);
    points.push_back({{a, b, b}, {0.5, 0.5, 0}});
  }
  std::vector<Index> cells;
  for (Index t = 0; t < coarse.mesh.triangle_count(); ++t) cells.insert(cells.end(), 4, t);
  return {blended(arrays.points, points), rows_of(arrays.cells, cells)};
}

SurfacePiece subdivided_once(Communicator& ranks, SurfacePiece piece, DataArrays& arrays) {
  std::uint64_t end = 0;
  for (const std::uint64_t id : piece.vertex_ids) end = std::max(end, id + 1);
  end = ranks.greatest(end);
  const PieceEdges edges = edges_of(piece);
  ranks.throw_on_all([&] { arrays = finer_arrays(arrays, piece, edges); });
  const auto old_vertices = static_cast<Index>(piece.vertex_ids.size());
  for (const std::uint64_t number : numbers_in_whole(ranks, edges.edges, end)) {
    piece.vertex_ids.push_back(end + number);
  }
  for (const auto& [a, b] : edges.vertices) {
    // The same bits as `subdivide`.
    const Vec3 middle = 0.5f * piece.mesh.positions[a] + 0.5f * piece.mesh.positions[b];
    piece.mesh.positions.push_back(middle);
  }
  std::vector<Triangle> finer;
  finer.reserve(4 * piece.mesh.triangle_count());
  for (std::size_t t = 0; t < piece.mesh.triangle_count(); ++t) {
    const auto& [a, b, c] = piece.mesh.triangles[t];
    const Index ab = old_vertices + edges.of_corner[3 * t],
                bc = old_vertices + edges.of_corner[3 * t + 1],
                ca = old_vertices + edges.of_corner[3 * t + 2];
    finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  piece.mesh.triangles = std::move(finer);
  std::vector<std::uint8_t> ghosts;
  for (const std::uint8_t ghost : piece.ghost_triangles) ghosts.insert(ghosts.end(), 4, ghost);
  piece.ghost_triangles = std::move(ghosts);
  std::vector<std::uint64_t> numbers;
  for (const std::uint64_t number : piece.triangle_ids) {
    for (std::uint64_t quarter = 0; quarter < 4; ++quarter) numbers.push_back(4 * number + quarter);
  }
  piece.triangle_ids = std::move(numbers);
  return piece;
}

void check_ids(const SurfacePiece& piece) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 62;
  for (const std::uint64_t id : piece.vertex_ids) {
    if (id < kMost) continue;
    throw Error("a vertex has the number " + std::to_string(id) +
                "; to subdivide a surface its numbers must be below 2^62");
  }
}

}  // namespace

SurfacePiece subdivided_piece(Communicator& ranks, SurfacePiece piece, int times) {
  DataArrays none;
  return subdivided_piece(ranks, std::move(piece), none, times);
}

SurfacePiece subdivided_piece(Communicator& ranks, SurfacePiece piece, DataArrays& arrays,
                              int times) {
  ranks.throw_on_all([&] {
    check_subdivisions(piece.mesh.triangle_count(), times);
    check_ids(piece);
  });
  for (int i = 0; i < times; ++i) piece = subdivided_once(ranks, std::move(piece), arrays);
  return piece;
}

}  // namespace brindle
