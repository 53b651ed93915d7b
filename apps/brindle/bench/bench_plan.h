/// The measurements of `brindle bench`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/measurements.h"

namespace brindle::tool {

struct BenchArguments {
  std::vector<std::string> meshes;  ///< files or shapes; empty: built-in shapes
  int figure = 0;                   ///< figure 13, 14 or 16 of the paper; 0: the default run
  std::optional<int> subdivide;     ///< default run: subdivisions of the finer copy of a mesh
  int threads = 0;                  ///< most threads; 0: all that the machine has
  std::optional<int> repetitions;
  std::optional<double> budget_seconds;
  int global_limit = 120000;  ///< largest vertex count for the global solver
  bool quick = false;         ///< small shapes, few repetitions
};

struct BenchPlan {
  std::vector<std::string> meshes;
  int subdivide = 0;        ///< subdivisions of the finer copies; 0: none
  bool two_fields = false;  ///< a second field at right angles
  bool cross = false;       ///< the field is a cross field
  std::vector<SolverCase> solvers;
  std::vector<int> threads;  ///< ascending; each is measured
  bool memory = false;
  int picture_width = 0;  ///< pixels; 0: no pictures
  int picture_height = 0;
  bool surroundings = false;  ///< also textures and fields
  bool slack = false;         ///< also spacing tolerance
  Repetitions repetitions;
};

BenchPlan plan_of(const BenchArguments& arguments);

}  // namespace brindle::tool
