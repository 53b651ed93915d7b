#include "brindle/waves/orientation.h"

#include <cstdint>
#include <vector>

#include "brindle/base/parallel.h"

namespace brindle {
namespace {

enum class Visit : std::uint8_t { not_yet, queued, done };

/// The sum of signed agreements with the neighbours that are done decides.
bool runs_against_neighbors(const Adjacency& neighborhood, std::span<const Vec3> directions,
                            const std::vector<Visit>& visits, Index vertex) {
  float agreement = 0;
  for (const Index neighbor : neighborhood.of(vertex)) {
    if (visits[neighbor] == Visit::done) agreement += directions[vertex].dot(directions[neighbor]);
  }
  return agreement < 0;
}

}  // namespace

void orient_alike(const Adjacency& neighborhood, std::span<Vec3> directions) {
  const auto count = static_cast<Index>(directions.size());
  std::vector<Visit> visits(count, Visit::not_yet);
  std::vector<Index> queue;
  queue.reserve(count);
  for (Index start = 0; start < count; ++start) {
    if (visits[start] != Visit::not_yet) continue;
    visits[start] = Visit::queued;
    std::size_t next = queue.size();
    queue.push_back(start);
    for (; next < queue.size(); ++next) {
      const Index vertex = queue[next];
      if (runs_against_neighbors(neighborhood, directions, visits, vertex)) {
        directions[vertex] = -directions[vertex];
      }
      visits[vertex] = Visit::done;
      for (const Index neighbor : neighborhood.of(vertex)) {
        // What has no wave carries no sign on.
        if (visits[neighbor] != Visit::not_yet || directions[neighbor].isZero(0)) continue;
        visits[neighbor] = Visit::queued;
        queue.push_back(neighbor);
      }
    }
  }
}

void orient_like(std::span<const Vec3> reference, std::span<Vec3> directions) {
  parallel_for(directions.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (directions[i].dot(reference[i]) < 0) directions[i] = -directions[i];
    }
  });
}

}  // namespace brindle
