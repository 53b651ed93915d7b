/// Lines that tell a shape: where it turns away from the viewer, its creases and borders.
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

/// Where the surface turns from the viewer's side to the other: lines through triangles on which
/// normals, linear between vertices, are at right angles to the view (Hertzmann and Zorin 2000).
/// `normals` has one unit normal per vertex; vertices without one (zero) are on the viewer's side.
/// `eye` is relative to the mesh's origin. Also edges at which the mesh is split, as along creases,
/// if one side is turned to the viewer and the other away.
Polylines silhouette_lines(const Mesh& mesh, std::span<const Vec3> normals, const Vec3& eye);

/// The edge along which a slice (`Camera::slice`) opens the surface, a ten-thousandth of its
/// diagonal within what is left.
Polylines slice_lines(const Mesh& mesh, std::span<const Vec3> normals,
                      const Eigen::Hyperplane<float, 3>& slice);

/// Borders, and edges at which the surface bends by more than `angle_deg` degrees (0: flat).
/// Vertices at one place count as one. Throws Cancelled if `progress` asks for it.
Polylines crease_lines(const Mesh& mesh, std::span<const Vec3> normals, float angle_deg,
                       const Progress& progress = {});

/// The parts of lines that a pattern's strokes cover, which are `width` of a period wide: dashes
/// that lie where the surface's own strokes would. Where there is no wave, lines are whole. `lines`
/// come from the functions above; `waves` and `z` have an entry per vertex.
Polylines dashes_of(const Polylines& lines, const Mesh& mesh, const WaveSet& waves,
                    std::span<const Complex> z, float width);

/// Strokes cut into dashes of `on` pixels with `off` pixels between them, both above zero.
std::vector<Stroke> dashed(std::span<const Stroke> strokes, float on, float off);

}  // namespace brindle
