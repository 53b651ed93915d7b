#include "brindle/gpu/gpu_topology.h"

#include <algorithm>
#include <array>

#include "brindle/gl/gl_buffer.h"
#include "brindle/gpu/gpu_kernels.h"
#include "brindle/phases/multilevel.h"

namespace brindle {
namespace {

/// Sums of levels with fewer slots are made by one group: for larger ones a dispatch a step takes
/// less time (docs/gpu.md).
constexpr Index kSmallSums = 1024;

/// The uniform block `Levels` of shaders/levels.glsl.
struct LevelTable {
  std::array<FlatLevel, FlatHierarchy::kMostLevels> levels;
  std::uint32_t level_count, node_at, scratch_size, unused;
};

GlBuffer level_table(const FlatHierarchy& flat) {
  LevelTable table{};
  std::ranges::copy(flat.levels, table.levels.begin());
  table.level_count = static_cast<std::uint32_t>(flat.levels.size());
  table.node_at = flat.node_at;
  table.scratch_size = flat.finest_entries;
  return make_buffer(sizeof table, &table, "levels");
}

std::vector<GpuTopology::Color> colors_of(const FlatHierarchy& flat, const FlatLevel& level) {
  std::vector<GpuTopology::Color> colors(level.color_count);
  for (std::size_t c = 0; c < colors.size(); ++c) {
    const std::uint32_t begin = flat.topology[level.color_begin + c];
    colors[c] = {begin, (flat.topology[level.color_begin + c + 1] - begin) / 3 * kLanes};
  }
  return colors;
}

}  // namespace

GpuTopology::GpuTopology(const FlatHierarchy& flat)
    : levels_(flat.levels),
      node_count_(flat.node_count),
      slot_count_(flat.slot_count),
      entry_count_(flat.neighbors.size()),
      finest_entries_(flat.finest_entries),
      level_table_(level_table(flat)),
      topology_(buffer_of(flat.topology, "topology")),
      neighbors_(buffer_of(flat.neighbors, "neighbours")) {
  for (const FlatLevel& level : levels_) colors_.push_back(colors_of(flat, level));
  first_small_ = first_below(kSmallLevel);
  first_small_sums_ = first_below(kSmallSums);
}

std::size_t GpuTopology::first_below(Index slots) const {
  std::size_t first = levels_.size();
  while (first > 0 && levels_[first - 1].slot_count < slots) --first;
  return first;
}

void GpuTopology::bind() const {
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, level_table_);
  bind_storage(kTopologyBinding, topology_);
  bind_storage(kNeighborBinding, neighbors_);
}

std::shared_ptr<const GpuTopology> topology_of(const Hierarchy& hierarchy, SweepPlan plan) {
  std::vector<LevelTopology> levels;
  for (const Level& level : hierarchy.levels) levels.push_back(level.topology);
  return std::make_shared<const GpuTopology>(flatten(levels, plan));
}

}  // namespace brindle
