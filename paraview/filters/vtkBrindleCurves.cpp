#include "vtkBrindleCurves.h"

#include <cmath>
#include <utility>
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
#include "piece_lines.h"
#include "surface_places.h"
#include "vtk_arrays.h"
#include "whole_lines.h"

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

/// Lines of a single process.
brindle::Polylines local_lines(const brindle::Surface& surface,
                               const brindle::StripePattern& pattern,
                               const bp::LineOptions& options) {
  brindle::StripeCurves curves = brindle::stripe_curves(surface, pattern, options.curves);
  if (options.minimum_length > 0) curves = brindle::longer_than(curves, options.minimum_length);
  return std::move(curves.lines);
}

/// All but metrics and the input's arrays; points have the type of those of `from`.
void fill(vtkPolyData& from, const brindle::Polylines& lines, vtkPolyData* output) {
  output->SetPoints(bp::placed_points(from, lines.points, lines.origin));
  output->SetLines(line_cells(lines));
  output->GetPointData()->SetNormals(bp::vtk_array(make_data_array("normal", lines.normals)));
  add_line_arrays(lines, *output->GetCellData());
}

}  // namespace

vtkStandardNewMacro(vtkBrindleCurves);

vtkBrindleCurves::vtkBrindleCurves() : Trim(brindle::CurveOptions::kTrim) {}
vtkBrindleCurves::~vtkBrindleCurves() = default;

void vtkBrindleCurves::Fill(Run& run, vtkPolyData* output) {
  const auto trim = static_cast<float>(this->Trim), fair = static_cast<float>(this->Fair);
  const bp::LineOptions options = {
      {.join = this->Join, .trim = this->Join ? 0 : trim, .fair = fair}, this->MinimumLength};
  run.ranks.throw_on_all([&] {
    if (std::isfinite(options.minimum_length) && options.minimum_length >= 0) return;
    throw brindle::Error("Minimum Length must be 0 or above");
  });
  const brindle::StripePattern& pattern = run.pattern();
  run.begin(0.8, 0.9, "curves");
  const bp::InputSurface& input = *run.input;
  const auto report = [&] { run.progress(0.9, 1).report("arrays", 0); };
  // The length and continuation of cut lines are unknown.
  const brindle::CurveOptions& wanted = options.curves;
  const bool whole_ones = wanted.join || wanted.fair != 0 || options.minimum_length > 0;
  if (input.piece && whole_ones) {
    const bp::WholeLines whole = bp::whole_lines(input, pattern, options);
    run.ranks.throw_on_all([&] {
      report();
      fill(*whole.points, whole.lines, output);
      bp::add_metrics(pattern.quality, run.metrics.waves, *output->GetFieldData());
      bp::carry(*whole.points->GetPointData(), bp::whole_rows(whole.rows), *output->GetPointData());
    });
    return;
  }
  const brindle::Polylines lines = input.piece ? bp::piece_lines(*input.piece, pattern, wanted)
                                               : local_lines(*input.surface, pattern, options);
  run.ranks.throw_on_all([&] {
    report();
    fill(*input.triangles, lines, output);
    bp::add_metrics(pattern.quality, run.metrics.waves, *output->GetFieldData());
    bp::carry_to_places(input, lines.places, *output->GetPointData());
  });
}
