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

/// The reason why no picture is written to a file of this name; empty for .png.
std::string picture_refusal(const std::filesystem::path& path);

/// Differences of a file's picture from the session's.
struct PictureChanges {
  std::optional<PictureSize> size;
  bool transparent = false;    ///< without a background
  bool scaled_widths = false;  ///< widths in pixels scale with the size
  double dpi = 0;              ///< pixels per inch stored in a PNG file; 0: none

  bool operator==(const PictureChanges&) const = default;
};

/// Whether the shown part of the document has widths in pixels.
bool has_pixel_widths(const SessionDocument& document);

/// The document of that picture. Throws CLI::ValidationError or Error for changes without effect or
/// out of range.
SessionDocument with_changes(const SessionDocument& document, const PictureChanges& changes);

/// The document for a file's picture, checked for everything that `export_picture` would reject.
SessionDocument planned_picture(const SessionDocument& document, const PictureChanges& changes,
                                const std::filesystem::path& path);

/// One picture in several files: pixels as in windows and `brindle render`, or outlines as in
/// `brindle stripe` and `curves`. Use it on one thread.
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

/// Solves for a document and writes its picture atomically. Throws Cancelled.
void export_picture(const SessionDocument& document, const std::filesystem::path& path, double dpi,
                    JobListener& listener);

/// A mesh (.ply .vtp .obj .gltf .glb) or a report (.json), as `brindle stripe --output`. Throws
/// CLI::ValidationError for another extension, and what writing throws.
void export_pattern(const LiveState& state, const std::filesystem::path& path,
                    JobListener& listener);

/// The stripes' centre lines, as `brindle curves --output` in .vtp .ply .obj or .csv; for a
/// texture, those along the field. Uses the options of curves, including tubes, if these are shown;
/// then .json is their report. Throws Error for points without triangles and for another extension.
void export_curves(const LiveState& state, const std::filesystem::path& path,
                   JobListener& listener);

/// Crossings of the stripes with those across them, as `brindle sample --output` in .csv .ply or
/// .vtp: the shown samples, or samples with default options. Without a texture, solves for the
/// stripes across. Throws Error for another extension and in builds without nanoflann.
void export_samples(const LiveState& state, const std::filesystem::path& path,
                    JobListener& listener);

}  // namespace brindle::tool
