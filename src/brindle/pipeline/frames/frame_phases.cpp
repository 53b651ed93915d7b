#include "brindle/pipeline/frames/frame_phases.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/pattern/triangle_kernels.h"
#include "brindle/phases/sliced_graph.h"
#include "brindle/pipeline/frames/animator_archive.h"
#include "brindle/solver.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

PhaseSteps steps_of_slice(const Complex* z, const Complex* last_z, const float* degree) {
  static_assert(kLanes == kTriangleLanes);
  PhaseSteps steps;
  alignas(64) float distances[kLanes];
  triangle_kernels::phase_distances(z, last_z, distances);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (degree[lane] <= 0 || last_z[lane] == Complex(0)) continue;
    steps.angle += static_cast<double>(distances[lane]);
    steps.count += 1;
  }
  return steps;
}

/// T_i = lambda deg_i z_i of the last frame, by slot.
void set_anchors(std::span<const float> degree, std::span<const Complex> last_z, float lambda,
                 std::vector<Complex>& anchor) {
  anchor.resize(degree.size());
  parallel_for(degree.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      anchor[slot] = lambda * degree[slot] * last_z[slot];
    }
  });
}

/// Arrays are by slot, in whole slices. A slot with degree 0 has no wave.
PhaseSteps phase_steps(std::span<const Complex> z, std::span<const Complex> last_z,
                       std::span<const float> degree) {
  return parallel_sum<PhaseSteps>(
      degree.size() / kLanes,
      [&](std::size_t begin, std::size_t end) {
        PhaseSteps steps;
        for (std::size_t first = begin * kLanes; first < end * kLanes; first += kLanes) {
          steps = steps +
                  steps_of_slice(z.data() + first, last_z.data() + first, degree.data() + first);
        }
        return steps;
      },
      kSliceGrain);
}

}  // namespace

FramePhases::FramePhases(const AnimatorOptions& options)
    : solver(options.solver),
      lambda(options.lambda),
      iterations(options.iterations),
      phase_shift(options.phase_shift) {
  momentum.strength = SolverOptions().momentum;
}

void FramePhases::start(const SlicedLayout& layout) {
  const Index slots = layout.slot_count();
  waves.reserve(slots);
  if (may_be_taken_back) cancellable_waves.reserve(slots);
  last_z.resize(slots);  // touches its pages now, not in the first `keep`
  last_z.clear();
  has_last = false;
  z_by_node.resize(layout.slot_of.size());
  if (solver == FrameSolver::relaxation) momentum.m.resize(slots);
  degree.resize(slots);
}

void FramePhases::give(std::span<const Complex> z) {
  given_z.assign(z.begin(), z.end());
  has_given = true;
}

bool FramePhases::load(const Level& finest, const FrameInput& input) {
  const SlicedLayout& layout = finest.layout();
  has_iterated = false;
  const bool changed =
      load_waves(layout, input.positions, input.directions, input.frequencies, next_waves(), waves,
                 has_given ? std::span<Complex>() : std::span(last_z), momentum.m);
  if (!has_given) return changed || !has_last;
  last_z.assign(layout.slot_count(), Complex(0));
  to_slots(layout, given_z, last_z);
  has_last = true;
  return true;
}

void FramePhases::couple_to(Level& finest, std::span<const SlicedWave> of) {
  couple(finest.layout(), of, phase_shift, weights, finest.couplings, degree);
}

void FramePhases::couple_next(Level& finest) {
  couple_to(finest, next_waves());
  const bool anchored = has_last && lambda > 0 && solver == FrameSolver::multilevel;
  if (anchored) {
    set_anchors(degree, last_z, lambda, finest.couplings.anchor);
  } else {
    finest.couplings.anchor.clear();
  }
}

void FramePhases::iterate(Level& finest, const std::function<void(Momentum&)>& relax) {
  if (may_be_taken_back) {
    last_momentum = momentum.m;
    has_iterated = true;
  }
  ranges::transform(last_z, finest.z.begin(),
                    [](const Complex& z) { return z == Complex(0) ? kPeak : z; });
  for (int iteration = 0; iteration < iterations; ++iteration) relax(momentum);
}

PhaseSteps FramePhases::steps(const Level& finest) const {
  return has_last ? phase_steps(finest.z, last_z, degree) : PhaseSteps();
}

void FramePhases::keep(const Level& finest) {
  const SlicedLayout& layout = finest.layout();
  last_z.assign(finest.z.begin(),
                finest.z.begin() + static_cast<std::ptrdiff_t>(layout.slot_count()));
  to_nodes(layout, last_z, z_by_node);
  has_given = false;
  if (may_be_taken_back) std::swap(waves, cancellable_waves);
  has_frame = has_last = true;
}

void FramePhases::take_back(Level& finest) {
  if (has_iterated) std::swap(momentum.m, last_momentum);
  if (!has_frame) return;
  turn_phases(waves, next_waves(), last_z);
  turn_phases(waves, next_waves(), momentum.m);
  couple_to(finest, waves);
  to_slots(finest.layout(), z_by_node, finest.z);
}

void FramePhases::restart() {
  last_z.clear();
  has_last = has_given = false;
  ranges::fill(momentum.m, Complex(0));
}

namespace {

bool is_finite(const Complex& z) { return std::isfinite(z.real()) && std::isfinite(z.imag()); }

/// Numbers by slot, archived by node; slots without a node get 0.
void archive_by_node(Archive& archive, const SlicedLayout& layout, std::vector<Complex>& by_slot) {
  std::vector<Complex> by_node;
  if (!archive.reads()) to_nodes(layout, by_slot, by_node);
  archive.list_of(layout.slot_of.size(), by_node);
  if (!archive.reads()) return;
  if (!ranges::all_of(by_node, is_finite)) Archive::fail();
  by_slot.assign(layout.slot_count(), Complex(0));
  to_slots(layout, by_node, by_slot);
}

}  // namespace

void archive_waves(Archive& archive, const SlicedLayout& layout, std::vector<SlicedWave>& waves) {
  const std::size_t nodes = layout.slot_of.size();
  // With the square roots of frequencies, which slots hold.
  WaveSet by_node;
  if (!archive.reads()) {
    by_node.positions.resize(nodes);
    by_node.directions.resize(nodes);
    by_node.frequencies.resize(nodes);
  }
  for (std::size_t node = 0; node < nodes && !archive.reads(); ++node) {
    const SlicedWave& wave = waves[layout.slot_of[node]];
    std::copy_n(wave.position, 3, by_node.positions[node].data());
    std::copy_n(wave.direction, 3, by_node.directions[node].data());
    by_node.frequencies[node] = wave.root_frequency;
  }
  archive_waves(archive, nodes, by_node);
  if (!archive.reads()) return;
  waves.assign(layout.slot_count(), SlicedWave());
  for (std::size_t node = 0; node < nodes; ++node) {
    SlicedWave& wave = waves[layout.slot_of[node]];
    std::copy_n(by_node.positions[node].data(), 3, wave.position);
    std::copy_n(by_node.directions[node].data(), 3, wave.direction);
    wave.root_frequency = by_node.frequencies[node];
  }
}

void FramePhases::archive(Archive& archive, std::size_t nodes, Level* finest) {
  bool follows = has_frame && has_last;
  archive(has_frame, follows, has_given);
  if (has_given) {
    archive.list_of(nodes, given_z);
    check_last_phases(given_z, nodes);
  }
  if (!has_frame) return;
  if (finest == nullptr) Archive::fail();
  const SlicedLayout& layout = finest->layout();
  archive_waves(archive, layout, waves);
  archive.list_of(nodes, z_by_node);
  check_last_phases(z_by_node, nodes);
  if (solver == FrameSolver::relaxation) archive_by_node(archive, layout, momentum.m);
  if (!archive.reads()) return;
  couple_to(*finest, waves);
  to_slots(layout, z_by_node, finest->z);
  has_last = follows;
  if (!follows) return;
  last_z.assign(layout.slot_count(), Complex(0));
  to_slots(layout, z_by_node, last_z);
}

}  // namespace brindle
