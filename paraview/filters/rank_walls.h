/// Faces between the pieces of a grid.
#pragma once

#include <vtkSmartPointer.h>

#include "ranks.h"

class vtkDataObject;
class vtkPolyData;

namespace brindle::paraview {

/// Whether data are cells of grids alone, whose surface is what is outside.
bool is_grid(vtkDataObject* data);

/// Collective. The surface of this rank's cells without the faces at which another rank's cells
/// lie: those that another rank's surface has, too, with points at exactly the same places.
vtkSmartPointer<vtkPolyData> without_walls(vtkSmartPointer<vtkPolyData> surface,
                                           const Ranks& ranks);

}  // namespace brindle::paraview
