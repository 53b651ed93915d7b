/// What of a piece is this rank's own.
#pragma once

#include <list>
#include <optional>
#include <vector>

#include <brindle/stripe_pattern.h>

#include "surface_cache.h"

namespace brindle::paraview {

/// A surface without ghosts, and its patterns. Where there are none, nothing is copied.
class OwnPart {
 public:
  /// What it is given must stay where it is.
  explicit OwnPart(const InputSurface& input);

  const InputSurface& surface() const { return own_ ? *own_ : input_; }
  /// A rank may have nothing.
  bool is_empty() const { return surface().surface->mesh.triangles.empty(); }
  const StripePattern& pattern(const StripePattern& whole);

 private:
  template <class T>
  std::vector<T> own_rows(const std::vector<T>& by_triangle) const;

  const InputSurface& input_;
  std::optional<InputSurface> own_;  // only with ghosts
  std::list<StripePattern> patterns_;
};

}  // namespace brindle::paraview
