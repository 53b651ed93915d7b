#include "vtkBrindleCurves.h"

#include <cmath>
#include <string>
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

/// Lines of one process.
brindle::Polylines whole_lines(const brindle::Surface& surface,
                               const brindle::StripePattern& pattern, bool join,
                               double minimum_length) {
  brindle::CurveOptions options;
  options.join = join;
  brindle::StripeCurves curves = brindle::stripe_curves(surface, pattern, options);
  if (minimum_length > 0) curves = brindle::longer_than(curves, minimum_length);
  return std::move(curves.lines);
}

void fill(const bp::InputSurface& input, const brindle::Polylines& lines,
          const brindle::PatternQuality& quality, vtkPolyData* output) {
  output->SetPoints(bp::placed_points(*input.triangles, lines.points, lines.origin));
  output->SetLines(line_cells(lines));
  output->GetPointData()->SetNormals(bp::vtk_array(make_data_array("normal", lines.normals)));
  add_line_arrays(lines, *output->GetCellData());
  bp::carry_to_places(input, lines.places, *output->GetPointData());
  bp::add_figures(quality, *output->GetFieldData());
}

}  // namespace

vtkStandardNewMacro(vtkBrindleCurves);

vtkBrindleCurves::vtkBrindleCurves() = default;
vtkBrindleCurves::~vtkBrindleCurves() = default;

/// What needs whole lines: over several ranks they are cut where pieces end.
void vtkBrindleCurves::CheckOptions(bool alone) const {
  if (!std::isfinite(this->MinimumLength) || this->MinimumLength < 0) {
    throw brindle::Error("Minimum Length must be 0 or above");
  }
  if (alone || (!this->Join && this->MinimumLength == 0)) return;
  throw brindle::Error(std::string(this->Join ? "Join" : "Minimum Length") +
                       " needs whole lines, which are cut at the borders between ranks; turn it "
                       "off, or run ParaView with one rank");
}

void vtkBrindleCurves::Fill(Run& run, vtkPolyData* output) {
  run.ranks.together([&] { this->CheckOptions(run.ranks.alone()); });
  const brindle::StripePattern& pattern = run.pattern();
  run.begin(0.8, 0.9, "curves");
  const bp::RankPiece* piece = run.input->piece.get();
  const brindle::Polylines lines =
      piece != nullptr ? bp::piece_lines(*piece, pattern)
                       : whole_lines(*run.input->surface, pattern, this->Join, this->MinimumLength);
  run.ranks.together([&] {
    run.progress(0.9, 1).report("arrays", 0);
    fill(*run.input, lines, pattern.quality, output);
  });
}
