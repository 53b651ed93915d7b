/// The least squares of a frequency that yields, as rows of a sparse matrix.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "brindle/adjacency.h"
#include "brindle/mesh.h"
#include "brindle/waves/bounded_multigrid.h"
#include "brindle/waves/row_levels.h"

namespace brindle {

/// What the frequencies of one frame have to fit.
struct FrequencyInput {
  std::span<const Vec3> positions;
  std::span<const Vec3> directions;
  std::span<const float> wanted;
};

/// What one triangle adds, in relative frequencies x_i = g_i / f_i. All zero where a corner has no
/// wave.
struct alignas(32) TriangleTerms {
  std::array<float, 3> diagonal{};  ///< at each corner
  std::array<float, 3> beside{};    ///< between the two other corners
  float mass = 0;                   ///< a third of the area
};

/// The terms of all triangles, and what makes them comparable.
struct FrequencyTerms {
  std::vector<TriangleTerms> triangles;
  float unit = 1;          ///< 1 / root mean square of the frequencies: they count in it
  float faithfulness = 0;  ///< mu
};

/// Overwrites `terms`, which has one entry per triangle. `weights` is empty or has the w_T.
void set_terms(std::span<const Triangle> triangles, const FrequencyInput& input,
               std::span<const float> weights, FrequencyTerms& terms);

/// Where terms are added up. Which nodes are merged follows the directions that it is made with.
class FrequencyRows {
 public:
  /// Edges of triangles are edges of `adjacency`. `weights` is empty or has one per triangle.
  FrequencyRows(std::span<const Triangle> triangles, std::span<const float> weights,
                const Adjacency& adjacency, const FrequencyInput& input);

  const std::shared_ptr<const RowLevels>& levels() const { return levels_; }

  /// Those of three vertices, in the order of the rows that they add to, with their weights: what
  /// `set_terms` is to be given.
  std::span<const Triangle> triangles() const { return triangles_; }
  std::span<const float> weights() const { return weights_; }

  /// Sets the matrix and the right side, but no bounds.
  void set(const FrequencyTerms& terms, std::span<const float> wanted,
           BoundedMultigrid& multigrid) const;

 private:
  /// A triangle's corner at the row of its vertex.
  struct Corner {
    Index corner;          ///< 4 t + m: corner m of `triangles_[t]`
    Index next, previous;  ///< the row's entries of the triangle's other vertices
  };
  void set_triangles(std::span<const Triangle> triangles, std::span<const float> weights);
  void set_corners();

  std::shared_ptr<const RowLevels> levels_;
  std::vector<Triangle> triangles_;
  std::vector<float> weights_;
  std::vector<Index> offsets_;  ///< per place, of `corners_`
  std::vector<Corner> corners_;
};

}  // namespace brindle
