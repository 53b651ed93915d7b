#include "vtkBrindleStripesRepresentation.h"

#include <algorithm>
#include <iomanip>
#include <locale>
#include <sstream>
#include <vector>

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkObjectFactory.h>
#include <vtkPVLODActor.h>
#include <vtkPVView.h>
#include <vtkPointData.h>
#include <vtkShaderProperty.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include "blocks.h"

namespace {

constexpr const char* kColorPlace = "//VTK::Color::Impl";

/// Whether a data set is drawn with texture coordinates: U alone or U and V.
bool has_coordinates(vtkDataSet* data) {
  vtkDataArray* coordinates = data->GetPointData()->GetTCoords();
  return coordinates != nullptr && coordinates->GetNumberOfComponents() <= 2;
}

/// Whether all visible blocks have them.
bool all_have_coordinates(vtkDataObject* data) {
  std::vector<vtkDataSet*> visible = brindle::paraview::blocks_of(data);
  std::erase_if(visible, [](vtkDataSet* block) { return block->GetNumberOfPoints() == 0; });
  return !visible.empty() && std::ranges::all_of(visible, has_coordinates);
}

/// After surface colours: the mean of stripes over the pixel. Its integral from 0 to u is `width`
/// per whole stripe plus the part of the last one.
constexpr const char* kStripes = R"(
  {
    float u = vec2(tcoordVCVSOutput).x;
    float pixel = max(length(vec2(dFdx(u), dFdy(u))), 1.0e-6);
    vec2 ends = u - floor(u) + vec2(-0.5, 0.5) * pixel;
    vec2 sums = stripeWidth * floor(ends)
              + clamp(fract(ends) - 0.5 + 0.5 * stripeWidth, 0.0, stripeWidth);
    float covered = stripeOpacity * clamp((sums.y - sums.x) / pixel, 0.0, 1.0);
    diffuseColor = mix(diffuseColor, diffuseIntensity * stripeColor, covered);
    ambientColor = mix(ambientColor, ambientIntensity * stripeColor, covered);
  }
)";

}  // namespace

vtkStandardNewMacro(vtkBrindleStripesRepresentation);

vtkBrindleStripesRepresentation::vtkBrindleStripesRepresentation() {
  vtkNew<vtkImageData> pixel;
  pixel->SetDimensions(1, 1, 1);
  pixel->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int c = 0; c < 3; ++c) pixel->SetScalarComponentFromDouble(0, 0, 0, c, 255);
  this->White->SetInputData(pixel);
  this->SetTexture(nullptr);
}

vtkBrindleStripesRepresentation::~vtkBrindleStripesRepresentation() = default;

void vtkBrindleStripesRepresentation::SetTexture(vtkTexture* texture) {
  this->Superclass::SetTexture(texture != nullptr ? texture : this->White.Get());
}

void vtkBrindleStripesRepresentation::SetInterpolateScalarsBeforeMapping(int) {
  this->Superclass::SetInterpolateScalarsBeforeMapping(0);
}

void vtkBrindleStripesRepresentation::UpdateColoringParameters() {
  this->Superclass::UpdateColoringParameters();
  this->Superclass::SetInterpolateScalarsBeforeMapping(0);
}

// Both clear the actor's replacements.
void vtkBrindleStripesRepresentation::SetUseShaderReplacements(bool use) {
  this->Superclass::SetUseShaderReplacements(use);
  this->Shader.clear();
}

void vtkBrindleStripesRepresentation::SetShaderReplacements(const char* replacements) {
  this->Superclass::SetShaderReplacements(replacements);
  this->Shader.clear();
}

int vtkBrindleStripesRepresentation::ProcessViewRequest(vtkInformationRequestKey* request,
                                                        vtkInformation* in, vtkInformation* out) {
  if (this->Superclass::ProcessViewRequest(request, in, out) == 0) return 0;
  if (request == vtkPVView::REQUEST_RENDER()) this->UpdateStripes();
  return 1;
}

std::string vtkBrindleStripesRepresentation::StripeShader() const {
  std::ostringstream code;
  code.imbue(std::locale::classic());
  code << std::fixed << std::setprecision(6) << kColorPlace
       << "\n  const float stripeWidth = " << this->StripeWidth
       << ";\n  const float stripeOpacity = " << this->StripeOpacity
       << ";\n  const vec3 stripeColor = vec3(" << this->StripeColor[0] << ", "
       << this->StripeColor[1] << ", " << this->StripeColor[2] << ");" << kStripes;
  return code.str();
}

/// Sets the actor's stripe shader, or removes it if the data have no coordinates.
void vtkBrindleStripesRepresentation::UpdateStripes() {
  const std::string wanted = all_have_coordinates(this->Mapper->GetInputDataObject(0, 0))
                                 ? this->StripeShader()
                                 : std::string();
  if (wanted == this->Shader) return;
  vtkShaderProperty* shaders = this->Actor->GetShaderProperty();
  shaders->ClearFragmentShaderReplacement(kColorPlace, true);
  if (!wanted.empty()) shaders->AddFragmentShaderReplacement(kColorPlace, true, wanted, false);
  this->Shader = wanted;
}

void vtkBrindleStripesRepresentation::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StripeWidth: " << this->StripeWidth << '\n'
     << indent << "StripeOpacity: " << this->StripeOpacity << '\n';
}
