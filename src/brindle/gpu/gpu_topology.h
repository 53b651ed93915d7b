/// The part of a hierarchy that stays as long as the graph's connectivity: in plain words, as the
/// shaders read it (shaders/levels.glsl), and on the device.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "brindle/gl/gl_name.h"
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
  std::uint32_t gauge_entry_count = 0;     ///< in the lists that gauges depend on
  std::uint32_t source_count = 0;          ///< places in all rounds
  std::array<std::uint32_t, 3> filling{};  ///< up to the alignment of the shaders

  LevelSweeps planned_sweeps() const { return {static_cast<int>(sweeps), over_relaxation}; }
};

struct FlatHierarchy {
  static constexpr std::size_t kMostLevels = 32;

  std::vector<FlatLevel> levels;         ///< finest first
  std::vector<std::uint32_t> topology;   ///< all lists
  std::vector<std::uint32_t> neighbors;  ///< entry -> slot of the neighbour, of all levels
  std::uint32_t node_at = 0;             ///< list: slot of the finest level -> node
  std::uint32_t slot_count = 0;          ///< of all levels; one slot more means no aggregate
  std::uint32_t finest_entries = 0;
  std::size_t node_count = 0;
};

/// Lists everything that the kernels read of the levels, finest first, as `build_hierarchy` makes
/// them. Descents make the sweeps of the plan. Throws Error if there is more
/// than 32-bit words can number.
FlatHierarchy flatten(std::span<const LevelTopology> levels, SweepPlan plan);

/// A FlatHierarchy on the device.
class GpuTopology {
 public:
  /// Copies `flat` to the context that is current. Throws Error if it is larger than the driver's
  /// buffers or OpenGL is out of memory.
  explicit GpuTopology(const FlatHierarchy& flat);

  /// Binds what levels.glsl reads.
  void bind() const;

  /// The nodes of one colour of a level.
  struct Color {
    std::uint32_t slices;      ///< list of its slices in words of the topology
    std::uint32_t slot_count;  ///< in these
  };

  std::size_t level_count() const { return levels_.size(); }
  const FlatLevel& level(std::size_t l) const { return levels_[l]; }
  const std::vector<Color>& colors(std::size_t l) const { return colors_[l]; }

  /// The first of the levels that one group descends together; `level_count()` if the coarsest is
  /// too large for that.
  std::size_t first_small_level() const { return first_small_; }

  /// The first of those whose gauges and sums one group makes.
  std::size_t first_small_sums() const { return first_small_sums_; }

  std::size_t node_count() const { return node_count_; }
  std::size_t slot_count() const { return slot_count_; }    ///< of all levels
  std::size_t entry_count() const { return entry_count_; }  ///< of all levels
  std::size_t finest_entries() const { return finest_entries_; }

 private:
  /// The first level from which on all have fewer slots.
  std::size_t first_below(Index slots) const;

  std::vector<FlatLevel> levels_;
  std::vector<std::vector<Color>> colors_;
  std::size_t first_small_, first_small_sums_;
  std::size_t node_count_, slot_count_, entry_count_, finest_entries_;
  GlBuffer level_table_, topology_, neighbors_;
};

/// The topology of a hierarchy whose descents make the sweeps of the plan.
std::shared_ptr<const GpuTopology> topology_of(const Hierarchy& hierarchy, SweepPlan plan);

}  // namespace brindle
