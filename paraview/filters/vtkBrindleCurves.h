/// Centre lines of stripes.
#pragma once

#include "BrindleFiltersModule.h"  // export macro
#include "vtkBrindleFilter.h"

/// One polyline per stripe, with normals and the input's arrays at its points; per line whether it
/// is closed, and its length. Over several ranks lines are cut at the borders, but for those that
/// `Join`, `Fair` or `MinimumLength` asks for: these are whole, and on the first rank.
class BRINDLEFILTERS_EXPORT vtkBrindleCurves : public vtkBrindleFilter {
 public:
  static vtkBrindleCurves* New();
  vtkTypeMacro(vtkBrindleCurves, vtkBrindleFilter);

  /// Joins curves that end in one branch, and extends others to a neighbour.
  vtkSetMacro(Join, bool);
  vtkGetMacro(Join, bool);
  /// Ends at branches are cut back to where no neighbour is nearer than this share of the spacing;
  /// 0 to 1, 0 leaves them. Not of joined curves, whose ends run into their neighbours.
  vtkSetMacro(Trim, double);
  vtkGetMacro(Trim, double);
  /// Smooths kinks shorter than about this share of the spacing; 0 to 1, 0: none. Needs the whole
  /// surface on one rank.
  vtkSetMacro(Fair, double);
  vtkGetMacro(Fair, double);
  /// Leaves out shorter curves; 0 or above, in units of length.
  vtkSetMacro(MinimumLength, double);
  vtkGetMacro(MinimumLength, double);

  vtkBrindleCurves(const vtkBrindleCurves&) = delete;
  void operator=(const vtkBrindleCurves&) = delete;

 protected:
  vtkBrindleCurves();
  ~vtkBrindleCurves() override;

  void Fill(Run& run, vtkPolyData* output) override;

 private:
  bool Join = false;
  double Trim;
  double Fair = 0;
  double MinimumLength = 0;
};
