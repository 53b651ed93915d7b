/// Textures and crosses that continue while something moves.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "brindle/cross_animator.h"
#include "brindle/texture_animator.h"
#include "jobs/stripe_job.h"
#include "session/session_options.h"

namespace brindle::tool {

/// Frames on one surface. The first is solved from scratch.
class TileFollower {
 public:
  /// `prepared` has no waves and outlives this object.
  TileFollower(const StripeArguments& arguments, std::shared_ptr<const Preparation> prepared);

  /// The next frame, continuing the last one. Throws what the animators throw, and Cancelled.
  StripeJob next(const StripeArguments& arguments, const PreparedWaves& waves,
                 const PreparationMetrics& metrics, const Progress& progress);

  double phase_step() const { return phase_step_; }

  /// Solves the next frame from scratch.
  void restart();

 private:
  StripeJob next_texture(const StripeArguments& arguments, const PreparedWaves& waves,
                         const PreparationMetrics& metrics);
  StripeJob next_cross(const StripeArguments& arguments, const PreparedWaves& waves,
                       const PreparationMetrics& metrics, const Progress& progress);

  std::shared_ptr<const Preparation> prepared_;
  std::optional<TextureAnimator> texture_;
  std::optional<CrossAnimator> cross_;
  std::shared_ptr<const Surface> cross_surface_;  ///< while the matching of crosses stays the same
  InputData cross_data_;
  WholeTiles whole_;  ///< of the last texture
  double phase_step_ = 0;
};

}  // namespace brindle::tool
