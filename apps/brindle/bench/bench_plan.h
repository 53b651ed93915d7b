/// What `brindle bench` measures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/measurements.h"

namespace brindle::tool {

struct BenchArguments {
  std::vector<std::string> meshes;  ///< files or shapes; empty: built-in shapes
  int figure = 0;                   ///< 13, 14 or 16 of the paper; 0: the default run
  std::optional<int> subdivide;     ///< default run: how often the finer copy of a mesh is split
  int threads = 0;                  ///< most threads; 0: all that the machine has
  std::optional<int> repetitions;
  std::optional<double> budget_seconds;
  int global_limit = 120000;  ///< vertices above which the global solver is left out
  bool quick = false;         ///< small shapes, few repetitions
};

struct BenchPlan {
  std::vector<std::string> meshes;
  int subdivide = 0;        ///< 0: no finer copies
  bool two_fields = false;  ///< a second field at right angles
  bool cross = false;       ///< the field is a cross field
  std::vector<SolverCase> solvers;
  std::vector<int> threads;  ///< ascending; each is measured
  bool memory = false;
  int picture_width = 0;  ///< pixels; 0: no pictures
  int picture_height = 0;
  bool surroundings = false;  ///< textures and fields, too
  bool slack = false;         ///< frequencies that yield
  Repetitions repetitions;
};

BenchPlan plan_of(const BenchArguments& arguments);

}  // namespace brindle::tool
