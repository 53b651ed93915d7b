/// Faces between partitions of a grid.
#pragma once

#include <cstdint>
#include <span>

#include <vtkSmartPointer.h>

#include "ranks.h"

class vtkDataObject;
class vtkPolyData;

namespace brindle::paraview {

/// Whether all data are cells of grids, whose surface is their outside.
bool is_grid(vtkDataObject* data);

/// Marks cells with a volume if some have none: shells of grids are no internal faces even if
/// another rank has the same. Returns other data unchanged.
vtkSmartPointer<vtkDataObject> with_solids_marked(vtkDataObject* input);

/// Collective. The surface of this rank's cells without internal faces between partitions, on any
/// ranks: faces of cells with a volume that occur twice. `numbers` are the vertex numbers of the
/// surface's points (`global_numbers`). Removes the marks of `with_solids_marked`.
vtkSmartPointer<vtkPolyData> without_walls(vtkSmartPointer<vtkPolyData> surface,
                                           std::span<const std::uint64_t> numbers,
                                           const Ranks& ranks);

}  // namespace brindle::paraview
