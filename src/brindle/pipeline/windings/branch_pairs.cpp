#include "brindle/branch_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include "brindle/base/elementary.h"
#include "brindle/base/graph.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/base/stopwatch.h"
#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "brindle/pipeline/cross_parts.h"
#include "brindle/pipeline/measured_pattern.h"
#include "brindle/pipeline/windings/twisted_forms.h"

namespace brindle {
namespace {

/// Radius solved around a pair's path, as a share of the largest pair distance; and the smaller
/// radius, in periods, tried if other branches block that one.
constexpr double kAround = 0.4;
constexpr double kNear = 4;
constexpr double kMostDistance = 1000;  // periods
constexpr int kPolishSweeps = 4;
constexpr int kMostMergeRounds = 12;
/// Steps between two progress reports. With many edges per period, a pair's neighbourhood takes
/// about a second.
constexpr std::size_t kStepsPerReport = 1 << 13;
constexpr Index kNoNumber = std::numeric_limits<Index>::max();

/// Makes conjugate gradients cancellable: every iteration calls its preconditioner once.
struct TickingPreconditioner : Eigen::DiagonalPreconditioner<double> {
  Progress progress;

  template <class Right>
  Eigen::Solve<Eigen::DiagonalPreconditioner<double>, Right> solve(
      const Eigen::MatrixBase<Right>& b) const {
    progress.tick();
    return Eigen::DiagonalPreconditioner<double>::solve(b);
  }
};

/// An edge crossed by a phase jump of `turns` full turns.
struct Crossed {
  Index edge;
  int turns;
};

/// Candidate phases of the vertices around a pair.
struct Trial {
  double raise = 0;              ///< of the total energy
  std::vector<Index> triangles;  ///< around the vertices; new branch indices in `indices`
  std::vector<int> indices;
  std::vector<Index> vertices;
  std::vector<Complex> z;
};

struct BranchPair {
  double length = 0;
  std::array<Index, 2> triangles{};
  std::vector<Crossed> way;
  Trial trial = {};
};

class PairCanceller {
 public:
  PairCanceller(const Surface& surface, const StripePattern& pattern, double distance,
                const StripeOptions& options, Progress progress)
      : progress_(std::move(progress)),
        distance_(distance),
        mesh_(surface.mesh),
        adjacency_(*surface.neighborhood),
        waves_(pattern.waves),
        kind_(pattern.phase_shift),
        fixed_(options.fixed_phases),
        z_(pattern.solution.z),
        edges_(mesh_edges(mesh_, adjacency_, progress_)),
        forms_(mesh_, edges_, waves_.directions),
        index_(mesh_.triangle_count()),
        number_(mesh_.vertex_count(), kNoNumber),
        ways_(mesh_.vertex_count()),
        best_(mesh_.triangle_count(), std::numeric_limits<double>::infinity()),
        turns_(edges_.count()) {
    weigh_edges(options.weights);
    shift_edges();
    changed_.assign(mesh_.vertex_count(), true);
    each(mesh_.triangle_count(),
         [&](std::size_t t) { index_[t] = index_of(static_cast<Index>(t)); });
    each(edges_.count(), [&](std::size_t e) { energy_ += term(static_cast<Index>(e)); });
  }

  /// Cancels pairs while the energy allows it. Returns the number of pairs.
  std::size_t cancel(double share, Progress progress) {
    progress_ = std::move(progress);
    const double most = (1 + share) * energy_;
    std::size_t cancelled = 0;
    for (int round = 0; round < kMostMergeRounds; ++round) {
      const double left = std::pow(0.5, round);
      progress_.report(1 - left);
      std::vector<BranchPair> pairs = find_pairs();
      const auto all = static_cast<double>(pairs.size());
      double tried = 0;
      std::erase_if(pairs, [&](BranchPair& pair) {
        progress_.report(1 - left * (1 - 0.5 * tried++ / all));
        std::optional<Trial> trial = try_pair(pair);
        if (trial) pair.trial = std::move(*trial);
        return !trial;
      });
      ranges::sort(pairs.begin(), pairs.end(), [](const BranchPair& a, const BranchPair& b) {
        return std::pair(a.trial.raise, a.triangles) < std::pair(b.trial.raise, b.triangles);
      });
      std::fill(changed_.begin(), changed_.end(), false);
      const std::size_t before = cancelled;
      for (BranchPair& pair : pairs) cancelled += apply(pair, most);
      if (cancelled == before) break;
    }
    return cancelled;
  }

  const std::vector<Complex>& phases() const { return z_; }

 private:
  Progress tick_alone() const { return progress_.part(1, 1); }

  /// Calls `body(i)` sequentially for every i below `count`, with progress.
  template <class Body>
  void each(std::size_t count, const Body& body) const {
    for (std::size_t i = 0; i < count; ++i) {
      if (i % kReportSlice == 0) progress_.tick();
      body(i);
    }
  }

  void weigh_edges(EdgeWeights weights) {
    weight_.resize(edges_.count());
    std::vector<float> cotangents;
    if (weights == EdgeWeights::cotangent)
      cotangents = cotangent_weights(mesh_, adjacency_, tick_alone());
    each(edges_.count(), [&](std::size_t e) {
      const auto [a, b] = edges_.vertices[e];
      weight_[e] = std::abs(static_cast<double>(waves_.directions[a].dot(waves_.directions[b])));
      if (!cotangents.empty()) weight_[e] *= value_at(adjacency_, cotangents, b, a);
    });
  }

  /// Phase shifts in the lower vertex's orientation, and the edge of each directed edge.
  void shift_edges() {
    shift_.resize(edges_.count());
    each(edges_.count(), [&](std::size_t number) {
      const auto e = static_cast<Index>(number);
      const auto [a, b] = edges_.vertices[e];
      Wave there = waves_.wave(b);
      if (forms_.sign(e) < 0) there.direction = -there.direction;
      shift_[e] = static_cast<double>(phase_shift(kind_, waves_.wave(a), there).radians);
    });
    edge_at_.resize(adjacency_.directed_edge_count());
    each(adjacency_.node_count(), [&](std::size_t node) {
      const auto v = static_cast<Index>(node);
      for (Index k = adjacency_.offsets[v]; k < adjacency_.offsets[v + 1]; ++k) {
        edge_at_[k] = edges_.between(v, adjacency_.neighbors[k]);
      }
    });
  }

  /// The phase at the edge's higher vertex, in the orientation of the lower one.
  Complex seen_from_lower(Index e, Complex z) const {
    return forms_.sign(e) < 0 ? -std::conj(z) : z;
  }

  /// Phase difference along an edge minus the shift of its waves, in (-pi, pi). From the lower
  /// vertex in its orientation.
  double remainder(Index e) const {
    const auto [a, b] = edges_.vertices[e];
    const Complex difference = seen_from_lower(e, z_[b]) * std::conj(z_[a]);
    return std::remainder(static_cast<double>(elementary::arg(difference)) - shift_[e],
                          2 * std::numbers::pi);
  }

  double term(Index e) const {
    return forms_.sign(e) == 0 ? 0 : weight_[e] * (1 - elementary::cos(remainder(e)));
  }

  int index_of(Index t) const {
    return corner_phases(corner_waves(mesh_.triangles[t], waves_, z_), kind_).branch_index;
  }

  Vec3 barycentre(Index t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    return (mesh_.positions[a] + mesh_.positions[b] + mesh_.positions[c]) / 3;
  }

  double period_at(Index t) const {
    return 1 / static_cast<double>(waves_.frequencies[mesh_.triangles[t][0]]);
  }

  /// The path from every branch to the nearest opposite one.
  std::vector<BranchPair> find_pairs() {
    std::vector<BranchPair> pairs;
    for (Index t = 0; t < index_.size(); ++t) {
      if (std::abs(index_[t]) != 1) continue;
      if (auto pair = nearest_partner(t)) pairs.push_back(std::move(*pair));
    }
    const auto ends = [](const BranchPair& p) {
      return std::minmax(p.triangles[0], p.triangles[1]);
    };
    ranges::sort(pairs.begin(), pairs.end(), [&](const BranchPair& a, const BranchPair& b) {
      return std::pair(ends(a), a.length) < std::pair(ends(b), b.length);
    });
    const auto last =
        std::unique(pairs.begin(), pairs.end(),
                    [&](const BranchPair& a, const BranchPair& b) { return ends(a) == ends(b); });
    pairs.erase(last, pairs.end());
    return pairs;
  }

  struct Step {
    double length;
    Index triangle;
    Index edge;  ///< through which the triangle was entered
    int turns;
    int before;  ///< index of the previous step
    bool operator>(const Step& other) const {
      return std::pair(length, triangle) > std::pair(other.length, other.triangle);
    }
  };

  std::optional<BranchPair> nearest_partner(Index start) {
    steps_.clear();
    std::vector<Index> touched;
    std::priority_queue<Step, std::vector<Step>, std::greater<>> queue;
    const double reach = distance_ * period_at(start);
    const auto push = [&](Index from, int out, int turns, double length, int before) {
      const Index e = edges_.of_triangle[from][out];
      const Index to = edges_.beyond(from, out);
      if (to == kNoTriangle) return;
      const double reached =
          length + static_cast<double>((barycentre(to) - barycentre(from)).norm());
      if (reached > reach || reached >= best_[to]) return;
      if (std::isinf(best_[to])) touched.push_back(to);
      best_[to] = reached;
      queue.push({reached, to, e, turns, before});
    };
    best_[start] = 0;
    touched.push_back(start);
    const auto own = forms_.senses(start);
    for (int m = 0; own && m < 3; ++m) {
      push(start, m, forms_.number(start, *own, m, -index_[start]), 0, -1);
    }
    std::optional<BranchPair> found;
    for (std::size_t steps = 0; !queue.empty() && !found; ++steps) {
      if (steps % kStepsPerReport == 0) progress_.tick();
      const Step step = queue.top();
      queue.pop();
      if (step.length > best_[step.triangle]) continue;
      found = visit(start, step, push);
    }
    for (const Index t : touched) best_[t] = std::numeric_limits<double>::infinity();
    return found;
  }

  template <class Push>
  std::optional<BranchPair> visit(Index start, const Step& step, const Push& push) {
    const auto own = forms_.senses(step.triangle);
    if (!own) return std::nullopt;
    const auto& sides = edges_.of_triangle[step.triangle];
    const int in =
        static_cast<int>(std::find(sides.begin(), sides.end(), step.edge) - sides.begin());
    steps_.push_back(step);
    const auto number = static_cast<int>(steps_.size() - 1);
    const int gained = forms_.round(step.triangle, *own, in, step.turns);
    if (index_[step.triangle] != 0) {
      if (index_[step.triangle] != -gained) return std::nullopt;
      BranchPair pair{step.length, {start, step.triangle}, {}};
      for (int i = number; i >= 0; i = steps_[i].before) {
        pair.way.push_back({steps_[i].edge, steps_[i].turns});
      }
      return pair;
    }
    for (int out = 0; out < 3; ++out) {
      if (out == in) continue;
      push(step.triangle, out, forms_.number(step.triangle, *own, out, -gained), step.length,
           number);
    }
    return std::nullopt;
  }

  bool is_free(Index v) const {
    return !waves_.directions[v].isZero(0) && (fixed_.empty() || fixed_[v] == Complex(0));
  }

  /// Free vertices within `periods` of the path, nearest first.
  std::vector<Index> vertices_around(const BranchPair& pair, double periods) const {
    const double reach = periods * period_at(pair.triangles[0]);
    std::vector<Index> found;
    for (const Crossed& crossed : pair.way) {
      for (const Index v : edges_.vertices[crossed.edge]) ways_.offer(v, 0);
    }
    for (std::size_t steps = 0; const auto next_vertex = ways_.next(); ++steps) {
      if (steps % kStepsPerReport == 0) progress_.tick();
      const auto [distance, v] = *next_vertex;
      if (is_free(v)) found.push_back(v);
      for (const Index n : adjacency_.of(v)) {
        const double next =
            distance + static_cast<double>((mesh_.positions[n] - mesh_.positions[v]).norm());
        if (next <= reach) ways_.offer(n, next);
      }
    }
    ways_.clear();
    return found;
  }

  /// Edges with at least one end among the numbered vertices.
  std::vector<Index> edges_around(const std::vector<Index>& vertices) const {
    std::vector<Index> found;
    for (const Index v : vertices) {
      for (Index k = adjacency_.offsets[v]; k < adjacency_.offsets[v + 1]; ++k) {
        const Index n = adjacency_.neighbors[k];
        if (number_[n] == kNoNumber || v < n) found.push_back(edge_at_[k]);
      }
    }
    return found;
  }

  std::optional<Trial> try_pair(const BranchPair& pair) {
    const double around = kAround * distance_;
    std::optional<Trial> trial = try_within(pair, around);
    return trial || around <= kNear ? std::move(trial) : try_within(pair, kNear);
  }

  /// Optimal phases around the path with its full turns imposed, if both branches disappear and no
  /// other appears.
  std::optional<Trial> try_within(const BranchPair& pair, double periods) {
    Trial trial;
    trial.vertices = vertices_around(pair, periods);
    if (!is_changed(trial.vertices)) return std::nullopt;  // unchanged since the last attempt
    for (std::size_t i = 0; i < trial.vertices.size(); ++i) {
      number_[trial.vertices[i]] = static_cast<Index>(i);
    }
    const std::vector<Index> edges = edges_around(trial.vertices);
    double before = 0;
    each(edges.size(), [&](std::size_t e) { before += term(edges[e]); });
    const std::vector<Complex> old = phases_of(trial.vertices);
    turn_phases(trial.vertices, edges, pair.way);
    for (int sweep = 0; sweep < kPolishSweeps; ++sweep) polish(trial.vertices);
    double after = 0;
    each(edges.size(), [&](std::size_t e) { after += term(edges[e]); });
    trial.raise = after - before;
    trial.z = phases_of(trial.vertices);
    trial.triangles = triangles_around(edges);
    const bool good = is_cancelled(pair, trial);
    for (std::size_t i = 0; i < old.size(); ++i) {
      z_[trial.vertices[i]] = old[i];
      number_[trial.vertices[i]] = kNoNumber;
    }
    if (!good) return std::nullopt;
    return trial;
  }

  std::vector<Complex> phases_of(const std::vector<Index>& vertices) const {
    std::vector<Complex> z;
    for (const Index v : vertices) z.push_back(z_[v]);
    return z;
  }

  /// Least squares of all remainders with full turns imposed on the path; phases outside are fixed.
  void turn_phases(const std::vector<Index>& vertices, const std::vector<Index>& edges,
                   const std::vector<Crossed>& way) {
    const auto count = static_cast<Eigen::Index>(vertices.size());
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    for (Index i = 0; i < vertices.size(); ++i) entries.emplace_back(i, i, 1e-9);
    for (const Crossed& crossed : way) turns_[crossed.edge] += crossed.turns;
    each(edges.size(), [&](std::size_t number) {
      const Index e = edges[number];
      const int sign = forms_.sign(e);
      if (sign == 0) return;
      const double wanted = remainder(e) + 2 * std::numbers::pi * turns_[e];
      const Index a = number_[edges_.vertices[e][0]], b = number_[edges_.vertices[e][1]];
      const double w = weight_[e];
      if (a != kNoNumber) {
        entries.emplace_back(a, a, w);
        right[a] += w * wanted;
      }
      if (b != kNoNumber) {
        entries.emplace_back(b, b, w);
        right[b] -= sign * w * wanted;
      }
      if (a == kNoNumber || b == kNoNumber) return;
      entries.emplace_back(a, b, -sign * w);
      entries.emplace_back(b, a, -sign * w);
    });
    for (const Crossed& crossed : way) turns_[crossed.edge] = 0;
    progress_.tick();
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper,
                             TickingPreconditioner>
        solver(matrix);
    solver.preconditioner().progress = progress_;
    solver.setTolerance(1e-3);
    const Eigen::VectorXd turn = solver.solve(right);
    for (Eigen::Index i = 0; i < count; ++i) {
      Complex& z = z_[vertices[static_cast<std::size_t>(i)]];
      z = Complex(std::complex<double>(z) * elementary::polar(1.0, turn[i]));
      z /= std::abs(z);
    }
  }

  /// Gauss-Seidel: moves each vertex to its optimum given its neighbours.
  void polish(const std::vector<Index>& vertices) {
    each(vertices.size(), [&](std::size_t number) {
      const Index v = vertices[number];
      std::complex<double> sum = 0;
      for (Index k = adjacency_.offsets[v]; k < adjacency_.offsets[v + 1]; ++k) {
        const Index e = edge_at_[k];
        if (forms_.sign(e) == 0) continue;
        const auto [a, b] = edges_.vertices[e];
        const std::complex<double> turn =
            elementary::polar(weight_[e], v == a ? -shift_[e] : shift_[e]);
        const Complex other = z_[v == a ? b : a];
        // The neighbour's phase as predicted at v, in the orientation of v.
        sum += v == a ? std::complex<double>(seen_from_lower(e, other)) * turn
                      : std::complex<double>(
                            seen_from_lower(e, Complex(std::complex<double>(other) * turn)));
      }
      if (std::abs(sum) > 0) z_[v] = Complex(sum / std::abs(sum));
    });
  }

  std::vector<Index> triangles_around(const std::vector<Index>& edges) const {
    std::vector<Index> found;
    for (const Index e : edges) {
      for (const Index t : edges_.triangles(e)) {
        if (t != kNoTriangle) found.push_back(t);
      }
    }
    ranges::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// Whether two branches have gone; others may have moved to a neighbouring triangle.
  bool is_cancelled(const BranchPair& pair, Trial& trial) const {
    int fewer = 0;
    each(trial.triangles.size(), [&](std::size_t number) {
      const Index t = trial.triangles[number];
      trial.indices.push_back(index_of(t));
      fewer += std::abs(index_[t]) - std::abs(trial.indices.back());
    });
    const auto gone = [&](Index t) { return index_of(t) == 0; };
    return fewer >= 2 && gone(pair.triangles[0]) && gone(pair.triangles[1]);
  }

  bool is_changed(const std::vector<Index>& vertices) const {
    return std::any_of(vertices.begin(), vertices.end(), [&](Index v) { return changed_[v]; });
  }

  /// Applies a trial; recomputes it first if phases nearby have changed.
  bool apply(BranchPair& pair, double most) {
    if (is_changed(pair.trial.vertices)) {
      if (index_[pair.triangles[0]] == 0 || index_[pair.triangles[1]] == 0) return false;
      std::optional<Trial> again = try_pair(pair);
      if (!again) return false;
      pair.trial = std::move(*again);
    }
    const Trial& trial = pair.trial;
    if (trial.raise > 0 && energy_ + trial.raise > most) return false;
    for (std::size_t i = 0; i < trial.z.size(); ++i) {
      const Index v = trial.vertices[i];
      z_[v] = trial.z[i];
      changed_[v] = true;
      for (const Index n : adjacency_.of(v)) changed_[n] = true;
    }
    energy_ += trial.raise;
    for (std::size_t i = 0; i < trial.triangles.size(); ++i) {
      index_[trial.triangles[i]] = trial.indices[i];
    }
    return true;
  }

  Progress progress_;
  double distance_;  ///< in periods
  const Mesh& mesh_;
  const Adjacency& adjacency_;
  const WaveSet& waves_;
  PhaseShiftKind kind_;
  std::span<const Complex> fixed_;
  std::vector<Complex> z_;
  MeshEdges edges_;
  TwistedForms forms_;
  std::vector<int> index_;
  mutable std::vector<Index> number_;  ///< index among the vertices solved for
  mutable ShortestWays<double> ways_;
  std::vector<double> best_;
  std::vector<Step> steps_;
  std::vector<double> weight_, shift_;
  std::vector<Index> edge_at_;
  std::vector<int> turns_;     ///< by edge: full turns on the path under trial
  std::vector<bool> changed_;  ///< since all pairs were last tried
  double energy_ = 0;
};

double energy_of(const Surface& surface, const StripePattern& pattern, EdgeWeights weights,
                 const Progress& progress) {
  std::vector<float> cotangents;
  if (weights == EdgeWeights::cotangent) {
    cotangents = cotangent_weights(surface.mesh, *surface.neighborhood, progress.part(0, 0.5));
  }
  const PhaseGraph graph = build_phase_graph(
      surface.neighborhood, pattern.waves, pattern.phase_shift, cotangents, progress.part(0.5, 1));
  progress.report(1);
  return energy(graph, pattern.solution.z);
}

}  // namespace

CancelledBranches cancel_branches(const Surface& surface, StripePattern& pattern,
                                  const CancellationOptions& cancellation,
                                  const StripeOptions& options, const Progress& progress) {
  if (!(cancellation.share >= 0) || !std::isfinite(cancellation.share)) {
    throw Error("cancelling branches: the share must be a finite number of 0 or above");
  }
  if (!(cancellation.distance > 0) || !(cancellation.distance <= kMostDistance)) {
    throw Error("cancelling branches: the distance must be above 0 and 1000 periods at most");
  }
  if (surface.mesh.triangles.empty()) throw Error("cancelling branches needs triangles");
  if (pattern.solution.z.size() != surface.mesh.vertex_count() ||
      pattern.corners.size() != surface.mesh.triangle_count()) {
    throw Error("cancelling branches: the pattern was made for another surface");
  }
  Stopwatch watch;
  StripeMilliseconds times = pattern.milliseconds;
  CancelledBranches cancelled;
  cancelled.branches_before = pattern.quality.branches;
  cancelled.energy_before = pattern.solution.energy;
  JobStages stages(progress, {{"branches", 1}, {"cancelling branches", 5}, {"pattern", 1}});
  PairCanceller canceller(surface, pattern, cancellation.distance, options,
                          stages.begin("branches"));
  cancelled.pairs = canceller.cancel(cancellation.share, stages.begin("cancelling branches"));
  const Progress measuring = stages.begin("pattern");
  if (cancelled.pairs > 0) {
    StripePattern result = pattern;
    result.solution.z = canceller.phases();
    result.solution.energy = energy_of(surface, result, options.weights, measuring.part(0, 0.4));
    measure_pattern(surface, options.slack.branch_penalty, result, measuring.part(0.4, 1));
    stages.finish();
    pattern = std::move(result);
  } else {
    stages.finish();
  }
  times.cancel += watch.lap();
  pattern.milliseconds = times;
  cancelled.branches_after = pattern.quality.branches;
  cancelled.energy_after = pattern.solution.energy;
  return cancelled;
}

CancelledBranches cancel_branches(const Surface& surface, TexturePattern& pattern,
                                  const CancellationOptions& cancellation,
                                  const TextureOptions& options, const Progress& progress) {
  JobStages stages(progress, {{"stripes of U", 4}, {"stripes of V", 4}, {"texture", 2}});
  TexturePattern result = pattern;
  CancelledBranches cancelled = cancel_branches(surface, result.u, cancellation, options.stripes,
                                                stages.begin("stripes of U"));
  const CancelledBranches of_v = cancel_branches(surface, result.v, cancellation, options.stripes,
                                                 stages.begin("stripes of V"));
  cancelled.pairs += of_v.pairs;
  cancelled.branches_before += of_v.branches_before;
  cancelled.branches_after += of_v.branches_after;
  cancelled.energy_before += of_v.energy_before;
  cancelled.energy_after += of_v.energy_after;
  const Progress texture = stages.begin("texture");
  if (cancelled.pairs > 0) orient_texture(surface.mesh, options.oriented, texture, result);
  stages.finish();
  pattern = std::move(result);
  return cancelled;
}

CancelledBranches cancel_branches(const Surface& surface, CrossPattern& pattern,
                                  const CancellationOptions& cancellation,
                                  const StripeOptions& options, const Progress& progress) {
  StripeOptions on_cover = options;
  on_cover.slack = slack_on_cover(options.slack);
  const CancelledBranches cancelled =
      cancel_branches(pattern.surface, pattern.pattern, cancellation, on_cover, progress);
  pattern.quality = cross_quality(surface.mesh.triangles, pattern, options.slack.branch_penalty);
  return cancelled;
}

}  // namespace brindle
