/// Faces between the pieces of a grid.
#pragma once

#include <cstdint>
#include <span>

#include <vtkSmartPointer.h>

#include "ranks.h"

class vtkDataObject;
class vtkPolyData;

namespace brindle::paraview {

/// Whether data are cells of grids alone, whose surface is what is outside.
bool is_grid(vtkDataObject* data);

/// Grids whose cells say whether they have a volume, if some have none: shells of grids are no
/// walls, wherever others have the same. Other data as they are.
vtkSmartPointer<vtkDataObject> with_solids_marked(vtkDataObject* input);

/// Collective. The surface of this rank's cells without the faces at which another piece's cells
/// lie, on this rank or another: those of cells with a volume that are there twice, with the same
/// vertices. `numbers` says of the surface's points which vertex they are (`global_numbers`). Marks
/// of `with_solids_marked` go.
vtkSmartPointer<vtkPolyData> without_walls(vtkSmartPointer<vtkPolyData> surface,
                                           std::span<const std::uint64_t> numbers,
                                           const Ranks& ranks);

}  // namespace brindle::paraview
