/// The part of a hierarchy that depends on connectivity alone, in the shaders' layout
/// (shaders/levels.glsl), and on the device.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "brindle/gl/gl_name.h"
#include "brindle/phases/multilevel.h"

namespace brindle {

/// Starts of a level's lists: slots and columns, numbered through all levels, or words of
/// `FlatHierarchy::topology`; see shaders/levels.glsl.
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
  float over_relaxation = 1;  ///< of all sweeps except the last
  std::uint32_t filling = 0;  ///< padding to the shaders' alignment

  LevelSweeps planned_sweeps() const { return {static_cast<int>(sweeps), over_relaxation}; }
};

struct FlatHierarchy {
  static constexpr std::size_t kMostLevels = 32;

  std::vector<FlatLevel> levels;         ///< finest first
  std::vector<std::uint32_t> topology;   ///< all lists
  std::vector<std::uint32_t> neighbors;  ///< maps entries to neighbour slots, for all levels
  std::uint32_t node_at = 0;             ///< list from slots of the finest level to nodes
  std::uint32_t slot_count = 0;  ///< of all levels; the slot after the last means no aggregate
  std::uint32_t finest_entries = 0;
  std::size_t node_count = 0;
};

/// Flattens the levels of `build_hierarchy`, finest first. `plan` has the sweeps of descents.
/// Throws Error beyond the range of 32-bit words.
FlatHierarchy flatten(std::span<const LevelTopology> levels, SweepPlan plan);

/// A FlatHierarchy on the device.
class GpuTopology {
 public:
  /// Uploads `flat` to the current context. Throws Error if it exceeds the driver's buffer limit or
  /// OpenGL is out of memory.
  explicit GpuTopology(const FlatHierarchy& flat);

  /// Binds the buffers of levels.glsl.
  void bind() const;

  /// The nodes of one colour of a level.
  struct Color {
    std::uint32_t slices;      ///< list of its slices, as a word of the topology
    std::uint32_t slot_count;  ///< in these slices
  };

  std::size_t level_count() const { return levels_.size(); }
  const FlatLevel& level(std::size_t l) const { return levels_[l]; }
  const std::vector<Color>& colors(std::size_t l) const { return colors_[l]; }

  /// The first level of the tail that one group descends; `level_count()` if the coarsest is too
  /// large.
  std::size_t first_small_level() const { return first_small_; }

  /// The first level whose gauges and sums one group computes.
  std::size_t first_small_sums() const { return first_small_sums_; }

  /// The nodes at the slots of the finest level; kNone for padding.
  std::span<const std::uint32_t> node_at() const { return node_at_; }

  std::size_t node_count() const { return node_count_; }
  std::size_t slot_count() const { return slot_count_; }    ///< of all levels
  std::size_t entry_count() const { return entry_count_; }  ///< of all levels
  std::size_t finest_entries() const { return finest_entries_; }

 private:
  /// The first level from which on all have fewer slots.
  std::size_t first_below(Index slots) const;

  std::vector<FlatLevel> levels_;
  std::vector<std::vector<Color>> colors_;
  std::vector<std::uint32_t> node_at_;
  std::size_t first_small_, first_small_sums_;
  std::size_t node_count_, slot_count_, entry_count_, finest_entries_;
  GlBuffer level_table_, topology_, neighbors_;
};

/// The topology of a hierarchy, with the sweeps of the plan.
std::shared_ptr<const GpuTopology> topology_of(const Hierarchy& hierarchy, SweepPlan plan);

}  // namespace brindle
