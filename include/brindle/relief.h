/// Reliefs: a texture raised from a surface, as a closed mesh for printing and milling.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "brindle/broken_tiles.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/surface.h"
#include "brindle/texture_coordinates.h"

namespace BRINDLE_EXPORT brindle {

/// The height of a texture, from 0 (the surface) to 1, at texture coordinates, which repeat after
/// 1. Called from several threads. `tile_height` of renderer.h has the tiles of pictures.
using TextureHeight = std::function<float(float u, float v)>;

/// A texture as a relief.
struct ReliefTexture {
  const TexturedMesh& coordinates;  ///< of the surface (`texture_coordinates`)
  TextureHeight height;
  /// Motifs that are left out at height 0, as in pictures; null: none.
  const BrokenTiles* broken = nullptr;
  /// The smallest detail of `height`, in sides of the tile: 1/256 to 1/4.
  float detail = 1.0f / 48;
};

/// Meshes made of a texture.
enum class ReliefKind : std::uint8_t {
  raised,  ///< the surface, displaced
  inlay,   ///< a closed body for each part of the surface above half of the height
  cut      ///< a shell on the surface, with these parts as slots right through it
};

/// Holes up to this share of the bounding box's diagonal are filled unless requested otherwise.
inline constexpr float kFilledHoles = 0.5f;

/// Options of `make_relief`. Lengths are in units of the mesh.
struct ReliefOptions {
  ReliefKind kind = ReliefKind::raised;
  float height = 0;      ///< of height 1 above the surface; of shells, their thickness; above 0
  float depth = 0;       ///< of an inlay below the surface; 0 or more
  float tolerance = 0;   ///< greatest error of the height; 0: a twentieth of `height`
  float fill_holes = 0;  ///< of `raised`: up to this perimeter, without texture
  /// Triangles with the texture: 1, others: 0; empty: all.
  std::vector<std::uint8_t> only = {};
};

/// Measures of a relief.
struct ReliefMetrics {
  std::size_t refined_triangles = 0;  ///< before decimation
  std::size_t bodies = 0;             ///< connected components
  bool closed = false;                ///< every edge has two triangles, wound alike
  double volume_before = 0;           ///< inside the surface
  double volume = 0;                  ///< inside the relief
  float greatest_height = 0;
  double area = 0;          ///< of the surface with the texture
  double limited_area = 0;  ///< where the relief is lower than the texture, to avoid intersections
  std::size_t filled_holes = 0;
  std::size_t intersecting_triangles = 0;  ///< those left, such as those of the surface itself
};

/// A relief and its measures.
struct Relief {
  Mesh mesh;
  ReliefMetrics metrics;
};

/// Calls `add(name, value)` for all that reports say of a relief, in their order.
template <class Add>
void visit_metrics(const Relief& relief, const Add& add) {
  const ReliefMetrics& metrics = relief.metrics;
  add("vertices", relief.mesh.vertex_count());
  add("triangles", relief.mesh.triangle_count());
  add("refined_triangles", metrics.refined_triangles);
  add("bodies", metrics.bodies);
  add("closed", metrics.closed);
  add("intersecting_triangles", metrics.intersecting_triangles);
  add("volume_before", metrics.volume_before);
  add("volume", metrics.volume);
  add("greatest_height", metrics.greatest_height);
  add("area", metrics.area);
  add("limited_area", metrics.limited_area);
  add("filled_holes", metrics.filled_holes);
}

/// Raises a texture from a surface. Edges are split where the height is not linear, so that the
/// error is at most half of the tolerance. Edges shorter than that are not split, which bounds
/// steps. Vertices move along the normal; on creases they move to where the displaced faces meet,
/// at most 3 times as far. They move at most 0.45 times the radius of the largest empty ball that
/// touches the surface there, so that opposite walls do not meet. The result is decimated within
/// the other half of the tolerance. Where triangles intersect nevertheless, vertices are lowered,
/// down to the surface if need be. Triangles without texture stay as they are. A mesh that encloses
/// a negative volume is turned inside out.
///
/// Throws Error for coordinates or `only` of another surface, options out of range, edges of three
/// or more triangles, triangles that cannot be wound alike, and for more than 30 million triangles;
/// Cancelled if `progress` cancels. Results do not depend on the number of threads.
Relief make_relief(const Surface& surface, const ReliefTexture& texture,
                   const ReliefOptions& options, const Progress& progress = {});

/// Faces with a texture: those that meet all conditions.
struct ReliefFaces {
  float flat_width = 0;         ///< not flat and wider than this (`flat_faces`); 0: any
  Vec3 towards = Vec3::Zero();  ///< their normals are within `degrees` of this; zero: any
  float degrees = 45;
  std::vector<float> weights = {};  ///< above 0.5 at all corners; a number per vertex, or empty
};

/// 1 for the triangles chosen, else 0. Throws Error if there are none, and for angles above 180
/// degrees.
std::vector<std::uint8_t> chosen_faces(const Surface& surface, const ReliefFaces& faces);

/// 1 for triangles in flat faces, else 0. A flat face is a connected set of triangles whose normals
/// differ by less than 0.1 degrees, and it is wider than `width`: twice its area over its
/// perimeter.
std::vector<std::uint8_t> flat_faces(const Surface& surface, float width);

}  // namespace brindle
