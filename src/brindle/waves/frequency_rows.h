/// The least-squares problem of `relaxed_frequencies` as rows of a sparse matrix.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "brindle/base/compressed_rows.h"
#include "brindle/mesh.h"
#include "brindle/types.h"
#include "brindle/waves/bounded_multigrid.h"
#include "brindle/waves/row_levels.h"

namespace brindle {

/// The waves of one frame, one entry per vertex.
struct FrequencyInput {
  std::span<const Vec3> positions;
  std::span<const Vec3> directions;
  std::span<const float> wanted;
};

/// The terms of one triangle in x_i = 1 + log(g_i / f_i). Its rows sum to zero. All zero if a
/// corner has no wave.
struct alignas(32) TriangleTerms {
  std::array<float, 3> beside{};  ///< entries between the two other corners
  std::array<float, 3> pull{};    ///< right sides of corners
  float mass = 0;                 ///< a third of the area
  float faith = 0;                ///< mass times w_T: the weight of the requested frequencies
};

/// Area and weight of one row.
struct RowMass {
  float area = 0;
  float pull = 0;  ///< weight of the requested frequency: mu times the sum of `faith`, times f^2
};

/// The terms of all triangles, and their common scale.
struct FrequencyTerms {
  std::vector<TriangleTerms> triangles;
  float unit = 1;          ///< of frequencies: 1 / their root mean square
  float faithfulness = 0;  ///< mu
  double constant = 0;     ///< sum of squares at x = 1 over this process's counted triangles
};

/// Triangles of a process, in any order.
struct FrequencyTriangles {
  std::vector<Triangle> corners;
  std::vector<float> weights;  ///< w_T; empty: 1
  /// 1 for triangles that this process counts; empty: all. Each process with a vertex of a triangle
  /// has the triangle, and one of them counts it.
  std::vector<std::uint8_t> counted;
};

/// The matrix in which terms are summed. Construction merges nodes along stripes of the directions.
/// With `peers`, ghost vertices come last; all triangles of own vertices are present.
class FrequencyRows {
 public:
  /// Edges of triangles must be edges of `adjacency`.
  FrequencyRows(const FrequencyTriangles& triangles, const Adjacency& adjacency,
                const FrequencyInput& input, MultigridPeers* peers = nullptr,
                const Progress& progress = {});

  const std::shared_ptr<const RowLevels>& levels() const { return levels_; }

  /// Triangles with three different vertices, in the order of their rows.
  const FrequencyTriangles& triangles() const { return triangles_; }

  /// The number of own vertices, which have rows here.
  Index own() const { return levels_->levels[0].size(); }

  /// Overwrites `terms`, which has one entry per triangle.
  void set_terms(const FrequencyInput& input, MultigridPeers* peers, FrequencyTerms& terms) const;

  /// Sets the matrix, the right side, which attracts logarithms to 0, and `masses`, but no bounds.
  void set(const FrequencyTerms& terms, std::span<const float> wanted, BoundedMultigrid& multigrid,
           std::span<RowMass> masses) const;

 private:
  /// A triangle's corner in the row of its vertex.
  struct Corner {
    Index corner;          ///< 4 t + m: corner m of triangle t
    Index next, previous;  ///< the row's entries of the triangle's other vertices
  };
  void set_triangles(const FrequencyTriangles& triangles, const Progress& progress);
  void set_corners(const Progress& progress);

  std::shared_ptr<const RowLevels> levels_;
  FrequencyTriangles triangles_;
  CompressedRows<Corner> corners_;  ///< one row per place
};

}  // namespace brindle
