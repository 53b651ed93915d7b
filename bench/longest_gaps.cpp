// How long each of the library's long jobs leaves its caller unheard: the longest time between two
// reports of its progress, its begin and its end counted as reports. Time is that of the calling
// thread on a processor, which takes part in all work, so that other programs do not count.
// `longest_gaps [torus resolution] [words of jobs' names...]`.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <unistd.h>

#include "brindle/branch_pairs.h"
#include "brindle/camera.h"
#include "brindle/carried_phases.h"
#include "brindle/cross_animator.h"
#include "brindle/cross_texture.h"
#include "brindle/feature_lines.h"
#include "brindle/files.h"
#include "brindle/glyphs.h"
#include "brindle/image.h"
#include "brindle/line_drawing.h"
#include "brindle/normals.h"
#include "brindle/points.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/spacing_tolerance.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"
#include "brindle/strokes.h"
#include "brindle/texture_animator.h"
#include "brindle/texture_coordinates.h"
#include "brindle/texture_pattern.h"
#include "gallery/gallery.h"

namespace {

using namespace brindle;

double milliseconds() {
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

constexpr float kFrequency = 12;
std::string resolution = "1290";  // some 800,000 vertices

/// The gaps between the reports of one job.
class Gaps {
 public:
  Progress progress() {
    last_ = milliseconds();
    return Progress([this](const ProgressReport& report) {
      hear(report.step, report.fraction);
      return true;
    });
  }
  void end() { hear("(end)", 1); }

  void print(const std::string& name) const {
    std::printf("%-34s %7.0f ms in %5zu reports, longest gap %6.0f ms: ", name.c_str(), total_,
                reports_ - 1, longest_);
    std::printf("%s %.3f -> %s %.3f\n", from_.c_str(), from_fraction_, to_.c_str(), to_fraction_);
    std::fflush(stdout);
  }

 private:
  void hear(std::string_view step, double fraction) {
    const double gap = milliseconds() - last_;
    ++reports_;
    total_ += gap;
    if (gap > longest_) {
      longest_ = gap;
      from_ = step_, from_fraction_ = fraction_;
      to_ = step, to_fraction_ = fraction;
    }
    step_ = step;
    fraction_ = fraction;
    last_ = milliseconds();
  }

  double last_ = 0, longest_ = 0, total_ = 0;
  std::size_t reports_ = 0;
  std::string step_ = "(begin)", from_, to_;
  double fraction_ = 0, from_fraction_ = 0, to_fraction_ = 0;
};

const Surface& torus() {
  static const Surface surface = make_surface(make_shape("torus,resolution=" + resolution));
  return surface;
}

const DirectionField& field() {
  static const DirectionField directions = smooth_direction_field(torus());
  return directions;
}

/// A field with singularities and curl, as those of real data.
const DirectionField& rough_field() {
  static const DirectionField directions =
      projected_direction_field({1, 0.3f, 0.2f}, torus().normals);
  return directions;
}

const WaveSet& rough_waves() {
  static const WaveSet waves{torus().mesh.positions, rough_field(),
                             FrequencyField(torus().mesh.vertex_count(), kFrequency)};
  return waves;
}

FrameInput rough_frame() {
  const WaveSet& waves = rough_waves();
  return {waves.positions, waves.directions, waves.frequencies};
}

const Surface& points() {
  static const Surface surface =
      make_point_surface(make_point_cloud(torus().mesh.positions).cloud, 8);
  return surface;
}

const StripePattern& pattern() {
  static const StripePattern stripes = stripe_pattern(torus(), field(), kFrequency);
  return stripes;
}

const StripePattern& rough_pattern() {
  static const StripePattern stripes = stripe_pattern(torus(), rough_waves());
  return stripes;
}

const StripeCurves& curves() {
  static const StripeCurves traced = stripe_curves(torus(), pattern());
  return traced;
}

std::vector<Sample> many_samples() {
  std::vector<Sample> samples;
  const Surface& s = torus();
  for (Index v = 0; v < s.mesh.vertex_count() / 8; ++v) {
    Sample sample;
    sample.barycentric = Vec3::Zero();
    sample.position = s.mesh.positions[v];
    sample.normal = s.normals[v];
    sample.direction_u = sample.direction_v = field()[v];
    sample.spacing_u = sample.spacing_v = 0.01f;
    samples.push_back(sample);
  }
  return samples;
}

Image picture() {
  Image image(6000, 4000);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto level = static_cast<std::uint8_t>((x * 7 + y * 13 + (x * y) / 91) % 251);
      image.at(x, y) = {level, static_cast<std::uint8_t>(255 - level), 17, 255};
    }
  }
  return image;
}

const Visibility& seen() {
  static const Visibility visibility(torus().mesh, CameraView{}, 4000, 3000);
  return visibility;
}

std::filesystem::path scratch(const char* name) {
  return std::filesystem::temp_directory_path() /
         ("longest_gaps_" + std::to_string(getpid()) + name);
}

struct Job {
  std::string name;
  std::function<void(const Progress&)> run;
};

/// Jobs that keep nothing: their first run counts.
std::vector<Job> making_jobs() {
  std::vector<Job> jobs;
  for (const std::string& spec :
       {"torus,resolution=" + resolution, std::string("plane,resolution=900"),
        std::string("sphere,resolution=280"), "torus,noise=0.5,resolution=" + resolution,
        std::string("vessels,resolution=500"), std::string("molecule,resolution=265"),
        std::string("box,resolution=250")}) {
    jobs.push_back({"make_shape " + spec, [spec](const Progress& p) { make_shape(spec, p); }});
  }
  for (const GalleryItem& item : gallery_items()) {
    jobs.push_back({"data of " + item.name, [&item](const Progress& p) { item.make(1, p); }});
  }
  return jobs;
}

std::vector<Job> field_jobs() {
  SmoothFieldOptions by_features;
  by_features.feature_anchor = 1;
  by_features.feature_radius = 0.05f;
  by_features.feature_angle_deg = 30;
  return {
      {"make_surface", [](const Progress& p) { make_surface(torus().mesh, p); }},
      {"feature_strokes", [](const Progress& p) { feature_strokes(torus(), 0.05f, 0.1, 1, p); }},
      {"smooth_direction_field", [](const Progress& p) { smooth_direction_field(torus(), {}, p); }},
      {"smooth field with feature strokes",
       [by_features](const Progress& p) { smooth_direction_field(torus(), by_features, p); }},
      {"make_point_cloud",
       [](const Progress& p) { make_point_cloud(torus().mesh.positions, {}, p); }},
      {"make_point_surface",
       [](const Progress& p) {
         static const PointCloud cloud = make_point_cloud(torus().mesh.positions).cloud;
         make_point_surface(cloud, 8, p);
       }},
      {"relaxed_frequencies",
       [](const Progress& p) { relaxed_frequencies(torus(), rough_waves(), 0.2f, p); }},
  };
}

/// Patterns of waves, by what is unusual in their options.
std::vector<Job> stripe_jobs() {
  std::vector<Job> jobs;
  const auto add = [&](const std::string& name, const StripeOptions& options) {
    jobs.push_back({"stripe_pattern " + name, [options](const Progress& p) {
                      stripe_pattern(torus(), rough_waves(), options, p);
                    }});
  };
  StripeOptions slack, cotangent;
  slack.slack = 0.2f;
  cotangent.weights = EdgeWeights::cotangent;
  for (const Solver solver : {Solver::multilevel, Solver::relaxation, Solver::averaged}) {
    StripeOptions options;
    options.solver.solver = solver;
    options.solver.max_iterations = 40;
    add(std::string(name_of(solver)), options);
  }
  add("slack", slack);
  add("cotangent", cotangent);
  for (const auto& [name, options] :
       {std::pair("points", StripeOptions()), {"points slack", slack}}) {
    jobs.push_back({std::string("stripe_pattern ") + name, [options = options](const Progress& p) {
                      static const DirectionField along =
                          projected_direction_field({1, 0.3f, 0.2f}, points().normals);
                      stripe_pattern(points(), along, kFrequency, options, p);
                    }});
  }
  jobs.push_back(
      {"cross_pattern", [](const Progress& p) { cross_pattern(torus(), rough_waves(), {}, p); }});
  jobs.push_back({"cross_pattern slack",
                  [slack](const Progress& p) { cross_pattern(torus(), rough_waves(), slack, p); }});
  return jobs;
}

std::vector<Job> pattern_jobs() {
  AnimatorOptions slack;
  slack.slack = 0.2f;
  return {
      {"StripeAnimator first frame",
       [](const Progress& p) { StripeAnimator(torus()).frame(rough_frame(), p); }},
      {"StripeAnimator slack first frame",
       [slack](const Progress& p) { StripeAnimator(torus(), slack).frame(rough_frame(), p); }},
      {"CrossAnimator first frame",
       [](const Progress& p) { CrossAnimator(torus()).frame({rough_frame()}, p); }},
      {"cancel_branches",
       [](const Progress& p) {
         StripePattern merged = rough_pattern();
         cancel_branches(torus(), merged, {0.1}, {}, p);
       }},
      {"texture_pattern",
       [](const Progress& p) { texture_pattern(torus(), rough_field(), kFrequency, {}, p); }},
      {"stripe_curves",
       [](const Progress& p) { stripe_curves(torus(), pattern(), {.join = true}, p); }},
  };
}

std::vector<Job> picture_jobs() {
  return {
      {"glyphs_at",
       [](const Progress& p) {
         static const std::vector<Sample> samples = many_samples();
         glyphs_at(samples, GlyphShape::disc, glyph_sizes(samples, 0.5f), p);
       }},
      {"write_png",
       [](const Progress& p) {
         static const Image image = picture();
         const auto path = scratch(".png");
         write_png(path, image, p);
         std::filesystem::remove(path);
       }},
      {"Visibility",
       [](const Progress& p) { Visibility(torus().mesh, CameraView{}, 4000, 3000, p); }},
      {"Visibility::strokes",
       [](const Progress& p) { seen().strokes(curves().lines, 1e-4f, false, p); }},
      {"outline",
       [](const Progress& p) {
         outline(torus().mesh, torus().normals, CameraView{}, 4000, 3000, p);
       }},
      {"silhouette_lines",  // short: it reports nothing
       [](const Progress&) {
         silhouette_lines(torus().mesh, torus().normals, {3, 2, 1});
       }},
      {"crease_lines",
       [](const Progress& p) { crease_lines(torus().mesh, torus().normals, 10.0f, p); }},
      {"write_svg",
       [](const Progress& p) {
         static const std::vector<Pen> pens(8, Pen{"p", {}, 1, seen().strokes(curves().lines)});
         const auto path = scratch(".svg");
         write_svg(path, 4000, 3000, pens, p);
         std::filesystem::remove(path);
       }},
  };
}

/// Runs a job once before, if it keeps what is made once.
void measure(const Job& job, bool keeps) {
  try {
    if (keeps) job.run({});
    Gaps gaps;
    job.run(gaps.progress());
    gaps.end();
    gaps.print(job.name);
  } catch (const std::exception& error) {
    std::printf("%-34s %s\n", job.name.c_str(), error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) resolution = argv[1];
  std::printf("torus of %zu vertices\n", torus().mesh.vertex_count());
  const std::vector<std::string> words(argv + std::min(argc, 2), argv + argc);
  const auto measure_all = [&](const std::vector<Job>& jobs, bool keeps) {
    for (const Job& job : jobs) {
      const auto is_in_name = [&](const std::string& word) {
        return job.name.find(word) != std::string::npos;
      };
      if (words.empty() || std::ranges::any_of(words, is_in_name)) measure(job, keeps);
    }
  };
  measure_all(making_jobs(), false);
  for (const auto& jobs : {field_jobs(), stripe_jobs(), pattern_jobs(), picture_jobs()}) {
    measure_all(jobs, true);
  }
}
