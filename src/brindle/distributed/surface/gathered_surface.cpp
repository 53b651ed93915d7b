#include "brindle/distributed/surface/gathered_surface.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace brindle {

GatheredSurface::GatheredSurface(const RankSurface& surface)
    : piece_(surface),
      vertices_(*surface.ranks, surface.graph.own),
      triangles_(*surface.ranks, surface.mesh.triangle_count()) {
  const std::vector<std::uint64_t> known = known_ids(surface);
  const auto own = [&]<class T>(const std::vector<T>& by_vertex) {
    std::vector<T> all;
    vertices_.gather(std::span<const T>(by_vertex).first(surface.graph.own), all);
    return all;
  };
  std::vector<SentTriangle> sent, triangles;
  for (std::size_t t = 0; t < surface.mesh.triangle_count(); ++t) {
    const auto& [a, b, c] = surface.mesh.triangles[t];
    sent.push_back({surface.triangle_numbers.empty() ? 0 : surface.triangle_numbers[t],
                    {known[a], known[b], known[c]}});
  }
  triangles_.gather(std::span<const SentTriangle>(sent), triangles);
  const auto ids = own(known);
  const auto positions = own(surface.mesh.positions);
  surface.ranks->throw_on_all([&] {
    if (is_first()) put_together(ids, positions, triangles);
  });
}

void GatheredSurface::put_together(const std::vector<std::uint64_t>& ids,
                                   const std::vector<Vec3>& positions,
                                   const std::vector<SentTriangle>& triangles) {
  Mesh mesh;
  mesh.origin = piece_.mesh.origin;
  std::vector<Index> rows(ids.size());
  std::iota(rows.begin(), rows.end(), Index{0});
  std::ranges::sort(rows, {}, [&](Index row) { return ids[row]; });
  vertex_of_row_.resize(rows.size());
  for (const Index row : rows) {
    vertex_of_row_[row] = static_cast<Index>(ids_.size());
    ids_.push_back(ids[row]);
    mesh.positions.push_back(positions[row]);
  }
  row_of_triangle_.resize(triangles.size());
  std::iota(row_of_triangle_.begin(), row_of_triangle_.end(), Index{0});
  std::ranges::stable_sort(row_of_triangle_, {}, [&](Index row) { return triangles[row].number; });
  for (const Index row : row_of_triangle_) {
    Triangle& corners = mesh.triangles.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      const auto place = std::ranges::lower_bound(ids_, triangles[row].ids[c]);
      corners[c] = static_cast<Index>(place - ids_.begin());
    }
  }
  surface_ = make_surface(std::move(mesh), piece_.creases);
}

std::vector<TriangleOfPiece> GatheredSurface::triangles_of_pieces() const {
  std::vector<TriangleOfPiece> of_piece(piece_.piece_triangles);
  for (Index t = 0; t < of_piece.size(); ++t) of_piece[t] = {piece_.ranks->rank(), t};
  return of_triangles(std::span<const TriangleOfPiece>(of_piece));
}

}  // namespace brindle
