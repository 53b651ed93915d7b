/// A surface with its stripes drawn pixel by pixel.
#pragma once

#include <string>

#include <vtkGeometryRepresentationWithFaces.h>
#include <vtkNew.h>

#include "BrindleFiltersModule.h"  // export macro

class vtkTexture;

/// Draws stripes where texture coordinates say so, as vtkBrindleStripes makes them, over whatever
/// colour a surface has. U is evaluated at every pixel and averaged over it, so that borders are
/// sharp from near and even from afar, where a picture would have pixels of its own. A surface
/// without texture coordinates is drawn without stripes.
class BRINDLEFILTERS_EXPORT vtkBrindleStripesRepresentation
    : public vtkGeometryRepresentationWithFaces {
 public:
  static vtkBrindleStripesRepresentation* New();
  vtkTypeMacro(vtkBrindleStripesRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Red, green and blue from 0 to 1.
  vtkSetVector3Macro(StripeColor, double);
  vtkGetVector3Macro(StripeColor, double);
  /// The share of a period that a stripe covers, from 0 to 1.
  vtkSetClampMacro(StripeWidth, double, 0, 1);
  vtkGetMacro(StripeWidth, double);
  /// How much of the surface's colour stripes cover, from 0 to 1.
  vtkSetClampMacro(StripeOpacity, double, 0, 1);
  vtkGetMacro(StripeOpacity, double);

  /// Surfaces have texture coordinates on their way to the screen only if there is a texture.
  void SetTexture(vtkTexture* texture) override;
  /// Colours that are interpolated as numbers take the place of texture coordinates: here they are
  /// interpolated as colours.
  void SetInterpolateScalarsBeforeMapping(int) override;
  void SetUseShaderReplacements(bool use) override;
  void SetShaderReplacements(const char* replacements) override;

  int ProcessViewRequest(vtkInformationRequestKey* request, vtkInformation* in,
                         vtkInformation* out) override;

  vtkBrindleStripesRepresentation(const vtkBrindleStripesRepresentation&) = delete;
  void operator=(const vtkBrindleStripesRepresentation&) = delete;

 protected:
  vtkBrindleStripesRepresentation();
  ~vtkBrindleStripesRepresentation() override;

  void UpdateColoringParameters() override;

 private:
  std::string StripeShader() const;
  void UpdateStripes();

  double StripeColor[3] = {0.08, 0.09, 0.12};
  double StripeWidth = 0.5;
  double StripeOpacity = 1;
  vtkNew<vtkTexture> White;
  std::string Shader;  ///< that the actor has now; empty: none
};
