/// Input that changes from frame to frame, for moving pictures and for measuring.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "brindle/phase_graph.h"
#include "brindle/surface.h"

namespace brindle {

enum class SceneKind {
  zoom,      ///< the frequency grows by 1 % a frame; directions from a global vector
  vortices,  ///< the field whirls, in opposite senses, around two cores that orbit the surface, 1
             ///< degree a frame (paper, 5.1)
  rotate,    ///< the global vector turns, 1 degree a frame
  wobble,    ///< a wave runs through the surface, once in 60 frames, and moves its vertices
  brush      ///< a stroke is drawn across the surface in 120 frames, and a smooth field follows it
};

/// Reads "zoom", "vortices", "rotate", "wobble" or "brush".
std::optional<SceneKind> parse_scene_kind(std::string_view name);
std::string_view name_of(SceneKind kind);

struct SceneOptions {
  SceneKind kind = SceneKind::zoom;
  Vec3 direction{0.31f, 0.9f, 0.27f};  ///< the global vector of zoom, rotate and wobble, of any
                                       ///< length above 0; rotate turns it about an axis across it
  float frequency = 0;                 ///< in frame 0, stripes per unit length, above 0
};

struct SceneFrame {
  Mesh mesh;                  ///< that of the surface; other positions in `wobble` alone
  std::vector<Vec3> normals;  ///< of `mesh`
  WaveSet waves;              ///< one wave per vertex
  std::vector<Vec3> points;   ///< both cores of `vortices`, the tip of `brush`, else none
};

/// A scene on a surface of any kind and scale. What a frame holds depends on the surface, the
/// options and the frame's number alone. The first frame, number 0, of `zoom`, `rotate` and
/// `wobble` is the surface itself with the global vector's field.
class Scene {
 public:
  /// Copies what it needs of the surface. Throws Error for options out of range.
  Scene(const Surface& surface, const SceneOptions& options);
  ~Scene();
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;

  /// The frame of a number from 0; valid until the next call. In `brush` a frame follows from those
  /// before it: asked for out of order, it solves for these first.
  const SceneFrame& frame(int number);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace brindle
