// The contribution of a disc to a pixel. Waves have arbitrary signs, so phases of two discs cannot
// be averaged, but distances from the nearest stripe's middle can.

in vec2 disc;
in vec3 view_position;
flat in vec3 view_normal;
flat in float turns;
flat in float turns_per_radius;
flat in float has_wave;

layout(location = 0) out vec4 phase_sum;   // distance, footprint, weight of waves, weight
layout(location = 1) out vec4 normal_sum;  // towards the viewer

void main() {
  vec2 turns_per_pixel = turns_per_radius * vec2(dFdx(disc.x), dFdy(disc.x));
  float square = dot(disc, disc);
  if (square > 1.0) discard;
  float weight = exp(-4.0 * square);
  float u = turns + turns_per_radius * disc.x - 0.25;
  float distance = abs(u - floor(u + 0.5));
  float wave = weight * has_wave;
  phase_sum = vec4(wave * distance, wave * length(turns_per_pixel), wave, weight);
  vec3 normal = dot(view_normal, view_position) > 0.0 ? -view_normal : view_normal;
  normal_sum = vec4(weight * normal, 0.0);
}
