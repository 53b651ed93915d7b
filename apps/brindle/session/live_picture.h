/// Pictures of a live pattern, as `brindle stripe --output` writes them.
#pragma once

#include <memory>
#include <string>

#include "brindle/image.h"
#include "session/live_pattern.h"

namespace brindle::tool {

/// Draws in a headless OpenGL context of its own, on the thread that makes it.
class LivePicture {
 public:
  /// Throws Error, naming what was tried, if no OpenGL 4.5 context is to be had.
  LivePicture();
  ~LivePicture();

  /// The document's picture, of the state's `LivePattern`. What was uploaded before is not uploaded
  /// again. Throws Error if OpenGL fails; Cancelled if `progress` asks for it.
  Image draw(const std::shared_ptr<const LiveState>& state, PictureQuality quality,
             const Progress& progress = {});

  /// The same at interactive quality, in so much detail as there is time for while something moves
  /// (`DraftSize`), of which its state has taken `before` milliseconds.
  Image draft(const std::shared_ptr<const LiveState>& state, double before = 0,
              const Progress& progress = {});

  /// How the picture that was drawn of the state was taken: for picking and for what a window draws
  /// on top. Coordinates are those of the surface's mesh.
  Camera camera(const LiveState& state) const;

  /// Why that picture shows nothing (`slice_refusal`): then no file of it is written. Empty if it
  /// shows anything.
  std::string nothing_left(const LiveState& state) const;

 private:
  struct Drawing;
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace brindle::tool
