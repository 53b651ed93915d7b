#include <cstdio>

#include "brindle/surface/mesh.h"

int main() {
  brindle::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  std::printf("diagonal %.4f\n", static_cast<double>(brindle::bounding_box(mesh).diagonal()));
}
