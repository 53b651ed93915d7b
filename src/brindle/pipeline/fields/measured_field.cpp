#include "brindle/measured_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/base/random.h"
#include "brindle/base/standard.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/geometry/topology.h"
#include "brindle/phases/screened.h"
#include "brindle/pipeline/fields/measured_scale.h"
#include "brindle/pipeline/fields/surface_elements.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {
namespace {

/// Relative residuals of the solver. Directions are then off by some hundredths of a degree, in
/// frames that start from the last one by a tenth. Vertices far from all data need a smaller
/// residual.
constexpr float kTolerance = 5e-3f, kToleranceInFrames = 1e-2f, kToleranceInHoles = 5e-4f;
constexpr int kMostIterations = 2000;

constexpr float kFarthestPair = 64;  // in periods

void require(bool holds, const std::string& message) {
  if (!holds) throw Error("measured field: " + message);
}

bool is_strength(float number) { return std::isfinite(number) && number >= 0; }

void check_smoothing(const FieldSmoothingOptions& options) {
  check_scale("measured field", options.periods, options.fill);
  require(options.symmetry >= 1, "the symmetry N must be 1 or above");
  require(is_strength(options.memory), "the memory must be a finite number of 0 or above");
  require(options.hold_out >= 0 && options.hold_out < 1,
          "the share of data to hold out must be 0 or above, and below 1");
}

void check_field(const MeasuredField& field, std::size_t places, const std::string& what) {
  const auto count = [&](std::size_t entries, const std::string& name) {
    require(entries == places, "there are " + std::to_string(entries) + " " + name + " of " + what +
                                   " for " + std::to_string(places) +
                                   (field.of_triangles ? " triangles" : " vertices") +
                                   "; give one to each");
  };
  count(field.directions.size(), "directions");
  if (field.confidence.empty()) return;
  count(field.confidence.size(), "confidences");
  require(ranges::all_of(field.confidence, is_strength),
          "confidences must be finite numbers of 0 or above");
}

/// Rotation of a direction by smoothing, and the area that it represents.
struct DatumTurn {
  float degrees;
  float weight;
};

/// The same places in every run and on every surface with these numbers.
bool is_held_out(std::size_t place, float share) {
  const double number = jenkins_hash(static_cast<std::uint32_t>(place)) / 4294967296.0;
  return number < static_cast<double>(share);
}

/// The rotation below which `share` of the total weight lies.
double quantile(std::span<const DatumTurn> sorted, double total, double share) {
  double sum = 0;
  for (const DatumTurn& turn : sorted) {
    sum += static_cast<double>(turn.weight);
    if (sum >= share * total) return static_cast<double>(turn.degrees);
  }
  return sorted.empty() ? 0 : static_cast<double>(sorted.back().degrees);
}

/// Directional coherence of the data around a vertex, 0 to 1.
float coherence(const Complex& u) { return std::min(std::sqrt(std::norm(u)), 1.0f); }

void tell_turns(std::vector<DatumTurn> turns, FieldSmoothingMetrics& metrics) {
  ranges::sort(turns, {}, &DatumTurn::degrees);
  double total = 0, sum = 0, over = 0;
  for (const DatumTurn& turn : turns) {
    const auto weight = static_cast<double>(turn.weight);
    total += weight;
    sum += weight * static_cast<double>(turn.degrees);
    over += turn.degrees > 20 ? weight : 0;
  }
  if (!(total > 0)) return;
  metrics.turned_mean_deg = sum / total;
  metrics.turned_median_deg = quantile(turns, total, 0.5);
  metrics.turned_p95_deg = quantile(turns, total, 0.95);
  metrics.turned_share_over_20deg = over / total;
}

}  // namespace

/// A datum at a vertex: its direction there, its area, and its area times confidence.
struct FieldDatum {
  Complex u;  ///< of unit length up to rounding
  float area;
  float weight;
};

struct FieldSmoothing::State {
  State(const Surface& given, const FieldSmoothingOptions& wanted, const Progress& progress)
      : options(wanted), surface(given) {
    check_smoothing(options);
    check_positions(surface.mesh.positions);
    require(!options.singularities || !surface.mesh.triangles.empty(),
            "points have no triangles that a field could turn round");
    const std::vector<float> stiffness = edge_stiffness(surface, progress.part(0, 0.5));
    graph = build_weighted_direction_graph(surface.neighborhood, surface.normals, options.symmetry,
                                           stiffness, progress.part(0.5, 1));
    degrees = stiffness_sums(*surface.neighborhood, stiffness);
    bases.resize(count());
    parallel_for(count(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) bases[i] = tangent_basis(surface.normals[i]);
    });
    triangle_areas = areas_of_triangles(surface.mesh);
    areas = areas_of_vertices(surface, triangle_areas);
  }

  std::size_t count() const { return surface.mesh.vertex_count(); }

  /// A direction as a datum in the tangent basis of vertex `i`.
  FieldDatum datum(const MeasuredField& field, std::size_t place, Index i, float area) const {
    const Vec3 tangent = tangent_direction(field.directions[place], surface.normals[i]);
    const float confidence = field.confidence.empty() ? 1 : field.confidence[place];
    if (tangent.isZero(0) || confidence == 0) return {0, 0, 0};
    const Complex in_basis(tangent.dot(bases[i].x), tangent.dot(bases[i].y));
    Complex power = in_basis;
    for (int n = 1; n < options.symmetry; ++n) power *= in_basis;
    return {power, area, area * confidence};
  }

  /// Calls `body` with every datum of a vertex.
  template <class Body>
  void for_data(const MeasuredField& field, Index i, const Body& body) const {
    if (!field.of_triangles) return body(datum(field, i, i, areas[i]));
    for (const Index t : around.of(i)) body(datum(field, t, i, triangle_areas[t] / 3));
  }

  /// Sums of data by vertex: weighted directions, weights, and areas.
  struct Sums {
    std::vector<Complex> pull;
    std::vector<float> weight, area;
  };

  /// Result of a frame.
  struct Found {
    Sums data;
    std::vector<Complex> u;
  };

  /// How data that were not used differ from the field.
  struct HeldOut {
    std::size_t count = 0;
    double mean_deg = 0;
  };

  Sums sums_of(const MeasuredField& field) const {
    Sums sums{std::vector<Complex>(count()), std::vector<float>(count()),
              std::vector<float>(count())};
    if (field.directions.empty()) return sums;
    parallel_for(count(), [&](std::size_t begin, std::size_t end) {
      for (Index i = static_cast<Index>(begin); i < end; ++i) {
        for_data(field, i, [&](const FieldDatum& d) {
          sums.pull[i] += d.weight * d.u;
          sums.weight[i] += d.weight;
          sums.area[i] += d.area;
        });
      }
    });
    return sums;
  }

  /// Mean confidence of the data, by which weights are divided.
  static double mean_confidence(const Sums& sums) {
    const auto sum = [](const std::vector<float>& values) {
      return parallel_sum<double>(values.size(), [&](std::size_t begin, std::size_t end) {
        return std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(begin),
                               values.begin() + static_cast<std::ptrdiff_t>(end), 0.0);
      });
    };
    const double area = sum(sums.area);
    return area > 0 ? sum(sums.weight) / area : 1;
  }

  SmoothedField frame(const MeasuredField& measured, std::span<const float> frequencies,
                      const MeasuredField& last, const Progress& progress);
  void check_frame(const MeasuredField& measured, std::span<const float> frequencies,
                   const MeasuredField& last) const;
  Found solve(const MeasuredField& measured, std::span<const float> frequencies,
              const MeasuredField& last, const Progress& progress);
  std::vector<float> distances(const Sums& data, std::span<const float> frequencies) const;
  FoundSingularities pairs_to_undo(std::span<const Complex> u, std::span<const float> frequencies,
                                   std::size_t more) const;
  void undo_singularities(std::span<const float> frequencies, std::vector<float>& screening,
                          const ScreenedOptions& solving, std::vector<Complex>& u);
  SmoothedField seen(const Found& found, std::span<const float> frequencies,
                     const Progress& progress) const;
  void sign_like_last(DirectionField& field, const Progress& progress) const;
  HeldOut hold_out(const MeasuredField& measured, std::span<const float> frequencies,
                   const MeasuredField& last, const Progress& progress);
  std::vector<DatumTurn> turns(const MeasuredField& measured, std::span<const Complex> u,
                               std::span<const Vec3> field) const;
  double mean_coherence(bool of_data) const;

  FieldSmoothingOptions options;
  Surface surface;
  PhaseGraph graph;            // transport, times stiffness
  std::vector<float> degrees;  // sums of stiffness
  std::vector<TangentBasis> bases;
  std::vector<float> areas, triangle_areas;
  VertexTriangles around;

  // The last completed frame.
  std::optional<MeasuredField> measured_;
  Found found_;
  HeldOut held_out_;
  DirectionField directions;
};

void FieldSmoothing::State::check_frame(const MeasuredField& measured,
                                        std::span<const float> frequencies,
                                        const MeasuredField& last) const {
  require(!measured.of_triangles || !surface.mesh.triangles.empty(),
          "points have no triangles that data could be of");
  check_field(measured, measured.of_triangles ? surface.mesh.triangle_count() : count(),
              "the data");
  if (!last.directions.empty()) {
    require(!last.of_triangles, "the last field has one direction per vertex");
    check_field(last, count(), "the last field");
  }
  require(frequencies.size() == count(), "there are " + std::to_string(frequencies.size()) +
                                             " frequencies for " + std::to_string(count()) +
                                             " vertices; give one to each");
  require(ranges::all_of(frequencies, is_strength),
          "frequencies must be finite numbers of 0 or above");
}

FieldSmoothing::State::Found FieldSmoothing::State::solve(const MeasuredField& measured,
                                                          std::span<const float> frequencies,
                                                          const MeasuredField& last,
                                                          const Progress& progress) {
  Found found{sums_of(measured), {}};
  const Sums& data = found.data;
  const std::vector<Complex>& last_u = found_.u;
  const auto even = static_cast<float>(1 / mean_confidence(data));
  const Sums before = options.memory > 0 ? sums_of(last) : Sums{};
  std::vector<float> screening(count());
  std::vector<Complex> start(count());
  graph.anchor.assign(count(), Complex(0));
  parallel_for(count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float inverse = 2 * frequencies[i] / options.periods;  // of the length l
      const float square = inverse * inverse;
      graph.anchor[i] = square * even * data.pull[i];
      screening[i] = square * even * data.weight[i];
      if (!before.pull.empty()) {
        graph.anchor[i] += square * options.memory * before.pull[i];
        screening[i] += square * options.memory * before.weight[i];
      }
      if (screening[i] > 0) start[i] = graph.anchor[i] / screening[i];
      // The last frame's solution is a closer start, where it exists.
      if (!last_u.empty() && last_u[i] != Complex(0)) start[i] = last_u[i];
    }
  });
  const bool has_holes = ranges::find(screening, 0.0f) != screening.end();
  ScreenedOptions solving = {.max_iterations = kMostIterations,
                             .tolerance = has_holes        ? kToleranceInHoles
                                          : last_u.empty() ? kTolerance
                                                           : kToleranceInFrames,
                             .of_anchors = true,
                             .degrees = degrees,
                             .progress = options.singularities ? progress.part(0, 0.5) : progress};
  found.u = smooth_screened(graph, screening, std::move(start), solving);
  if (!options.singularities) return found;
  solving.progress = progress.part(0.5, 1);
  undo_singularities(frequencies, screening, solving, found.u);
  return found;
}

/// Distance of every vertex from the nearest datum along edges, in periods; infinite beyond the
/// fill distance. Empty without holes.
std::vector<float> FieldSmoothing::State::distances(const Sums& data,
                                                    std::span<const float> frequencies) const {
  if (ranges::find(data.weight, 0.0f) == data.weight.end()) return {};
  const auto is_hole = [&](Index j) { return data.weight[j] == 0; };
  return periods_from_data(surface, frequencies, std::not_fn(is_hole), is_hole, options.fill);
}

/// The number of singularities, and the nearest opposite pairs: enough to reach the requested
/// number, plus `more`. Doubles the search radius until there are pairs.
FoundSingularities FieldSmoothing::State::pairs_to_undo(std::span<const Complex> u,
                                                        std::span<const float> frequencies,
                                                        std::size_t more) const {
  const DirectionField field = directions_of(u, surface.normals, options.symmetry);
  FoundSingularities found;
  for (float reach = 1; reach <= kFarthestPair; reach *= 2) {
    found = opposite_singularities(surface, field, options.symmetry, frequencies, reach);
    if (found.count <= *options.singularities) return {found.count, {}};
    const std::size_t most = (found.count - *options.singularities + 1) / 2 + more;
    if (found.pairs.size() > most) found.pairs.resize(most);
    if (!found.pairs.empty()) return found;
  }
  return found;
}

/// Increases the smoothing around pairs of singularities until few enough are left. Otherwise keeps
/// the field with the fewest.
void FieldSmoothing::State::undo_singularities(std::span<const float> frequencies,
                                               std::vector<float>& screening,
                                               const ScreenedOptions& solving,
                                               std::vector<Complex>& u) {
  constexpr int kMostRounds = 30;
  PeriodWalk walk(surface, frequencies);
  std::vector<Complex> best;
  std::size_t fewest = std::numeric_limits<std::size_t>::max(), in_vain = 0;
  for (int round = 0; round <= kMostRounds; ++round) {
    // Sharp cones force a singularity on every field: then try additional pairs.
    const FoundSingularities found = pairs_to_undo(u, frequencies, in_vain);
    in_vain = found.count < fewest ? 0 : in_vain + 2;
    if (found.count < fewest) best = u;
    fewest = std::min(fewest, found.count);
    if (found.pairs.empty() || round == kMostRounds) break;
    // Pairs that persist need smoothing over a larger area.
    const float grown = 1 + 0.2f * static_cast<float>(round);
    std::vector<std::uint8_t> is_near(count());
    for (const OppositeSingularities& pair : found.pairs) {
      for (const Index triangle : {pair.positive, pair.negative}) {
        walk.from(surface.mesh.triangles[triangle], grown * (0.5f + pair.distance),
                  [&](Index i, float) {
                    is_near[i] = 1;
                    return true;
                  });
      }
    }
    constexpr float kLess = 0.25f;  // twice the scale
    constexpr float kRounding = std::numeric_limits<float>::epsilon();
    for (std::size_t i = 0; i < count(); ++i) {
      // Anchors below rounding have no effect.
      if (is_near[i] == 0 || screening[i] < kRounding * degrees[i]) continue;
      screening[i] *= kLess;
      graph.anchor[i] *= kLess;
    }
    ScreenedOptions again = solving;
    again.progress =
        solving.progress.part(round / double{kMostRounds}, (round + 1) / double{kMostRounds});
    u = smooth_screened(graph, screening, std::move(u), again);
  }
  u = std::move(best);
}

/// Chooses signs like the neighbours in the first frame, later like the last frame.
void FieldSmoothing::State::sign_like_last(DirectionField& field, const Progress& progress) const {
  if (directions.empty()) return orient_alike(surface, field, progress);
  std::vector<std::uint8_t> settled(count());
  parallel_for(count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      settled[i] = directions[i].isZero(0) ? 0 : 1;
      if (field[i].dot(directions[i]) < 0) field[i] = -field[i];
    }
  });
  const bool all = ranges::find(settled, std::uint8_t{0}) == settled.end();
  if (!all) orient_alike(*surface.neighborhood, settled, field);
}

SmoothedField FieldSmoothing::State::seen(const Found& found, std::span<const float> frequencies,
                                          const Progress& progress) const {
  SmoothedField field{DirectionField(count()), std::vector<float>(count()),
                      std::vector<std::uint8_t>(count())};
  const std::vector<Complex>& u = found.u;
  const std::vector<float> distance = distances(found.data, frequencies);
  parallel_for(count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      field.directions[i] = Vec3::Zero();
      const bool is_near = distance.empty() || distance[i] <= options.fill;
      const bool has_wave = frequencies[i] > 0 && u[i] != Complex(0) && is_near;
      if (!has_wave || surface.normals[i].isZero(0)) continue;
      const Complex root = unit_root(u[i], options.symmetry);
      field.directions[i] = root.real() * bases[i].x + root.imag() * bases[i].y;
      field.coherence[i] = coherence(u[i]);
      field.filled[i] = found.data.weight[i] > 0 ? 0 : 1;
    }
  });
  if (options.symmetry % 2 == 0) sign_like_last(field.directions, progress);
  return field;
}

SmoothedField FieldSmoothing::State::frame(const MeasuredField& measured,
                                           std::span<const float> frequencies,
                                           const MeasuredField& last, const Progress& progress) {
  check_frame(measured, frequencies, last);
  if (measured.of_triangles && around.entries.empty()) around = vertex_triangles(surface.mesh);
  progress.report(0);
  const bool holds_out = options.hold_out > 0;
  const HeldOut held_out =
      holds_out ? hold_out(measured, frequencies, last, progress.part(0, 0.4)) : HeldOut{};
  Found found = solve(measured, frequencies, last, progress.part(holds_out ? 0.4 : 0, 0.8));
  const bool is_any = ranges::any_of(found.data.weight, [](float w) { return w > 0; });
  require(is_any, "there is no datum: no direction is along the surface, finite and of any weight");
  SmoothedField field = seen(found, frequencies, progress.part(0.8, 1));
  DirectionField kept = field.directions;
  measured_ = measured;
  found_ = std::move(found);
  held_out_ = held_out;
  directions = std::move(kept);
  return field;
}

/// Solves with the other data, and compares.
FieldSmoothing::State::HeldOut FieldSmoothing::State::hold_out(const MeasuredField& measured,
                                                               std::span<const float> frequencies,
                                                               const MeasuredField& last,
                                                               const Progress& progress) {
  MeasuredField used = measured, hidden = measured;
  for (std::size_t place = 0; place < measured.directions.size(); ++place) {
    MeasuredField& without = is_held_out(place, options.hold_out) ? used : hidden;
    without.directions[place] = Vec3::Zero();
  }
  const Found found = solve(used, frequencies, last, progress.part(0, 0.8));
  require(ranges::any_of(found.data.weight, [](float w) { return w > 0; }),
          "no datum is left beside those to hold out; hold out a smaller share");
  const DirectionField field = seen(found, frequencies, progress.part(0.8, 1)).directions;
  FieldSmoothingMetrics metrics;
  const std::vector<DatumTurn> turned = turns(hidden, found.u, field);
  tell_turns(turned, metrics);
  require(!turned.empty(),
          "holes are filled over too short a distance to reach data held out; fill "
          "them farther, or hold out a smaller share");
  return {turned.size(), metrics.turned_mean_deg};
}

std::vector<DatumTurn> FieldSmoothing::State::turns(const MeasuredField& measured,
                                                    std::span<const Complex> u,
                                                    std::span<const Vec3> field) const {
  const auto in_degrees = [&](const Complex& turned) {
    return std::abs(elementary::arg(turned)) * 180 /
           (std::numbers::pi_v<float> * static_cast<float>(options.symmetry));
  };
  std::vector<DatumTurn> turns(measured.directions.size(), DatumTurn{0, 0});
  parallel_for(turns.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t place = begin; place < end; ++place) {
      Complex turned = 0;
      const auto add = [&](Index i, float area) {
        const FieldDatum d = datum(measured, place, i, area);
        if (d.weight == 0 || field[i].isZero(0)) return;
        turned += std::conj(d.u) * u[i];
        turns[place].weight += area;
      };
      if (!measured.of_triangles) {
        add(static_cast<Index>(place), areas[place]);
      } else {
        for (const Index i : surface.mesh.triangles[place]) add(i, triangle_areas[place] / 3);
      }
      turns[place].degrees = in_degrees(turned);
    }
  });
  std::erase_if(turns, [](const DatumTurn& turn) { return turn.weight == 0; });
  return turns;
}

double FieldSmoothing::State::mean_coherence(bool of_data) const {
  double sum = 0, area = 0;
  for (std::size_t i = 0; i < count(); ++i) {
    if (directions[i].isZero(0) || (found_.data.weight[i] > 0) != of_data) continue;
    sum += static_cast<double>(areas[i] * coherence(found_.u[i]));
    area += static_cast<double>(areas[i]);
  }
  return area > 0 ? sum / area : 0;
}

FieldSmoothing::FieldSmoothing(const Surface& surface, const FieldSmoothingOptions& options,
                               const Progress& progress)
    : state_(std::make_unique<State>(surface, options, progress)) {}
FieldSmoothing::~FieldSmoothing() = default;
FieldSmoothing::FieldSmoothing(FieldSmoothing&&) noexcept = default;
FieldSmoothing& FieldSmoothing::operator=(FieldSmoothing&&) noexcept = default;

SmoothedField FieldSmoothing::frame(const MeasuredField& measured,
                                    std::span<const float> frequencies, const MeasuredField& last,
                                    const Progress& progress) {
  return state_->frame(measured, frequencies, last, progress);
}

FieldSmoothingMetrics FieldSmoothing::metrics() const {
  const State& state = *state_;
  require(state.measured_.has_value(), "there is no frame yet that metrics could be of");
  FieldSmoothingMetrics metrics;
  tell_turns(state.turns(*state.measured_, state.found_.u, state.directions), metrics);
  metrics.coherence_mean = state.mean_coherence(true);
  metrics.coherence_filled_mean = state.mean_coherence(false);
  metrics.held_out = state.held_out_.count;
  metrics.held_out_turned_mean_deg = state.held_out_.mean_deg;
  std::vector<Complex> before(state.count());
  for (Index i = 0; i < state.count(); ++i) {
    const bool has_datum = state.found_.data.weight[i] > 0,
               has_direction = !state.directions[i].isZero(0);
    if (has_datum) before[i] = state.found_.data.pull[i];
    metrics.filled += has_direction && !has_datum ? 1 : 0;
    metrics.unfilled += !has_direction && !state.surface.neighborhood->of(i).empty() ? 1 : 0;
    metrics.data += has_datum ? 1 : 0;
  }
  const int symmetry = state.options.symmetry;
  DirectionField given = directions_of(before, state.surface.normals, symmetry);
  for (Index i = 0; i < state.count(); ++i) {
    if (before[i] == Complex(0)) given[i] = Vec3::Zero();
  }
  metrics.singularities_of_data = count_singularities(state.surface.mesh, given, symmetry);
  metrics.singularities = count_singularities(state.surface.mesh, state.directions, symmetry);
  const std::size_t wanted = state.options.singularities.value_or(metrics.singularities);
  metrics.singularities_too_many = metrics.singularities - std::min(wanted, metrics.singularities);
  return metrics;
}

}  // namespace brindle
