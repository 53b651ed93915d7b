/// The part of a hierarchy that stays as long as the graph's connectivity, on the device.
#pragma once

#include <memory>
#include <vector>

#include "brindle/gl/gl_name.h"
#include "brindle/gpu/flat_hierarchy.h"

namespace brindle {

class GpuTopology {
 public:
  /// Copies `flat` to the context that is current. Throws Error if it is larger than the driver's
  /// buffers or OpenGL is out of memory.
  explicit GpuTopology(const FlatHierarchy& flat);

  /// Binds what the shaders of levels.glsl know of it.
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

/// That of a hierarchy whose descents make the sweeps of the plan.
std::shared_ptr<const GpuTopology> topology_of(const Hierarchy& hierarchy, SweepPlan plan);

}  // namespace brindle
