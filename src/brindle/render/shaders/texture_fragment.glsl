// The waves U and V that a texture follows, three a triangle each. The twin of `texture_fragment` is
// in pattern/texture_waves.cpp.

layout(std430, binding = 7) readonly buffer TextureU { float texture_u[]; };  // direction,
layout(std430, binding = 8) readonly buffer TextureV { float texture_v[]; };  // frequency, z

// What a texture's waves are here.
struct TextureFragment {
  FragmentWave u, v;
};

bool run_alike(CornerWave corners[3]) {
  return !runs_against(corners[0].direction, corners[1].direction) &&
         !runs_against(corners[1].direction, corners[2].direction) &&
         !runs_against(corners[2].direction, corners[0].direction);
}

FragmentWave wave_of(CornerWave corners[3], bool oriented, vec3 barycentric, vec3 barycentric_dx,
                     vec3 barycentric_dy) {
  if (!all_have_waves(corners)) return kNoWave;
  Fragment f = fragment_at(corners, barycentric, barycentric_dx, barycentric_dy);
  return oriented ? blended_wave(corners, f) : split_wave(corners, f);
}

TextureFragment texture_here() {
  vec3 barycentric_dx = dFdx(centre_barycentric);
  vec3 barycentric_dy = dFdy(centre_barycentric);
  CornerWave u[3];
  CornerWave v[3];
  for (uint m = 0u; m < 3u; ++m) {
    vec3 position = position_of(vertex_of(triangle, m));
    uint i = 6u * (3u * triangle + m);
    u[m] = CornerWave(position, vec3(texture_u[i], texture_u[i + 1u], texture_u[i + 2u]),
                      texture_u[i + 3u], vec2(texture_u[i + 4u], texture_u[i + 5u]));
    v[m] = CornerWave(position, vec3(texture_v[i], texture_v[i + 1u], texture_v[i + 2u]),
                      texture_v[i + 3u], vec2(texture_v[i + 4u], texture_v[i + 5u]));
  }
  bool oriented = run_alike(u) && run_alike(v);
  vec3 weights = weights_here();
  return TextureFragment(wave_of(u, oriented, weights, barycentric_dx, barycentric_dy),
                         wave_of(v, oriented, weights, barycentric_dx, barycentric_dy));
}
