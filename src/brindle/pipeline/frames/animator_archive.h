/// The state of animators in archives (saved.h).
#pragma once

#include "brindle/base/archive.h"
#include "brindle/cross_animator.h"
#include "brindle/phase_graph.h"
#include "brindle/spacing_tolerance.h"
#include "brindle/stripe_animator.h"
#include "brindle/surface.h"
#include "brindle/texture_animator.h"

namespace brindle {

/// Archives hold only options and input of frames, with their phases. The rest follows from these:
/// levels, for instance, from the waves of the frame for which they were built. `surface` is the
/// one that the animator was made of.
struct AnimatorArchive {
  static void write(Archive& archive, const Surface& surface, StripeAnimator& animator);
  static void write(Archive& archive, const Surface& surface, TextureAnimator& animator);
  static void write(Archive& archive, const Surface& surface, CrossAnimator& animator);

  // Throw Error for values that frames would reject.
  static StripeAnimator read_stripes(Archive& archive, const Surface& surface);
  static TextureAnimator read_texture(Archive& archive, const Surface& surface);
  static CrossAnimator read_crosses(Archive& archive, const Surface& surface);

  /// The part that frames change, of an animator with the same options and surface.
  static void state(Archive& archive, StripeAnimator& animator);
  static bool has_slack(const StripeAnimator& animator);
};

void archive_options(Archive& archive, AnimatorOptions& options);

/// Throws Error unless vertices, edges and normals are alike.
void check_made_of(const Surface& surface, const Adjacency& neighborhood,
                   std::span<const Vec3> normals);

/// Options for an animator that was made with slack, even if it has none now, and for others.
AnimatorOptions made_with(AnimatorOptions options, bool slack);

}  // namespace brindle
