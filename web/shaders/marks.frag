// A disc with a light rim.

uniform vec3 branch_color;    // sRGB
uniform vec3 singular_color;

flat in uint kind;

layout(location = 0) out vec4 color;

void main() {
  float away = 2.0 * length(gl_PointCoord - 0.5);
  float edge = fwidth(away);
  float inside = 1.0 - smoothstep(1.0 - edge, 1.0, away);
  float rim = smoothstep(0.68 - edge, 0.68, away);
  color = vec4(mix(kind == 2u ? singular_color : branch_color, vec3(1.0), rim), 1.0) * inside;
}
