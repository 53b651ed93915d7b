// The numbers behind the picture, for tests: phase, barycentric coordinates and triangle.

layout(location = 0) out vec2 z;
layout(location = 1) out vec4 weights;
layout(location = 2) out uint triangle_number;

void main() {
  z = wave_here().z;
  weights = vec4(weights_here(), 0.0);
  triangle_number = triangle;
}
