/// Data sets of composite data.
#pragma once

#include <functional>
#include <vector>

#include <vtkSmartPointer.h>

class vtkDataObject;
class vtkDataSet;
class vtkUnsignedCharArray;

namespace brindle::paraview {

/// All blocks that are data sets; of a single data set, that one.
std::vector<vtkDataSet*> blocks_of(vtkDataObject* data);

/// The data with `change` of every block that is a data set.
vtkSmartPointer<vtkDataObject> with_blocks(
    vtkDataObject* data,
    const std::function<vtkSmartPointer<vtkDataSet>(vtkDataSet& block)>& change);

/// The same data with one more array, of cells.
vtkSmartPointer<vtkDataSet> with_flags(vtkDataSet& data, vtkUnsignedCharArray* flags);

}  // namespace brindle::paraview
