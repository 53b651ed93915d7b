/// Surfaces, fields, patterns, frames, curves and files. Pictures and drawings: pictures.h;
/// OpenGL's device: gpu.h; surfaces over MPI ranks: ranks.h; programs with options of the tool:
/// requests.h.
///
/// Surfaces: `make_mesh` and `make_surface` from arrays, `split_at_creases` for sharp edges,
/// `read_mesh` from files, `make_shape`. Fields: `smooth_direction_field`,
/// `projected_direction_field`, `curvature_direction_field`, `tangent_directions`,
/// `direction_field_of` arrays, `tensor_field_of`. Patterns: `stripe_pattern`, `texture_pattern`,
/// `cross_pattern`, `pattern_warnings`. From patterns: `stripe_curves`, `stripe_samples`,
/// `texture_coordinates`, `make_relief`. Spacing tolerance alone: `relaxed_frequencies`. Moving
/// input: `StripeAnimator`, `SmoothFieldAnimator`; time series: `matched_phases`, `carried_phases`,
/// `matched_directions`, `carried_directions`.
///
/// Functions throw `Error` for errors that a caller can fix. Failed or cancelled calls change no
/// object. For concurrent calls, see threads.h.
#pragma once

#include "brindle/array_field.h"
#include "brindle/arrays.h"
#include "brindle/boundary_phases.h"
#include "brindle/branch_pairs.h"
#include "brindle/broken_tiles.h"
#include "brindle/carried_phases.h"
#include "brindle/corner_phases.h"
#include "brindle/creases.h"
#include "brindle/cross_animator.h"
#include "brindle/cross_cover.h"
#include "brindle/cross_texture.h"
#include "brindle/curve_measures.h"
#include "brindle/curves.h"
#include "brindle/data_arrays.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/export.h"
#include "brindle/files.h"
#include "brindle/fragment_phase.h"
#include "brindle/frequency_field.h"
#include "brindle/local_positions.h"
#include "brindle/measured_field.h"
#include "brindle/mesh.h"
#include "brindle/mesh_data.h"
#include "brindle/nearest.h"
#include "brindle/normals.h"
#include "brindle/pattern_buffers.h"
#include "brindle/pattern_frames.h"
#include "brindle/pattern_warnings.h"
#include "brindle/phase_graph.h"
#include "brindle/phase_shift.h"
#include "brindle/points.h"
#include "brindle/polylines.h"
#include "brindle/progress.h"
#include "brindle/quality.h"
#include "brindle/relief.h"
#include "brindle/samples.h"
#include "brindle/saved.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/solver.h"
#include "brindle/spacing_tolerance.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"
#include "brindle/stripe_tracer.h"
#include "brindle/strokes.h"
#include "brindle/surface.h"
#include "brindle/tensor_field.h"
#include "brindle/texture_animator.h"
#include "brindle/texture_coordinates.h"
#include "brindle/texture_pattern.h"
#include "brindle/texture_waves.h"
#include "brindle/threads.h"
#include "brindle/tool_paths.h"
#include "brindle/types.h"
#include "brindle/version.h"
#include "brindle/wave_metrics.h"
#include "brindle/windings.h"
