#include "preparation.h"

#include <utility>

#include "brindle/base/stopwatch.h"

namespace brindle::tool {

Preparation prepare(const SurfaceOptions& surface, const WaveOptions& waves,
                    ProgressDisplay& display) {
  Preparation result;
  Stopwatch watch;
  display.stage("loading " + surface.mesh);
  LoadedMesh loaded = load_mesh(surface);
  display.note(describe(loaded.repair));
  result.load_milliseconds = watch.lap();

  display.stage("neighbourhood and normals");
  result.surface = make_surface(std::move(loaded.mesh));
  result.topology_milliseconds = watch.lap();

  display.stage("direction field");
  result.waves = make_waves(result.surface, waves);
  result.load_milliseconds += watch.lap();
  return result;
}

}  // namespace brindle::tool
