// One wave by slot (twin: SlicedWave of phases/sliced_waves.h).
struct Wave {
  vec3 position;
  float root_frequency;
  vec3 direction;
  float unused;
};

// The effect of an edge on the phase.
struct EdgeShift {
  float cosine;     // <d_i, d_j>
  bool reflecting;  // Eq. 7
  float turns;      // Phi_ji / 2 pi
};
