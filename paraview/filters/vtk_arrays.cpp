#include "vtk_arrays.h"

#include <algorithm>
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

std::optional<NumberType> signed_type(int bytes) {
  switch (bytes) {
    case 1:
      return NumberType::int8;
    case 2:
      return NumberType::int16;
    case 4:
      return NumberType::int32;
    case 8:
      return NumberType::int64;
    default:
      return std::nullopt;
  }
}

std::optional<NumberType> number_type_of(const vtkDataArray& array) {
  const int bytes = array.GetDataTypeSize();
  switch (array.GetDataType()) {
    case VTK_FLOAT:
      return NumberType::float32;
    case VTK_DOUBLE:
      return NumberType::float64;
    case VTK_UNSIGNED_CHAR:
      return NumberType::uint8;
    case VTK_UNSIGNED_SHORT:
      return NumberType::uint16;
    case VTK_UNSIGNED_INT:
      return NumberType::uint32;
    case VTK_UNSIGNED_LONG:
    case VTK_UNSIGNED_LONG_LONG:
      return bytes == 8 ? NumberType::uint64 : NumberType::uint32;
    case VTK_BIT:
      return std::nullopt;
    default:
      return signed_type(bytes);
  }
}

std::string name_of(vtkAbstractArray& array) {
  return array.GetName() == nullptr ? std::string() : std::string(array.GetName());
}

int vtk_type_of(NumberType type) {
  switch (type) {
    case NumberType::float32:
      return VTK_FLOAT;
    case NumberType::float64:
      return VTK_DOUBLE;
    case NumberType::int8:
      return VTK_SIGNED_CHAR;
    case NumberType::uint8:
      return VTK_UNSIGNED_CHAR;
    case NumberType::int16:
      return VTK_SHORT;
    case NumberType::uint16:
      return VTK_UNSIGNED_SHORT;
    case NumberType::int32:
      return VTK_INT;
    case NumberType::uint32:
      return VTK_UNSIGNED_INT;
    case NumberType::int64:
      return VTK_LONG_LONG;
    case NumberType::uint64:
      break;
  }
  return VTK_UNSIGNED_LONG_LONG;
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
  const auto made =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(vtk_type_of(array.type)));
  made->SetName(array.name.c_str());
  made->SetNumberOfComponents(array.components);
  made->SetNumberOfTuples(static_cast<vtkIdType>(array.rows()));
  if (!array.bytes.empty()) {
    std::memcpy(made->GetVoidPointer(0), array.bytes.data(), array.bytes.size());
  }
  return made;
}

void carry(vtkDataSetAttributes& from, std::span<const RowBlend> blends, vtkDataSetAttributes& to) {
  vtkNew<vtkIdList> rows;
  rows->SetNumberOfIds(static_cast<vtkIdType>(blends.size()));
  for (std::size_t i = 0; i < blends.size(); ++i) {
    rows->SetId(static_cast<vtkIdType>(i), heaviest_row(blends[i]));
  }
  for (int a = 0; a < from.GetNumberOfArrays(); ++a) {
    vtkAbstractArray& array = *from.GetAbstractArray(a);
    if (array.GetName() != nullptr && to.HasArray(array.GetName()) != 0) continue;
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
