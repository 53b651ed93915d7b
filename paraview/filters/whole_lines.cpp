#include "whole_lines.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

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

/// Collective. On the first rank, the points of all ranks in rank order; elsewhere the rank's own.
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

/// The remaining rows of points after `longer_than` removed lines.
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

/// A point of a line, sent to the rank with its triangle.
struct PointOfRank {
  std::array<float, 3> position;
  TrianglePoint place;
};

/// The points of all ranks in rank order. `rows` are the rows of all points in these.
std::vector<std::vector<PointOfRank>> points_by_rank(const WholeCurves& whole, const Ranks& ranks,
                                                     std::vector<Index>& rows) {
  const Polylines& lines = whole.curves.lines;
  std::vector<std::vector<PointOfRank>> points(static_cast<std::size_t>(ranks.size()));
  for (std::size_t i = 0; i < lines.points.size(); ++i) {
    auto& of_rank = points[static_cast<std::size_t>(whole.rank_of_point[i])];
    rows.push_back(static_cast<Index>(of_rank.size()));
    const Vec3& p = lines.points[i];
    of_rank.push_back({{p.x(), p.y(), p.z()}, lines.places[i]});
  }
  std::vector<Index> first = {0};
  for (const auto& of_rank : points) first.push_back(first.back() + Index(of_rank.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i] += first[static_cast<std::size_t>(whole.rank_of_point[i])];
  }
  return points;
}

/// Lines that the first rank makes of the whole surface.
StripeCurves lines_of_first(const InputSurface& input, const PiecePattern& pattern,
                            const CurveOptions& options, WholeLines& whole) {
  const Ranks& ranks = input.piece->ranks();
  WholeCurves curves = whole_curves(pattern, options);
  const auto asked = ranks.swap_lists(points_by_rank(curves, ranks, whole.rows));
  vtkSmartPointer<vtkPolyData> own;
  ranks.throw_on_all([&] {
    Polylines points;
    points.origin = input.surface->mesh.origin;
    for (const auto& [position, place] : asked[0]) {
      points.points.emplace_back(position.data());
      points.places.push_back(place);
    }
    own = points_with_arrays(input, points);
  });
  whole.points = gathered(*own, ranks);
  return std::move(curves.curves);
}

}  // namespace

WholeLines whole_lines(const InputSurface& input, const StripePattern& pattern,
                       const LineOptions& options) {
  const PiecePattern of_piece = input.piece->part_of(pattern);
  WholeLines whole;
  const StripeCurves curves = lines_of_first(input, of_piece, options.curves, whole);
  whole.rows = rows_of_longer(curves.lines, whole.rows, options.minimum_length);
  whole.lines = longer_than(curves, options.minimum_length).lines;
  return whole;
}

}  // namespace brindle::paraview
