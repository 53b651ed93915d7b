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

/// Ten stripes over the distance from the needle's tip, at least 8 mm, per millimetre.
GalleryPicture needle_picture(const std::string& name, const std::string& what,
                              const std::string& tip) {
  return {name,
          what,
          "stripe {surface=vessels.vtp} --field {field=curvature} --along --frequency 10 "
          "--frequency-by {values=distance:" +
              tip +
              "} --frequency-range 0.001,0.125,reciprocal --width-by {values=distance:" + tip +
              "} --width-range 0.68,0.3 --no-legend --depth-cue chroma "
              "--with {file=tumour.vtp}@#e6c9a0 --with {file=needle.vtp}@#ffffff@" +
              tip + " --colors #2a2522,#f4efe6,#ffffff --up z --camera 20,12",
          "760x620",
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
            "stripe {surface=hull.vtp} --field {field=smooth} --stripes 64 --between nothing "
            "--width-by {values=distance:-42,-60,10} --width-range 0.08,0.62 --no-legend "
            "--with {file=vessels.vtp}@#b5352b --with {file=tumour.vtp}@#d9a441 "
            "--colors #8f5a4a,#8f5a4a,#ffffff --occlusion 0.5 --up z --camera 20,12",
            "640x470",
            {"stripes", "width-range", "between", "occlusion"}}}};
}

}  // namespace brindle
