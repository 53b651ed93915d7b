#include <string>

#include "gallery/flows.h"
#include "gallery/items.h"

namespace brindle {
namespace {

std::vector<GalleryFile> make_vortices(double detail, const Progress& progress) {
  const Mesh pebble = vortex_pebble(detail, progress.part(0, 0.5));
  const Progress steps_made = progress.part(0.5, 1);
  std::vector<GalleryFile> steps;
  for (int number = 0; number < kVortexSteps; ++number) {
    steps_made.report(static_cast<double>(number) / kVortexSteps);
    steps.push_back(vortex_step(number, pebble));
  }
  return steps;
}

}  // namespace

GalleryItem vortices_item() {
  const std::string style =
      "--field {field=array:velocity} --oriented --stripes 44 "
      "--frequency-by {values=array:speed} "
      "--frequency-range 0.7,1.6,inverse --texture arrows --texture-by {values=array:near} "
      "--regions 0.62,dots@#8fa3b3 --color-by {own=array:core} --colormap {own=coolwarm} "
      "{own=--no-legend} "
      "--colors #243b55,#f2efe8,#ffffff --up z --camera 50,22,0.95";
  return {"vortices",
          "arrows around two vortices that move, dots where little happens",
          make_vortices,
          {{"still",
            "one step: arrows near the cores, larger where the flow is faster",
            "stripe {surface=step_000.vtp} " + style,
            "760x560",
            {"stripes", "frequency-range", "regions", "texture-shift"}},
           {"flow", "all steps: the cores travel, tiles flow along the field",
            "animate --series {file=step_%03d.vtp} " + style + " --texture-flow 1", "560x420"}}};
}

}  // namespace brindle
