#include "brindle/windings.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <utility>

#include "brindle/base/elementary.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/pipeline/measured_pattern.h"
#include "brindle/pipeline/windings/twisted_forms.h"

namespace brindle {
namespace {

constexpr int kMostRounds = 5;
constexpr double kLargestShare = 0.95;  // of the wave that a change may reach

std::vector<LoopWalk> walks_of(const Surface& surface, std::span<const SurfaceLoop> loops,
                               const StripePattern& pattern) {
  if (pattern.solution.z.size() != surface.mesh.vertex_count()) {
    throw Error("windings: the pattern has " + std::to_string(pattern.solution.z.size()) +
                " phases, the surface " + std::to_string(surface.mesh.vertex_count()) +
                " vertices");
  }
  std::vector<LoopWalk> walks;
  for (const SurfaceLoop& loop : loops) {
    for (const Index v : loop.vertices) {
      if (v >= surface.mesh.vertex_count()) throw Error(loop.name + " is of another surface");
    }
    walks.push_back(
        walk_round(loop, surface.normals, pattern.waves, pattern.solution.z, pattern.phase_shift));
  }
  return walks;
}

std::vector<Winding> numbers_of(const std::vector<LoopWalk>& walks) {
  std::vector<Winding> numbers;
  for (const LoopWalk& walk : walks) {
    numbers.push_back(walk.oriented ? Winding(walk.winding()) : std::nullopt);
  }
  return numbers;
}

std::string names_of(const std::vector<SurfaceLoop>& loops) {
  std::string names;
  for (const SurfaceLoop& loop : loops) names += (names.empty() ? "" : ", ") + loop.name;
  return names;
}

/// Loops to prescribe: one boundary per connected component follows from the others.
std::vector<std::size_t> independent(const std::vector<SurfaceLoop>& loops) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const bool last = std::none_of(loops.begin() + static_cast<std::ptrdiff_t>(i) + 1, loops.end(),
                                   [&](const SurfaceLoop& other) {
                                     return other.boundary && other.component == loops[i].component;
                                   });
    if (!loops[i].boundary || !last) found.push_back(i);
  }
  return found;
}

std::size_t find_loop(const std::vector<SurfaceLoop>& loops, const std::string& name) {
  const std::vector<std::size_t> ways = independent(loops);
  if (ways.empty()) {
    throw Error(
        "windings: this surface has no way round: every loop on it can be drawn together, as on a "
        "sphere or a disc; a tube, a ring or a surface with a handle has one");
  }
  if (name.empty() && ways.size() == 1) return ways.front();
  if (name.empty()) {
    throw Error("windings: this surface has " + std::to_string(ways.size()) +
                " ways round; name the one that is meant: " + names_of(loops));
  }
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (loops[i].name == name) return i;
  }
  throw Error("windings: there is no '" + name + "'; this surface has " + names_of(loops));
}

struct Wanted {
  std::size_t loop;
  int periods;
};

/// Wave sign per vertex, 1 or -1, in an orientation of each component's field; 0 without a wave.
/// Unique up to sign if the field is orientable.
std::vector<int> senses_of(const Surface& surface, const std::vector<Vec3>& directions) {
  std::vector<int> senses(directions.size(), 0);
  std::vector<Index> queue;
  for (Index start = 0; start < directions.size(); ++start) {
    if (senses[start] != 0 || directions[start].isZero(0)) continue;
    senses[start] = 1;
    queue.assign(1, start);
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const Index v = queue[next];
      for (const Index w : surface.neighborhood->of(v)) {
        if (senses[w] != 0 || directions[w].isZero(0)) continue;
        senses[w] = directions[v].dot(directions[w]) < 0 ? -senses[v] : senses[v];
        queue.push_back(w);
      }
    }
  }
  return senses;
}

/// The boundaries of every connected component that has at least two.
std::vector<std::vector<std::size_t>> boundaries_of_pieces(std::span<const SurfaceLoop> loops) {
  std::map<std::size_t, std::vector<std::size_t>> of_piece;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (loops[i].boundary) of_piece[loops[i].component].push_back(i);
  }
  std::vector<std::vector<std::size_t>> result;
  for (auto& [piece, boundaries] : of_piece) {
    if (boundaries.size() > 1) result.push_back(std::move(boundaries));
  }
  return result;
}

std::vector<Wanted> wanted_of(const std::vector<SurfaceLoop>& loops,
                              std::span<const WantedWinding> wanted) {
  std::vector<Wanted> result;
  for (const WantedWinding& w : wanted) {
    if (std::abs(w.periods) > 1'000'000) {
      throw Error("windings: " + std::to_string(w.periods) + " is beyond a million");
    }
    const std::size_t loop = find_loop(loops, w.loop);
    for (const Wanted& other : result) {
      if (other.loop == loop) throw Error("windings: " + loops[loop].name + " is named twice");
    }
    result.push_back({loop, w.periods});
  }
  return result;
}

/// Adds the other handles with their present numbers, so that these stay.
void keep_others(const std::vector<SurfaceLoop>& loops, const std::vector<Winding>& before,
                 std::vector<Wanted>& wanted) {
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const bool named = ranges::any_of(wanted, [&](const Wanted& w) { return w.loop == i; });
    if (!named && !loops[i].boundary && before[i]) wanted.push_back({i, *before[i]});
  }
}

[[noreturn]] void refuse_sum(const std::vector<SurfaceLoop>& loops,
                             const std::vector<std::size_t>& boundaries, int last) {
  std::string names;
  for (const std::size_t b : boundaries) names += (names.empty() ? "" : ", ") + loops[b].name;
  throw Error("windings: " + names +
              " are all boundaries of their piece, and what winds in at "
              "some must wind out at others: with the others as wanted, " +
              loops[boundaries.back()].name + " has " + std::to_string(last) +
              "; ask for that, or leave it out");
}

/// Components whose boundaries are all prescribed: the last one, which follows from the others.
std::vector<std::size_t> followers(const Surface& surface, const std::vector<SurfaceLoop>& loops,
                                   const std::vector<LoopWalk>& walks, const WaveSet& waves,
                                   const std::vector<MissingPeriods>& missing) {
  std::vector<std::size_t> result;
  std::vector<int> senses;
  for (const auto& boundaries : boundaries_of_pieces(loops)) {
    int sum = 0, named = 0;
    for (const MissingPeriods& m : missing) {
      if (ranges::find(boundaries, m.loop) == boundaries.end()) continue;
      if (senses.empty()) senses = senses_of(surface, waves.directions);
      sum += senses[loops[m.loop].vertices[0]] * m.periods;
      ++named;
    }
    if (named < std::ssize(boundaries)) continue;
    const std::size_t last = boundaries.back();
    if (sum != 0) {
      const auto own = ranges::find(missing, last, &MissingPeriods::loop);
      const int gained = walks[last].periods + own->periods - senses[loops[last].vertices[0]] * sum;
      refuse_sum(loops, boundaries, walks[last].sign * gained);
    }
    result.push_back(last);
  }
  return result;
}

void check_oriented(const SurfaceLoop& loop, const LoopWalk& walk) {
  if (walk.oriented) return;
  throw Error("windings: the field cannot be oriented along " + loop.name +
              ", or has no waves there: there is no number to choose");
}

/// The missing periods in each loop's own orientation; empty if none.
std::vector<MissingPeriods> missing_of(const std::vector<SurfaceLoop>& loops,
                                       const std::vector<LoopWalk>& walks,
                                       const std::vector<Wanted>& wanted) {
  std::vector<MissingPeriods> missing;
  bool any = false;
  for (const Wanted& w : wanted) {
    const LoopWalk& walk = walks[w.loop];
    check_oriented(loops[w.loop], walk);
    missing.push_back({w.loop, walk.sign * w.periods - walk.periods});
    any = any || missing.back().periods != 0;
  }
  return any ? missing : std::vector<MissingPeriods>();
}

/// Waves whose phase gradient is changed by `change` (radians per unit length).
WaveSet turned_waves(const WaveSet& waves, const std::vector<Eigen::Vector3d>& change) {
  WaveSet result = waves;
  for (std::size_t v = 0; v < change.size(); ++v) {
    if (waves.directions[v].isZero(0)) continue;
    const Eigen::Vector3d own =
        static_cast<double>(waves.frequencies[v]) * waves.directions[v].cast<double>();
    const Eigen::Vector3d more = change[v] / (2 * std::numbers::pi);
    if (!(more.norm() < kLargestShare * own.norm())) {
      throw Error(
          "windings: these numbers would change the wave at vertex " + std::to_string(v) +
          " by more than there is of it; take numbers nearer to those that the pattern has");
    }
    const Eigen::Vector3d sum = own + more;
    result.directions[v] = sum.normalized().cast<float>();
    result.frequencies[v] = static_cast<float>(sum.norm());
  }
  return result;
}

void measure_turn(const WaveSet& before, WoundPattern& result) {
  const WaveSet& after = result.pattern.waves;
  double sum = 0, count = 0;
  for (std::size_t v = 0; v < before.directions.size(); ++v) {
    const Eigen::Vector3d a = before.directions[v].cast<double>();
    const Eigen::Vector3d b = after.directions[v].cast<double>();
    if (a.isZero(0)) continue;
    const double turn = elementary::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
    const double change =
        static_cast<double>(after.frequencies[v]) / static_cast<double>(before.frequencies[v]) - 1;
    sum += turn;
    ++count;
    result.largest_turn_deg = std::max(result.largest_turn_deg, turn);
    result.largest_frequency_change = std::max(result.largest_frequency_change, std::abs(change));
  }
  result.mean_turn_deg = count > 0 ? sum / count : 0;
}

}  // namespace

std::vector<Winding> windings(const Surface& surface, std::span<const SurfaceLoop> loops,
                              const StripePattern& pattern) {
  return numbers_of(walks_of(surface, loops, pattern));
}

std::vector<WindingSum> winding_sums(const Surface& surface, std::span<const SurfaceLoop> loops,
                                     const StripePattern& pattern) {
  const std::vector<LoopWalk> walks = walks_of(surface, loops, pattern);
  const std::vector<int> senses = senses_of(surface, pattern.waves.directions);
  std::vector<WindingSum> result;
  for (const auto& boundaries : boundaries_of_pieces(loops)) {
    WindingSum sum{boundaries};
    bool oriented = true;
    for (const std::size_t b : boundaries) {
      oriented = oriented && walks[b].oriented;
      sum.periods += senses[loops[b].vertices[0]] * walks[b].periods;
    }
    if (oriented) result.push_back(std::move(sum));
  }
  return result;
}

std::size_t branches_of_piece(const Surface& surface, const SurfaceLoop& loop,
                              const StripePattern& pattern) {
  if (pattern.corners.size() != surface.mesh.triangle_count()) {
    throw Error("windings: the pattern is of another surface");
  }
  std::vector<bool> reached(surface.mesh.vertex_count());
  std::vector<Index> queue = {loop.vertices.at(0)};
  reached.at(queue[0]) = true;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (const Index neighbor : surface.neighborhood->of(queue[next])) {
      if (!reached[neighbor]) queue.push_back(neighbor);
      reached[neighbor] = true;
    }
  }
  std::size_t count = 0;
  for (std::size_t t = 0; t < pattern.corners.size(); ++t) {
    count += is_branch(pattern.corners[t].kind) && reached[surface.mesh.triangles[t][0]];
  }
  return count;
}

WaveSet waves_round(const Surface& surface, const DirectionField& reference,
                    const WantedWinding& wanted) {
  if (wanted.periods <= 0)
    throw Error("windings: the number of stripes round a loop must be above 0");
  if (reference.size() != surface.mesh.vertex_count()) {
    throw Error("windings: there must be one direction per vertex");
  }
  const std::vector<SurfaceLoop> loops = surface_loops(surface);
  const Wanted number = wanted_of(loops, std::span(&wanted, 1)).front();
  const std::size_t count = surface.mesh.vertex_count();
  WaveSet waves{surface.mesh.positions, reference, std::vector<float>(count, 1e-6f)};
  std::vector<LoopWalk> walks;
  const std::vector<Complex> z(count, Complex(0, 1));
  for (const SurfaceLoop& loop : loops) {
    walks.push_back(walk_round(loop, surface.normals, waves, z, PhaseShiftKind::aligned));
  }
  check_oriented(loops[number.loop], walks[number.loop]);
  const auto change = harmonic_change(surface, mesh_edges(surface.mesh, *surface.neighborhood),
                                      loops, walks, {{number.loop, number.periods}}, reference);
  for (std::size_t v = 0; v < count; ++v) {
    const double radians = change[v].norm();
    waves.directions[v] =
        radians > 0 ? Vec3((change[v] / radians).cast<float>()) : Vec3(Vec3::Zero());
    waves.frequencies[v] =
        radians > 0 ? static_cast<float>(radians / (2 * std::numbers::pi)) : 1.0f;
  }
  return waves;
}

WoundPattern wind(const Surface& surface, const StripePattern& pattern,
                  std::span<const WantedWinding> wanted, const StripeOptions& options,
                  const Progress& progress) {
  JobStages stages(progress, {{"loops", 2}, {"windings", 10}});
  stages.begin("loops");
  const std::vector<SurfaceLoop> loops = surface_loops(surface);
  std::vector<Wanted> numbers = wanted_of(loops, wanted);
  std::vector<LoopWalk> walks = walks_of(surface, loops, pattern);
  WoundPattern result;
  result.pattern = pattern;
  result.before = numbers_of(walks);
  keep_others(loops, result.before, numbers);
  result.energy_before = pattern.solution.energy;
  const MeshEdges edges = mesh_edges(surface.mesh, *surface.neighborhood);
  const Progress winding = stages.begin("windings");
  for (int round = 0;; ++round) {
    std::vector<MissingPeriods> missing = missing_of(loops, walks, numbers);
    if (missing.empty()) break;
    for (const std::size_t last : followers(surface, loops, walks, result.pattern.waves, missing)) {
      std::erase_if(missing, [&](const MissingPeriods& m) { return m.loop == last; });
    }
    if (round == kMostRounds) {
      throw Error("windings: the solver comes to other numbers than those wanted, as with " +
                  loops[missing[0].loop].name + "; take numbers nearer to those of the pattern");
    }
    const Progress of_round = winding.part(1 - std::pow(0.5, round), 1 - std::pow(0.5, round + 1));
    of_round.report(0);
    const WaveSet& waves = result.pattern.waves;
    WaveSet turned = turned_waves(
        waves, harmonic_change(surface, edges, loops, walks, missing, waves.directions));
    result.pattern =
        resolve_with_frequencies(surface, std::move(turned), pattern, options, of_round);
    walks = walks_of(surface, loops, result.pattern);
  }
  result.after = numbers_of(walks);
  measure_turn(pattern.waves, result);
  stages.finish();
  return result;
}

}  // namespace brindle
