#include "vtkBrindleSamples.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <brindle/direction_field.h>
#include <brindle/distributed_pattern.h>
#include <brindle/error.h>
#include <brindle/pattern_warnings.h>
#include <brindle/samples.h>
#include <vtkCellArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "filter_run.h"
#include "vtk_data.h"

using brindle::make_data_array;
using brindle::Sample;
namespace bp = brindle::paraview;

/// The pattern along the field.
struct vtkBrindleSamples::Crossing {
  bp::PatternSeries series;
};

namespace {

/// The waves turned by 90 degrees, with `factor` times the frequency.
brindle::WaveSet crossing_waves(const brindle::Surface& surface, const brindle::WaveSet& waves,
                                double factor) {
  brindle::WaveSet crossing = waves;
  crossing.directions =
      brindle::rotated(waves.directions, surface.normals, std::numbers::pi_v<float> / 2);
  for (float& frequency : crossing.frequencies) frequency *= static_cast<float>(factor);
  return crossing;
}

/// Samples of one process, or of this rank's own triangles; unique over all ranks.
std::vector<Sample> crossings_of(const bp::InputSurface& input, const brindle::StripePattern& u,
                                 const brindle::StripePattern& v) {
  if (!input.piece) return brindle::stripe_samples(*input.surface, u, v);
  std::vector<Sample> samples =
      brindle::wave_samples(input.piece->part_of(u), input.piece->part_of(v));
  brindle::drop_doubles(input.piece->surface(), samples);
  return samples;
}

/// One cell per point.
vtkSmartPointer<vtkCellArray> vertex_cells(std::size_t count) {
  vtkNew<vtkIdTypeArray> points;
  points->SetNumberOfValues(static_cast<vtkIdType>(count));
  for (vtkIdType i = 0; i < points->GetNumberOfValues(); ++i) points->SetValue(i, i);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(1, points);
  return cells;
}

template <class Value, class Member>
std::vector<Value> each(const std::vector<Sample>& samples, Member Sample::*member) {
  std::vector<Value> values;
  for (const Sample& sample : samples) values.push_back(sample.*member);
  return values;
}

void add_sample_arrays(const std::vector<Sample>& samples, vtkPointData& points) {
  using brindle::Vec3;
  points.SetNormals(bp::vtk_array(make_data_array("normal", each<Vec3>(samples, &Sample::normal))));
  points.AddArray(
      bp::vtk_array(make_data_array("direction_u", each<Vec3>(samples, &Sample::direction_u))));
  points.AddArray(
      bp::vtk_array(make_data_array("direction_v", each<Vec3>(samples, &Sample::direction_v))));
  points.AddArray(
      bp::vtk_array(make_data_array("spacing_u", 1, each<float>(samples, &Sample::spacing_u))));
  points.AddArray(
      bp::vtk_array(make_data_array("spacing_v", 1, each<float>(samples, &Sample::spacing_v))));
}

std::vector<brindle::TrianglePoint> places_of(const std::vector<Sample>& samples) {
  std::vector<brindle::TrianglePoint> places;
  for (const Sample& sample : samples) {
    const Eigen::Vector3d at = sample.barycentric.cast<double>();
    places.push_back({sample.triangle, {at.x(), at.y(), at.z()}});
  }
  return places;
}

void fill(const bp::InputSurface& input, const std::vector<Sample>& samples, vtkPolyData* output) {
  output->SetPoints(bp::placed_points(*input.triangles,
                                      each<brindle::Vec3>(samples, &Sample::position),
                                      input.surface->mesh.origin));
  output->SetVerts(vertex_cells(samples.size()));
  add_sample_arrays(samples, *output->GetPointData());
  input.carry_to_places(places_of(samples), *output->GetPointData());
}

}  // namespace

vtkStandardNewMacro(vtkBrindleSamples);

vtkBrindleSamples::vtkBrindleSamples() : Second(std::make_unique<Crossing>()) {}
vtkBrindleSamples::~vtkBrindleSamples() = default;

void vtkBrindleSamples::Fill(Run& run, vtkPolyData* output) {
  run.ranks.throw_on_all([&] {
    if (std::isfinite(this->CrossingFactor) && this->CrossingFactor > 0) return;
    throw brindle::Error("Crossing Factor must be above 0");
  });
  brindle::WaveSet crossing = crossing_waves(*run.input->surface, run.waves, this->CrossingFactor);
  if (this->CrossingFactor != 1) run.metrics.crossing = bp::wave_metrics(run.surface(), crossing);
  const brindle::StripePattern& u = run.pattern();
  const brindle::StripePattern& v = this->Second->series.next(
      run.surface(), std::move(crossing), run.options, run.follows, run.progress(0.7, 0.8));
  run.metrics.quality = worse_of(u.quality, v.quality);
  run.begin(0.8, 0.9, "samples");
  const std::vector<Sample> samples = crossings_of(*run.input, u, v);
  run.ranks.throw_on_all([&] {
    run.progress(0.9, 1).report("arrays", 0);
    fill(*run.input, samples, output);
  });
}
