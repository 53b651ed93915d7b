/// Results of `brindle bench` as text and JSON.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "bench/draw_measurements.h"
#include "bench/gpu_measurements.h"
#include "bench/measurements.h"

namespace brindle::tool {

/// The machine of a measurement.
struct Machine {
  std::string processor;        ///< empty if the system does not report it
  int threads = 0;              ///< hardware threads
  std::string instruction_set;  ///< of the kernels
  double load = -1;  ///< runnable processes in the minute before the measurements; -1: unknown
};

Machine this_machine();

struct MeshMetrics {
  std::string mesh;
  int subdivided = 0;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  Index luby_colors = 0;    ///< of the paper's colouring, for relaxation
  Index greedy_colors = 0;  ///< of the colouring of multilevel and the animator
  std::size_t fields = 1;
  double neighborhood_milliseconds = 0;
  std::vector<SolverMetrics> solvers;
  std::vector<FrameMetrics> frames;           ///< on the processor
  std::optional<SlackMetrics> slack;          ///< on the processor, with the most threads
  std::optional<GpuFrameMetrics> gpu_frames;  ///< on the GPU
  std::vector<SurroundingMetrics> surroundings;
  std::optional<MemoryMetrics> memory;
  std::optional<DrawMetrics> draw;
};

/// A ratio of two measurements of one run.
struct Quotient {
  double numerator = 0;
  double denominator = 0;

  double value() const { return numerator / denominator; }
};

struct Ratio {
  std::string name;
  std::string unit;  ///< of numerator and denominator
  Quotient median;   ///< of medians
  Quotient min;      ///< of minima, which other processes disturb less
};

struct BenchReport {
  Machine machine;
  nlohmann::ordered_json device;  ///< from Device::description
  double copy_bandwidth = 0;      ///< of the GPU, bytes per second, read and written
  int figure = 0;                 ///< of the paper; 0: the default run
  std::vector<MeshMetrics> meshes;
  std::vector<std::string> notes;
};

/// Ratios of a default run: frames and topology to the other solvers, a finer mesh to its original,
/// many threads to one. Empty for metrics and for the GPU.
std::vector<Ratio> ratios_of(const BenchReport& report);

nlohmann::ordered_json to_json(const BenchReport& report);

void print_bench_report(std::ostream& out, const BenchReport& report);

}  // namespace brindle::tool
