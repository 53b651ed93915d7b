/// The least squares of a frequency that yields, as rows of a sparse matrix.
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
#include "brindle/waves/row_peers.h"

namespace brindle {

/// What the frequencies of one frame have to fit.
struct FrequencyInput {
  std::span<const Vec3> positions;
  std::span<const Vec3> directions;
  std::span<const float> wanted;
};

/// What one triangle adds, in logarithms of relative frequencies, x_i = 1 + log(g_i / f_i). Its
/// rows sum to zero. All zero where a corner has no wave.
struct alignas(32) TriangleTerms {
  std::array<float, 3> beside{};  ///< between the two other corners
  std::array<float, 3> pull{};    ///< on the right side of each corner
  float mass = 0;                 ///< a third of the area
  float faith = 0;                ///< the same times w_T: what holds frequencies to those asked for
};

/// What one row stands for.
struct RowMass {
  float area = 0;
  float pull = 0;  ///< to the frequency asked for: mu times area and the square of the frequency
};

/// The terms of all triangles, and what makes them comparable.
struct FrequencyTerms {
  std::vector<TriangleTerms> triangles;
  float unit = 1;          ///< 1 / root mean square of the frequencies: they count in it
  float faithfulness = 0;  ///< mu
  double constant = 0;  ///< what the triangles' squares are at x = 1, counted ones of this process
};

/// Triangles of a process, in any order.
struct FrequencyTriangles {
  std::vector<Triangle> corners;
  std::vector<float> weights;  ///< w_T; empty: 1
  /// 1 for those that this process counts; empty: all. A triangle with vertices of several
  /// processes is known to each of them, and counted by one.
  std::vector<std::uint8_t> counted;
};

/// Where terms are added up. Which nodes are merged follows the directions that it is made with.
/// With peers vertices of others come after the own ones, which have all their triangles here.
class FrequencyRows {
 public:
  /// Edges of triangles are edges of `adjacency`.
  FrequencyRows(const FrequencyTriangles& triangles, const Adjacency& adjacency,
                const FrequencyInput& input, RowPeers* peers = nullptr,
                const Progress& progress = {});

  const std::shared_ptr<const RowLevels>& levels() const { return levels_; }

  /// Those of three vertices, in the order of the rows that they add to.
  const FrequencyTriangles& triangles() const { return triangles_; }

  /// How many vertices have rows here.
  Index own() const { return levels_->levels[0].size(); }

  /// Overwrites `terms`, which has one entry per triangle.
  void set_terms(const FrequencyInput& input, RowPeers* peers, FrequencyTerms& terms,
                 const Progress& progress = {}) const;

  /// Sets the matrix and the right side for logarithms drawn to 0, but no bounds; and what rows
  /// stand for, into `masses`.
  void set(const FrequencyTerms& terms, std::span<const float> wanted, BoundedMultigrid& multigrid,
           std::span<RowMass> masses) const;

 private:
  /// A triangle's corner at the row of its vertex.
  struct Corner {
    Index corner;          ///< 4 t + m: corner m of triangle t
    Index next, previous;  ///< the row's entries of the triangle's other vertices
  };
  void set_triangles(const FrequencyTriangles& triangles, const Progress& progress);
  void set_corners(const Progress& progress);

  std::shared_ptr<const RowLevels> levels_;
  FrequencyTriangles triangles_;
  CompressedRows<Corner> corners_;  ///< a row a place
};

}  // namespace brindle
