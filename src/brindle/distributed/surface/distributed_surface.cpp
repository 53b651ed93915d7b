#include "brindle/distributed_surface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "brindle/distributed/surface/gathered_surface.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/distributed/surface/shared_vertices.h"
#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "brindle/geometry/normals_around.h"
#include "brindle/geometry/topology.h"

namespace brindle {
namespace {

/// Ranks without triangles have no numbers of them.
bool have_triangle_ids(Communicator& ranks, const SurfacePiece& piece) {
  const bool any = ranks.any(!piece.triangle_ids.empty());
  if (ranks.any(any && piece.triangle_ids.size() != piece.mesh.triangle_count())) {
    throw Error(
        "some pieces have triangle numbers and some have none; number all triangles, or "
        "none");
  }
  return any;
}

void check_origins(Communicator& ranks, const Eigen::Vector3d& origin) {
  const std::array<double, 3> own = {origin.x(), origin.y(), origin.z()};
  for (const auto& other : ranks.all(own)) {
    if (other == own) continue;
    throw Error("the pieces' positions are relative to different origins; give all the same");
  }
}

/// A vertex of another rank.
struct ForeignVertex {
  int owner;
  std::uint64_t id;
  Index known_as;  ///< index among the vertices of the partition and received ones

  auto key() const { return std::tuple(owner, id); }
};

/// Builds a RankSurface from a partition.
class SurfaceMaker {
 public:
  SurfaceMaker(SurfacePiece piece, RankSurface& made)
      : piece_(std::move(piece)), made_(made), ranks_(*made.ranks) {}

  void make() {
    made_.piece_ids = piece_.vertex_ids;
    made_.creases = std::move(piece_.creases);
    drop_ghosts();
    owner_ = find_owners(ranks_, piece_.vertex_ids, used_vertices());
    own_triangles_ = piece_.mesh.triangle_count();
    made_.triangle_numbers = piece_.triangle_ids;
    if (!have_triangle_ids(ranks_, piece_)) piece_.triangle_ids = ranks_.numbers_of(own_triangles_);
    if (ranks_.size() > 1) hear_of_triangles(ranks_, piece_, owner_);
    number_vertices();
    made_.graph.halo = halo_of(ghosts_, made_.graph.own);
    made_.rest = halo_of(rest_, made_.graph.own + static_cast<Index>(ghosts_.size()));
    renumber();
    derive();
    count();
  }

 private:
  void drop_ghosts() {
    made_.piece_triangles = piece_.mesh.triangle_count();
    std::vector<Triangle> own;
    std::vector<std::uint64_t> own_numbers;
    for (Index t = 0; t < made_.piece_triangles; ++t) {
      if (!piece_.ghost_triangles.empty() && piece_.ghost_triangles[t]) continue;
      own.push_back(piece_.mesh.triangles[t]);
      if (!piece_.triangle_ids.empty()) own_numbers.push_back(piece_.triangle_ids[t]);
      made_.triangle_of_piece.push_back(t);
    }
    // Vertices of ghost triangles alone are not this rank's.
    in_ghost_.assign(piece_.mesh.vertex_count(), 0);
    if (own.size() < made_.piece_triangles) mark_ghost_vertices();
    piece_.mesh.triangles = std::move(own);
    piece_.triangle_ids = std::move(own_numbers);
  }

  void mark_ghost_vertices() {
    for (std::size_t t = 0; t < made_.piece_triangles; ++t) {
      if (!piece_.ghost_triangles[t]) continue;
      for (const Index v : piece_.mesh.triangles[t]) in_ghost_[v] = 1;
    }
  }

  /// Vertices without any triangle count as used.
  std::vector<std::uint8_t> used_vertices() const {
    std::vector<std::uint8_t> used(in_ghost_.size());
    for (std::size_t v = 0; v < used.size(); ++v) used[v] = in_ghost_[v] ? 0 : 1;
    for (const Triangle& triangle : piece_.mesh.triangles) {
      for (const Index v : triangle) used[v] = 1;
    }
    return used;
  }

  /// Own vertices, then ghosts, then the rest.
  void number_vertices() {
    const auto known = static_cast<Index>(owner_.size());
    std::vector<std::uint8_t> near_own(known);
    for (const Triangle& triangle : piece_.mesh.triangles) {
      if (std::ranges::none_of(triangle, [&](Index v) { return is_own(v); })) continue;
      for (const Index v : triangle) near_own[v] = 1;
    }
    new_number_.assign(known, 0);
    const auto pieces = static_cast<Index>(in_ghost_.size());
    for (Index v = 0; v < known; ++v) {
      if (is_own(v)) {
        new_number_[v] = made_.graph.own++;
      } else if (near_own[v] || v < pieces) {
        (near_own[v] ? ghosts_ : rest_).push_back({owner_[v], piece_.vertex_ids[v], v});
      }
    }
    Index next = made_.graph.own;
    for (std::vector<ForeignVertex>* vertices : {&ghosts_, &rest_}) {
      std::ranges::sort(*vertices, {}, &ForeignVertex::key);
      for (const ForeignVertex& vertex : *vertices) new_number_[vertex.known_as] = next++;
    }
  }

  bool is_own(Index v) const { return owner_[v] == ranks_.rank(); }

  /// Requests vertices from their owners; they are numbered from `first` on.
  NodeHalo halo_of(const std::vector<ForeignVertex>& vertices, Index first) {
    const auto size = static_cast<std::size_t>(ranks_.size());
    std::vector<std::vector<std::uint64_t>> asked(size);
    for (const ForeignVertex& vertex : vertices) {
      asked[static_cast<std::size_t>(vertex.owner)].push_back(vertex.id);
    }
    const auto wanted = size > 1 ? ranks_.swap_lists(asked) : asked;
    NodeHalo halo;
    for (std::size_t r = 0; r < size; ++r) {
      const auto count = static_cast<Index>(asked[r].size());
      if (count > 0 || !wanted[r].empty()) {
        halo.push_back({static_cast<int>(r), own_numbers(wanted[r]), first, count});
      }
      first += count;
    }
    return halo;
  }

  std::vector<Index> own_numbers(const std::vector<std::uint64_t>& ids) {
    if (own_number_.empty()) {
      for (Index v = 0; v < owner_.size(); ++v) {
        if (is_own(v)) own_number_[piece_.vertex_ids[v]] = new_number_[v];
      }
    }
    std::vector<Index> numbers;
    for (const std::uint64_t id : ids) numbers.push_back(own_number_.at(id));
    return numbers;
  }

  /// Applies the new numbers to all data.
  void renumber() {
    const std::size_t count = made_.graph.own + ghosts_.size() + rest_.size();
    made_.mesh.origin = piece_.mesh.origin;
    made_.mesh.positions.resize(count);
    for (std::size_t v = 0; v < owner_.size(); ++v) {
      made_.mesh.positions[new_number_[v]] = piece_.mesh.positions[v];
    }
    for (Triangle& triangle : piece_.mesh.triangles) {
      for (Index& v : triangle) v = new_number_[v];
    }
    made_.mesh.triangles = std::move(piece_.mesh.triangles);
    made_.vertex_of_piece.assign(
        new_number_.begin(), new_number_.begin() + static_cast<std::ptrdiff_t>(in_ghost_.size()));
  }

  /// Sorts the triangles around vertices by global number, the order of summation.
  void sort_around(VertexTriangles& around) const {
    const auto number = [&](Index t) { return piece_.triangle_ids[t]; };
    for (std::size_t v = 0; v < around.size(); ++v) {
      const std::span<Index> row = around.of(v);
      if (!std::ranges::is_sorted(row, {}, number)) std::ranges::stable_sort(row, {}, number);
    }
  }

  /// Computes neighbourhood and normals of own vertices, all of whose triangles are known.
  void derive() {
    const Mesh known = made_.mesh;
    const auto received = known.triangles.begin() + static_cast<std::ptrdiff_t>(own_triangles_);
    made_.ring.assign(received, known.triangles.end());
    made_.mesh.triangles.resize(own_triangles_);
    const Index nodes = made_.graph.own + static_cast<Index>(ghosts_.size());
    VertexTriangles around = vertex_triangles(known);
    Adjacency adjacency = vertex_neighborhood(known, around);
    adjacency.offsets.resize(nodes + 1);
    const Index own_edges = adjacency.offsets[made_.graph.own];
    std::fill(adjacency.offsets.begin() + made_.graph.own, adjacency.offsets.end(), own_edges);
    adjacency.neighbors.resize(own_edges);
    made_.graph.adjacency = std::make_shared<const Adjacency>(std::move(adjacency));
    if (ranks_.size() > 1) sort_around(around);
    find_normals(known, around);
    made_.exchange_all(std::span(made_.normals));
    made_.piece_normals = made_.to_piece(std::span<const Vec3>(made_.normals));
    for (const Index v : made_.vertex_of_piece) {
      made_.piece_is_own.push_back(v < made_.graph.own ? 1 : 0);
    }
  }

  /// Winding is a property of whole components, so rank 0 decides if neighbours, of which it alone
  /// knows those over creases, may disagree anywhere.
  void find_normals(const Mesh& known, const VertexTriangles& around) {
    std::vector<TriangleAngles> angles;
    const bool against = fill_vertex_normals(known, around, {}, angles, made_.normals);
    if (!ranks_.any(against || !made_.creases.empty())) return;
    const std::vector<std::uint8_t> turned = turned_of_whole();
    fill_vertex_normals(known, around, turned, angles, made_.normals);
  }

  /// For the triangles known here.
  std::vector<std::uint8_t> turned_of_whole() {
    const GatheredSurface whole(made_);
    std::vector<std::uint64_t> number_of_piece(made_.piece_triangles);
    for (std::size_t t = 0; t < own_triangles_; ++t) {
      number_of_piece[made_.triangle_of_piece[t]] = piece_.triangle_ids[t];
    }
    const std::vector<std::uint64_t> number_of =
        whole.of_triangles(std::span<const std::uint64_t>(number_of_piece));
    std::vector<std::uint64_t> numbers;
    for (std::size_t t = 0; t < whole.surface().turned.size(); ++t) {
      if (whole.surface().turned[t] != 0) numbers.push_back(number_of[t]);
    }
    numbers = ranks_.of_first(numbers);
    std::vector<std::uint8_t> turned;
    for (const std::uint64_t number : piece_.triangle_ids) {
      turned.push_back(std::ranges::binary_search(numbers, number) ? 1 : 0);
    }
    return turned;
  }

  void count() {
    made_.vertices = ranks_.sum(std::size_t{made_.graph.own});
    made_.triangles = ranks_.sum(own_triangles_);
    made_.edges = ranks_.sum(made_.graph.adjacency->directed_edge_count()) / 2 -
                  ranks_.sum(made_.creases.edges.size());
    made_.crease_vertices = ranks_.sum(made_.creases.copied.size());
    made_.diagonal = diagonal_of_all();
  }

  double diagonal_of_all() {
    if (ranks_.size() == 1) return static_cast<double>(bounding_box(made_.mesh).diagonal());
    std::array<float, 6> corners;  // lower corner and negated upper corner
    corners.fill(std::numeric_limits<float>::max());
    const bool no_triangles = made_.triangles == 0;
    const auto include = [&](const Vec3& p) {
      for (int k = 0; k < 3; ++k) {
        corners[static_cast<std::size_t>(k)] = std::min(corners[static_cast<std::size_t>(k)], p[k]);
        corners[static_cast<std::size_t>(k) + 3] =
            std::min(corners[static_cast<std::size_t>(k) + 3], -p[k]);
      }
    };
    for (const Triangle& triangle : made_.mesh.triangles) {
      for (const Index v : triangle) include(made_.mesh.positions[v]);
    }
    for (const Vec3& p : made_.mesh.positions) {
      if (no_triangles) include(p);
    }
    for (const auto& other : ranks_.all(corners)) {
      for (std::size_t k = 0; k < 6; ++k) corners[k] = std::min(corners[k], other[k]);
    }
    if (made_.vertices == 0) return 0;
    return static_cast<double>(
        Vec3(-corners[3] - corners[0], -corners[4] - corners[1], -corners[5] - corners[2]).norm());
  }

  SurfacePiece piece_;  ///< with received triangles appended
  RankSurface& made_;
  Communicator& ranks_;
  std::size_t own_triangles_ = 0;
  std::vector<std::uint8_t> in_ghost_;  ///< by vertex of the partition: used by a ghost triangle
  std::vector<int> owner_;
  std::vector<Index> new_number_;
  std::vector<ForeignVertex> ghosts_, rest_;
  std::unordered_map<std::uint64_t, Index> own_number_;
};

}  // namespace

std::vector<std::uint64_t> known_ids(const RankSurface& surface) {
  std::vector<std::uint64_t> ids(surface.vertex_count());
  for (std::size_t p = 0; p < surface.piece_ids.size(); ++p) {
    ids[surface.vertex_of_piece[p]] = surface.piece_ids[p];
  }
  return ids;
}

Mesh triangles_around_own(const RankSurface& surface) {
  Mesh mesh;
  mesh.origin = surface.mesh.origin;
  mesh.positions = surface.mesh.positions;
  const auto is_own = [&](Index v) { return v < surface.graph.own; };
  for (const auto* triangles : {&surface.mesh.triangles, &surface.ring}) {
    std::ranges::copy_if(*triangles, std::back_inserter(mesh.triangles),
                         [&](const Triangle& t) { return std::ranges::any_of(t, is_own); });
  }
  return mesh;
}

DistributedSurface::DistributedSurface(SurfacePiece piece, MPI_Comm communicator) {
  auto surface = std::make_shared<RankSurface>();
  surface->ranks = std::make_unique<Communicator>(communicator);
  surface->ranks->throw_on_all([&] { check_piece(piece); });
  check_origins(*surface->ranks, piece.mesh.origin);
  SurfaceMaker(std::move(piece), *surface).make();
  const EdgeLengths own =
      edge_lengths(std::span<const Vec3>(surface->mesh.positions), *surface->graph.adjacency);
  const EdgeLengths all{surface->ranks->sum(own.sum), surface->ranks->sum(own.count)};
  surface->ranks->throw_on_all([&] { check_edge_lengths(all); });
  surface_ = std::move(surface);
}

std::span<const Vec3> DistributedSurface::normals() const { return rank_surface().piece_normals; }
std::span<const std::uint8_t> DistributedSurface::is_own() const {
  return rank_surface().piece_is_own;
}
std::size_t DistributedSurface::vertex_count() const { return rank_surface().vertices; }
std::size_t DistributedSurface::own_vertex_count() const {
  return vertex_count() - rank_surface().crease_vertices;
}
std::size_t DistributedSurface::triangle_count() const { return rank_surface().triangles; }
std::size_t DistributedSurface::edge_count() const { return rank_surface().edges; }
double DistributedSurface::diagonal() const { return rank_surface().diagonal; }
const Traffic& DistributedSurface::traffic() const { return rank_surface().ranks->traffic(); }

}  // namespace brindle
