#include "wave_arrays.h"

#include <array>
#include <cmath>
#include <complex>
#include <limits>

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>

#include "vtk_arrays.h"

namespace brindle::paraview {

bool is_branch(const CornerPhases& corners) {
  return corners.kind == TriangleKind::branch || corners.kind == TriangleKind::field_singularity;
}

std::vector<float> branches_at_vertices(const Mesh& mesh, std::span<const CornerPhases> corners) {
  std::vector<float> flags(mesh.vertex_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (!is_branch(corners[t])) continue;
    for (const Index vertex : mesh.triangles[t]) flags[vertex] = 1;
  }
  return flags;
}

void add_waves(const PointWaves& waves, vtkDataSetAttributes& points) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> phases, sines;
  std::vector<unsigned char> valid;
  for (std::size_t i = 0; i < waves.z.size(); ++i) {
    const bool wave = !waves.directions[i].isZero(0) && waves.z[i] != Complex(0);
    phases.push_back(wave ? std::arg(waves.z[i]) : kNan);
    sines.push_back(wave ? std::sin(phases.back()) : kNan);
    valid.push_back(wave ? 1 : 0);
  }
  points.AddArray(vtk_array("phase", 1, phases));
  points.AddArray(vtk_array("sin_phase", 1, sines));
  points.AddArray(vtk_array("direction", waves.directions));
  points.AddArray(vtk_array("frequency", 1, waves.frequencies));
  if (!waves.frequencies_wanted.empty()) {
    points.AddArray(vtk_array("frequency_wanted", 1, waves.frequencies_wanted));
  }
  points.AddArray(vtk_array("branch", 1, waves.branches));
  points.AddArray(vtk_array("valid", valid));
}

void add_figures(const PatternQuality& quality, vtkFieldData& data) {
  const auto add = [&](const char* name, double value) {
    const std::array<float, 1> figure = {static_cast<float>(value)};
    data.AddArray(vtk_array(name, 1, figure));
  };
  add("branches", static_cast<double>(quality.branches));
  add("angle_error_mean_deg", quality.angle_error_mean_deg);
  add("spacing_error_mean", quality.spacing_error_mean);
}

}  // namespace brindle::paraview
