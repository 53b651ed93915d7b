#include "brindle/pipeline/measured_pattern.h"

#include <utility>

#include "brindle/pattern/quality_sums.h"

namespace brindle {
namespace {

PatternQuality quality_of(const Surface& surface, const WaveSet& waves,
                          const StripePattern& pattern, const Progress& progress) {
  if (!surface.mesh.triangles.empty()) {
    return measure_quality(surface.mesh, waves, pattern.corners, progress);
  }
  return measure_point_quality(*surface.neighborhood, surface.normals, waves, pattern.solution.z,
                               pattern.phase_shift, progress);
}

VertexWaves vertex_waves(const StripePattern& pattern) {
  return {pattern.waves.positions, pattern.waves.directions, pattern.waves.frequencies,
          pattern.solution.z};
}

}  // namespace

std::size_t count_in_avoided_area(std::span<const Triangle> triangles,
                                  std::span<const CornerPhases> corners,
                                  std::span<const float> branch_penalty) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < corners.size(); ++t) {
    const TriangleKind kind = corners[t].kind;
    if (!is_branch(kind)) continue;
    const auto& [a, b, c] = triangles[t];
    count += branch_penalty[a] + branch_penalty[b] + branch_penalty[c] >= 1.5f;
  }
  return count;
}

void set_corners(std::span<const Triangle> triangles, StripePattern& pattern,
                 const Progress& progress) {
  pattern.corners.resize(triangles.size());
  fill_corner_phases(triangles, pattern.waves, pattern.solution.z, pattern.phase_shift,
                     pattern.corners, progress);
}

void set_quality(const Surface& surface, std::span<const float> branch_penalty,
                 StripePattern& pattern, const Progress& progress) {
  WaveSet& waves = pattern.waves;
  PatternQuality quality = quality_of(surface, waves, pattern, progress.part(0, 0.5));
  quality.spacing_error_wanted_mean = quality.spacing_error_mean;
  if (!pattern.frequencies_wanted.empty()) {
    // Measures the requested frequencies in place of the pattern's; the destructor restores them.
    struct Swapped {
      StripePattern& pattern;
      explicit Swapped(StripePattern& p) : pattern(p) { swap(); }
      ~Swapped() { swap(); }
      Swapped(const Swapped&) = delete;
      Swapped& operator=(const Swapped&) = delete;
      void swap() { std::swap(pattern.waves.frequencies, pattern.frequencies_wanted); }
    };
    const Swapped wanted(pattern);
    quality.spacing_error_wanted_mean =
        quality_of(surface, waves, pattern, progress.part(0.5, 1)).spacing_error_mean;
  }
  if (!branch_penalty.empty()) {
    quality.branches_in_avoided_area =
        count_in_avoided_area(surface.mesh.triangles, pattern.corners, branch_penalty);
  }
  pattern.quality = quality;
}

void measure_pattern(const Surface& surface, std::span<const float> branch_penalty,
                     StripePattern& pattern, const Progress& progress) {
  set_corners(surface.mesh.triangles, pattern, progress.part(0, 0.4));
  set_quality(surface, branch_penalty, pattern, progress.part(0.4, 1));
}

StripeMilliseconds times_of(const FrameMilliseconds& frame) {
  StripeMilliseconds times;
  times.frequency = frame.frequency;
  times.couple = frame.couple;
  times.solve = frame.sum + frame.solve;
  return times;
}

void set_frame(WaveSet waves, const FrameResult& frame, StripePattern& pattern) {
  pattern.waves = std::move(waves);
  if (!frame.frequencies.empty()) {
    pattern.frequencies_wanted = std::exchange(
        pattern.waves.frequencies, {frame.frequencies.begin(), frame.frequencies.end()});
    pattern.frequency_change = frame.frequency_change;
  }
  pattern.solution.z.assign(frame.z.begin(), frame.z.end());
  pattern.milliseconds = times_of(frame.milliseconds);
}

void set_oriented_waves(std::span<const Triangle> triangles, const TextureOrientation& orientation,
                        TexturePattern& pattern, const Progress& progress) {
  pattern.seams = orientation.seams();
  set_texture_waves(triangles, orientation.signs(), vertex_waves(pattern.u),
                    vertex_waves(pattern.v), pattern.waves, progress);
}

TextureQuality texture_quality(const Mesh& mesh, const TexturePattern& pattern,
                               const Progress& progress) {
  return measure_texture(mesh, {pattern.u.corners, pattern.u.waves.frequencies},
                         {pattern.v.corners, pattern.v.waves.frequencies}, progress);
}

void orient_texture(const Mesh& mesh, bool as_given, const Progress& progress,
                    TexturePattern& pattern) {
  progress.report(0);
  TextureOrientation orientation(mesh.triangles);
  progress.tick();
  orientation.follow(pattern.u.waves.directions, pattern.v.waves.directions, as_given,
                     progress.part(0, 0.8));
  set_oriented_waves(mesh.triangles, orientation, pattern, progress.part(0.8, 0.9));
  pattern.quality = texture_quality(mesh, pattern, progress.part(0.9, 1));
}

}  // namespace brindle
