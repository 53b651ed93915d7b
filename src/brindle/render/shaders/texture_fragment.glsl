// The waves U and V that a texture follows, three a triangle each. The twin of `texture_fragment` is
// in pattern/texture_waves.cpp.

uniform samplerBuffer texture_u;  // three pairs for every corner: direction, frequency, z
uniform samplerBuffer texture_v;

// What a texture's waves are here.
struct TextureFragment {
  FragmentWave u, v;
};

CornerWave corner_of(samplerBuffer buffer_of_waves, vec3 position, int first) {
  vec2 a = texelFetch(buffer_of_waves, first).xy;
  vec2 b = texelFetch(buffer_of_waves, first + 1).xy;
  return CornerWave(position, vec3(a, b.x), b.y, texelFetch(buffer_of_waves, first + 2).xy);
}

TextureFragment texture_at(SurfacePoint p) {
  CornerWave u[3];
  CornerWave v[3];
  for (int m = 0; m < 3; ++m) {
    vec3 position = position_of(p.vertices[m]);
    int first = 3 * (3 * int(p.triangle) + m);
    u[m] = corner_of(texture_u, position, first);
    v[m] = corner_of(texture_v, position, first);
  }
  return TextureFragment(
      split_fragment_phase(u, p.barycentric, p.barycentric_dx, p.barycentric_dy),
      split_fragment_phase(v, p.barycentric, p.barycentric_dx, p.barycentric_dy));
}
