/// The topology of a hierarchy in plain words, as the shaders read it (shaders/levels.glsl).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "brindle/phases/multilevel.h"

namespace brindle {

/// Where a level's parts begin: in slots and columns, which are numbered through all levels, or in
/// words of `FlatHierarchy::topology`. Each begin is that of a list; see shaders/levels.glsl.
struct FlatLevel {
  std::uint32_t first_slot = 0;
  std::uint32_t slot_count = 0;
  std::uint32_t first_column = 0;
  std::uint32_t columns = 0;
  std::uint32_t coarse_slots = 0;
  std::uint32_t member_begin = 0;
  std::uint32_t source_begin = 0;
  std::uint32_t color_begin = 0;
  std::uint32_t color_count = 0;
  std::uint32_t sweeps = 0;
  float over_relaxation = 1;               ///< of all sweeps but the last
  std::uint32_t gauge_entry_count = 0;     ///< in the lists that gauges hang on
  std::uint32_t source_count = 0;          ///< places in all rounds
  std::array<std::uint32_t, 3> filling{};  ///< to whole vectors, as shaders count

  LevelSweeps planned_sweeps() const { return {static_cast<int>(sweeps), over_relaxation}; }
};

struct FlatHierarchy {
  static constexpr std::size_t kMostLevels = 32;

  std::vector<FlatLevel> levels;         ///< finest first
  std::vector<std::uint32_t> topology;   ///< all lists
  std::vector<std::uint32_t> neighbors;  ///< entry -> slot of the neighbour, of all levels
  std::uint32_t node_at = 0;             ///< list: slot of the finest level -> node
  std::uint32_t slot_count = 0;          ///< of all levels; a slot more stands for no aggregate
  std::uint32_t finest_entries = 0;
  std::size_t node_count = 0;
};

/// Lists everything that the kernels read of the levels, finest first, as `build_hierarchy` makes
/// them. Descents make the sweeps of the plan. Throws Error if there is more
/// than 32-bit words can number.
FlatHierarchy flatten(std::span<const LevelTopology> levels, SweepPlan plan);

}  // namespace brindle
