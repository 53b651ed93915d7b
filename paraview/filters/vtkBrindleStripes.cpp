#include "vtkBrindleStripes.h"

#include <vector>

#include <brindle/pattern_arrays.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "filter_run.h"
#include "stripe_surface.h"
#include "vtk_data.h"

namespace bp = brindle::paraview;

vtkStandardNewMacro(vtkBrindleStripes);

vtkBrindleStripes::vtkBrindleStripes() = default;
vtkBrindleStripes::~vtkBrindleStripes() = default;

namespace {

/// All but the metrics.
void fill(const bp::InputSurface& input, const bp::StripeSurface& surface, float turn_deg,
          vtkPolyData* output) {
  vtkPolyData& from = *input.triangles;
  output->SetPoints(bp::blended_points(from, surface.sources));
  output->SetPolys(bp::triangle_cells(surface.triangles));

  vtkPointData& points = *output->GetPointData();
  for (const brindle::DataArray& array : surface.point_arrays)
    points.AddArray(bp::vtk_array(array));
  if (!surface.coordinates.empty()) {
    points.SetTCoords(bp::vtk_array(brindle::make_data_array("uv", 2, surface.coordinates)));
  }
  bp::carry(*from.GetPointData(), surface.sources, points);
  points.RemoveArray(brindle::kTurnArray);  // the input's belongs to other waves
  std::vector<brindle::DataArray> turn;
  brindle::add_turn(turn, turn_deg, surface.sources.size());
  for (const brindle::DataArray& array : turn) points.AddArray(bp::vtk_array(array));
  output->GetCellData()->AddArray(bp::vtk_array(surface.branches));
  bp::carry(*from.GetCellData(), bp::whole_rows(surface.cells), *output->GetCellData());
  output->GetFieldData()->PassData(from.GetFieldData());
}

}  // namespace

void vtkBrindleStripes::Fill(Run& run, vtkPolyData* output) {
  const brindle::StripePattern& pattern = run.pattern();
  run.begin(0.8, 0.9, "texture coordinates");
  const bp::VertexNotes notes{bp::branches_at_vertices(*run.input, pattern), run.support};
  run.ranks.throw_on_all([&] {
    const bp::StripeSurface surface = this->TextureCoordinates
                                          ? bp::textured_surface(*run.input, pattern, notes)
                                          : bp::plain_surface(*run.input, pattern, notes);
    run.progress(0.9, 1).report("arrays", 0);
    fill(*run.input, surface, run.turn_deg, output);
    bp::add_metrics(pattern.quality, run.metrics.waves, *output->GetFieldData());
  });
}
