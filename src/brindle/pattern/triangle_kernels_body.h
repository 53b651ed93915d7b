// The kernels that triangle_kernels.h declares, written once for scalars and vectors. The including
// source defines, in its own namespace,
//   Real   one float or several, with + - * / and unary -,
//   Truth  the result of < > and == of Reals, with && || ! and !=,
//   kReals the number of floats in a Real, and
//   real(float), load(const float*), load_pairs(const float*, Real& first, Real& second),
//   store(Real, float*), chosen(Truth, Real, Real), absolute(Real), square_root(Real),
//   truncated(Real), with_sign_of(Real, Real) and is_negative(Real), true for -0.
// There is no include guard, because each instruction set includes this file again.

namespace {

struct RealVector {
  Real x;
  Real y;
  Real z;
};

BRINDLE_KERNEL RealVector operator-(const RealVector& a, const RealVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

BRINDLE_KERNEL RealVector operator+(const RealVector& a, const RealVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

BRINDLE_KERNEL RealVector operator*(Real factor, const RealVector& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}

/// Adds in Eigen's order, because other code tests the signs of the same products.
BRINDLE_KERNEL Real dot(const RealVector& a, const RealVector& b) {
  return a.x * b.x + (a.y * b.y + a.z * b.z);
}

BRINDLE_KERNEL RealVector cross(const RealVector& a, const RealVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

BRINDLE_KERNEL Real larger(Real a, Real b) { return chosen(a < b, b, a); }

/// Rounds to the nearest whole number, halves away from zero, as std::round does.
BRINDLE_KERNEL Real rounded(Real a) {
  const Real whole = truncated(a);
  const Real further = whole + with_sign_of(real(1), a);
  return chosen(absolute(a - whole) < real(0.5f), whole, further);
}

/// A vector as its largest component times the rest, whose squares neither overflow nor vanish.
struct Scaled {
  Real largest;
  RealVector rest;
};

BRINDLE_KERNEL Scaled scaled(const RealVector& a) {
  const Real largest = larger(larger(absolute(a.x), absolute(a.y)), absolute(a.z));
  const Real divisor = chosen(largest > real(0), largest, real(1));
  return {largest, {a.x / divisor, a.y / divisor, a.z / divisor}};
}

/// atan2(y, x) by the odd polynomial of Cephes' atanf for |t| below tan(pi / 8). Mirroring at 90,
/// 45 and 22.5 degrees reduces angles to this range.
BRINDLE_KERNEL Real angle_of(Real y, Real x) {
  const Real pi = real(3.14159265358979f);
  const Real width = absolute(x), height = absolute(y);
  const Truth is_steep = width < height;
  const Real large = chosen(is_steep, height, width), small = chosen(is_steep, width, height);
  const Truth is_diagonal = real(0.414213562f) * large < small;
  const Real numerator = chosen(is_diagonal, small - large, small);
  const Real denominator = chosen(is_diagonal, small + large, large);
  const Real t = numerator / chosen(denominator == real(0), real(1), denominator);
  const Real square = t * t;
  Real series = real(8.05374449538e-2f);
  series = series * square - real(1.38776856032e-1f);
  series = series * square + real(1.99777106478e-1f);
  series = series * square - real(3.33329491539e-1f);
  Real angle = series * square * t + t;
  angle = chosen(is_diagonal, real(0.25f) * pi + angle, angle);
  angle = chosen(is_steep, real(0.5f) * pi - angle, angle);
  angle = chosen(is_negative(x), pi - angle, angle);
  return with_sign_of(angle, y);
}

/// The waves at one corner of kReals triangles.
struct RealWave {
  RealVector position;
  RealVector direction;
  Real frequency;
  Real z_re;
  Real z_im;
};

BRINDLE_KERNEL RealVector load_vector(const float (&axes)[3][kTriangleLanes], std::size_t lane) {
  return {load(axes[0] + lane), load(axes[1] + lane), load(axes[2] + lane)};
}

BRINDLE_KERNEL RealWave load_wave(const CornerLanes& corners, std::size_t m, std::size_t lane) {
  return {load_vector(corners.position[m], lane), load_vector(corners.direction[m], lane),
          load(corners.frequency[m] + lane), load(corners.z_re[m] + lane),
          load(corners.z_im[m] + lane)};
}

BRINDLE_KERNEL Truth has_no_wave(const RealVector& direction) {
  return direction.x == real(0) && direction.y == real(0) && direction.z == real(0);
}

/// The wave, reversed if `sign` is -1.
BRINDLE_KERNEL RealWave turned(const RealWave& wave, Real sign) {
  return {wave.position, sign * wave.direction, wave.frequency, sign * wave.z_re, wave.z_im};
}

/// Phi_ji of waves that run alike.
BRINDLE_KERNEL Real shift_between(const RealWave& j, const RealWave& i, bool trapezoid) {
  const Real cosine = dot(i.direction, j.direction);
  const Real sign = chosen(cosine < real(0), real(-1), real(1));
  const Real along = dot(i.position - j.position, j.direction + sign * i.direction);
  const Real length = trapezoid ? real(0.5f) * along : along / (real(1) + absolute(cosine));
  return real(kTwoPi) * square_root(i.frequency * j.frequency) * length;
}

/// The shift plus the wrapped remainder of the phase difference.
BRINDLE_KERNEL Real step_between(Real j_re, Real j_im, Real i_re, Real i_im, Real shift) {
  const Real difference = angle_of(i_im * j_re - i_re * j_im, i_re * j_re + i_im * j_im);
  const Real remainder = difference - shift;
  return shift + remainder - real(kTwoPi) * rounded(remainder / real(kTwoPi));
}

BRINDLE_KERNEL Real kind_number(TriangleKind kind) {
  return real(static_cast<float>(static_cast<int>(kind)));
}

/// Triangle kinds that are known before lifting, and the signs that orient corners alike.
struct Orientation {
  Truth no_wave;
  Truth singular;
  Real sign_1;
  Real sign_2;
};

BRINDLE_KERNEL Orientation orientation_of(const RealWave (&wave)[3]) {
  const auto runs_against = [&](int a, int b) {
    return dot(wave[a].direction, wave[b].direction) < real(0);
  };
  const Truth turn_1 = runs_against(0, 1), turn_2 = runs_against(0, 2);
  return {has_no_wave(wave[0].direction) || has_no_wave(wave[1].direction) ||
              has_no_wave(wave[2].direction),
          runs_against(1, 2) != (turn_1 != turn_2), chosen(turn_1, real(-1), real(1)),
          chosen(turn_2, real(-1), real(1))};
}

BRINDLE_KERNEL void lift_lane(const CornerLanes& corners, PhaseShiftKind kind,
                              const ShiftLanes* given, std::size_t lane, LiftedLanes& lifted) {
  RealWave wave[3] = {load_wave(corners, 0, lane), load_wave(corners, 1, lane),
                      load_wave(corners, 2, lane)};
  const Orientation orientation = orientation_of(wave);
  wave[1] = turned(wave[1], orientation.sign_1);
  wave[2] = turned(wave[2], orientation.sign_2);
  const auto step = [&](int j, int i) {
    const Real shift = given != nullptr
                           ? load(given->radians[j] + lane)
                           : shift_between(wave[j], wave[i], kind == PhaseShiftKind::trapezoid);
    return step_between(wave[j].z_re, wave[j].z_im, wave[i].z_re, wave[i].z_im, shift);
  };
  const Real step_1 = step(0, 1), step_2 = step(1, 2), step_0 = step(2, 0);
  const Real around = step_1 + step_2 + step_0;
  // The index saturates at its limits, and triangles with NaN phases count as without a wave.
  const Real turns = rounded(around / real(kTwoPi));
  const Real limit = real(127);
  const Real index = chosen(absolute(turns) > limit, with_sign_of(limit, turns), turns);
  const Truth none = orientation.no_wave || !(around == around);
  const Truth skipped = none || orientation.singular;
  const Real zero = real(0);
  const Real phase_0 = angle_of(wave[0].z_im, wave[0].z_re);
  const Real phase_1 = phase_0 + step_1;
  store(chosen(skipped, zero, phase_0), lifted.phase[0] + lane);
  store(chosen(skipped, zero, phase_1), lifted.phase[1] + lane);
  store(chosen(skipped, zero, phase_1 + step_2), lifted.phase[2] + lane);
  store(chosen(skipped, zero, real(1)), lifted.sign[0] + lane);
  store(chosen(skipped, zero, orientation.sign_1), lifted.sign[1] + lane);
  store(chosen(skipped, zero, orientation.sign_2), lifted.sign[2] + lane);
  store(chosen(skipped, zero, index), lifted.branch_index + lane);
  const Real closing =
      chosen(index == zero, kind_number(TriangleKind::regular), kind_number(TriangleKind::branch));
  const Real with_wave =
      chosen(orientation.singular, kind_number(TriangleKind::field_singularity), closing);
  store(chosen(none, kind_number(TriangleKind::no_wave), with_wave), lifted.kind + lane);
}

/// A triangle's plane.
struct RealPlane {
  RealVector edge_1;  ///< from corner 0 to 1
  RealVector edge_2;  ///< from corner 0 to 2
  RealVector normal;  ///< its length is twice the triangle's area
};

BRINDLE_KERNEL RealPlane load_plane(const CornerLanes& corners, std::size_t lane) {
  const RealVector origin = load_vector(corners.position[0], lane);
  const RealVector edge_1 = load_vector(corners.position[1], lane) - origin;
  const RealVector edge_2 = load_vector(corners.position[2], lane) - origin;
  return {edge_1, edge_2, cross(edge_1, edge_2)};
}

/// The gradient of the linear function with these values at a triangle's corners, in the
/// triangle's plane; zero if the triangle has no area.
BRINDLE_KERNEL RealVector gradient_in(const RealPlane& plane,
                                      const float (&phase)[3][kTriangleLanes], std::size_t lane) {
  const Real square = dot(plane.normal, plane.normal);
  const Real first = load(phase[0] + lane);
  const RealVector sum = (load(phase[2] + lane) - first) * plane.edge_1 -
                         (load(phase[1] + lane) - first) * plane.edge_2;
  const RealVector along = cross(plane.normal, sum);
  const Truth has_area = square > real(0);
  const Real zero = real(0), divisor = chosen(has_area, square, real(1));
  return {chosen(has_area, along.x / divisor, zero), chosen(has_area, along.y / divisor, zero),
          chosen(has_area, along.z / divisor, zero)};
}

/// The corners' mean direction up to its length, projected into the triangle's plane: no pattern
/// can follow the normal component.
BRINDLE_KERNEL RealVector direction_in(const RealPlane& plane, const CornerLanes& corners,
                                       const LiftedLanes& lifted, std::size_t lane) {
  RealVector direction = load(lifted.sign[0] + lane) * load_vector(corners.direction[0], lane);
  for (std::size_t m = 1; m < 3; ++m) {
    direction = direction + load(lifted.sign[m] + lane) * load_vector(corners.direction[m], lane);
  }
  const RealVector across = scaled(plane.normal).rest;
  const Real square = dot(across, across);
  const Real height = dot(direction, across) / chosen(square > real(0), square, real(1));
  return direction - height * across;
}

BRINDLE_KERNEL Real mean_of(const float (&corners)[3][kTriangleLanes], std::size_t lane) {
  return (load(corners[0] + lane) + load(corners[1] + lane) + load(corners[2] + lane)) / real(3);
}

BRINDLE_KERNEL void measure_lane(const CornerLanes& corners, const LiftedLanes& lifted,
                                 std::size_t lane, ErrorLanes& errors) {
  const RealPlane plane = load_plane(corners, lane);
  const Scaled slope = scaled(gradient_in(plane, lifted.phase, lane));
  const RealVector direction = direction_in(plane, corners, lifted, lane);
  const RealVector across = cross(slope.rest, direction);
  // The angle between lines, at most a right angle.
  store(angle_of(square_root(dot(across, across)), absolute(dot(slope.rest, direction))),
        errors.angle + lane);
  const Real frequency = mean_of(corners.frequency, lane);
  const Real steepness = slope.largest * square_root(dot(slope.rest, slope.rest));
  store(absolute(steepness / (real(kTwoPi) * frequency) - real(1)), errors.spacing + lane);
  store(real(0.5f) * square_root(dot(plane.normal, plane.normal)), errors.area + lane);
}

/// A parallelogram of coordinates with these gradients has the angle of 180 degrees minus that
/// between the gradients. Its area is 1 over that of the gradients' parallelogram.
BRINDLE_KERNEL void distortion_lane(const CornerLanes& corners, const LiftedLanes& u,
                                    const LiftedLanes& v, const DensityLanes& density,
                                    std::size_t lane, DistortionLanes& distortions) {
  const RealPlane plane = load_plane(corners, lane);
  const Real period = real(kTwoPi);
  const Real per_u = period * mean_of(density.u, lane), per_v = period * mean_of(density.v, lane);
  const RealVector slope_u = gradient_in(plane, u.phase, lane);
  const RealVector slope_v = gradient_in(plane, v.phase, lane);
  // Relative to the requested lengths: near 1 for any unit of length.
  const RealVector unit_u{slope_u.x / per_u, slope_u.y / per_u, slope_u.z / per_u};
  const RealVector unit_v{slope_v.x / per_v, slope_v.y / per_v, slope_v.z / per_v};
  const RealVector across = cross(unit_u, unit_v);
  const Real ratio = square_root(dot(across, across));
  store(angle_of(ratio, dot(unit_u, unit_v)), distortions.angle + lane);
  store(ratio, distortions.area_ratio + lane);
}

/// Complex numbers, one per lane.
struct RealComplex {
  Real re;
  Real im;
};

BRINDLE_KERNEL RealComplex load_complex(const Complex* from) {
  RealComplex result;
  load_pairs(reinterpret_cast<const float*>(from), result.re, result.im);
  return result;
}

}  // namespace

void phase_distances(const Complex* a, const Complex* b, float* distances) {
  for (std::size_t lane = 0; lane < kTriangleLanes; lane += kReals) {
    const RealComplex x = load_complex(a + lane), y = load_complex(b + lane);
    const Real angle = angle_of(x.im * y.re - x.re * y.im, x.re * y.re + x.im * y.im);
    store(absolute(angle), distances + lane);
  }
}

void lift_corners(const CornerLanes& corners, PhaseShiftKind kind, const ShiftLanes* given,
                  LiftedLanes& lifted) {
  for (std::size_t lane = 0; lane < kTriangleLanes; lane += kReals) {
    lift_lane(corners, kind, given, lane, lifted);
  }
}

void measure_errors(const CornerLanes& corners, const LiftedLanes& lifted, ErrorLanes& errors) {
  for (std::size_t lane = 0; lane < kTriangleLanes; lane += kReals) {
    measure_lane(corners, lifted, lane, errors);
  }
}

void measure_distortions(const CornerLanes& corners, const LiftedLanes& u, const LiftedLanes& v,
                         const DensityLanes& density, DistortionLanes& distortions) {
  for (std::size_t lane = 0; lane < kTriangleLanes; lane += kReals) {
    distortion_lane(corners, u, v, density, lane, distortions);
  }
}
