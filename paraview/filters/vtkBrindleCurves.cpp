#include "vtkBrindleCurves.h"

#include <cmath>
#include <vector>

#include <brindle/curves.h>
#include <brindle/error.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "filter_run.h"
#include "outputs.h"
#include "surface_places.h"
#include "vtk_arrays.h"

using brindle::make_data_array;
namespace bp = brindle::paraview;

namespace {

vtkSmartPointer<vtkCellArray> line_cells(const brindle::Polylines& lines) {
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (std::size_t line = 0; line < lines.count(); ++line) {
    const brindle::Index begin = lines.offsets[line], end = lines.offsets[line + 1];
    cells->InsertNextCell(static_cast<int>(end - begin) + lines.closed[line]);
    for (brindle::Index point = begin; point < end; ++point) cells->InsertCellPoint(point);
    if (lines.closed[line] != 0) cells->InsertCellPoint(begin);
  }
  return cells;
}

void add_line_arrays(const brindle::Polylines& lines, vtkCellData& cells) {
  std::vector<float> lengths;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    lengths.push_back(static_cast<float>(brindle::length_of(lines, line)));
  }
  cells.AddArray(bp::vtk_array(make_data_array("closed", 1, lines.closed)));
  cells.AddArray(bp::vtk_array(make_data_array("length", 1, lengths)));
}

}  // namespace

vtkStandardNewMacro(vtkBrindleCurves);

vtkBrindleCurves::vtkBrindleCurves() = default;
vtkBrindleCurves::~vtkBrindleCurves() = default;

void vtkBrindleCurves::Fill(Run& run, vtkPolyData* output) {
  if (!std::isfinite(this->MinimumLength) || this->MinimumLength < 0) {
    throw brindle::Error("Minimum Length must be 0 or above");
  }
  const brindle::StripePattern& pattern = run.pattern();
  run.progress(0.8, 0.9).report("curves", 0);
  brindle::CurveOptions options;
  options.join = this->Join;
  brindle::StripeCurves curves = brindle::stripe_curves(*run.input->surface, pattern, options);
  if (this->MinimumLength > 0) curves = brindle::longer_than(curves, this->MinimumLength);
  const brindle::Polylines& lines = curves.lines;

  run.progress(0.9, 1).report("arrays", 0);
  output->SetPoints(bp::placed_points(*run.input->triangles, lines.points, lines.origin));
  output->SetLines(line_cells(lines));
  output->GetPointData()->SetNormals(bp::vtk_array(make_data_array("normal", lines.normals)));
  add_line_arrays(lines, *output->GetCellData());
  bp::carry_to_places(*run.input, lines.places, *output->GetPointData());
  bp::add_figures(pattern.quality, *output->GetFieldData());
}
