/// Regular points on a surface.
#pragma once

#include <memory>

#include "BrindleFiltersModule.h"  // export macro
#include "vtkBrindleFilter.h"

/// Points where the stripes across a field and those along it cross, with normal, direction_u,
/// direction_v, spacing_u, spacing_v and the input's arrays, such as glyphs need.
class BRINDLEFILTERS_EXPORT vtkBrindleSamples : public vtkBrindleFilter {
 public:
  static vtkBrindleSamples* New();
  vtkTypeMacro(vtkBrindleSamples, vtkBrindleFilter);

  /// How many times as many stripes the second pattern has as the first; above 0.
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
