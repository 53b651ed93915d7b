/// Files of a live pattern, as the tool's other commands write them.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/job_listener.h"
#include "session/live_pattern.h"
#include "session/live_picture.h"

namespace brindle::tool {

/// Why no picture of pixels is written to a file of this name; empty if one is: a .png.
std::string picture_refusal(const std::filesystem::path& path);

/// What a file's picture has otherwise than the session's.
struct PictureChanges {
  std::optional<PictureSize> size;
  bool transparent = false;    ///< without a background
  bool scaled_widths = false;  ///< those in pixels grow with the size, as all else does
  double dpi = 0;              ///< pixels an inch that a PNG file says; 0: nothing

  bool operator==(const PictureChanges&) const = default;
};

/// Whether the document has widths in pixels, of stripes or lines, in what it shows.
bool has_pixel_widths(const SessionDocument& document);

/// The document whose picture that is. Throws CLI::ValidationError or Error for changes without
/// effect and out of range.
SessionDocument with_changes(const SessionDocument& document, const PictureChanges& changes);

/// The document that is drawn to a file, checked together with it: what `export_picture` would
/// refuse later.
SessionDocument planned_picture(const SessionDocument& document, const PictureChanges& changes,
                                const std::filesystem::path& path);

/// The same picture in several files: pixels as windows and `brindle render` draw them, or outlines
/// as `brindle stripe` and `curves`. Made and called on one thread.
class PictureWriter {
 public:
  /// `dpi`: as in `PictureChanges`.
  explicit PictureWriter(PictureQuality quality, double dpi = 0) : quality_(quality), dpi_(dpi) {}

  void write(const std::shared_ptr<const LiveState>& state, const std::filesystem::path& path,
             JobListener& listener);

 private:
  PictureQuality quality_;
  double dpi_;
  std::optional<LivePicture> picture_;
};

/// Solves for a document and writes its picture, whole or not at all. Throws Cancelled if the
/// listener asks for it.
void export_picture(const SessionDocument& document, const std::filesystem::path& path, double dpi,
                    JobListener& listener);

/// A mesh (.ply .vtp .obj .gltf .glb) or a report (.json), as `brindle stripe --output`. Throws
/// CLI::ValidationError for another extension, and what writing throws.
void export_pattern(const LiveState& state, const std::filesystem::path& path,
                    JobListener& listener);

/// The stripes' centre lines, as `brindle curves --output` in .vtp .ply .obj or .csv; of a texture,
/// those along the field. With the options of curves where these are shown, tubes among them, else
/// without any. Where they are shown, a .json is the report of these.
/// Throws Error for points without triangles and for another extension.
void export_curves(const LiveState& state, const std::filesystem::path& path,
                   JobListener& listener);

/// Points where the stripes and those across them meet, as `brindle sample --output` in .csv .ply
/// or .vtp; those that are shown, or else those without options. Solves then for the stripes across
/// unless there is a texture. Throws Error for another extension and in a build without nanoflann.
void export_samples(const LiveState& state, const std::filesystem::path& path,
                    JobListener& listener);

}  // namespace brindle::tool
