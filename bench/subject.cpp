#include "subject.h"

#include <numbers>
#include <string_view>
#include <utility>

#include "brindle/base/text.h"
#include "brindle/creases.h"
#include "brindle/cross_cover.h"
#include "brindle/cross_texture.h"
#include "brindle/direction_field.h"
#include "brindle/files.h"
#include "brindle/frequency_field.h"
#include "brindle/shapes.h"
#include "brindle/waves_of.h"

namespace brindle::bench {
namespace {

constexpr float kDegree = std::numbers::pi_v<float> / 180;
constexpr float kZoom = 1.01f;
constexpr std::string_view kShapePrefix = "shape:";

// As in the paper's measurements (5.2); not parallel to a symmetry axis or plane of any built-in
// shape.
const Vec3 kDirection(0.31f, 0.9f, 0.27f);

Mesh load(const std::string& mesh) {
  if (!mesh.starts_with(kShapePrefix)) return read_mesh(mesh).mesh;
  return make_shape(std::string_view(mesh).substr(kShapePrefix.size()));
}

ChangingInput changing_input(const Surface& surface, const WaveSet& waves) {
  ChangingInput input{waves.positions,
                      {waves.directions, rotated(waves.directions, surface.normals, kDegree)},
                      {waves.frequencies, waves.frequencies}};
  for (float& frequency : input.frequencies[1]) frequency *= kZoom;
  return input;
}

}  // namespace

Subject make_subject(const std::string& name, int subdivisions, Fields fields, float stripes) {
  Mesh mesh = subdivide(load(name), subdivisions);
  Creases creases = split_at_creases(mesh);
  Subject subject{name, make_surface(std::move(mesh), std::move(creases)), {}, {}};
  if (subdivisions > 0) subject.name += formatted("/subdivided:%d", subdivisions);
  Surface& surface = subject.surface;
  const float frequency = frequency_of_stripes(stripes, bounding_box(surface.mesh).diagonal());
  const WaveSet waves{surface.mesh.positions,
                      projected_direction_field(kDirection, surface.normals),
                      constant_frequency_field(frequency, surface.mesh.vertex_count())};
  if (fields == Fields::crosses) {
    CrossCover cover = cross_cover(*surface.neighborhood, surface.mesh.triangles,
                                   cross_waves(waves, surface.normals));
    surface = cover_surface(cover, surface.normals);
    subject.fields = {std::move(cover.waves)};
  } else {
    subject.fields = {waves};
    if (fields == Fields::two) subject.fields.push_back(waves_across(waves, surface.normals));
  }
  for (const WaveSet& field : subject.fields) {
    subject.inputs.push_back(changing_input(surface, field));
  }
  return subject;
}

void Quality::add(double energy_of_one, const PatternQuality& quality, std::size_t fields) {
  const double share = 1 / static_cast<double>(fields);
  energy += share * energy_of_one;
  branches += quality.branches;
  angle_error_mean_deg += share * quality.angle_error_mean_deg;
}

Quality quality_of(const Subject& subject, int number, std::span<const std::vector<Complex>> z) {
  const Surface& surface = subject.surface;
  Quality quality;
  for (std::size_t field = 0; field < subject.inputs.size(); ++field) {
    const WaveSet waves = subject.inputs[field].waves(number);
    const PhaseGraph graph = build_phase_graph(surface.neighborhood, waves);
    const auto corners =
        corner_phases(surface.mesh.triangles, waves, z[field], PhaseShiftKind::aligned);
    quality.add(energy(graph, z[field]), measure_quality(surface.mesh, waves, corners),
                subject.inputs.size());
  }
  return quality;
}

}  // namespace brindle::bench
