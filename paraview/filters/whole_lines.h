/// Centre lines of stripes of all ranks, joined on the first.
#pragma once

#include <vector>

#include <brindle/polylines.h>
#include <brindle/stripe_pattern.h>
#include <vtkSmartPointer.h>

#include "surface_cache.h"

class vtkPolyData;

namespace brindle::paraview {

struct LineOptions {
  CurveOptions curves;
  double minimum_length = 0;  ///< shorter lines are left out
};

/// Lines across borders, with the ranks' data at their points.
struct WholeLines {
  Polylines lines;
  vtkSmartPointer<vtkPolyData> points;  ///< of the lines and others, with the input's arrays
  std::vector<Index> rows;              ///< the rows of the lines' points in these
};

/// Collective. All lines on the first rank, with the arrays that all ranks have; empty elsewhere.
WholeLines whole_lines(const InputSurface& input, const StripePattern& pattern,
                       const LineOptions& options);

}  // namespace brindle::paraview
