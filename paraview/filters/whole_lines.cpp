#include "whole_lines.h"

#include <cstddef>

#include <brindle/distributed_pattern.h>
#include <vtkAppendPolyData.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "outputs.h"
#include "surface_places.h"

namespace brindle::paraview {
namespace {

/// Collective: the points of all ranks, rank by rank, on the first; elsewhere the rank's own.
vtkSmartPointer<vtkPolyData> gathered(vtkPolyData& own, const Ranks& ranks) {
  std::vector<vtkSmartPointer<vtkDataObject>> all;
  vtkMultiProcessController::GetGlobalController()->Gather(&own, all, 0);
  if (ranks.rank() != 0) return &own;
  vtkNew<vtkAppendPolyData> together;
  for (vtkDataObject* points : all) together->AddInputDataObject(points);
  together->Update();
  return together->GetOutput();
}

vtkSmartPointer<vtkPolyData> points_with_arrays(const InputSurface& input, const Polylines& lines) {
  auto points = vtkSmartPointer<vtkPolyData>::New();
  points->SetPoints(placed_points(*input.triangles, lines.points, lines.origin));
  carry_to_places(input, lines.places, *points->GetPointData());
  return points;
}

/// What is left of the points' rows where `longer_than` leaves out lines.
std::vector<Index> rows_of_longer(const Polylines& lines, const std::vector<Index>& rows,
                                  double length) {
  std::vector<Index> left;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    if (length_of(lines, line) < length) continue;
    left.insert(left.end(), rows.begin() + lines.offsets[line],
                rows.begin() + lines.offsets[line + 1]);
  }
  return left;
}

}  // namespace

WholeLines whole_lines(const InputSurface& input, const StripePattern& pattern,
                       const LineOptions& options) {
  const RankPiece& piece = *input.piece;
  const PieceCurves cut = piece_curves(piece.part_of(pattern), options.curves);
  WholeLines whole;
  StripeCurves curves = joined_curves(piece.surface(), cut, &whole.rows);
  vtkSmartPointer<vtkPolyData> own;
  piece.ranks().together([&] { own = points_with_arrays(input, cut.lines); });
  whole.points = gathered(*own, piece.ranks());
  whole.rows = rows_of_longer(curves.lines, whole.rows, options.minimum_length);
  whole.lines = longer_than(curves, options.minimum_length).lines;
  return whole;
}

}  // namespace brindle::paraview
