/// A surface with stripes drawn per pixel.
#pragma once

#include <string>

#include <vtkGeometryRepresentationWithFaces.h>
#include <vtkNew.h>

#include "BrindleFiltersModule.h"  // export macro

class vtkTexture;

/// Draws the stripes of texture coordinates from vtkBrindleStripes over a surface's colour. U is
/// evaluated per pixel and averaged over it, so that borders are sharp from near and even from
/// afar, unlike an image texture. Surfaces without texture coordinates have no stripes.
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
  /// The opacity of stripes over the surface's colour, from 0 to 1.
  vtkSetClampMacro(StripeOpacity, double, 0, 1);
  vtkGetMacro(StripeOpacity, double);

  /// VTK passes texture coordinates to the shader only if there is a texture.
  void SetTexture(vtkTexture* texture) override;
  /// VTK would replace texture coordinates by scalars to interpolate; here, colours are
  /// interpolated instead.
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
  std::string Shader;  ///< current replacement in the actor; may be empty
};
