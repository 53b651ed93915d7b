// The shaded surface with its stripes, in linear light, from the means over all discs at a pixel.

uniform sampler2D phase_sums;
uniform sampler2D normal_sums;
uniform vec4 tile;         // as in splat.vert
uniform vec2 target_size;  // in pixels
uniform vec2 view_scale;   // clip from view coordinates, x and y
uniform bool orthographic;
uniform bool shading;
uniform vec3 base_color;
uniform vec3 stripe_color;
uniform float stripe_width;  // share of the period

layout(location = 0) out vec4 color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 sums = texelFetch(phase_sums, pixel, 0);
  if (!(sums.w > 0.0)) {
    color = vec4(0.0);
    return;
  }
  vec3 surface = base_color;
  if (sums.z > 0.0) {
    float share = covered_share(sums.x / sums.z, sums.y / sums.z, stripe_width);
    surface = mix(surface, stripe_color, share * sums.z / sums.w);
  }
  vec2 clip = 2.0 * gl_FragCoord.xy / target_size - 1.0;
  vec2 aside = orthographic ? vec2(0.0) : (clip - tile.zw) / tile.xy / view_scale;
  vec3 towards = vec3(aside, -1.0);
  vec3 normal = texelFetch(normal_sums, pixel, 0).xyz;
  color = vec4(shading ? lit_here(surface, normal, towards) : surface, 1.0);
}
