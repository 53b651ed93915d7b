#include "own_part.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include <vtkPolyData.h>

namespace brindle::paraview {

OwnPart::OwnPart(const InputSurface& input) : input_(input) {
  if (!input.piece || std::ranges::count(input.piece->ghosts(), 1) == 0) return;
  InputSurface own = input;
  Mesh mesh = input.surface->mesh;
  mesh.triangles = own_rows(mesh.triangles);
  Surface surface = make_surface(std::move(mesh));
  surface.normals = input.surface->normals;
  own.surface = std::make_shared<const Surface>(std::move(surface));
  own.cell_of_triangle = own_rows(input.cell_of_triangle);
  own.points_of_triangle = own_rows(input.points_of_triangle);
  own_ = std::move(own);
}

const StripePattern& OwnPart::pattern(const StripePattern& whole) {
  if (!own_) return whole;
  StripePattern own = whole;
  own.corners = own_rows(whole.corners);
  return patterns_.emplace_back(std::move(own));
}

template <class T>
std::vector<T> OwnPart::own_rows(const std::vector<T>& by_triangle) const {
  std::vector<T> own;
  for (std::size_t t = 0; t < by_triangle.size(); ++t) {
    if (input_.piece->ghosts()[t] == 0) own.push_back(by_triangle[t]);
  }
  return own;
}

}  // namespace brindle::paraview
