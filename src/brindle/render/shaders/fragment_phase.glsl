// The phase at any point of a triangle (Eq. 13 and 14). Twin of pattern/fragment_phase.cpp: same
// names, same order of statements. Change both or neither; tests/render/renderer_test.cpp compares
// them. Derivatives are only here.

const float kTurn = 6.28318530717958648;
const float kMostMismatch = 1.0 / 3.0;
const float kLeastWeight = 1e-4;

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

// Barycentric weights and their point, with derivatives along x and y.
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

bool comes_first(vec3 a, vec3 b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}

float turns_from_peak(vec2 z) { return atan(-z.x, z.y) / kTurn; }

struct EdgeTurns {
  float shift;
  float mismatch;
};

EdgeTurns turns_between(CornerWave a, CornerWave b) {
  bool backward = comes_first(b.position, a.position);
  CornerWave first = a;
  CornerWave second = b;
  if (backward) {
    first = b;
    second = a;
  }
  bool reversed = comes_first(first.direction, vec3(0.0));
  // Must be computed alike for both triangles of an edge.
  precise float distance =
      aligned_distance(first.position, first.direction, second.position, second.direction);
  precise float shift = sqrt(first.frequency * second.frequency) * distance;
  precise float rest = turns_from_peak(second.z) - turns_from_peak(first.z) - shift;
  precise float mismatch = reversed ? -rest : rest;
  precise float wrapped = mismatch - floor(mismatch + 0.5);
  if (reversed) wrapped = -wrapped;
  if (backward) return EdgeTurns(-shift, -wrapped);  // WebGL has no `?:` of structures
  return EdgeTurns(shift, wrapped);
}

struct Round {
  CornerWave corners[4];
  bvec4 turned_round;
  EdgeTurns edges[3];
};

Round passed_round(CornerWave corners[3]) {
  Round round;
  round.turned_round[0] = false;
  for (int m = 0; m < 4; ++m) {
    CornerWave corner = corners[m % 3];
    if (m > 0) {
      vec3 last = corners[m - 1].direction;
      round.turned_round[m] = round.turned_round[m - 1] != runs_against(last, corner.direction);
    }
    round.corners[m] = corner;
    if (round.turned_round[m]) round.corners[m] = flipped(corner);
  }
  for (int m = 0; m < 3; ++m) {
    round.edges[m] = turns_between(round.corners[m], round.corners[m + 1]);
  }
  for (int m = 0; m < 4; ++m) round.corners[m].position -= corners[0].position;
  return round;
}

bool all_have_waves(CornerWave corners[3]) {
  for (int m = 0; m < 3; ++m) {
    if (dot(corners[m].direction, corners[m].direction) == 0.0) return false;
  }
  return true;
}

// Products of numbers with their derivatives along x and y.
vec3 product(vec3 a, vec3 b) { return vec3(a.x * b.x, a.x * b.yz + b.x * a.yz); }

vec3 square(vec3 a) { return product(a, a); }

vec3 quotient(vec3 a, vec3 b) {
  float share = a.x / b.x;
  return vec3(share, (a.yz - share * b.yz) / b.x);
}

// The component along `v`, relative to the origin of `point`.
vec3 component(Fragment f, vec3 from, vec3 v) {
  return vec3(dot(f.point - from, v), dot(f.point_dx, v), dot(f.point_dy, v));
}

vec3 weight_of(Fragment f, int m) { return vec3(f.weights[m], f.weights_dx[m], f.weights_dy[m]); }

// The direction is taken as constant, because it turns too slowly to matter for filtering.
vec3 turns_to(Fragment f, FragmentWave there, CornerWave corner) {
  float cosine = dot(there.direction, corner.direction);
  float s = cosine < 0.0 ? -1.0 : 1.0;
  vec3 along = component(f, corner.position, corner.direction + s * there.direction) /
               (1.0 + abs(cosine));
  return sqrt(corner.frequency * there.frequency) * along;
}

float excess_of(EdgeTurns edge) {
  return edge.mismatch - clamp(edge.mismatch, -kMostMismatch, kMostMismatch);
}

int nearest_edge(vec3 barycentric) {
  int c = barycentric[1] < barycentric[0] ? 1 : 0;
  return ((barycentric[2] < barycentric[c] ? 2 : c) + 1) % 3;
}

vec3 bounded_weight(Fragment f, int m) {
  return f.weights[m] > kLeastWeight ? weight_of(f, m) : vec3(kLeastWeight, 0.0, 0.0);
}

struct PhaseSum {
  vec2 sum, sum_dx, sum_dy;
};

void add_term(inout PhaseSum s, vec3 weight, vec2 z, vec3 turns) {
  vec2 term = complex_product(z, turned(turns.x));
  vec2 rotated = kTurn * vec2(-term.y, term.x);
  s.sum += weight.x * term;
  s.sum_dx += weight.y * term + weight.x * turns.y * rotated;
  s.sum_dy += weight.z * term + weight.x * turns.z * rotated;
}

// Derivatives of the sum's phase, over 2 pi.
vec2 turns_by(PhaseSum s) {
  // Im(conj(sum) d sum) / |sum|^2: without a difference of angles, nothing wraps.
  vec2 normal = vec2(-s.sum.y, s.sum.x) / max(kTurn * dot(s.sum, s.sum), 1e-30);
  return vec2(dot(normal, s.sum_dx), dot(normal, s.sum_dy));
}

FragmentWave blended_wave(Round round, Fragment f) {
  FragmentWave fragment = kNoWave;
  for (int m = 0; m < 3; ++m) {
    fragment.direction += f.weights[m] * round.corners[m].direction;
    fragment.frequency += f.weights[m] * round.corners[m].frequency;
  }
  fragment.direction = normalize(fragment.direction);
  PhaseSum phase = PhaseSum(vec2(0.0), vec2(0.0), vec2(0.0));
  for (int m = 0; m < 3; ++m) {
    int next = (m + 1) % 3;
    int last = (m + 2) % 3;
    vec3 ahead = excess_of(round.edges[m]) * weight_of(f, next) -
                 excess_of(round.edges[last]) * weight_of(f, last);
    vec3 turns = turns_to(f, fragment, round.corners[m]) + ahead;
    add_term(phase, weight_of(f, m), round.corners[m].z, turns);
  }
  float length = sqrt(phase.sum.x * phase.sum.x + phase.sum.y * phase.sum.y);
  fragment.z = length > 0.0 ? phase.sum / length : vec2(0.0);
  fragment.turns_per_pixel = turns_by(phase);
  return fragment;
}

struct TurnsFromCentre {
  vec3 corners;
  float centre;
};

TurnsFromCentre turns_from_centre(Round round) {
  float start = turns_from_peak(round.corners[0].z);
  float turns = start;
  TurnsFromCentre result;
  for (int m = 0; m < 3; ++m) {
    result.corners[m] = turns;
    turns += round.edges[m].shift + round.edges[m].mismatch;
  }
  result.centre = 0.5 * floor(turns + start + 0.5);
  for (int m = 0; m < 3; ++m) result.corners[m] -= result.centre;
  return result;
}

// `round.corners[m]` and `round.edges[m]`. Software renderers keep arrays with variable indices in
// memory, which makes the program twice as long.
CornerWave corner_at(Round round, int m) {
  CornerWave corner = round.corners[0];
  for (int k = 1; k < 4; ++k) {
    if (k == m) corner = round.corners[k];
  }
  return corner;
}

EdgeTurns edge_at(Round round, int m) {
  EdgeTurns edge = round.edges[0];
  for (int k = 1; k < 3; ++k) {
    if (k == m) edge = round.edges[k];
  }
  return edge;
}

vec3 turns_beside(Round round, int m, Fragment f, float at_corner, inout FragmentWave fragment) {
  CornerWave from = corner_at(round, m);
  CornerWave to = corner_at(round, m + 1);
  EdgeTurns edge = edge_at(round, m);
  vec3 a = weight_of(f, m);
  vec3 b = weight_of(f, (m + 1) % 3);
  vec3 share = quotient(b, a + b);
  vec3 rest = vec3(1.0, 0.0, 0.0) - share;
  fragment.direction = normalize(rest.x * from.direction + share.x * to.direction);
  fragment.frequency = rest.x * from.frequency + share.x * to.frequency;
  float excess = excess_of(edge);
  vec3 turns = turns_to(f, fragment, from);
  vec3 turns_b = turns_to(f, fragment, to);
  PhaseSum phase = PhaseSum(vec2(0.0), vec2(0.0), vec2(0.0));
  add_term(phase, rest, from.z, turns + excess * share);
  add_term(phase, share, to.z, turns_b - excess * rest);
  float gain = edge.shift + edge.mismatch;
  float led = rest.x * turns.x + share.x * (gain + turns_b.x);
  float off = turns_from_peak(phase.sum) - turns_from_peak(from.z) - led;
  return vec3(at_corner + led + off - floor(off + 0.5), turns_by(phase));
}

FragmentWave singular_wave(Round round, Fragment f) {
  int m = nearest_edge(f.weights);
  bool at_first = f.weights[m] >= f.weights[(m + 1) % 3];
  int second = (at_first ? m + 2 : m + 1) % 3;
  bool reversed = at_first ? m == 0 : m == 2;

  vec3 least = bounded_weight(f, (m + 2) % 3);
  vec3 most = bounded_weight(f, at_first ? m : (m + 1) % 3);
  vec3 middle = bounded_weight(f, at_first ? (m + 1) % 3 : m);
  vec3 weight = square(product(middle, most - least));
  vec3 weight_of_second = square(product(least, most - middle));
  vec3 total = weight + weight_of_second;
  vec3 share = total.x > 0.0 ? quotient(weight_of_second, total) : vec3(0.5, 0.0, 0.0);

  TurnsFromCentre turns = turns_from_centre(round);
  FragmentWave fragment = kNoWave;
  vec3 own = vec3(0.0), other = vec3(0.0);
  // No compiler writes a loop out whose length depends on the point: this is most of the program.
  for (int edge = share.x > 0.0 ? 1 : 0; edge >= 0; --edge) {
    int corner = edge == 1 ? second : m;
    vec3 beside = turns_beside(round, corner, f, turns.corners[corner], fragment);
    if (edge == 1) {
      other = beside;
    } else {
      own = beside;
    }
  }
  vec3 inside = square(27.0 * product(product(least, middle), most));
  float way = sqrt(max(1.0 - inside.x, 0.0));
  vec3 blended = own + product(share, (reversed ? -other : other) - own);
  fragment.z = turned(turns.centre + way * blended.x + 0.25);
  fragment.turns_per_pixel = way * blended.yz - 0.5 * blended.x / max(way, 1e-3) * inside.yz;
  return fragment;
}

// Corner positions are relative to the first one.
Fragment fragment_at(Round round, vec3 weights, vec3 weights_dx, vec3 weights_dy) {
  mat3 points =
      mat3(round.corners[0].position, round.corners[1].position, round.corners[2].position);
  return Fragment(weights, weights_dx, weights_dy, points * weights, points * weights_dx,
                  points * weights_dy);
}

FragmentWave wave_in(Round round, vec3 barycentric, vec3 barycentric_dx, vec3 barycentric_dy) {
  Fragment f = fragment_at(round, barycentric, barycentric_dx, barycentric_dy);
  if (round.turned_round[3]) return singular_wave(round, f);
  return blended_wave(round, f);
}

FragmentWave fragment_phase(CornerWave corners[3], vec3 barycentric, vec3 barycentric_dx,
                            vec3 barycentric_dy) {
  if (!all_have_waves(corners)) return kNoWave;
  return wave_in(passed_round(corners), barycentric, barycentric_dx, barycentric_dy);
}

FragmentWave split_fragment_phase(CornerWave corners[3], vec3 barycentric, vec3 barycentric_dx,
                                  vec3 barycentric_dy) {
  if (!all_have_waves(corners)) return kNoWave;
  Round round = passed_round(corners);
  FragmentWave fragment = wave_in(round, barycentric, barycentric_dx, barycentric_dy);
  if (round.turned_round[nearest_edge(barycentric)]) {
    fragment.direction = -fragment.direction;
    fragment.z = vec2(-fragment.z.x, fragment.z.y);
    fragment.turns_per_pixel = -fragment.turns_per_pixel;
  }
  return fragment;
}

// Phi / 2 pi at the pixel's centre, where adjacent triangles agree.
float turns_at_centre(FragmentWave wave, SurfacePoint p) {
  return atan(wave.z.y, wave.z.x) / kTurn + dot(wave.turns_per_pixel, p.way_to_centre);
}
