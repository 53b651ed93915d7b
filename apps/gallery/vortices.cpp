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

namespace {

std::string style_of_vortices(bool moving) {
  return "--field {field=array:velocity} --oriented --stripes 44 "
         "--frequency-by {values=array:speed}@0.7..1.6,inverse "
         "--texture arrows" +
         std::string(moving ? ",flow=1" : "") +
         " --texture-by {values=array:near},regions=0.62,dots@#8fa3b3 "
         "--color-by {own=array:core} --colormap {own=coolwarm} "
         "--legend {own=none} "
         "--colors #243b55,#f2efe8,#ffffff --up z --camera 50,22,0.95";
}

}  // namespace

GalleryItem vortices_item() {
  return {"vortices",
          "arrows around two vortices that move, dots where little happens",
          make_vortices,
          {{"still",
            "one step: arrows near the cores, larger where the flow is faster",
            "stripe {surface=step_000.vtp} " + style_of_vortices(false),
            "760x560",
            {"stripes", "frequency-range", "regions", "texture-shift"}},
           {"flow", "all steps: the cores travel, tiles flow along the field",
            "animate --series {file=step_%03d.vtp} " + style_of_vortices(true), "560x420"}}};
}

}  // namespace brindle
