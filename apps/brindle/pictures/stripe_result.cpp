#include "pictures/stripe_result.h"

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

#include "brindle/corner_phases.h"

namespace brindle::tool {

struct WholeTiles::Found {
  std::mutex mutex;  ///< pictures and files may be written concurrently
  std::shared_ptr<const BrokenTileFinder> finder;
  std::vector<CornerPhases> u, v;
  std::vector<std::pair<TileMotifs, std::shared_ptr<const BrokenTiles>>> of_motifs;
};

WholeTiles::WholeTiles(std::optional<bool> asked)
    : asked_(asked), found_(std::make_shared<Found>()) {}

WholeTiles WholeTiles::of_next_texture(std::optional<bool> asked) const {
  WholeTiles next(asked);
  const std::scoped_lock lock(found_->mutex);
  next.found_->finder = found_->finder;
  return next;
}

std::optional<TileMotifs> WholeTiles::motifs_of(const TextureTile& tile,
                                                const Eigen::Vector2f& shift, float size) const {
  if (!asked_.value_or(has_own_shape(tile))) return std::nullopt;
  return motifs_within(tile_motifs(tile), size, shift);
}

std::shared_ptr<const BrokenTiles> WholeTiles::broken(std::span<const Triangle> triangles,
                                                      const TextureWaves& waves,
                                                      const TextureTile& tile,
                                                      const Eigen::Vector2f& shift,
                                                      float size) const {
  const std::optional<TileMotifs> motifs = motifs_of(tile, shift, size);
  if (!motifs) return nullptr;
  Found& found = *found_;
  const std::scoped_lock lock(found.mutex);
  const auto known = std::ranges::find(
      found.of_motifs, *motifs, [](const auto& pair) -> auto& { return pair.first; });
  if (known != found.of_motifs.end()) return known->second;
  if (found.finder == nullptr) found.finder = std::make_shared<const BrokenTileFinder>(triangles);
  if (found.u.size() != triangles.size()) {
    found.u = corner_phases(waves.u, PhaseShiftKind::aligned);  // as in drawn textures
    found.v = corner_phases(waves.v, PhaseShiftKind::aligned);
  }
  auto broken = std::make_shared<const BrokenTiles>(found.finder->find(found.u, found.v, *motifs));
  found.of_motifs.emplace_back(*motifs, broken);
  return broken;
}

void WholeTiles::know(const TileMotifs& motifs, BrokenTiles broken) {
  const std::scoped_lock lock(found_->mutex);
  found_->of_motifs.emplace_back(motifs, std::make_shared<const BrokenTiles>(std::move(broken)));
}

}  // namespace brindle::tool
