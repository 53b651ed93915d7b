#include "brindle/pattern_warnings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "brindle/base/text.h"

namespace brindle {
namespace {

constexpr double kMostBranches = 0.1;   // share of the area
constexpr double kMostSingular = 0.01;  // share of the triangles
constexpr double kMostCoarse = 0.25;    // share of the area
constexpr double kFewestEdges = 2;      // a period
constexpr double kFewestWhole = 0.1;    // share of the triangles
constexpr int kMostSubdivisions = 6;    // that are worth proposing

/// "; or subdivide the mesh, times: 2", or nothing.
std::string or_subdivide(int times, const WarningWords& words) {
  if (words.subdivide.empty() || times < 1 || times > kMostSubdivisions) return "";
  return "; or " + words.subdivide + " " + std::to_string(words.subdivided + times);
}

/// Until a wave passes enough edges; 0: it does.
int subdivisions_missing(const WaveMetrics& motifs) {
  const double edges = motifs.edges_per_period_median;
  return edges > 0 ? static_cast<int>(std::ceil(std::log2(kFewestEdges / edges))) : 0;
}

std::vector<std::string> warnings_of(const Surface& surface, const StripePattern& pattern,
                                     const PatternQuality& quality, const WarningWords& words) {
  WaveMetrics motifs;
  if (pattern.frequencies_wanted.empty()) {
    motifs = measure_waves(surface, pattern.waves);
  } else {
    WaveSet wanted = pattern.waves;
    wanted.frequencies = pattern.frequencies_wanted;
    motifs = measure_waves(surface, wanted);
  }
  std::vector<std::string> result = surface_warnings(surface, words.join);
  const auto add = [&](std::vector<std::string> more) {
    for (std::string& sentence : more) result.push_back(std::move(sentence));
  };
  add(wave_warnings(motifs, words));
  add(quality_warnings(motifs, quality, surface.mesh.triangle_count(), words));
  return result;
}

}  // namespace

std::vector<std::string> pattern_warnings(const Surface& surface, const StripePattern& pattern,
                                          const WarningWords& words) {
  return warnings_of(surface, pattern, pattern.quality, words);
}

std::vector<std::string> pattern_warnings(const Surface& surface, const TexturePattern& texture,
                                          const WarningWords& words) {
  return warnings_of(surface, texture.u, worse_of(texture.u.quality, texture.v.quality), words);
}

std::vector<std::string> quality_warnings(const WaveMetrics& motifs, const PatternQuality& quality,
                                          std::size_t triangles, const WarningWords& words) {
  if (quality.branch_area_share > kMostBranches) {
    return {formatted("stripes begin or end in %zu of %zu triangles, on %.0f %% of the area",
                      quality.branches, triangles, 100 * quality.branch_area_share) +
            "; " + words.fewer + "; or a smoother " + words.field +
            or_subdivide(subdivisions_missing(motifs), words)};
  }
  const double coarse = quality.coarse_share_over_5deg;
  if (coarse <= kMostCoarse) return {};
  return {formatted("on %.0f %% of the area stripes run more than 5 degrees off their field, in "
                    "triangles longer than half a period; ",
                    100 * coarse) +
          words.fewer + or_subdivide(std::max(1, subdivisions_missing(motifs)), words)};
}

PatternQuality worse_of(const PatternQuality& u, const PatternQuality& v) {
  PatternQuality worse;
  worse.branches = std::max(u.branches, v.branches);
  worse.field_singularities = std::max(u.field_singularities, v.field_singularities);
  worse.branch_area_share = std::max(u.branch_area_share, v.branch_area_share);
  worse.coarse_share_over_5deg = std::max(u.coarse_share_over_5deg, v.coarse_share_over_5deg);
  return worse;
}

std::vector<std::string> noise_warnings(std::size_t field_singularities, std::size_t triangles,
                                        const WarningWords& words) {
  const auto singular = static_cast<double>(field_singularities);
  const auto all = static_cast<double>(triangles);
  if (singular <= kMostSingular * all) return {};
  return {
      formatted("the field is singular in %zu of %zu triangles (%.1f %%), which suggests noise; ",
                field_singularities, triangles, 100 * singular / all) +
      words.smoothing + " smooths it"};
}

std::vector<std::string> tile_warnings(const BrokenTiles& broken, std::size_t triangles,
                                       const WarningWords& words) {
  const double whole = broken.whole_share(triangles);
  if (whole >= kFewestWhole) return {};
  return {formatted("motifs are whole in only %.1f %% of the triangles, and the others are left "
                    "out; ",
                    100 * whole) +
          words.fewer + "; or a smoother " + words.field + "; or cut motifs"};
}

std::vector<std::string> turn_warnings(std::size_t turned_apart) {
  if (turned_apart == 0) return {};
  return {
      formatted("along %zu edges the two sides of the surface meet, and neighbours turn in "
                "opposite senses; turn the field by a multiple of 90 degrees, or wind the "
                "triangles alike, if the surface has two sides",
                turned_apart)};
}

std::vector<std::string> smoothing_warnings(const FieldSmoothingMetrics& motifs,
                                            const WarningWords& words) {
  if (motifs.singularities_too_many == 0) return {};
  return {formatted("%zu singularities of the field are left, %zu more than ", motifs.singularities,
                    motifs.singularities_too_many) +
          words.singularities + " asks for: no pair of opposite ones undoes them"};
}

}  // namespace brindle
