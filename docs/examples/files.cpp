// A textured mesh for other programs. Built and run by the tests.
#include "brindle/files.h"

#include <filesystem>
#include <vector>

#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/texture_coordinates.h"
#include "brindle/texture_pattern.h"

int main() {
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("torus"));
  const brindle::TexturePattern texture = brindle::texture_pattern(
      surface, {surface.mesh.positions, brindle::smooth_direction_field(surface),
                brindle::constant_frequency_field(16, surface.mesh.vertex_count())});
  const brindle::TexturedMesh textured =
      brindle::texture_coordinates(surface.mesh, texture.waves, texture.phase_shift);
  std::vector<float> numbers;
  for (const auto& at_vertex : textured.coordinates) {
    numbers.insert(numbers.end(), at_vertex.begin(), at_vertex.end());
  }
  const brindle::DataArray uv = brindle::make_data_array("uv", 2, numbers);
  const auto path = std::filesystem::temp_directory_path() / "brindle_example_files.obj";
  brindle::write_mesh(path, textured.mesh, {&uv, 1});  // or write_textured_mesh, with a picture
  std::filesystem::remove(path);
}
