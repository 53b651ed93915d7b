/// Pictures of stripes on points: every point is a disc in its tangent plane, and overlapping discs
/// are blended into a closed surface (Botsch et al. 2005).
#pragma once

#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/phase_graph.h"
#include "brindle/progress.h"
#include "brindle/renderer.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// A drawing with one entry per point in all spans. Points without a normal (zero) are not drawn;
/// those without a wave, or all if there are no waves, are plain.
struct SplatDrawing {
  std::span<const Vec3> positions;
  std::span<const Vec3> normals;  ///< unit; their signs do not matter
  std::span<const float> radii;   ///< of the discs, above 0
  const WaveSet* waves = nullptr;
  std::span<const Complex> z = {};  ///< exp(i Phi)
};

/// Radii of overlapping discs: the mean distance to the neighbours. Zero without neighbours.
std::vector<float> splat_radii(std::span<const Vec3> positions, const Adjacency& neighborhood);

/// Draws discs in the OpenGL 4.5 context that is current at construction, which must be current
/// whenever the renderer is used or destroyed.
class SplatRenderer {
 public:
  /// Throws Error, naming shader file and line, if the driver rejects the shaders.
  SplatRenderer();
  ~SplatRenderer();
  SplatRenderer(SplatRenderer&&) noexcept;
  SplatRenderer& operator=(SplatRenderer&&) noexcept;

  /// Copies the drawing to OpenGL, in place of the last one. Throws Error if sizes do not match or
  /// the drawing is larger than the driver's buffers.
  void upload(const SplatDrawing& drawing);

  /// Draws the uploaded drawing. A pixel blends the phases Phi + 2 pi f <x - p, d> of all discs
  /// there, weighted by nearness to their centres. Options as for `Renderer::draw`; marks are not
  /// drawn.
  Image draw(const RenderOptions& options, const Progress& progress = {}) const;

 private:
  struct State;
  Pimpl<State> state_;
};

/// Draws one picture in a headless context of its own. Throws what HeadlessContext and
/// SplatRenderer do.
Image render_splats(const SplatDrawing& drawing, const RenderOptions& options = {},
                    const Progress& progress = {});

}  // namespace brindle
