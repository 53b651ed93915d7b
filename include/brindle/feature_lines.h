/// Feature lines of a shape: silhouettes, creases, borders and slices.
#pragma once

#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/line_drawing.h"
#include "brindle/mesh.h"
#include "brindle/phase_graph.h"
#include "brindle/polylines.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// Silhouettes: lines through triangles where normals, linear between vertices, are at right angles
/// to the view (Hertzmann and Zorin 2000). `normals` has one unit normal per vertex; vertices
/// without one (zero) count as facing the viewer. `eye` is relative to the mesh's origin. Includes
/// edges at which the mesh is split, as along creases, between a front face and a back face.
Polylines silhouette_lines(const Mesh& mesh, std::span<const Vec3> normals, const Vec3& eye);

/// The edge where a slice (`Camera::slice`) opens the surface, moved by a ten-thousandth of the
/// diagonal into the part that remains.
Polylines slice_lines(const Mesh& mesh, std::span<const Vec3> normals,
                      const Eigen::Hyperplane<float, 3>& slice);

/// Borders, and edges at which the surface bends by more than `angle_deg` degrees (0: flat).
/// Coincident vertices count as one. Throws Cancelled if `progress` cancels.
Polylines crease_lines(const Mesh& mesh, std::span<const Vec3> normals, float angle_deg,
                       const Progress& progress = {});

/// The parts of lines that a pattern's strokes cover, which are `width` of a period wide. The
/// dashes lie where the surface's own strokes would. Without a wave, lines are whole. `lines` come
/// from the functions above; `waves` and `z` have one entry per vertex.
Polylines dashes_of(const Polylines& lines, const Mesh& mesh, const WaveSet& waves,
                    std::span<const Complex> z, float width);

/// Strokes cut into dashes of `on` pixels with `off` pixels between them, both above zero.
std::vector<Stroke> dashed(std::span<const Stroke> strokes, float on, float off);

}  // namespace brindle
