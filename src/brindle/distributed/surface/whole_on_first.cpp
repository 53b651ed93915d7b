#include "brindle/distributed/surface/whole_on_first.h"

namespace brindle {

WholeOnFirst::WholeOnFirst(const RankSurface& surface) : surface_(surface), ranks_(*surface.ranks) {
  std::vector<Index> all(surface.mesh.triangle_count());
  std::iota(all.begin(), all.end(), Index{0});
  const std::vector<SentTriangle> own = sent_triangles(surface, all, surface.normals);
  auto sent = joined<SentTriangle>(ranks_.gather(std::as_bytes(std::span(own))));
  const std::vector<std::uint64_t> ids = own_ids(surface);
  const auto of_ranks = ranks_.gather(std::as_bytes(std::span(ids)));
  ranks_.together([&] {
    if (!is_first()) return;
    for (const SentTriangle& triangle : sent) numbers_.push_back(triangle.number);
    part_ = part_of(std::move(sent), surface.mesh.origin, joined<std::uint64_t>(of_ranks));
    for (const std::vector<std::byte>& of_rank : of_ranks) {
      std::vector<Index>& places = places_.emplace_back();
      for (const std::uint64_t id : joined<std::uint64_t>({of_rank})) {
        const auto place = std::ranges::lower_bound(part_.ids, id);
        places.push_back(static_cast<Index>(place - part_.ids.begin()));
      }
    }
  });
  places_.resize(static_cast<std::size_t>(ranks_.size()));
}

std::vector<SentVector> sent_vectors(std::span<const Vec3> vectors) {
  std::vector<SentVector> result;
  for (const Vec3& vector : vectors) result.push_back(floats_of(vector));
  return result;
}

DirectionField received_vectors(const std::vector<SentVector>& vectors) {
  DirectionField result;
  for (const SentVector& vector : vectors) result.push_back(vector_of(vector));
  return result;
}

}  // namespace brindle
