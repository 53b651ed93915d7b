// Ambient occlusion in screen space (Mittring 2007, with points in the hemisphere over the
// surface).

uniform float occlusion;         // strength, above 0; 1 is full
uniform float occlusion_radius;  // range of occluders, in units of length
uniform vec2 part_of_target;     // used share of the depth texture
uniform vec2 target_corner;      // position of the target in the picture, in pixels of the target
uniform bool has_surroundings;   // whether the picture extends beyond the target
uniform sampler2D depths_of_picture;  // of the whole picture then, coarser

float view_depth(float depth) {
  if (is_orthographic()) {
    return (clip_from_view[3][2] - (2.0 * depth - 1.0)) / clip_from_view[2][2];
  }
  return clip_from_view[3][2] / (2.0 * depth - 1.0 + clip_from_view[2][2]);
}

// Jimenez 2014: interleaved gradient noise.
float chance(vec2 pixel) {
  return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
}

// The picture's depth at a position in clip space; beyond its edges, behind everything.
float front_depth(vec2 clip) {
  vec2 target = 0.5 * (clip * tile.xy + tile.zw) + 0.5;
  if (all(equal(target, clamp(target, 0.0, 1.0)))) {
    return textureLod(visible_depth, target * part_of_target, 0.0).r;
  }
  vec2 picture = 0.5 * clip + 0.5;
  bool is_inside = has_surroundings && all(equal(picture, clamp(picture, 0.0, 1.0)));
  return is_inside ? textureLod(depths_of_picture, picture, 0.0).r : 1.0;
}

float open_share(SurfacePoint p) {
  if (!kOcclusion) return 1.0;
  const float kSamples = 18.0;
  const float kFullTurn = 6.28318530717958648;
  vec3 n = normalize(p.view_normal);
  vec3 side = normalize(cross(n, abs(n.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
  vec3 other = cross(n, side);
  float turn = chance(gl_FragCoord.xy + target_corner);
  float blocked = 0.0;
  for (float k = 0.5; k < kSamples; k += 1.0) {
    float share = k / kSamples;
    float angle = kFullTurn * (turn + 0.618034 * k);
    float flat_part = sqrt(share);
    vec3 direction = flat_part * (cos(angle) * side + sin(angle) * other) + sqrt(1.0 - share) * n;
    float distance = occlusion_radius * (0.08 + 0.92 * fract(turn + 0.754878 * k));
    vec3 place = p.view_position + distance * direction + 0.01 * occlusion_radius * n;
    vec4 clip = clip_from_view * vec4(place, 1.0);
    float front = view_depth(front_depth(clip.xy / clip.w));
    float behind = -place.z - front;
    // Far in front is a separate object, which does not occlude.
    if (behind > 0.02 * occlusion_radius) {
      blocked += 1.0 - smoothstep(1.0, 2.5, behind / occlusion_radius);
    }
  }
  return 1.0 - occlusion * clamp(1.35 * blocked / kSamples, 0.0, 1.0);
}
