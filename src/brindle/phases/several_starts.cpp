#include "brindle/phases/several_starts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/random.h"
#include "brindle/base/standard.h"
#include "brindle/phases/multilevel.h"
#include "brindle/waves/circulation.h"

namespace brindle {
namespace {

constexpr std::uint32_t kStarts = 256;

/// Starts are compared on a level of at most `kFirstLevel` slots; the `kFinalists` lowest are then
/// compared on a finer level.
constexpr std::size_t kFinalists = 24;
constexpr std::size_t kFirstLevel = 300;

/// With fewer nodes, starts hardly differ; with many, sweeps cannot remove their singularities.
constexpr std::size_t kFewestNodes = 20;

/// The coarsest level with this many nodes, at most as fine as `finest`.
std::size_t coarsest_with(const std::vector<Level>& levels, std::size_t nodes, std::size_t finest) {
  std::size_t level = levels.size() - 1;
  while (level > finest && levels[level].layout().slot_of.size() < nodes) --level;
  return level;
}

/// The finest level with at most this many slots, or else the coarsest.
std::size_t finest_with(const std::vector<Level>& levels, std::size_t slots) {
  std::size_t level = 0;
  while (level + 1 < levels.size() && levels[level].layout().slot_count() > slots) ++level;
  return level;
}

void set_by_chance(Level& level, std::uint32_t start) {
  const Index slots = level.layout().slot_count();
  for (Index slot = 0; slot < slots; ++slot) {
    const std::uint32_t draw = jenkins_hash(slot * 32 + start % 32 + start / 32 * 0x9e3779b9U);
    level.z[slot] = draw % 2 == 0 ? kPeak : -kPeak;
  }
}

/// Prolongs phases from a level to `finest`, with sweeps over each finer level.
void prolong_levels(std::vector<Level>& levels, std::size_t from, std::size_t finest, int sweeps) {
  for (std::size_t l = from; l-- > finest;) {
    prolong(levels[l + 1], levels[l]);
    sweep_level(levels[l], sweeps);
  }
}

/// The phases that one start leads to on a level.
struct Descent {
  std::vector<Complex> z;
  double energy;
};

std::vector<Descent> descents_by_chance(std::vector<Level>& levels, std::size_t to, int sweeps,
                                        const Progress& progress) {
  const std::size_t coarse = coarsest_with(levels, kFewestNodes, to);
  std::vector<Descent> descents;
  for (std::uint32_t start = 0; start < kStarts; ++start) {
    progress.tick();
    // Half of the starts are one level finer, because levels lead to different minima.
    const std::size_t from = start % 2 == 1 && coarse > to ? coarse - 1 : coarse;
    set_by_chance(levels[from], start);
    sweep_level(levels[from], sweeps);
    prolong_levels(levels, from, to, sweeps);
    descents.push_back({levels[to].z, lowered_sums(levels[to], levels[to].z).energy});
  }
  return descents;
}

}  // namespace

EnergySums lowered_sums(const Level& level, std::span<const Complex> z) {
  EnergySums sums = energy_sums(level.layout(), level.couplings, z);
  const std::vector<Complex>& anchor = level.couplings.anchor;
  sums.energy += parallel_sum<double>(anchor.size(), [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t slot = begin; slot < end; ++slot) {
      const std::complex<double> target = anchor[slot];
      sum +=
          std::sqrt(std::norm(target)) - (std::conj(std::complex<double>(z[slot])) * target).real();
    }
    return sum;
  });
  return sums;
}

bool is_much_lower(const EnergySums& found, const EnergySums& plain) {
  // Above rounding errors of phase lengths, 6e-8.
  constexpr double kRounding = 2e-7;
  return found.energy < 0.9 * plain.energy - kRounding * plain.weight;
}

void descend_from_lowest(Hierarchy& hierarchy, int sweeps, const Progress& progress) {
  std::vector<Level>& levels = hierarchy.levels;
  const std::size_t judged = finest_with(levels, kSmallLevel);
  const std::size_t first = finest_with(levels, kFirstLevel);
  std::vector<Descent> descents = descents_by_chance(levels, first, sweeps, progress);
  ranges::stable_sort(descents, {}, &Descent::energy);
  if (descents.size() > kFinalists) descents.resize(kFinalists);
  Descent lowest{{}, std::numeric_limits<double>::infinity()};
  for (Descent& descent : descents) {
    progress.tick();
    levels[first].z = std::move(descent.z);
    prolong_levels(levels, first, judged, sweeps);
    const double energy = lowered_sums(levels[judged], levels[judged].z).energy;
    if (lowest.z.empty() || energy < lowest.energy) lowest = {levels[judged].z, energy};
  }
  levels[judged].z = std::move(lowest.z);
  progress.tick();
  prolong_levels(levels, judged, 0, sweeps);
}

bool descend_from_several(Hierarchy& hierarchy, int sweeps, const Progress& progress) {
  Level& finest = hierarchy.levels[0];
  descend(hierarchy, sweeps, progress);
  const EnergySums plain_sums = lowered_sums(finest, finest.z);
  std::vector<Complex> plain = finest.z;
  descend_from_lowest(hierarchy, sweeps, progress);
  const bool is_lower = is_much_lower(lowered_sums(finest, finest.z), plain_sums);
  if (!is_lower) finest.z = std::move(plain);
  return is_lower;
}

Starts starts_of_field(const PhaseGraph& graph, bool has_triangles) {
  return has_triangles && is_one_sided(graph) ? Starts::several : Starts::one;
}

LowestPhases solve_from(Starts starts, const PhaseGraph& graph, int sweeps, int cycles,
                        const Progress& progress) {
  JobStages stages(progress, {{"hierarchy", 7}, {"descent", 2}, {"cycles", 3}});
  Hierarchy hierarchy = build_hierarchy(graph, stages.begin("hierarchy"));
  LowestPhases phases;
  const Progress descent = stages.begin("descent");
  if (starts == Starts::several) {
    phases.is_lower = descend_from_several(hierarchy, sweeps, descent);
  } else {
    descend(hierarchy, sweeps, descent);
  }
  run_cycles(hierarchy, sweeps, cycles, stages.begin("cycles"));
  stages.finish();
  const Level& finest = hierarchy.levels[0];
  phases.z = to_nodes(finest.layout(), finest.z);
  return phases;
}

}  // namespace brindle
