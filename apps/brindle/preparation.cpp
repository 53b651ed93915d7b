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
  WavesAndCrossing made = make_waves(result.surface, waves);
  result.waves = std::move(made.waves);
  result.frequencies_v = std::move(made.frequencies_v);
  result.load_milliseconds += watch.lap();
  return result;
}

}  // namespace brindle::tool
