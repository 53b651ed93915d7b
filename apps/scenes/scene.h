/// Input that changes from frame to frame, for animations.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "brindle/phase_graph.h"
#include "brindle/smooth_field.h"
#include "brindle/surface.h"
#include "scenes/brush_stroke.h"

namespace brindle {

enum class SceneKind {
  zoom,      ///< the frequency grows by 1 % per frame; directions from a global vector
  vortices,  ///< two counter-rotating vortices orbit the surface, 1 degree per frame (paper, 5.1)
  rotate,    ///< the global vector turns by 1 degree per frame
  wobble,    ///< a wave of 60 frames moves the vertices
  brush      ///< a stroke is drawn across the surface in 120 frames, and a smooth field follows it
};

/// Parses "zoom", "vortices", "rotate", "wobble" or "brush".
std::optional<SceneKind> parse_scene_kind(std::string_view name);
std::string_view name_of(SceneKind kind);

struct SceneOptions {
  SceneKind kind = SceneKind::zoom;
  Vec3 direction{0.31f, 0.9f,
                 0.27f};  ///< the global vector of zoom, rotate and wobble, of any length above 0;
                          ///< rotate turns it about a perpendicular axis
  float frequency = 0;    ///< in frame 0, stripes per unit length, above 0
};

struct SceneFrame {
  Mesh mesh;                  ///< that of the surface; only `wobble` moves vertices
  std::vector<Vec3> normals;  ///< of `mesh`
  WaveSet waves;              ///< one wave per vertex
  std::vector<Vec3> points;   ///< both cores of `vortices`, the tip of `brush`, else empty
};

/// A scene on a surface of any kind and scale. A frame depends only on the surface, the options and
/// its number. Frame 0 of `zoom`, `rotate` and `wobble` is the surface itself with the global
/// vector's field.
class Scene {
 public:
  /// Copies the surface's data. Throws Error for options out of range.
  Scene(const Surface& surface, const SceneOptions& options);

  /// The frame of a number from 0; valid until the next call. A frame of `brush` depends on the
  /// earlier ones: out of order, it solves for these first.
  const SceneFrame& frame(int number);

 private:
  void brush(int number);

  SceneOptions options_;
  BoundingBox box_;
  std::vector<Vec3> at_rest_;  // positions
  SceneFrame frame_;

  // brush
  std::shared_ptr<const Adjacency> neighborhood_;
  BrushStroke stroke_;
  std::vector<FieldAnchor> anchors_;
  std::optional<SmoothFieldAnimator> field_;
  int drawn_ = -1;  // the last frame for which `field_` was solved
};

}  // namespace brindle
