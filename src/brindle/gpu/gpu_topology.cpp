#include "brindle/gpu/gpu_topology.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "brindle/error.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/gpu/gpu_kernels.h"

namespace brindle {
namespace {

/// Appends to the words of a FlatHierarchy; returns the position of the appended list.
class Words {
 public:
  explicit Words(std::vector<std::uint32_t>& words) : words_(words) {}

  std::uint32_t next() const { return static_cast<std::uint32_t>(words_.size()); }

  template <class Values, class Map>
  std::uint32_t append(const Values& values, Map map) {
    const std::uint32_t begin = next();
    for (const auto value : values) words_.push_back(map(value));
    return begin;
  }

  /// Reserves words that are filled in later.
  std::uint32_t leave(std::size_t count) {
    const std::uint32_t begin = next();
    words_.resize(words_.size() + count);
    return begin;
  }

  void push(std::uint32_t word) { words_.push_back(word); }
  void set(std::uint32_t place, std::uint32_t word) { words_[place] = word; }

 private:
  std::vector<std::uint32_t>& words_;
};

/// For every colour, the list of its slices with three words each: number, first column and end of
/// columns.
void append_colors(Words& words, const SlicedLayout& layout, FlatLevel& level) {
  level.color_count = layout.color_count();
  level.color_begin = words.leave(std::size_t{level.color_count} + 1);
  for (Index color = 0; color < layout.color_count(); ++color) {
    words.set(level.color_begin + color, words.next());
    for (const SliceRange& range : layout.ranges_of(color)) {
      for (Index slice = range.begin; slice < range.end; ++slice) {
        words.push(slice);
        words.push(level.first_column + layout.column_begin[slice]);
        words.push(level.first_column + layout.column_begin[slice + 1]);
      }
    }
  }
  words.set(level.color_begin + level.color_count, words.next());
}

/// For every slot, the entries that its gauge depends on, in round order.
std::vector<std::vector<Index>> gauge_entries(const LevelTopology& topology) {
  std::vector<std::vector<Index>> entries(topology.layout->slot_count());
  const GaugeSchedule& rounds = topology.aggregation->gauges;
  for (std::size_t m = 0; m < rounds.member.size(); ++m) {
    if (rounds.member[m] == kNone) continue;
    for (Index round = rounds.round_begin[m / kLanes]; round < rounds.round_begin[m / kLanes + 1];
         ++round) {
      const Index entry = rounds.entry[std::size_t{round} * kLanes + m % kLanes];
      if (entry != kNone) entries[rounds.member[m]].push_back(entry);
    }
  }
  return entries;
}

/// Members of all aggregates with two words each: the slot, and the start of the list of entries,
/// with neighbours, that its gauge depends on. The list ends where the next member's starts.
void append_members(Words& words, const LevelTopology& topology, FlatLevel& level) {
  const Aggregation& aggregation = *topology.aggregation;
  const std::uint32_t members =
      words.next() + static_cast<std::uint32_t>(aggregation.member_begin.size());
  level.member_begin =
      words.append(aggregation.member_begin, [&](Index begin) { return members + 2 * begin; });
  words.leave(2 * aggregation.member.size() + 2);
  const auto entries = gauge_entries(topology);
  const std::uint32_t first_entry = level.first_column * kLanes;
  for (std::uint32_t m = 0; m < aggregation.member.size(); ++m) {
    const Index slot = aggregation.member[m];
    words.set(members + 2 * m, level.first_slot + slot);
    words.set(members + 2 * m + 1, words.next());
    for (const Index entry : entries[slot]) {
      words.push(first_entry + entry);
      words.push(level.first_slot + topology.layout->neighbor[entry]);
    }
  }
  const std::uint32_t end = members + 2 * static_cast<std::uint32_t>(aggregation.member.size());
  words.set(end + 1, words.next());
}

/// Here, rounds refer to fine entries: all couplings are gauged before sums begin.
void append_sources(Words& words, const LevelTopology& topology, const SlicedLayout& coarse,
                    FlatLevel& level) {
  const SumSchedule& sources = topology.aggregation->sources;
  const std::uint32_t rounds = words.next();
  for (Index block = 0; block < coarse.block_count(); ++block) {
    const std::vector<Index> entry_at = entries_of_places(sources, *topology.layout, block);
    const SliceRange slices = coarse.block(block);
    const auto first = std::size_t{sources.round_begin[coarse.column_begin[slices.begin]]};
    const auto end = std::size_t{sources.round_begin[coarse.column_begin[slices.end]]};
    words.append(std::span(sources.entry).subspan(first * kLanes, (end - first) * kLanes),
                 [&](Index place) { return entry_at[place]; });
  }
  level.source_begin =
      words.append(sources.round_begin, [&](Index round) { return rounds + round * kLanes; });
}

/// `nowhere` is the slot for no aggregate.
void append_aggregation(Words& words, const LevelTopology& topology, const SlicedLayout& coarse,
                        std::uint32_t nowhere, FlatLevel& level) {
  const std::uint32_t next_slot = level.first_slot + level.slot_count;
  level.coarse_slots = words.append(topology.aggregation->coarse_slot, [&](Index slot) {
    return slot == coarse.slot_count() ? nowhere : next_slot + slot;
  });
  append_members(words, topology, level);
  append_sources(words, topology, coarse, level);
}

/// An overflow would need more memory than any device has, but would be silent.
void check_counts(std::size_t topology_words, std::size_t entries, std::size_t levels) {
  if (levels > FlatHierarchy::kMostLevels) {
    throw Error("this mesh has " + std::to_string(levels) +
                " levels and the GPU solver takes 32; solve it on the processor");
  }
  if (std::max(topology_words, entries) >= std::numeric_limits<std::uint32_t>::max()) {
    throw Error("this mesh is too large for the GPU solver; solve it on the processor");
  }
}

}  // namespace

FlatHierarchy flatten(std::span<const LevelTopology> levels, SweepPlan plan) {
  FlatHierarchy flat;
  Words words(flat.topology);
  for (const LevelTopology& level : levels) flat.slot_count += level.layout->slot_count();
  FlatLevel level;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const SlicedLayout& layout = *levels[l].layout;
    level.slot_count = layout.slot_count();
    const LevelSweeps planned = plan.on_level(layout.slot_count());
    level.sweeps = static_cast<std::uint32_t>(planned.count);
    level.over_relaxation = planned.over_relaxation;
    level.columns = words.append(layout.column_begin,
                                 [&](Index column) { return level.first_column + column; });
    for (const Index slot : layout.neighbor) flat.neighbors.push_back(level.first_slot + slot);
    append_colors(words, layout, level);
    if (l + 1 < levels.size()) {
      append_aggregation(words, levels[l], *levels[l + 1].layout, flat.slot_count, level);
    }
    flat.levels.push_back(level);
    level.first_slot += level.slot_count;
    level.first_column += static_cast<std::uint32_t>(layout.entry_count() / kLanes);
  }
  const SlicedLayout& finest = *levels[0].layout;
  flat.node_at = words.append(finest.node_at, [](Index node) { return node; });
  flat.node_count = finest.slot_of.size();
  flat.finest_entries = static_cast<std::uint32_t>(finest.entry_count());
  check_counts(flat.topology.size(), flat.neighbors.size(), levels.size());
  return flat;
}

namespace {

/// Levels with fewer slots sum in one group; for larger ones, a dispatch per step is faster
/// (docs/gpu.md).
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
      node_at_(flat.topology.begin() + flat.node_at,
               flat.topology.begin() + flat.node_at + flat.levels[0].slot_count),
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
