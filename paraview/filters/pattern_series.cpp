#include "pattern_series.h"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <utility>

#include <brindle/carried_phases.h>
#include <brindle/corner_phases.h>
#include <brindle/pattern_of.h>
#include <brindle/quality.h>

namespace brindle::paraview {
namespace {

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

Ranks ranks_of(const PatternSurface& surface) {
  return surface.piece ? surface.piece->ranks() : Ranks();
}

/// Whether it is true on all ranks.
bool everywhere(const PatternSurface& surface, bool holds) {
  return ranks_of(surface).every(holds);
}

/// The result of `work` with either animator, which there is.
template <class Animators, class Work>
auto of_animator(Animators& animators, const Work& work) {
  auto* over_ranks = std::get_if<DistributedStripeAnimator>(&animators);
  return over_ranks != nullptr ? work(*over_ranks) : work(std::get<StripeAnimator>(animators));
}

/// The identity of a vertex over time: id or position, and index among its copies.
using VertexKey = std::array<std::uint64_t, 2>;

/// 0 for the first of the vertices split at creases.
std::vector<std::uint64_t> copy_numbers(const Surface& surface) {
  std::vector<std::uint64_t> numbers(surface.own_vertex_count());
  std::vector<std::uint64_t> last = numbers;
  for (const Index vertex : surface.creases.copied) numbers.push_back(++last[vertex]);
  return numbers;
}

std::vector<VertexKey> keys_of(const PatternSurface& surface, std::span<const Vec3> positions,
                               bool by_id) {
  const std::vector<std::uint64_t> copies = copy_numbers(*surface.surface);
  std::vector<VertexKey> keys;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (by_id) {
      keys.push_back({(*surface.ids)[v], copies[v] << 32});
      continue;
    }
    const auto bits = [&](int k) {
      return std::uint64_t{std::bit_cast<std::uint32_t>(positions[v][k] + 0.0f)};
    };
    keys.push_back({bits(0) << 32 | bits(1), copies[v] << 32 | bits(2)});
  }
  return keys;
}

/// A wave that is sent between ranks.
struct KnownWave {
  VertexKey key{};
  std::array<float, 3> direction{};
  std::array<float, 2> z{};
};

/// Collective. The waves of all ranks with keys known to this rank, sorted by key.
std::vector<KnownWave> known_waves(const Ranks& ranks, std::span<const VertexKey> keys,
                                   std::span<const Vec3> directions, std::span<const Complex> z) {
  std::vector<std::vector<KnownWave>> told(static_cast<std::size_t>(ranks.size()));
  for (std::size_t v = 0; v < keys.size(); ++v) {
    const Vec3& d = directions[v];
    told[ranks.rank_of(keys[v])].push_back(
        {keys[v], {d.x(), d.y(), d.z()}, {z[v].real(), z[v].imag()}});
  }
  std::vector<KnownWave> known;
  for (const auto& list : ranks.swap_lists(told))
    known.insert(known.end(), list.begin(), list.end());
  std::ranges::stable_sort(known, {}, &KnownWave::key);
  return known;
}

/// A wave for every request, without a direction if unknown.
std::vector<std::vector<KnownWave>> answered(std::span<const KnownWave> known,
                                             const std::vector<std::vector<VertexKey>>& questions) {
  std::vector<std::vector<KnownWave>> answers;
  for (const auto& list : questions) {
    std::vector<KnownWave>& of_rank = answers.emplace_back();
    for (const VertexKey& key : list) {
      const auto found = std::ranges::lower_bound(known, key, {}, &KnownWave::key);
      const bool is_there = found != known.end() && found->key == key;
      of_rank.push_back(is_there ? *found : KnownWave());
    }
  }
  return answers;
}

}  // namespace

std::vector<Complex> phases_elsewhere(const PatternSurface& last, const StripePattern& pattern,
                                      const PatternSurface& surface, const WaveSet& waves) {
  const Ranks ranks = ranks_of(surface);
  const bool by_id = ranks.every(last.ids && surface.ids);
  // Positions are relative to an origin, equal on all ranks.
  if (!by_id && last.surface->mesh.origin != surface.surface->mesh.origin) {
    return std::vector<Complex>(waves.positions.size());
  }
  const std::vector<VertexKey> known = keys_of(last, pattern.waves.positions, by_id);
  const std::vector<KnownWave> of_ranks =
      known_waves(ranks, known, pattern.waves.directions, pattern.solution.z);
  const std::vector<KnownWave> found = answers_to(
      ranks, keys_of(surface, waves.positions, by_id),
      [&](const VertexKey& key) { return ranks.rank_of(key); },
      [&](const auto& questions) { return answered(of_ranks, questions); });
  WaveSet before = waves;
  std::vector<Complex> z;
  for (std::size_t v = 0; v < found.size(); ++v) {
    before.directions[v] = Vec3(found[v].direction.data());
    z.emplace_back(found[v].z[0], found[v].z[1]);
  }
  return matched_phases({surface.surface->mesh, before, z}, waves);
}

bool same_connectivity(const PatternSurface& a, const PatternSurface& b) {
  if (a.surface == b.surface && a.piece == b.piece) return true;
  if (!a.piece != !b.piece || (a.piece && !a.piece->is_shared_like(*b.piece))) return false;
  return a.surface->mesh.vertex_count() == b.surface->mesh.vertex_count() &&
         a.surface->mesh.triangles == b.surface->mesh.triangles;
}

bool same_connectivity_everywhere(const PatternSurface& a, const PatternSurface& b) {
  return everywhere(b, a.surface && same_connectivity(a, b));
}

const StripePattern& PatternSeries::next(const PatternSurface& surface, WaveSet waves,
                                         const SeriesOptions& options, bool follows,
                                         const Progress& progress) {
  const bool fitting = everywhere(surface, fits(surface, options));
  if (fitting && everywhere(surface, has_pattern_of(waves))) {
    surface_ = surface;
    return pattern_;
  }
  const bool renumbered = follows && !fitting && options == options_ && has_animator();
  std::optional<std::vector<Complex>> last;
  if (renumbered) last = phases_to_follow(surface, waves);
  lost_track_ = renumbered && !last;
  try {
    // A restarted animator would keep the aggregates of its first frame.
    if (!fitting || !follows) start(surface, options);
    if (last) of_animator(animator_, [&](auto& animator) { animator.set_last_phases(*last); });
    surface_ = surface;
    solve(std::move(waves), progress);
    patterns_followed_ += follows && (fitting || last) ? 1 : 0;
  } catch (...) {
    animator_ = {};
    throw;
  }
  return pattern_;
}

/// Empty if fewer than half of the waves have a last phase.
std::optional<std::vector<Complex>> PatternSeries::phases_to_follow(const PatternSurface& surface,
                                                                    const WaveSet& waves) const {
  std::vector<Complex> last = phases_elsewhere(surface_, pattern_, surface, waves);
  std::array<std::size_t, 2> counts{};  // of waves, and of those with a last phase
  for (std::size_t v = 0; v < last.size(); ++v) {
    if (waves.directions[v].isZero(0)) continue;
    ++counts[0];
    counts[1] += last[v] != Complex(0) ? 1 : 0;
  }
  std::array<std::size_t, 2> sums{};
  for (const auto& of_rank : ranks_of(surface).all(counts)) {
    sums = {sums[0] + of_rank[0], sums[1] + of_rank[1]};
  }
  if (sums[1] == 0 || 2 * sums[1] < sums[0]) return std::nullopt;
  return last;
}

bool PatternSeries::fits(const PatternSurface& surface, const SeriesOptions& options) const {
  return has_animator() && options == options_ && same_connectivity(surface_, surface);
}

bool PatternSeries::has_pattern_of(const WaveSet& waves) const {
  const FrequencyField& wanted = pattern_.frequencies_wanted.empty() ? pattern_.waves.frequencies
                                                                     : pattern_.frequencies_wanted;
  return waves.positions == pattern_.waves.positions &&
         waves.directions == pattern_.waves.directions && waves.frequencies == wanted;
}

void PatternSeries::start(const PatternSurface& surface, const SeriesOptions& options) {
  DistributedOptions frames;
  frames.slack = options.slack;
  frames.lambda = options.lambda;
  if (surface.piece) {
    animator_.emplace<DistributedStripeAnimator>(surface.piece->surface(), frames);
  } else {
    animator_.emplace<StripeAnimator>(*surface.surface, frames);
  }
  options_ = options;
  ++solvers_made_;
}

void PatternSeries::solve(WaveSet waves, const Progress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  const FrameInput input{waves.positions, waves.directions, waves.frequencies};
  const FrameResult frame =
      of_animator(animator_, [&](auto& animator) { return animator.frame(input, progress); });
  solve_milliseconds_ = milliseconds_since(begin);
  const double energy = of_animator(animator_, [](auto& animator) { return animator.energy(); });
  StripePattern made = pattern_of_frame(frame, std::move(waves), energy, PhaseShiftKind::aligned);
  // Corner phases, also of ghosts.
  made.corners = corner_phases(surface_.surface->mesh.triangles, made.waves, made.solution.z,
                               made.phase_shift);
  made.quality = quality_of(made);
  pattern_ = std::move(made);
}

/// Of the whole surface.
PatternQuality PatternSeries::quality_of(const StripePattern& made) const {
  const auto* over_ranks = std::get_if<DistributedStripeAnimator>(&animator_);
  if (over_ranks != nullptr) return over_ranks->measure().quality;
  return measure_quality(surface_.surface->mesh, made.waves, made.corners);
}

}  // namespace brindle::paraview
