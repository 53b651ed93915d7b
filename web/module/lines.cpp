#include <array>
#include <cmath>

#include <emscripten/bind.h>

#include "brindle/base/memory_file.h"
#include "brindle/files.h"
#include "brindle/line_drawing.h"
#include "brindle/polylines.h"
#include "brindle/samples.h"
#include "objects.h"

namespace brindle::web {
namespace {

val lines_of(const Polylines& lines) {
  val result = val::object();
  put(result, "points", array_of(lines.points));
  put(result, "normals", array_of(lines.normals));
  put(result, "offsets", array_of(lines.offsets));
  put(result, "closed", array_of(lines.closed));
  return result;
}

/// NaN: the default of `trim`.
StripeCurves traced(const PatternObject& object, bool join, float trim, float fair) {
  CurveOptions options;
  options.join = join;
  if (!std::isnan(trim)) options.trim = trim;
  options.fair = fair;
  return stripe_curves(object.surface->surface, object.pattern, options);
}

val curves_of(const PatternObject& object, bool join, float trim, float fair) {
  const StripeCurves curves = traced(object, join, trim, fair);
  val result = lines_of(curves.lines);
  std::vector<std::uint8_t> ends;
  for (const auto& both : curves.ends) {
    for (const CurveEnd end : both) ends.push_back(static_cast<std::uint8_t>(end));
  }
  put(result, "ends", array_of(ends));
  return result;
}

val samples_of(const PatternObject& u, const PatternObject& v) {
  const std::vector<Sample> samples = stripe_samples(u.surface->surface, u.pattern, v.pattern);
  std::vector<Vec3> positions, normals;
  std::vector<std::uint32_t> triangles;
  std::vector<Vec3> barycentric;
  for (const Sample& sample : samples) {
    positions.push_back(sample.position);
    normals.push_back(sample.normal);
    triangles.push_back(sample.triangle);
    barycentric.push_back(sample.barycentric);
  }
  val result = val::object();
  put(result, "positions", array_of(positions));
  put(result, "normals", array_of(normals));
  put(result, "triangles", array_of(triangles));
  put(result, "barycentric", array_of(barycentric));
  return result;
}

/// What has been written into the file.
val content_of(const MemoryFile& file) {
  return array_of(std::span<const std::uint8_t>(
      reinterpret_cast<const std::uint8_t*>(file.content.data()), file.content.size()));
}

val curves_file(const PatternObject& object, const std::string& format, bool join, float trim,
                float fair) {
  const StripeCurves curves = traced(object, join, trim, fair);
  const std::array<NamedLines, 1> kinds{NamedLines{"stripes", curves.lines, {}}};
  MemoryFile file("stripes." + format);
  write_polylines(file.name(), kinds);
  return content_of(file);
}

val drawing(const PatternObject& object, const val& rotation, float zoom, bool orthographic,
            int width, int height, bool join, float trim, float fair) {
  const Surface& surface = object.surface->surface;
  CameraView view;
  view.zoom = zoom;
  if (orthographic) view.projection = Projection::orthographic;
  if (const std::vector<float> turn = floats_of(rotation); !turn.empty()) {
    view.rotation = Eigen::Quaternionf(turn[3], turn[0], turn[1], turn[2]);
  }
  const StripeCurves curves = traced(object, join, trim, fair);
  const std::array<PenLines, 1> lines{PenLines{"stripes", Color{}, curves.lines}};
  const std::vector<Pen> pens =
      line_drawing(surface.mesh, surface.normals, lines, view, width, height);
  MemoryFile file("drawing.svg");
  write_svg(file.name(), width, height, pens);
  return content_of(file);
}

}  // namespace

void bind_lines() {
  using namespace emscripten;
  function("curves", guarded<curves_of>);
  function("samples", guarded<samples_of>);
  function("curvesFile", guarded<curves_file>);
  function("drawing", guarded<drawing>);
}

}  // namespace brindle::web
