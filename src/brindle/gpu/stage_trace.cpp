#include "brindle/gpu/stage_trace.h"

#include <algorithm>

#include <epoxy/gl.h>

#include "brindle/gpu/gpu_topology.h"

namespace brindle {
namespace {

// Bytes per item (shaders/levels.glsl, couplings.glsl).
constexpr std::size_t kWord = 4, kNumber = 8, kRow = 16, kWave = 32, kVertexInput = 28;

std::size_t entries_of(const GpuTopology& topology, std::size_t l) {
  const std::size_t end = l + 1 < topology.level_count()
                              ? std::size_t{topology.level(l + 1).first_column} * kLanes
                              : topology.entry_count();
  return end - std::size_t{topology.level(l).first_column} * kLanes;
}

/// Gauges, gauged couplings and sums of a level.
std::size_t sum_bytes(const GpuTopology& topology, std::size_t l) {
  if (l + 1 == topology.level_count()) return 0;
  const FlatLevel& fine = topology.level(l);
  const std::size_t fine_slots = fine.slot_count, fine_entries = entries_of(topology, l);
  const std::size_t coarse_slots = topology.level(l + 1).slot_count;
  const std::size_t gauges =
      fine.gauge_entry_count * (2 * kWord + kNumber) + fine_slots * (2 * kWord + kRow + kNumber);
  const std::size_t gauged = fine_entries * (kWord + 2 * kNumber) + fine_slots * (kRow + kNumber);
  const std::size_t sums = fine.source_count * kWord + fine_entries * kNumber +
                           entries_of(topology, l + 1) * 2 * kNumber +
                           fine_slots * (2 * kWord + kNumber + kRow) + coarse_slots * kRow;
  return gauges + gauged + sums;
}

/// Prolongation and sweeps of a level.
std::size_t descent_bytes(const GpuTopology& topology, std::size_t l) {
  const std::size_t slots = topology.level(l).slot_count;
  const std::size_t prolonging = slots * (kWord + 2 * kNumber);
  const std::size_t sweep =
      entries_of(topology, l) * (kWord + kNumber) + slots * (kRow + 2 * kNumber);
  return prolonging + topology.level(l).sweeps * sweep;
}

}  // namespace

std::vector<StageBytes> frame_traffic(const GpuTopology& topology) {
  const std::size_t slots = topology.level(0).slot_count;
  std::size_t sums = 0, small = 0, sweeps = 0;
  for (std::size_t l = 0; l < topology.level_count(); ++l) {
    sums += sum_bytes(topology, l);
    (l < topology.first_small_level() ? sweeps : small) += descent_bytes(topology, l);
  }
  return {
      {"load", slots * (kWord + kVertexInput + 2 * kWave + 2 * kNumber)},
      {"couple", topology.finest_entries() * (kWord + kNumber) + slots * (kWave + kNumber + kRow)},
      {"sums", sums},
      {"small levels", small},
      {"sweeps", sweeps},
      {"nodes", slots * (kWord + 3 * kNumber)}};
}

StageTimer::~StageTimer() {
  if (!queries_.empty()) glDeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
}

void StageTimer::start() {
  names_.clear();
  mark();
}

void StageTimer::stage(std::string_view name) {
  names_.push_back(name);
  mark();
}

void StageTimer::mark() {
  if (names_.size() == queries_.size()) {
    GLuint query = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &query);
    queries_.push_back(query);
  }
  glQueryCounter(queries_[names_.size()], GL_TIMESTAMP);
}

std::vector<StageTime> StageTimer::milliseconds() const {
  std::vector<StageTime> times;
  const auto nanoseconds = [&](std::size_t query) {
    GLuint64 value = 0;
    glGetQueryObjectui64v(queries_[query], GL_QUERY_RESULT, &value);
    return value;
  };
  for (std::size_t s = 0; s < names_.size(); ++s) {
    const double duration = 1e-6 * static_cast<double>(nanoseconds(s + 1) - nanoseconds(s));
    const auto known = std::ranges::find(times, names_[s], &StageTime::first);
    if (known == times.end()) {
      times.emplace_back(names_[s], duration);
    } else {
      known->second += duration;
    }
  }
  return times;
}

}  // namespace brindle
