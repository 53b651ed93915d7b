#include "vtk_data.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>

#include <brindle/error.h>
#include <vtkAbstractArray.h>
#include <vtkCellArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

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

vtkSmartPointer<vtkPoints> empty_points(vtkPolyData& from, std::size_t count) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(from.GetPoints()->GetDataType());
  points->SetNumberOfPoints(static_cast<vtkIdType>(count));
  return points;
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

vtkSmartPointer<vtkPoints> blended_points(vtkPolyData& from, std::span<const RowBlend> blends) {
  const auto points = empty_points(from, blends.size());
  for (std::size_t i = 0; i < blends.size(); ++i) {
    const auto& [rows, weights] = blends[i];
    Eigen::Vector3d place;
    from.GetPoint(rows[0], place.data());
    if (!is_whole(blends[i])) {
      place *= weights[0];
      for (const std::size_t k : {1u, 2u}) {
        Eigen::Vector3d other;
        from.GetPoint(rows[k], other.data());
        place += weights[k] * other;
      }
    }
    points->SetPoint(static_cast<vtkIdType>(i), place.data());
  }
  return points;
}

vtkSmartPointer<vtkPoints> placed_points(vtkPolyData& from, std::span<const Vec3> points,
                                         const Eigen::Vector3d& origin) {
  const auto placed = empty_points(from, points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d place = points[i].cast<double>() + origin;
    placed->SetPoint(static_cast<vtkIdType>(i), place.data());
  }
  return placed;
}

vtkSmartPointer<vtkCellArray> triangle_cells(std::span<const std::array<Index, 3>> triangles) {
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(3 * static_cast<vtkIdType>(triangles.size()));
  vtkIdType at = 0;
  for (const auto& triangle : triangles) {
    for (const Index corner : triangle) corners->SetValue(at++, corner);
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(3, corners);
  return cells;
}

std::vector<RowBlend> whole_rows(std::span<const Index> rows) {
  std::vector<RowBlend> blends;
  blends.reserve(rows.size());
  for (const Index row : rows) blends.push_back(whole_row(row));
  return blends;
}

void add_metrics(const PatternQuality& quality, const WaveMetrics& waves, vtkFieldData& data) {
  const auto add = [&](const char* name, double value) {
    data.AddArray(vtk_array(make_data_array(name, 1, std::vector<double>{value})));
  };
  add("branches", static_cast<double>(quality.branches));
  add("angle_error_mean_deg", quality.angle_error_mean_deg);
  add("spacing_error_mean", quality.spacing_error_mean);
  add("edges_per_period_min", waves.edges_per_period_min);
  add("edges_per_period_median", waves.edges_per_period_median);
}

}  // namespace brindle::paraview
