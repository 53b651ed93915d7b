/// What `brindle bench` found, for people and for programs.
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

/// Where the figures come from.
struct Machine {
  std::string processor;        ///< empty where the system does not tell
  int threads = 0;              ///< that run at the same time
  std::string instruction_set;  ///< that the kernels chose
  double load = -1;  ///< processes that ran or waited in the last minute, before the measurements;
                     ///< -1: unknown
};

Machine this_machine();

struct MeshFigures {
  std::string mesh;
  int subdivided = 0;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  Index luby_colors = 0;    ///< of the paper's colouring, which relaxation uses
  Index greedy_colors = 0;  ///< of the colouring that multilevel and the animator use
  std::size_t fields = 1;
  double neighborhood_milliseconds = 0;
  std::vector<SolverFigures> solvers;
  std::vector<FrameFigures> frames;           ///< on the processor
  std::optional<SlackFigures> slack;          ///< with the most threads, on the processor
  std::optional<GpuFrameFigures> gpu_frames;  ///< on the GPU
  std::vector<SurroundingFigures> surroundings;
  std::optional<MemoryFigures> memory;
  std::optional<DrawFigures> draw;
};

/// Two figures of one run against each other.
struct Quotient {
  double numerator = 0;
  double denominator = 0;

  double value() const { return numerator / denominator; }
};

struct Ratio {
  std::string name;
  std::string unit;  ///< of numerators and denominators
  Quotient median;   ///< of medians
  Quotient min;      ///< of minima, which others on the machine disturb less
};

struct BenchReport {
  Machine machine;
  nlohmann::ordered_json device;  ///< as Device::description gives it
  double copy_bandwidth = 0;      ///< of the GPU, bytes a second read and written
  int figure = 0;                 ///< of the paper; 0: the default run
  std::vector<MeshFigures> meshes;
  std::vector<std::string> notes;
};

/// What a default run says of the goals: frames and topology against the other
/// solvers, a finer mesh against its original, many threads against one. Empty for a figure and for
/// the GPU.
std::vector<Ratio> ratios_of(const BenchReport& report);

nlohmann::ordered_json to_json(const BenchReport& report);

void print_bench_report(std::ostream& out, const BenchReport& report);

}  // namespace brindle::tool
