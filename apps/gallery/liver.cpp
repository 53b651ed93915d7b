#include <algorithm>
#include <string>

#include "gallery/items.h"
#include "gallery/liver_parts.h"

namespace brindle {
namespace {

constexpr double kNearest = 8;  // mm: from there on strokes get no finer

/// Distances to a needle's tip and the frequencies of strokes that are a tenth of them apart.
void add_distances(const std::string& name, const Eigen::Vector3d& tip, GalleryFile& file) {
  std::vector<float> distances, frequencies;
  for (const Vec3& position : file.mesh.positions) {
    const double distance = (position.cast<double>() - tip).norm();
    distances.push_back(static_cast<float>(distance));
    frequencies.push_back(static_cast<float>(10 / std::max(distance, kNearest)));
  }
  file.arrays.points.push_back(make_data_array("distance_" + name, 1, distances));
  file.arrays.points.push_back(make_data_array("frequency_" + name, 1, frequencies));
}

std::vector<GalleryFile> make_liver(double detail) {
  GalleryFile vessels{"vessels.vtp", liver_vessels_mesh(detail), {}, {}};
  add_distances("far", kTipFar, vessels);
  add_distances("near", kTipNear, vessels);
  return {std::move(vessels),
          {"tumour.vtp", liver_tumour_mesh(detail), {}, {}},
          {"needle_far.vtp", needle_mesh(kTipFar, detail), {}, {}},
          {"needle_near.vtp", needle_mesh(kTipNear, detail), {}, {}}};
}

GalleryPicture needle_picture(const std::string& name, const std::string& what) {
  return {name, what,
          "stripe {surface=vessels.vtp} --field curvature --along "
          "--frequency {field=array:frequency_" +
              name + "} --width-by {values=array:distance_" + name +
              "} --width-range 0.68,0.3 --no-legend --depth-cue chroma "
              "--with {file=tumour.vtp}@#e6c9a0 --with {file=needle_" +
              name + ".vtp}@#ffffff --colors #2a2522,#f4efe6,#ffffff --up z --camera 20,12",
          "760x620"};
}

std::vector<GalleryFile> make_nested(double detail) {
  return {{"hull.vtp", liver_hull_mesh(detail), {}, {}},
          {"vessels.vtp", liver_vessels_mesh(detail), {}, {}},
          {"tumour.vtp", liver_tumour_mesh(detail), {}, {}}};
}

}  // namespace

GalleryItem liver_item() {
  return {"liver",
          "vessels hatched by their distance to a needle",
          make_liver,
          {needle_picture("near", "the needle at the tumour"),
           needle_picture("far", "the needle further away")}};
}

GalleryItem nested_item() {
  return {"nested",
          "a hull of stripes over vessels and a tumour in their own colours",
          make_nested,
          {{"focus", "thin strokes where one looks inside",
            "stripe {surface=hull.vtp} --field {field=smooth} --stripes 64 --between nothing "
            "--width-by {values=distance:-42,-60,10} --width-range 0.08,0.62 --no-legend "
            "--with {file=vessels.vtp}@#b5352b --with {file=tumour.vtp}@#d9a441 "
            "--colors #8f5a4a,#8f5a4a,#ffffff --occlusion 0.5 --up z --camera 20,12",
            "640x470"}}};
}

}  // namespace brindle
