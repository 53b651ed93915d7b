// The phase at any point of a triangle (Eq. 13 and 14). The twin of this file is
// pattern/fragment_phase.cpp: same names, same order of statements. Change both or neither;
// tests/render/renderer_test.cpp compares them. The derivatives are this file's own.

const float kTurn = 6.28318530717958648;

struct CornerWave {
  vec3 position;
  vec3 direction;
  float frequency;
  vec2 z;
};

struct FragmentWave {
  vec3 direction;
  float frequency;
  vec2 z;
  vec2 turns_per_pixel;  // derivatives of the phase along x and y of the picture, over 2 pi
};

// Weights of the corners and the point that they give, with derivatives along x and y.
struct Fragment {
  vec3 weights, weights_dx, weights_dy;
  vec3 point, point_dx, point_dy;
};

const FragmentWave kNoWave = FragmentWave(vec3(0.0), 0.0, vec2(0.0), vec2(0.0));

vec2 complex_product(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }

bool runs_against(vec3 a, vec3 b) { return dot(a, b) < 0.0; }

float aligned_distance(vec3 v_j, vec3 d_j, vec3 v_i, vec3 d_i) {
  float cosine = dot(d_i, d_j);
  float s = cosine < 0.0 ? -1.0 : 1.0;
  return dot(v_i - v_j, d_j + s * d_i) / (1.0 + abs(cosine));
}

vec2 turned(float turns) {
  float angle = kTurn * (turns - floor(turns + 0.5));
  return vec2(cos(angle), sin(angle));
}

CornerWave flipped(CornerWave corner) {
  return CornerWave(corner.position, -corner.direction, corner.frequency,
                    vec2(-corner.z.x, corner.z.y));
}

FragmentWave blended_wave(CornerWave corners[3], Fragment f) {
  FragmentWave fragment = kNoWave;
  for (int m = 0; m < 3; ++m) {
    fragment.direction += f.weights[m] * corners[m].direction;
    fragment.frequency += f.weights[m] * corners[m].frequency;
  }
  fragment.direction = normalize(fragment.direction);
  vec2 sum = vec2(0.0);
  vec2 sum_dx = vec2(0.0);
  vec2 sum_dy = vec2(0.0);
  for (int m = 0; m < 3; ++m) {
    CornerWave wave = corners[m];
    float distance =
        aligned_distance(wave.position, wave.direction, f.point, fragment.direction);
    float turns = sqrt(wave.frequency * fragment.frequency) * distance;
    vec2 term = complex_product(wave.z, turned(turns));
    sum += f.weights[m] * term;

    // The blended direction is taken as constant here: it turns too slowly to matter for a filter.
    vec3 along = (wave.direction + fragment.direction) /
                 (1.0 + dot(wave.direction, fragment.direction));
    vec3 wave_vector = kTurn * sqrt(wave.frequency * fragment.frequency) * along;
    vec2 rotated = vec2(-term.y, term.x);
    sum_dx += f.weights_dx[m] * term + f.weights[m] * dot(wave_vector, f.point_dx) * rotated;
    sum_dy += f.weights_dy[m] * term + f.weights[m] * dot(wave_vector, f.point_dy) * rotated;
  }
  float length = sqrt(sum.x * sum.x + sum.y * sum.y);
  fragment.z = length > 0.0 ? sum / length : vec2(0.0);
  // Im(conj(sum) d sum) / |sum|^2: no difference of angles, so nothing wraps.
  vec2 normal = vec2(-sum.y, sum.x) / max(kTurn * length * length, 1e-30);
  fragment.turns_per_pixel = vec2(dot(normal, sum_dx), dot(normal, sum_dy));
  return fragment;
}

bool all_have_waves(CornerWave corners[3]) {
  for (int m = 0; m < 3; ++m) {
    if (dot(corners[m].direction, corners[m].direction) == 0.0) return false;
  }
  return true;
}

int opposite_corner(vec3 barycentric) {
  int c = barycentric[1] < barycentric[0] ? 1 : 0;
  return barycentric[2] < barycentric[c] ? 2 : c;
}

FragmentWave split_wave(CornerWave corners[3], Fragment f) {
  int c = opposite_corner(f.weights);
  int a = (c + 1) % 3;
  int b = (c + 2) % 3;
  vec3 excess = f.weights - vec3(f.weights[c]);
  float total = excess[a] + excess[b];
  if (!(total > 0.0)) return kNoWave;
  if (runs_against(corners[a].direction, corners[b].direction)) {
    corners[b] = flipped(corners[b]);
  }
  vec3 excess_dx = f.weights_dx - vec3(f.weights_dx[c]);
  vec3 excess_dy = f.weights_dy - vec3(f.weights_dy[c]);
  f.weights = excess / total;
  f.weights_dx = (excess_dx - f.weights * (excess_dx[a] + excess_dx[b])) / total;
  f.weights_dy = (excess_dy - f.weights * (excess_dy[a] + excess_dy[b])) / total;
  return blended_wave(corners, f);
}

// Moves the corners so that the first is at zero.
Fragment fragment_at(inout CornerWave corners[3], vec3 barycentric, vec3 barycentric_dx,
                     vec3 barycentric_dy) {
  vec3 first = corners[0].position;
  for (int m = 0; m < 3; ++m) corners[m].position -= first;
  mat3 points = mat3(corners[0].position, corners[1].position, corners[2].position);
  return Fragment(barycentric, barycentric_dx, barycentric_dy, points * barycentric,
                  points * barycentric_dx, points * barycentric_dy);
}

FragmentWave fragment_phase(CornerWave corners[3], vec3 barycentric, vec3 barycentric_dx,
                            vec3 barycentric_dy) {
  if (!all_have_waves(corners)) return kNoWave;
  Fragment f = fragment_at(corners, barycentric, barycentric_dx, barycentric_dy);
  bool turn_second = runs_against(corners[0].direction, corners[1].direction);
  bool turn_third = runs_against(corners[0].direction, corners[2].direction);
  if (runs_against(corners[1].direction, corners[2].direction) != (turn_second != turn_third)) {
    return split_wave(corners, f);
  }
  if (turn_second) corners[1] = flipped(corners[1]);
  if (turn_third) corners[2] = flipped(corners[2]);
  return blended_wave(corners, f);
}
