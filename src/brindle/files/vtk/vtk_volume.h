/// Surfaces of VTK volume cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "brindle/types.h"

namespace brindle {

/// The linear or quadratic type of a Lagrange or Bezier cell with `points` points; other types are
/// returned unchanged. (Bezier cells of order 2 have points off their surface.)
std::uint8_t vtk_plain_type(std::uint8_t type, std::size_t points);

/// Volume cells with known faces: tetrahedra, voxels, hexahedra, wedges, pyramids, prisms and their
/// quadratic forms.
class VtkVolumes {
 public:
  /// The smallest number of points of a cell of this type; 0 if its faces are unknown.
  static std::size_t points_of(std::uint8_t type);

  /// A cell of a known type with at least `points_of` points; `cell` is its row.
  void add(std::uint8_t type, std::span<const Index> points, Index cell);

  std::size_t count() const { return types_.size(); }

  /// Calls `use` with the corners of every face that belongs to one cell only, and the cell's row,
  /// in cell order. Mid-edge points are between the corners. Faces are wound anticlockwise from
  /// outside, whatever the order of the cell's points.
  void for_each_boundary_face(
      std::span<const Eigen::Vector3d> positions,
      const std::function<void(std::span<const Index> corners, Index cell)>& use) const;

 private:
  template <class Use>
  void for_each_face(const Use& use) const;
  std::vector<char> on_boundary() const;

  std::vector<std::uint8_t> types_;  ///< of each cell
  std::vector<Index> cells_;         ///< the row of each
  std::vector<Index> points_;        ///< of all cells, `points_of` each
};

}  // namespace brindle
