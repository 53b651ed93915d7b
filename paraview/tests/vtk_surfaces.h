/// Surfaces in VTK's form, and results of filters.
#pragma once

#include <cmath>
#include <complex>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <brindle/mesh.h>
#include <brindle/shapes.h>
#include <brindle/surface.h>
#include <brindle/types.h>
#include <gtest/gtest.h>
#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "brindle/base/elementary.h"

namespace brindle::paraview {

/// The mesh's points, as doubles, and triangles.
inline vtkSmartPointer<vtkPolyData> polygons_of(const Mesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& p : mesh.positions) points->InsertNextPoint(p.x(), p.y(), p.z());
  vtkNew<vtkCellArray> cells;
  for (const Triangle& t : mesh.triangles) {
    cells->InsertNextCell({vtkIdType{t[0]}, vtkIdType{t[1]}, vtkIdType{t[2]}});
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

/// An array with a row for each of `rows`, computed from its number.
inline vtkSmartPointer<vtkDataArray> vectors_by(const char* name, vtkIdType rows,
                                                const std::function<Vec3(vtkIdType)>& vector) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < rows; ++i) {
    const Vec3 v = vector(i);
    array->InsertNextTuple3(v.x(), v.y(), v.z());
  }
  return array;
}

/// A vector field in space that turns with `angle`.
inline Vec3 swirl(const Vec3& p, float angle) {
  return {std::cos(angle) - p.y(), std::sin(angle) + p.x(), 0.5f + p.z()};
}

inline void add_swirl(vtkPolyData& data, float angle) {
  data.GetPointData()->AddArray(vectors_by("v", data.GetNumberOfPoints(), [&](vtkIdType i) {
    double p[3];
    data.GetPoint(i, p);
    return swirl({float(p[0]), float(p[1]), float(p[2])}, angle);
  }));
}

inline void choose(vtkAlgorithm& filter, int use, const char* name, bool points = true) {
  filter.SetInputArrayToProcess(
      use, 0, 0,
      points ? vtkDataObject::FIELD_ASSOCIATION_POINTS : vtkDataObject::FIELD_ASSOCIATION_CELLS,
      name);
}

inline void set_time(vtkDataObject& data, double time) {
  data.GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
}

/// Errors of a filter, in order.
class Errors {
 public:
  explicit Errors(vtkObject& of, unsigned long event = vtkCommand::ErrorEvent) : of_(of) {
    command_->SetClientData(&messages);
    command_->SetCallback([](vtkObject*, unsigned long, void* to, void* message) {
      static_cast<std::vector<std::string>*>(to)->push_back(static_cast<const char*>(message));
    });
    of.AddObserver(event, command_);
  }
  ~Errors() { of_.RemoveObserver(command_); }
  Errors(const Errors&) = delete;
  Errors& operator=(const Errors&) = delete;

  std::vector<std::string> messages;

 private:
  vtkObject& of_;
  vtkNew<vtkCallbackCommand> command_;
};

/// The numbers of a point array, row by row.
inline std::vector<float> numbers(vtkDataSet& data, const char* name) {
  std::vector<float> result;
  vtkDataArray* array = data.GetPointData()->GetArray(name);
  if (array == nullptr) {
    ADD_FAILURE() << "no array " << name;
    return result;
  }
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c) {
      result.push_back(static_cast<float>(array->GetComponent(i, c)));
    }
  }
  return result;
}

/// Expects these phases at the first points of an output, bit for bit.
inline void expect_phases(vtkDataSet& output, std::span<const Complex> z) {
  const std::vector<float> phases = numbers(output, "phase");
  ASSERT_GE(phases.size(), z.size());
  for (std::size_t i = 0; i < z.size(); ++i) {
    ASSERT_EQ(phases[i], elementary::arg(z[i])) << "at vertex " << i;
  }
}

}  // namespace brindle::paraview
