/// What tests on several ranks share.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/distributed/surface/partition.h"
#include "brindle/distributed_stripes.h"
#include "brindle/mesh.h"
#include "phase_graphs.h"

namespace brindle::testing_support {

inline int rank() {
  int value = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &value);
  return value;
}

inline int rank_count() {
  int value = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &value);
  return value;
}

template <class T>
bool same_bits(std::span<const T> a, std::span<const T> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

/// A surface with waves, and this rank's piece of it.
struct Parts {
  WavySurface whole;
  SurfacePiece piece;
  std::vector<std::uint64_t> ids;  ///< of the piece's vertices in the whole

  Parts(WavySurface surface, const std::vector<int>& rank_of_triangle)
      : whole(std::move(surface)),
        piece(piece_of(whole.mesh, rank_of_triangle, rank())),
        ids(piece.vertex_ids) {}
  explicit Parts(WavySurface surface)
      : Parts(surface, partition_by_curve(surface.mesh, rank_count())) {}

  DistributedSurface surface() const { return {piece, MPI_COMM_WORLD}; }

  template <class T>
  std::vector<T> of_piece(const std::vector<T>& all) const {
    std::vector<T> rows;
    for (const std::uint64_t id : ids) rows.push_back(all[id]);
    return rows;
  }
  WaveSet of_piece(const WaveSet& all) const {
    return {of_piece(all.positions), of_piece(all.directions), of_piece(all.frequencies)};
  }

  /// On all ranks the owners' values, by vertex of the whole; `floats` of them a vertex.
  std::vector<float> gathered(const float* values, std::size_t floats,
                              std::span<const std::uint8_t> is_own) const {
    std::vector<float> own(floats * whole.mesh.vertex_count()), all(own.size());
    for (std::size_t v = 0; v < ids.size(); ++v) {
      if (is_own[v]) std::copy_n(values + floats * v, floats, own.begin() + floats * ids[v]);
    }
    MPI_Allreduce(own.data(), all.data(), static_cast<int>(own.size()), MPI_FLOAT, MPI_SUM,
                  MPI_COMM_WORLD);
    return all;
  }
  std::vector<Complex> gathered(std::span<const Complex> z,
                                std::span<const std::uint8_t> is_own) const {
    const std::vector<float> all = gathered(reinterpret_cast<const float*>(z.data()), 2, is_own);
    std::vector<Complex> result;
    for (std::size_t v = 0; v < all.size(); v += 2) result.emplace_back(all[v], all[v + 1]);
    return result;
  }
  std::vector<Vec3> gathered(std::span<const Vec3> vectors,
                             std::span<const std::uint8_t> is_own) const {
    const std::vector<float> all = gathered(vectors.front().data(), 3, is_own);
    std::vector<Vec3> result;
    for (std::size_t v = 0; v < all.size(); v += 3) {
      result.emplace_back(all[v], all[v + 1], all[v + 2]);
    }
    return result;
  }
};

inline FrameInput frame_of(const WaveSet& waves) {
  return {waves.positions, waves.directions, waves.frequencies};
}

/// Ways to cut a surface that no partitioner would choose.
struct Cut {
  const char* name;
  std::vector<int> (*rank_of_triangle)(const Mesh& mesh);
};

inline constexpr Cut kAllCuts[] = {
    {"along a curve", [](const Mesh& mesh) { return partition_by_curve(mesh, rank_count()); }},
    {"the last rank has nothing",
     [](const Mesh& mesh) { return partition_by_curve(mesh, std::max(1, rank_count() - 1)); }},
    {"the first rank has one triangle",
     [](const Mesh& mesh) {
       std::vector<int> ranks = partition_by_curve(mesh, std::max(1, rank_count() - 1));
       for (int& r : ranks) r = std::min(r + 1, rank_count() - 1);
       ranks[ranks.size() / 2] = 0;
       return ranks;
     }},
    {"islands",
     [](const Mesh& mesh) {
       std::vector<int> ranks = partition_by_curve(mesh, 16 * rank_count());
       for (int& r : ranks) r %= rank_count();
       return ranks;
     }},
    {"every triangle by chance",
     [](const Mesh& mesh) {
       std::mt19937 random(1);
       std::vector<int> ranks(mesh.triangle_count());
       for (int& r : ranks) r = static_cast<int>(random() % static_cast<unsigned>(rank_count()));
       return ranks;
     }},
    {"the last rank has all",
     [](const Mesh& mesh) { return std::vector<int>(mesh.triangle_count(), rank_count() - 1); }},
};

/// All ways; to one rank they are the same.
inline std::span<const Cut> cuts() {
  return std::span(kAllCuts).first(rank_count() == 1 ? 1 : std::size(kAllCuts));
}

}  // namespace brindle::testing_support
