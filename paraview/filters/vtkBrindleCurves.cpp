#include "vtkBrindleCurves.h"

#include <cmath>
#include <utility>
#include <vector>

#include <brindle/curves.h>
#include <brindle/distributed_pattern.h>
#include <brindle/error.h>
#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "filter_run.h"
#include "vtk_data.h"

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

struct LineOptions {
  brindle::CurveOptions curves;
  double minimum_length = 0;  ///< shorter lines are left out
};

/// Lines of a single process.
brindle::Polylines local_lines(const brindle::Surface& surface,
                               const brindle::StripePattern& pattern, const LineOptions& options) {
  brindle::StripeCurves curves = brindle::stripe_curves(surface, pattern, options.curves);
  if (options.minimum_length > 0) curves = brindle::longer_than(curves, options.minimum_length);
  return std::move(curves.lines);
}

/// Lines across borders, all on the first rank, with the ranks' data at their points.
struct WholeLines {
  brindle::Polylines lines;
  vtkSmartPointer<vtkPolyData> points;  ///< of the lines and others, with the input's arrays
  std::vector<brindle::Index> rows;     ///< the rows of the lines' points in these
};

/// Collective. On the first rank, the points of all ranks in rank order; elsewhere the rank's own.
vtkSmartPointer<vtkPolyData> gathered(vtkPolyData& own, const bp::Ranks& ranks) {
  std::vector<vtkSmartPointer<vtkDataObject>> all;
  vtkMultiProcessController::GetGlobalController()->Gather(&own, all, 0);
  if (ranks.rank() != 0) return &own;
  vtkNew<vtkAppendPolyData> together;
  for (vtkDataObject* points : all) together->AddInputDataObject(points);
  together->Update();
  return together->GetOutput();
}

vtkSmartPointer<vtkPolyData> points_with_arrays(const bp::InputSurface& input,
                                                const brindle::Polylines& lines) {
  auto points = vtkSmartPointer<vtkPolyData>::New();
  points->SetPoints(bp::placed_points(*input.triangles, lines.points, lines.origin));
  input.carry_to_places(lines.places, *points->GetPointData());
  return points;
}

/// The remaining rows of points after `longer_than` removed lines.
std::vector<brindle::Index> rows_of_longer(const brindle::Polylines& lines,
                                           const std::vector<brindle::Index>& rows, double length) {
  std::vector<brindle::Index> left;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    if (brindle::length_of(lines, line) < length) continue;
    left.insert(left.end(), rows.begin() + lines.offsets[line],
                rows.begin() + lines.offsets[line + 1]);
  }
  return left;
}

/// A point of a line, sent to the rank with its triangle.
struct PointOfRank {
  brindle::Vec3 position;
  brindle::TrianglePoint place;
};

/// The points of all ranks in rank order. `rows` are the rows of all points in these.
std::vector<std::vector<PointOfRank>> points_by_rank(const brindle::WholeCurves& whole,
                                                     const bp::Ranks& ranks,
                                                     std::vector<brindle::Index>& rows) {
  const brindle::Polylines& lines = whole.curves.lines;
  std::vector<std::vector<PointOfRank>> points(static_cast<std::size_t>(ranks.size()));
  for (std::size_t i = 0; i < lines.points.size(); ++i) {
    auto& of_rank = points[static_cast<std::size_t>(whole.rank_of_point[i])];
    rows.push_back(static_cast<brindle::Index>(of_rank.size()));
    of_rank.push_back({lines.points[i], lines.places[i]});
  }
  std::vector<brindle::Index> first = {0};
  for (const auto& of_rank : points) first.push_back(first.back() + brindle::Index(of_rank.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i] += first[static_cast<std::size_t>(whole.rank_of_point[i])];
  }
  return points;
}

/// Lines that the first rank makes of the whole surface.
brindle::StripeCurves lines_of_first(const bp::InputSurface& input,
                                     const brindle::PiecePattern& pattern,
                                     const brindle::CurveOptions& options, WholeLines& whole) {
  const bp::Ranks& ranks = input.piece->ranks();
  brindle::WholeCurves curves = brindle::whole_curves(pattern, options);
  const auto asked = ranks.swap_lists(points_by_rank(curves, ranks, whole.rows));
  vtkSmartPointer<vtkPolyData> own;
  ranks.throw_on_all([&] {
    brindle::Polylines points;
    points.origin = input.surface->mesh.origin;
    for (const auto& [position, place] : asked[0]) {
      points.points.push_back(position);
      points.places.push_back(place);
    }
    own = points_with_arrays(input, points);
  });
  whole.points = gathered(*own, ranks);
  return std::move(curves.curves);
}

/// Collective. Empty on all but the first rank.
WholeLines whole_lines(const bp::InputSurface& input, const brindle::StripePattern& pattern,
                       const LineOptions& options) {
  WholeLines whole;
  const brindle::StripeCurves curves =
      lines_of_first(input, input.piece->part_of(pattern), options.curves, whole);
  whole.rows = rows_of_longer(curves.lines, whole.rows, options.minimum_length);
  whole.lines = brindle::longer_than(curves, options.minimum_length).lines;
  return whole;
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
  const LineOptions options = {{.join = this->Join, .trim = this->Join ? 0 : trim, .fair = fair},
                               this->MinimumLength};
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
    const WholeLines whole = whole_lines(input, pattern, options);
    run.ranks.throw_on_all([&] {
      report();
      fill(*whole.points, whole.lines, output);
      bp::add_metrics(pattern.quality, run.metrics.waves, *output->GetFieldData());
      bp::carry(*whole.points->GetPointData(), bp::whole_rows(whole.rows), *output->GetPointData());
    });
    return;
  }
  const brindle::Polylines lines =
      input.piece ? brindle::piece_curves(input.piece->part_of(pattern), wanted).lines
                  : local_lines(*input.surface, pattern, options);
  run.ranks.throw_on_all([&] {
    report();
    fill(*input.triangles, lines, output);
    bp::add_metrics(pattern.quality, run.metrics.waves, *output->GetFieldData());
    input.carry_to_places(lines.places, *output->GetPointData());
  });
}
