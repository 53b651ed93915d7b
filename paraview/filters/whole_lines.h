/// The middles of stripes of all ranks, put together.
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

/// Lines that go on over borders, with what the ranks know of their points.
struct WholeLines {
  Polylines lines;
  vtkSmartPointer<vtkPolyData> points;  ///< of the lines and others, with the input's arrays
  std::vector<Index> rows;              ///< of the lines' points in these
};

/// Collective. All on the first rank, with the arrays that all ranks have; elsewhere none.
WholeLines whole_lines(const InputSurface& input, const StripePattern& pattern,
                       const LineOptions& options);

}  // namespace brindle::paraview
