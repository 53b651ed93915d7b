#include "gallery/hare.h"
#include "gallery/items.h"

namespace brindle {
namespace {

std::vector<GalleryFile> make_figure(double detail, const Progress& progress) {
  const auto edge = static_cast<float>(0.016 / detail);
  return {{"hare.vtp", hare_mesh(edge, progress.part(0, 0.9)), {}, {}},
          {"pupils.vtp", hare_pupils(0.4f * edge, progress.part(0.9, 0.95)), {}, {}},
          {"glints.vtp", hare_glints(0.2f * edge, progress.part(0.95, 1)), {}, {}}};
}

}  // namespace

GalleryItem hatching_item() {
  return {"hatching",
          "pen drawings of a figure",
          make_figure,
          {{"pen",
            "strokes as thick as it is dark, crossed in the dark, with an outline",
            "stripe {surface=hare.vtp} --field {field=curvature} --stripes 150 "
            "--width-by light@0..0.62,tones=0.3..0.95,cross-hatch=0.3 --outline solid,width=2 "
            "--with {part=pupils.vtp}@#1b1b1f --with {part=glints.vtp}@#f7f3ea "
            "--colors #1b1b1f,#f7f3ea,#f7f3ea --up z --camera 35,10,0.98",
            "640x700",
            {"stripes", "tones", "cross-hatch", "line-width"}},
           {"dashed",
            "the outline dashed by the pattern, for what matters less",
            "stripe {surface=hare.vtp} --direction 0.35,0.6,1 --stripes 96 --stripe-width 0 "
            "--outline dashed,width=2.4 --flat --colors #1b1b1f,#f7f3ea,#f7f3ea --up z "
            "--camera 35,10,0.93",
            "640x700",
            {"stripes", "direction", "line-width"}},
           {"strokes",
            "strokes of a brush that cross the outline",
            "sample {surface=hare.vtp} --field {field=curvature} --stripes 90 --stripes-v 36 "
            "--glyph stroke --glyph-size 1.15 --colors #22252b,#f4ecdc,#f4ecdc --up z "
            "--camera 35,10,0.93",
            "640x700",
            {"stripes", "stripes-v", "glyph-size"}}}};
}

}  // namespace brindle
