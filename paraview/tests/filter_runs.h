/// Runs of the filters, and the library's equivalents.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <brindle/direction_field.h>
#include <brindle/stripe_pattern.h>
#include <brindle/wave_metrics.h>
#include <vtkFieldData.h>

#include "vtkBrindleStripes.h"
#include "vtk_surfaces.h"

namespace brindle::paraview {

enum { kSmooth, kCurvature, kDirection, kArray };
enum { kStripes, kFrequency, kFrequencyArray, kByArray, kSpacing };

inline vtkSmartPointer<vtkPolyData> swirling(const char* shape, float angle = 0) {
  auto data = polygons_of(make_shape(shape));
  add_swirl(*data, angle);
  return data;
}

/// The library's own pattern of the vectors.
inline StripePattern expected(vtkPolyData& data, const Surface& surface, float stripes,
                              float slack) {
  DirectionField directions = tangent_directions(
      [&] {
        std::vector<Vec3> vectors;
        const std::vector<float> v = numbers(data, "v");
        for (std::size_t i = 0; i < v.size(); i += 3)
          vectors.emplace_back(v[i], v[i + 1], v[i + 2]);
        return vectors;
      }(),
      surface.normals);
  StripeOptions options;
  options.slack = slack;
  const float diagonal = bounding_box(surface.mesh).diagonal();
  return stripe_pattern(surface, std::move(directions), frequency_of_stripes(stripes, diagonal),
                        options);
}

inline double area(vtkPolyData& data) {
  double sum = 0;
  for (vtkIdType t = 0; t < data.GetNumberOfPolys(); ++t) {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    data.GetPolys()->GetCellAtId(t, count, points);
    Eigen::Vector3d p[3];
    for (int k = 0; k < 3; ++k) data.GetPoint(points[k], p[k].data());
    sum += (p[1] - p[0]).cross(p[2] - p[0]).norm() / 2;
  }
  return sum;
}

inline double metric(vtkPolyData& output, const char* name) {
  return output.GetFieldData()->GetArray(name)->GetComponent(0, 0);
}

/// Whether a warning equals the library's, except for remedies.
inline bool says_the_same(const std::string& warning, const std::string& of_library) {
  return warning.find(of_library.substr(0, of_library.find(';'))) != std::string::npos;
}

/// The single error of a filter for an invalid input or setting; its output is then empty.
inline std::string only_error(vtkBrindleFilter& filter) {
  Errors errors(filter);
  filter.Update();
  EXPECT_EQ(errors.messages.size(), 1u);
  EXPECT_EQ(filter.GetOutput()->GetNumberOfPoints(), 0);
  return errors.messages.empty() ? "" : errors.messages[0];
}

}  // namespace brindle::paraview
