/// Pictures of a live pattern, equal to those of `brindle stripe --output`.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "brindle/image.h"
#include "session/live_pattern.h"

namespace brindle::tool {

/// Draws in its own headless OpenGL context, on the thread that creates it.
class LivePicture {
 public:
  /// Throws Error with what was tried if there is no OpenGL 4.5 context.
  LivePicture();
  ~LivePicture();

  /// The document's picture for a state of its `LivePattern`. Uploads only changes. Throws Error if
  /// OpenGL fails; throws Cancelled.
  Image draw(const std::shared_ptr<const LiveState>& state, PictureQuality quality,
             const Progress& progress = {});

  /// The same at interactive quality, with a resolution for fluent motion (`DraftSize`). `before`:
  /// milliseconds spent on the state.
  Image draft(const std::shared_ptr<const LiveState>& state, double before = 0,
              const Progress& progress = {});

  /// The camera of the picture of the state, in coordinates of the surface's mesh, for picking and
  /// for overlays of the window.
  Camera camera(const LiveState& state) const;

  /// The reason why that picture shows nothing (`slice_refusal`), which is then not written; else
  /// empty.
  std::string nothing_left(const LiveState& state) const;

 private:
  struct Drawing;
  std::unique_ptr<Drawing> drawing_;
};

/// The legend of a picture without one of its own.
struct ViewLegend {
  struct Entry {
    Color color;
    std::string meaning;
  };

  std::string title;           ///< empty: none
  std::vector<Entry> entries;  ///< colours with one meaning each
  std::vector<Color> scale;    ///< equal steps from `lowest` to `highest`
  std::string lowest, highest;

  bool empty() const { return entries.empty() && scale.empty(); }
};

/// For --view branches and angle_error, and for curves of two patterns. Empty otherwise: values
/// have legends within the picture, and plain stripes need none.
ViewLegend view_legend(const LiveState& state);

}  // namespace brindle::tool
