#include "blocks.h"

#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkUnsignedCharArray.h>

namespace brindle::paraview {
namespace {

template <class Visit>
void for_each_leaf(vtkCompositeDataSet& data, const Visit& visit) {
  const auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(data.NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem()) visit(leaf.Get());
}

}  // namespace

std::vector<vtkDataSet*> blocks_of(vtkDataObject* data) {
  std::vector<vtkDataSet*> blocks;
  const auto add = [&](vtkDataObject* object) {
    if (auto* block = vtkDataSet::SafeDownCast(object)) blocks.push_back(block);
  };
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data)) {
    for_each_leaf(*composite, [&](auto* leaf) { add(leaf->GetCurrentDataObject()); });
  } else {
    add(data);
  }
  return blocks;
}

vtkSmartPointer<vtkDataObject> with_blocks(
    vtkDataObject* data,
    const std::function<vtkSmartPointer<vtkDataSet>(vtkDataSet& block)>& change) {
  if (auto* block = vtkDataSet::SafeDownCast(data)) return change(*block);
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (composite == nullptr) return data;
  auto copy = vtkSmartPointer<vtkCompositeDataSet>::Take(composite->NewInstance());
  copy->CopyStructure(composite);
  for_each_leaf(*composite, [&](auto* leaf) {
    auto* block = vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject());
    copy->SetDataSet(leaf, block != nullptr ? change(*block).Get() : leaf->GetCurrentDataObject());
  });
  return copy;
}

vtkSmartPointer<vtkDataSet> with_flags(vtkDataSet& data, vtkUnsignedCharArray* flags) {
  auto copy = vtkSmartPointer<vtkDataSet>::Take(data.NewInstance());
  copy->ShallowCopy(&data);
  copy->GetCellData()->AddArray(flags);
  return copy;
}

}  // namespace brindle::paraview
