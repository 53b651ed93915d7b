#include <utility>

#include "brindle/distributed/curves/rank_pattern.h"
#include "brindle/distributed_pattern.h"
#include "brindle/error.h"
#include "brindle/pattern/sampling.h"

namespace brindle {
namespace {

/// Which of all ranks' samples stay, list by list.
std::vector<std::vector<std::uint8_t>> kept_samples(
    const std::vector<std::vector<std::byte>>& lists, float share) {
  std::vector<Sample> all = joined<Sample>(lists);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].triangle = static_cast<Index>(i);
  std::vector<std::vector<std::uint8_t>> kept;
  for (const auto& bytes : lists) kept.emplace_back(bytes.size() / sizeof(Sample), 0);
  drop_doubles(all, share);
  std::size_t list = 0, first = 0;
  for (const Sample& sample : all) {
    while (sample.triangle - first >= kept[list].size()) first += kept[list++].size();
    kept[list][sample.triangle - first] = 1;
  }
  return kept;
}

void check_one_surface(const PiecePattern& u, const PiecePattern& v) {
  if (&u.surface.rank_surface() == &v.surface.rank_surface()) return;
  throw Error("samples need two patterns on one surface");
}

}  // namespace

std::vector<Sample> wave_samples(const PiecePattern& u, const PiecePattern& v) {
  const RankSurface& surface = u.surface.rank_surface();
  surface.ranks->together([&] { check_one_surface(u, v); });
  const RankTriangles triangles = rank_triangles(surface);
  const RankWaves waves_u = rank_waves(u, triangles), waves_v = rank_waves(v, triangles);
  std::vector<Sample> samples;
  surface.ranks->together([&] {
    const LiftedWaves lifted_u(wave_pattern(triangles, waves_u, u.phase_shift));
    const LiftedWaves lifted_v(wave_pattern(triangles, waves_v, v.phase_shift));
    samples = wave_samples(triangles.mesh, triangles.normals, sampled_waves(lifted_u),
                           sampled_waves(lifted_v));
  });
  for (Sample& sample : samples) sample.triangle = surface.triangle_of_piece[sample.triangle];
  return samples;
}

std::size_t drop_doubles(const DistributedSurface& surface, std::vector<Sample>& samples,
                         float share) {
  Communicator& ranks = *surface.rank_surface().ranks;
  if (ranks.size() == 1) return drop_doubles(samples, share);
  const auto lists = ranks.gather(std::as_bytes(std::span<const Sample>(samples)));
  std::vector<std::vector<std::uint8_t>> kept(static_cast<std::size_t>(ranks.size()));
  ranks.together([&] {
    if (ranks.rank() == 0) kept = kept_samples(lists, share);
  });
  const std::vector<std::uint8_t> own = ranks.swap_lists(kept)[0];
  std::size_t left = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (own[i]) samples[left++] = samples[i];
  }
  const std::size_t dropped = samples.size() - left;
  samples.resize(left);
  return ranks.sum(dropped);
}

std::vector<Sample> gathered_samples(const DistributedSurface& surface,
                                     std::span<const Sample> samples) {
  return joined<Sample>(surface.rank_surface().ranks->gather(std::as_bytes(samples)));
}

}  // namespace brindle
