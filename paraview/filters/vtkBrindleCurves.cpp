#include "vtkBrindleCurves.h"

#include <cmath>
#include <string>
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
#include "own_part.h"
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

/// Lines of the pattern on this rank's own triangles.
brindle::StripeCurves own_curves(bp::OwnPart& own, const brindle::StripePattern& pattern, bool join,
                                 double minimum_length) {
  if (own.is_empty()) return {};
  brindle::CurveOptions options;
  options.join = join;
  brindle::StripeCurves curves =
      brindle::stripe_curves(*own.surface().surface, own.pattern(pattern), options);
  return minimum_length > 0 ? brindle::longer_than(curves, minimum_length) : curves;
}

void fill(const bp::InputSurface& own, const brindle::Polylines& lines,
          const brindle::PatternQuality& quality, vtkPolyData* output) {
  output->SetPoints(bp::placed_points(*own.triangles, lines.points, lines.origin));
  output->SetLines(line_cells(lines));
  output->GetPointData()->SetNormals(bp::vtk_array(make_data_array("normal", lines.normals)));
  add_line_arrays(lines, *output->GetCellData());
  bp::carry_to_places(own, lines.places, *output->GetPointData());
  bp::add_figures(quality, *output->GetFieldData());
}

}  // namespace

vtkStandardNewMacro(vtkBrindleCurves);

vtkBrindleCurves::vtkBrindleCurves() = default;
vtkBrindleCurves::~vtkBrindleCurves() = default;

/// What needs whole lines: over several ranks those of one pattern end where its pieces do.
void vtkBrindleCurves::CheckOptions(bool alone) const {
  if (!std::isfinite(this->MinimumLength) || this->MinimumLength < 0) {
    throw brindle::Error("Minimum Length must be 0 or above");
  }
  if (alone || (!this->Join && this->MinimumLength == 0)) return;
  throw brindle::Error(std::string(this->Join ? "Join" : "Minimum Length") +
                       " needs whole lines, which end at the borders between ranks; turn it off, "
                       "or run ParaView with one rank");
}

void vtkBrindleCurves::Fill(Run& run, vtkPolyData* output) {
  run.ranks.together([&] { this->CheckOptions(run.ranks.alone()); });
  const brindle::StripePattern& pattern = run.pattern();
  run.ranks.together([&] {
    run.progress(0.8, 0.9).report("curves", 0);
    bp::OwnPart own(*run.input);
    const brindle::StripeCurves curves = own_curves(own, pattern, this->Join, this->MinimumLength);
    run.progress(0.9, 1).report("arrays", 0);
    fill(own.surface(), curves.lines, pattern.quality, output);
  });
}
