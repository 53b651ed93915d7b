#include "brindle/mesh.h"
#include "gallery/items.h"
#include "gallery/machine_parts.h"

namespace brindle {
namespace {

std::vector<GalleryFile> make_parts(double detail, const Progress& progress) {
  const auto edge = static_cast<float>(0.021 / detail);
  GalleryFile file{"parts.vtp", flange_mesh(edge, progress.part(0, 0.6)), {}, {}};
  Mesh ball = windowed_ball_mesh(edge, progress.part(0.6, 1));
  translate(ball, {2.1f, 0.15f, 0.45f});
  append(ball, file.mesh);
  return {std::move(file)};
}

}  // namespace

GalleryItem crosses_item() {
  return {"crosses",
          "a mechanical part and a ball in tiles that look the same turned by 90 degrees",
          make_parts,
          {{"tiles",
            "tiles along a cross field that follows edges and curvature",
            "stripe {surface=parts.vtp} --cross --field {field=curvature} "
            "--feature-anchor 1 --texture checker --stripes 54 "
            "--colors #2f5d73,#f3ede0,#ffffff --up z --camera 0,38,0.98",
            "720x420",
            {"stripes", "texture", "curvature-anchor", "feature-anchor"}}}};
}

}  // namespace brindle
