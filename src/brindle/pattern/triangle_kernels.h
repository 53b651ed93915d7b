/// The inner loops of pattern measurement, for kTriangleLanes triangles at once. One source
/// (triangle_kernels_body.h) is compiled twice: as portable C++, and for Highway vectors, whose
/// instruction set is chosen at run time. Without fused multiply-adds, both give the same bits.
#pragma once

#include <cstddef>
#include <cstdint>

#include "brindle/corner_phases.h"
#include "brindle/phase_shift.h"
#include "brindle/types.h"

namespace brindle {

/// Triangles processed together: the widest float vector of any processor.
inline constexpr std::size_t kTriangleLanes = 16;

/// The corners of kTriangleLanes triangles; the last index is the triangle.
struct alignas(64) CornerLanes {
  float position[3][3][kTriangleLanes];   ///< by corner and axis
  float direction[3][3][kTriangleLanes];  ///< by corner and axis
  float frequency[3][kTriangleLanes];
  float z_re[3][kTriangleLanes];
  float z_im[3][kTriangleLanes];

  void set_position(std::size_t lane, std::size_t corner, const Vec3& at) {
    for (int axis = 0; axis < 3; ++axis) position[corner][axis][lane] = at[axis];
  }
  void set(std::size_t lane, std::size_t corner, const Vec3& at, const Vec3& d, float f) {
    set_position(lane, corner, at);
    for (int axis = 0; axis < 3; ++axis) direction[corner][axis][lane] = d[axis];
    frequency[corner][lane] = f;
  }
  void set_phase(std::size_t lane, std::size_t corner, Complex z) {
    z_re[corner][lane] = z.real();
    z_im[corner][lane] = z.imag();
  }
};

/// The corner phases of kTriangleLanes triangles. `kind` is the number of a TriangleKind.
struct alignas(64) LiftedLanes {
  float phase[3][kTriangleLanes];
  float sign[3][kTriangleLanes];
  float branch_index[kTriangleLanes];
  float kind[kTriangleLanes];

  void set(std::size_t lane, const CornerPhases& corners) {
    for (int m = 0; m < 3; ++m) {
      phase[m][lane] = corners.phase[m];
      sign[m][lane] = corners.sign[m];
    }
  }
  CornerPhases get(std::size_t lane) const {
    CornerPhases corners;
    for (int m = 0; m < 3; ++m) {
      corners.phase[m] = phase[m][lane];
      corners.sign[m] = static_cast<std::int8_t>(sign[m][lane]);
    }
    corners.branch_index = static_cast<std::int8_t>(branch_index[lane]);
    corners.kind = static_cast<TriangleKind>(static_cast<int>(kind[lane]));
    return corners;
  }
};

/// Phase shifts from corner 0 to 1, 1 to 2 and 2 to 0.
struct alignas(64) ShiftLanes {
  float radians[3][kTriangleLanes];
};

/// Errors of triangles relative to their waves; meaningless unless a triangle is regular.
struct alignas(64) ErrorLanes {
  float angle[kTriangleLanes];    ///< radians, 0 to pi / 2
  float spacing[kTriangleLanes];  ///< | |gradient| / (2 pi f) - 1 |
  float area[kTriangleLanes];
};

/// The frequencies of U and V at the corners of kTriangleLanes triangles.
struct alignas(64) DensityLanes {
  float u[3][kTriangleLanes];
  float v[3][kTriangleLanes];
};

/// The unit square of texture coordinates (phases over 2 pi) on kTriangleLanes triangles.
struct alignas(64) DistortionLanes {
  float angle[kTriangleLanes];       ///< radians, between the gradients
  float area_ratio[kTriangleLanes];  ///< requested area 1 / (f_U f_V) over the actual one
};

/// Corner phases as defined by `corner_phases`. Shifts follow from `kind`, unless `given` is not
/// null: it holds the shifts of corners oriented alike.
using LiftCorners = void(const CornerLanes& corners, PhaseShiftKind kind, const ShiftLanes* given,
                         LiftedLanes& lifted);

/// Errors as defined by `measure_quality`; ignores the corners' phases `z`.
using MeasureErrors = void(const CornerLanes& corners, const LiftedLanes& lifted,
                           ErrorLanes& errors);

/// Distortions as defined by `measure_texture`; uses only the corners' positions.
using MeasureDistortions = void(const CornerLanes& corners, const LiftedLanes& u,
                                const LiftedLanes& v, const DensityLanes& density,
                                DistortionLanes& distortions);

/// The distances of kTriangleLanes pairs of phases: |arg(a conj(b))|, in radians.
using PhaseDistances = void(const Complex* a, const Complex* b, float* distances);

namespace portable {
PhaseDistances phase_distances;
LiftCorners lift_corners;
MeasureErrors measure_errors;
MeasureDistortions measure_distortions;

/// Lifts only the first triangle.
LiftCorners lift_first;

/// arg z as the kernels compute it, with errors below 3e-7.
float phase_angle(Complex z);

/// `lifted_step` with the phase shift given.
float lifted_step(Complex z_j, Complex z_i, float shift);
}  // namespace portable

#ifdef BRINDLE_HAS_HIGHWAY
namespace simd {
PhaseDistances phase_distances;
LiftCorners lift_corners;
MeasureErrors measure_errors;
MeasureDistortions measure_distortions;
}  // namespace simd
namespace triangle_kernels = simd;
#else
namespace triangle_kernels = portable;
#endif

}  // namespace brindle
