/// Evenly spaced stripes over a surface, along or across a field.
#pragma once

#include "BrindleFiltersModule.h"  // export macro
#include "vtkBrindleFilter.h"

/// Adds the phases of stripes to a surface, as docs/paraview.md lists them, and texture
/// coordinates: U is across the stripes, one unit per stripe, with 1/2 at the middle of each.
class BRINDLEFILTERS_EXPORT vtkBrindleStripes : public vtkBrindleFilter {
 public:
  static vtkBrindleStripes* New();
  vtkTypeMacro(vtkBrindleStripes, vtkBrindleFilter);

  /// Whether the output has texture coordinates, with the points and triangles that they need.
  /// Otherwise it has the input's points.
  vtkSetMacro(TextureCoordinates, bool);
  vtkGetMacro(TextureCoordinates, bool);

  vtkBrindleStripes(const vtkBrindleStripes&) = delete;
  void operator=(const vtkBrindleStripes&) = delete;

 protected:
  vtkBrindleStripes();
  ~vtkBrindleStripes() override;

  void Fill(Run& run, vtkPolyData* output) override;

 private:
  bool TextureCoordinates = true;
};
