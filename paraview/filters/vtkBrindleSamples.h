/// Regular points on a surface.
#pragma once

#include <memory>

#include "BrindleFiltersModule.h"  // export macro
#include "vtkBrindleFilter.h"

/// Crossings of the stripes across a field with those along it, for glyphs, with normal,
/// direction_u, direction_v, spacing_u, spacing_v and the input's arrays.
class BRINDLEFILTERS_EXPORT vtkBrindleSamples : public vtkBrindleFilter {
 public:
  static vtkBrindleSamples* New();
  vtkTypeMacro(vtkBrindleSamples, vtkBrindleFilter);

  /// The frequency of the second pattern relative to the first; above 0.
  vtkSetMacro(CrossingFactor, double);
  vtkGetMacro(CrossingFactor, double);

  vtkBrindleSamples(const vtkBrindleSamples&) = delete;
  void operator=(const vtkBrindleSamples&) = delete;

 protected:
  vtkBrindleSamples();
  ~vtkBrindleSamples() override;

  void Fill(Run& run, vtkPolyData* output) override;

 private:
  struct Crossing;

  double CrossingFactor = 1;
  std::unique_ptr<Crossing> Second;
};
