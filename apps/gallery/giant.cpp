#include "gallery/hare.h"
#include "gallery/items.h"

namespace brindle {
namespace {

/// 0.8 million vertices at full detail.
constexpr double kEdge = 0.0032;

std::vector<GalleryFile> make_giant(double detail, const Progress& progress) {
  return {{"giant.vtp", fine_hare_mesh(static_cast<float>(kEdge / detail), progress), {}, {}}};
}

}  // namespace

GalleryItem giant_item() {
  return {"giant",
          "a surface with 800,000 vertices",
          make_giant,
          {{"stripes",
            "fine stripes over all of it",
            "stripe {surface=giant.vtp} --field {field=curvature} --along --stripes 110 "
            "--colors #1c325a,#f4efe6,#ffffff --up z --camera 35,10,1.02",
            "600x690",
            {"stripes", "rotate", "stripe-width"}}}};
}

}  // namespace brindle
