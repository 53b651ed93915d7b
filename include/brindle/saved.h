/// Patterns and animators in files, to go on later with the same bits.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "brindle/cross_animator.h"
#include "brindle/export.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"
#include "brindle/surface.h"
#include "brindle/texture_animator.h"

namespace BRINDLE_EXPORT brindle {

/// The content of a file, with its surface.
template <class Result>
struct Saved {
  Surface surface;
  Result result;
};

// `surface` is that of the pattern, or the one that the animator was made of. Files are written
// whole or not at all. An animator that is loaded gives the same bits in all following frames as
// the one that was saved, with the same version of Brindle. Throw Error for another surface, and
// what write_file throws.

void save(const std::filesystem::path& path, const Surface& surface, const StripePattern& pattern);
void save(const std::filesystem::path& path, const Surface& surface,
          const StripeAnimator& animator);
void save(const std::filesystem::path& path, const Surface& surface,
          const TextureAnimator& animator);
void save(const std::filesystem::path& path, const Surface& surface, const CrossAnimator& animator);

/// The bytes of such a file, for programs that store them elsewhere. Throws Error for another
/// surface.
std::string saved_bytes(const Surface& surface, const StripePattern& pattern);
std::string saved_bytes(const Surface& surface, const StripeAnimator& animator);
std::string saved_bytes(const Surface& surface, const TextureAnimator& animator);
std::string saved_bytes(const Surface& surface, const CrossAnimator& animator);

// Throw Error, naming the file and the remedy, if it cannot be read, is no such file, is damaged or
// truncated, holds something else, or is of a newer version. Any bytes are safe to load.

Saved<StripePattern> load_pattern(const std::filesystem::path& path);
Saved<StripeAnimator> load_stripe_animator(const std::filesystem::path& path);
Saved<TextureAnimator> load_texture_animator(const std::filesystem::path& path);
Saved<CrossAnimator> load_cross_animator(const std::filesystem::path& path);

// The same for `saved_bytes`.

Saved<StripePattern> pattern_of_bytes(std::string_view bytes);
Saved<StripeAnimator> stripe_animator_of_bytes(std::string_view bytes);
Saved<TextureAnimator> texture_animator_of_bytes(std::string_view bytes);
Saved<CrossAnimator> cross_animator_of_bytes(std::string_view bytes);

}  // namespace brindle
