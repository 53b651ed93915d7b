/// Times, quality and memory of all ways from waves to stripes, for `brindle bench`.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "brindle/base/stopwatch.h"
#include "brindle/solver.h"
#include "brindle/surface.h"
#include "device/device.h"

namespace brindle::tool {

/// Number of repetitions.
struct Repetitions {
  int count = 20;             ///< after an unmeasured run that warms caches
  double budget_seconds = 2;  ///< no further repetition after this; a first run that takes longer
                              ///< is the only one, and is measured
};

/// Milliseconds of repeated runs.
struct Spread {
  double min = 0;
  double median = 0;
  int repetitions = 0;
};

Spread spread_of(std::vector<double> milliseconds);

/// The results of repeated `run()`.
template <class Run>
auto samples_of(const Repetitions& wanted, const Run& run) {
  Stopwatch watch;
  std::vector samples{run()};
  const double budget = 1000 * wanted.budget_seconds;
  double spent = watch.lap();
  if (spent > budget) return samples;
  samples.clear();
  for (spent = 0; samples.empty() || (std::ssize(samples) < wanted.count && spent < budget);
       spent += watch.lap()) {
    samples.push_back(run());
  }
  return samples;
}

/// One part of each result.
template <class Sample, class Part>
Spread spread_of(const std::vector<Sample>& samples, const Part& part) {
  std::vector<double> values(samples.size());
  std::ranges::transform(samples, values.begin(), part);
  return spread_of(std::move(values));
}

/// A surface with one field, or with a second one at right angles to it.
struct Subject {
  std::string name;
  int subdivided = 0;  ///< subdivisions of `name` that gave `surface`
  Surface surface;
  std::vector<WaveSet> fields;
  double neighborhood_milliseconds = 0;  ///< neighbourhood and normals

  std::size_t vertex_count() const { return surface.mesh.vertex_count(); }
};

/// Adds the field at right angles to the first one.
void add_crossing_field(Subject& subject);

/// Makes the field a cross field: the surface becomes its double cover.
void make_cross_field(Subject& subject);

struct Quality {
  double energy = 0;                ///< mean over fields
  std::size_t branches = 0;         ///< sum over fields
  double angle_error_mean_deg = 0;  ///< mean over fields
};

struct SolverCase {
  std::string name;
  SolverOptions options;
};

/// From waves to phases, all fields of a subject.
struct SolverMetrics {
  std::string name;
  int threads = 0;
  int iterations = 0;  ///< of the last field
  Spread topology;     ///< once per connectivity, for all fields
  Spread couple;       ///< from waves to couplings, sum over fields
  Spread solve;        ///< from couplings to phases, sum over fields
  Quality quality;
};

SolverMetrics measure_solver(const Subject& subject, const SolverCase& solver, const Device& device,
                             const Repetitions& repetitions, const Progress& progress);

/// A frame of StripeAnimator, from changed waves to phases, all fields of a subject.
struct FrameMetrics {
  int threads = 0;
  Spread topology;  ///< once per connectivity, for all fields
  Spread couple;    ///< these three: sums over fields
  Spread sum;
  Spread solve;
  Spread total;
  Spread measure;   ///< corner phases, branches and errors of the last frame, sum over fields
  Quality quality;  ///< of the last frame
};

/// Each frame differs from the last one: directions are turned by a degree about the normals and
/// frequencies are 1 % higher, or back.
FrameMetrics measure_frames(const Subject& subject, const Repetitions& repetitions,
                            const Progress& progress);

/// Stages around the solver, each on a surface with one field.
struct SurroundingMetrics {
  int threads = 0;
  Spread texture;       ///< a frame of TextureAnimator without solving: orientation, seams, errors
  Spread whole_tiles;   ///< additional time to find broken tiles
  Spread cross_frame;   ///< a frame of CrossAnimator without solving: matching, corners, errors
  Spread cross;         ///< the same for one cross field: `cross_texture`, corner phases, errors
  Spread smooth_field;  ///< `smooth_direction_field`, once
};

SurroundingMetrics measure_surroundings(const Subject& subject, const Repetitions& repetitions,
                                        const Progress& progress);

/// A spacing tolerance of a quarter, for the first field of a subject.
struct SlackMetrics {
  int threads = 0;
  Spread from_scratch;  ///< including everything that depends on connectivity alone
  Spread
      in_frame;  ///< started from the last frame's frequencies, with the input of `measure_frames`
  int sweeps_from_scratch = 0;
  int sweeps_in_frame = 0;  ///< of the last frame
};

SlackMetrics measure_slack(const Subject& subject, const Repetitions& repetitions,
                           const Progress& progress);

/// Memory of following one field, in addition to the mesh and the field.
struct MemoryMetrics {
  std::size_t neighborhood = 0;   ///< neighbour lists
  std::size_t animator = 0;       ///< growth of resident memory after two frames
  std::size_t animator_peak = 0;  ///< peak growth in the first frame
  std::size_t sibling = 0;        ///< further growth by an animator for a second field
};

/// Empty if the system does not report it.
std::optional<MemoryMetrics> measure_memory(const Subject& subject);

}  // namespace brindle::tool
