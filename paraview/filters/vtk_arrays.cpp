#include "vtk_arrays.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>

#include <brindle/error.h>
#include <vtkAbstractArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>

namespace brindle::paraview {
namespace {

/// VTK's types in the order of NumberType.
constexpr std::array kVtkTypes = {
    VTK_FLOAT,          VTK_DOUBLE, VTK_SIGNED_CHAR,  VTK_UNSIGNED_CHAR, VTK_SHORT,
    VTK_UNSIGNED_SHORT, VTK_INT,    VTK_UNSIGNED_INT, VTK_LONG_LONG,     VTK_UNSIGNED_LONG_LONG};

/// VTK has several types of integers of one size.
std::optional<NumberType> number_type_of(const vtkDataArray& array) {
  const int type = array.GetDataType();
  if (type == VTK_FLOAT) return NumberType::float32;
  if (type == VTK_DOUBLE) return NumberType::float64;
  if (type == VTK_BIT) return std::nullopt;
  const int exponent = std::countr_zero(static_cast<unsigned>(array.GetDataTypeSize()));
  const bool is_unsigned = vtkDataArray::GetDataTypeMin(type) == 0;
  return static_cast<NumberType>(static_cast<int>(NumberType::int8) + 2 * exponent +
                                 (is_unsigned ? 1 : 0));
}

std::string name_of(vtkAbstractArray& array) {
  return array.GetName() == nullptr ? std::string() : std::string(array.GetName());
}

bool is_whole(const RowBlend& blend) {
  return blend.rows[0] == blend.rows[1] && blend.rows[1] == blend.rows[2];
}

Index heaviest_row(const RowBlend& blend) {
  const auto heaviest = std::max_element(blend.weights.begin(), blend.weights.end());
  return blend.rows[static_cast<std::size_t>(heaviest - blend.weights.begin())];
}

void interpolate(vtkAbstractArray& from, std::span<const RowBlend> blends, vtkAbstractArray& to) {
  vtkNew<vtkIdList> rows;
  rows->SetNumberOfIds(3);
  for (std::size_t i = 0; i < blends.size(); ++i) {
    if (is_whole(blends[i])) continue;
    for (vtkIdType k = 0; k < 3; ++k) rows->SetId(k, blends[i].rows[static_cast<std::size_t>(k)]);
    to.InterpolateTuple(static_cast<vtkIdType>(i), rows, &from,
                        const_cast<double*>(blends[i].weights.data()));
  }
}

bool is_floating(const vtkAbstractArray& array) {
  return array.GetDataType() == VTK_FLOAT || array.GetDataType() == VTK_DOUBLE;
}

void keep_active(vtkDataSetAttributes& from, vtkDataSetAttributes& to) {
  for (const int kind : {vtkDataSetAttributes::SCALARS, vtkDataSetAttributes::VECTORS,
                         vtkDataSetAttributes::NORMALS, vtkDataSetAttributes::TENSORS}) {
    vtkAbstractArray* active = from.GetAbstractAttribute(kind);
    if (active == nullptr || active->GetName() == nullptr) continue;
    if (to.GetAbstractAttribute(kind) == nullptr) to.SetActiveAttribute(active->GetName(), kind);
  }
}

}  // namespace

DataArray data_array_of(vtkDataArray& array) {
  const std::optional<NumberType> type = number_type_of(array);
  if (!type) throw Error("the array '" + name_of(array) + "' has bits, and no numbers");
  DataArray result{name_of(array), *type, array.GetNumberOfComponents(), {}};
  const auto copy = [&](vtkDataArray& from) {
    const auto count = static_cast<std::size_t>(from.GetNumberOfValues());
    result.bytes.resize(count * size_of(result.type));
    if (count > 0) std::memcpy(result.bytes.data(), from.GetVoidPointer(0), result.bytes.size());
  };
  if (array.HasStandardMemoryLayout()) {
    copy(array);
  } else {  // such as an array per component
    vtkNew<vtkDoubleArray> packed;
    packed->DeepCopy(&array);
    result.type = NumberType::float64;
    copy(*packed);
  }
  return result;
}

vtkSmartPointer<vtkDataArray> vtk_array(const DataArray& array) {
  const auto made = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(kVtkTypes[static_cast<std::size_t>(array.type)]));
  made->SetName(array.name.c_str());
  made->SetNumberOfComponents(array.components);
  made->SetNumberOfTuples(static_cast<vtkIdType>(array.rows()));
  if (!array.bytes.empty()) {
    std::memcpy(made->GetVoidPointer(0), array.bytes.data(), array.bytes.size());
  }
  return made;
}

std::vector<double> doubles_of(const DataArray& array) {
  const vtkSmartPointer<vtkDataArray> copy = vtk_array(array);
  std::vector<double> numbers;
  for (vtkIdType row = 0; row < copy->GetNumberOfTuples(); ++row) {
    for (int c = 0; c < array.components; ++c) numbers.push_back(copy->GetComponent(row, c));
  }
  return numbers;
}

void carry(vtkDataSetAttributes& from, std::span<const RowBlend> blends, vtkDataSetAttributes& to) {
  vtkNew<vtkIdList> rows;
  rows->SetNumberOfIds(static_cast<vtkIdType>(blends.size()));
  Index largest = 0;
  for (std::size_t i = 0; i < blends.size(); ++i) {
    rows->SetId(static_cast<vtkIdType>(i), heaviest_row(blends[i]));
    for (const Index row : blends[i].rows) largest = std::max(largest, row);
  }
  for (int a = 0; a < from.GetNumberOfArrays(); ++a) {
    vtkAbstractArray& array = *from.GetAbstractArray(a);
    if (array.GetName() != nullptr && to.HasArray(array.GetName()) != 0) continue;
    if (array.GetNumberOfTuples() <= largest) continue;
    const auto carried = vtkSmartPointer<vtkAbstractArray>::Take(array.NewInstance());
    carried->SetName(array.GetName());
    carried->SetNumberOfComponents(array.GetNumberOfComponents());
    carried->CopyComponentNames(&array);
    carried->SetNumberOfTuples(static_cast<vtkIdType>(blends.size()));
    array.GetTuples(rows, carried);
    if (is_floating(array)) interpolate(array, blends, *carried);
    to.AddArray(carried);
  }
  keep_active(from, to);
}

}  // namespace brindle::paraview
