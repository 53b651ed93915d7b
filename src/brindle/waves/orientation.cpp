#include "brindle/orientation.h"

#include <cstdint>
#include <vector>

#include "brindle/base/parallel.h"
#include "brindle/geometry/crease_edges.h"
#include "brindle/waves/crease_links.h"

namespace brindle {
namespace {

enum class Visit : std::uint8_t { not_yet, queued, done };

/// Visits vertices breadth-first.
class OrientationWalk {
 public:
  /// `creased` is the surface if neighbours may be on two sides of a crease, else null.
  OrientationWalk(const Adjacency& neighborhood, std::span<Vec3> directions,
                  const Progress& progress, const Surface* creased = nullptr)
      : neighborhood_(neighborhood),
        creased_(creased),
        directions_(directions),
        progress_(progress),
        visits_(directions.size(), Visit::not_yet) {
    queue_.reserve(directions.size());
  }

  void settle(Index vertex) { visits_[vertex] = Visit::done; }

  void enter(Index vertex) {
    if (visits_[vertex] != Visit::not_yet) return;
    visits_[vertex] = Visit::queued;
    queue_.push_back(vertex);
  }

  void enter_neighbors(Index vertex) {
    for (const Index neighbor : neighborhood_.of(vertex)) {
      // Vertices without a wave propagate no sign.
      if (!directions_[neighbor].isZero(0)) enter(neighbor);
    }
  }

  void run() {
    for (; next_ < queue_.size(); ++next_) {
      if (next_ % kReportSlice == 0) progress_.tick();
      const Index vertex = queue_[next_];
      if (runs_against_neighbors(vertex)) {
        directions_[vertex] = -directions_[vertex];
      }
      visits_[vertex] = Visit::done;
      enter_neighbors(vertex);
    }
  }

 private:
  float agreement(Index i, Index j) const {
    if (creased_ == nullptr || creased_->mesh.positions[i] != creased_->mesh.positions[j]) {
      return directions_[i].dot(directions_[j]);
    }
    return cosine_across(directions_[j], creased_->normals[j], directions_[i],
                         creased_->normals[i]);
  }

  /// Decides by the sum of signed cosines to the neighbours that are done.
  bool runs_against_neighbors(Index vertex) const {
    float sum = 0;
    for (const Index neighbor : neighborhood_.of(vertex)) {
      if (visits_[neighbor] == Visit::done) sum += agreement(vertex, neighbor);
    }
    return sum < 0;
  }

  const Adjacency& neighborhood_;
  const Surface* creased_;
  std::span<Vec3> directions_;
  const Progress& progress_;
  std::vector<Visit> visits_;
  std::vector<Index> queue_;
  std::size_t next_ = 0;
};

/// Starts at the first vertex of every component not yet reached.
void walk_all(OrientationWalk& walk, std::size_t count) {
  for (Index start = 0; start < count; ++start) {
    walk.enter(start);
    walk.run();
  }
}

}  // namespace

void orient_alike(const Adjacency& neighborhood, std::span<Vec3> directions,
                  const Progress& progress) {
  OrientationWalk walk(neighborhood, directions, progress);
  walk_all(walk, directions.size());
}

void orient_alike(const Surface& surface, std::span<Vec3> directions, const Progress& progress) {
  const auto neighbors = neighbors_over_creases(surface);
  OrientationWalk walk(*neighbors, directions, progress,
                       surface.creases.empty() ? nullptr : &surface);
  walk_all(walk, directions.size());
}

void orient_alike(const Adjacency& neighborhood, std::span<const std::uint8_t> settled,
                  std::span<Vec3> directions) {
  const Progress silent;
  OrientationWalk walk(neighborhood, directions, silent);
  for (Index vertex = 0; vertex < settled.size(); ++vertex) {
    if (settled[vertex] != 0) walk.settle(vertex);
  }
  for (Index vertex = 0; vertex < settled.size(); ++vertex) {
    if (settled[vertex] != 0 && !directions[vertex].isZero(0)) walk.enter_neighbors(vertex);
  }
  walk.run();
  walk_all(walk, directions.size());
}

void orient_like(std::span<const Vec3> reference, std::span<Vec3> directions) {
  parallel_for(directions.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (directions[i].dot(reference[i]) < 0) directions[i] = -directions[i];
    }
  });
}

}  // namespace brindle
