#include <string>

#include "gallery/items.h"
#include "gallery/liver_parts.h"

namespace brindle {
namespace {

std::vector<GalleryFile> make_liver(double detail, const Progress& progress) {
  return {{"vessels.vtp", liver_vessels_mesh(detail, progress.part(0, 0.8)), {}, {}},
          {"tumour.vtp", liver_tumour_mesh(detail, progress.part(0.8, 0.9)), {}, {}},
          {"needle.vtp", needle_mesh(detail, progress.part(0.9, 1)), {}, {}}};
}

/// Ten stripes over the distance from the needle's tip, at least 8 mm, in stripes per millimetre.
GalleryPicture needle_picture(const std::string& name, const std::string& what,
                              const std::string& tip) {
  return {name,
          what,
          "stripe {surface=vessels.vtp} --field {field=curvature} --along --frequency 10 "
          "--frequency-by {values=distance:" +
              tip + "}@0.001..0.125,reciprocal --width-by {values=distance:" + tip +
              "}@0.55..0.22 --legend {own='distance to needle tip in mm'} "
              "--depth-cue chroma --with {file=tumour.vtp}@untinted@#eab04c "
              "--with {file=needle.vtp}@untinted@#9aa1a8@" +
              tip + " --colors #17141c,#ffffff,#ffffff --up z --camera 20,12,0.86",
          "760x560",
          {"frequency", "width-range", "depth-cue"}};
}

std::vector<GalleryFile> make_nested(double detail, const Progress& progress) {
  return {{"hull.vtp", liver_hull_mesh(detail, progress.part(0, 0.4)), {}, {}},
          {"vessels.vtp", liver_vessels_mesh(detail, progress.part(0.4, 0.9)), {}, {}},
          {"tumour.vtp", liver_tumour_mesh(detail, progress.part(0.9, 1)), {}, {}}};
}

}  // namespace

GalleryItem liver_item() {
  return {"liver",
          "vessels hatched by their distance to a needle",
          make_liver,
          {needle_picture("near", "the needle at the tumour", "-40,-26,19"),
           needle_picture("far", "the needle further away", "-8,-66,40")}};
}

GalleryItem nested_item() {
  return {"nested",
          "a hull of stripes over vessels and a tumour in their own colours",
          make_nested,
          {{"focus",
            "thin strokes where one looks inside",
            "stripe {surface=hull.vtp} --field {field=smooth} --stripes 56 --between nothing "
            "--width-by {values=distance:-42,-60,10}@0.07..0.5 --legend none "
            "--with {file=vessels.vtp}@untinted@#c02a24 "
            "--with {file=tumour.vtp}@untinted@#e0a92f --colors #4f7891,#4f7891,#ffffff "
            "--depth-cue haze --occlusion 0.4 --up z --camera 20,12,0.9",
            "720x500",
            {"stripes", "width-range", "between", "depth-cue", "occlusion"}}}};
}

}  // namespace brindle
