#include "brindle/recipe/wave_report.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/pattern_warnings.h"

namespace brindle {
namespace {

std::vector<std::string> reasons(const MissingWaves& missing) {
  std::vector<std::string> lines;
  const auto add = [&](std::size_t count, const char* why) {
    if (count > 0) lines.push_back(formatted("%zu vertices have no wave: %s", count, why));
  };
  add(missing.too_far.value_or(0), "they are farther than --max-distance from the field's mesh");
  if (missing.unfilled) {
    add(*missing.unfilled, "they are farther than --fill from all data");
  } else if (missing.tensor) {
    add(missing.tensor->near_normal, "the tensor's axis is within 15 degrees of the normal");
    add(missing.tensor->isotropic, "the tensor has the same eigenvalue along other axes");
  }
  add(missing.without_frequency.value_or(0), "the array of their frequencies is not finite");
  return lines;
}

std::string warning_lines(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += "warning: " + sentence + "\n";
  return text;
}

}  // namespace

std::size_t unfilled_alone(const FieldSmoothingMetrics& smoothing, const MissingWaves& missing) {
  const std::size_t others = missing.without_frequency.value_or(0) + missing.too_far.value_or(0);
  return smoothing.unfilled - std::min(others, smoothing.unfilled);
}

WarningWords words_of_options(const std::string& source, std::optional<int> subdivided) {
  WarningWords words;
  words.fewer =
      "take fewer stripes: lower --stripes or --frequency, which counts stripes per unit of the "
      "mesh's own length";
  words.subdivide = subdivided ? "--subdivide" : "";
  words.subdivided = subdivided.value_or(0);
  words.field = "--field";
  words.smoothing = "--field-smoothing 1";
  words.singularities = "--field-singularities";
  words.source = source;
  return words;
}

void check_wave_report(const WaveReport& metrics, const std::string& source) {
  std::string why;
  for (const std::string& reason : reasons(metrics.missing)) why += "; " + reason;
  const bool all_told = metrics.missing.total() >= metrics.used;
  if (metrics.used > 0 && metrics.without_wave == metrics.used && all_told) {
    throw Error("no vertex has a wave" + why);
  }
  check_metrics(metrics, words_of_options(source), why);
}

std::string warnings(const WaveReport& metrics, const std::string& source) {
  const WarningWords words = words_of_options(source, metrics.subdivided);
  std::string text;
  for (const std::string& reason : reasons(metrics.missing)) text += reason + "\n";
  text += warning_lines(turn_warnings(metrics.turned_apart));
  if (metrics.smoothing) {
    text += warning_lines(smoothing_warnings(*metrics.smoothing, words));
  }
  WaveMetrics unexplained = metrics;
  unexplained.without_wave -= metrics.missing.total();
  return text + warning_lines(wave_warnings(unexplained, words));
}

std::string tile_warning(const BrokenTiles& broken, std::size_t triangles) {
  return warning_lines(tile_warnings(broken, triangles, words_of_options("")));
}

std::string quality_warning(const WaveReport& metrics, const PatternQuality& quality,
                            std::size_t triangles) {
  const WarningWords words = words_of_options("", metrics.subdivided);
  std::vector<std::string> sentences = quality_warnings(metrics, quality, triangles, words);
  if (metrics.measured && !metrics.smoothing) {
    for (std::string& sentence : noise_warnings(quality.field_singularities, triangles, words)) {
      sentences.push_back(std::move(sentence));
    }
  }
  return warning_lines(sentences);
}

}  // namespace brindle
