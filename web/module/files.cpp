#include "brindle/files.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <emscripten/bind.h>

#include "brindle/error.h"
#include "brindle/line_drawing.h"
#include "objects.h"

namespace brindle::web {
namespace {

/// What `write` puts into a file of this name.
template <class Write>
val written(const std::string& name, const Write& write) {
  const std::filesystem::path path = "written-" + name;
  write(path);
  std::ifstream in(path, std::ios::binary);
  const std::vector<char> content{std::istreambuf_iterator<char>(in), {}};
  in.close();
  std::filesystem::remove(path);
  return array_of(std::span<const std::uint8_t>(
      reinterpret_cast<const std::uint8_t*>(content.data()), content.size()));
}

val curves_file(const PatternObject& object, std::string name, bool join, float trim) {
  return guarded([&] {
    CurveOptions options;
    options.join = join;
    options.trim = trim;
    const StripeCurves curves = stripe_curves(object.surface->surface, object.pattern, options);
    const std::array<NamedLines, 1> kinds{NamedLines{"stripes", curves.lines, {}}};
    return written(name, [&](const std::filesystem::path& path) { write_polylines(path, kinds); });
  });
}

val drawing(const PatternObject& object, val rotation, float zoom, int width, int height) {
  return guarded([&] {
    const Surface& surface = object.surface->surface;
    CameraView view;
    view.zoom = zoom;
    view.rotation = Eigen::Quaternionf(rotation[3].as<float>(), rotation[0].as<float>(),
                                       rotation[1].as<float>(), rotation[2].as<float>());
    const StripeCurves curves = stripe_curves(surface, object.pattern);
    const std::array<PenLines, 1> lines{PenLines{"stripes", Color{}, curves.lines}};
    const std::vector<Pen> pens =
        line_drawing(surface.mesh, surface.normals, lines, view, width, height);
    return written("drawing.svg", [&](const std::filesystem::path& path) {
      write_svg(path, width, height, pens);
    });
  });
}

}  // namespace

void bind_files() {
  using namespace emscripten;
  function("curvesFile", &curves_file);
  function("drawing", &drawing);
}

}  // namespace brindle::web
