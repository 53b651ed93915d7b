#include "gallery/liver.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Geometry>

#include "gallery/items.h"
#include "gallery/vascular_tree.h"

namespace brindle {
namespace {

using Point = Eigen::Vector3d;

const Point kTumour(-48, -14, 12);
const BoundingBox kBody{{-125, -85, -100}, {125, 85, 85}};

// Above the hollow, slanting lower side.
double above_stomach(const Point& p) {
  const Point down = Point(0.42, -0.25, -0.87).normalized();
  const double bent = 0.0016 * (p.x() - 35) * (p.x() - 35);  // hollow under the left lobe
  return 0.75 * (down.dot(p - Point(20, 0, -26)) - bent * 0.4);
}

}  // namespace

ImplicitFunction liver_hull() {
  const ImplicitFunction lobes =
      blended({ellipsoid({-45, 0, 2}, {58, 56, 62}, turned(0, 12, 0)),
               ellipsoid({-58, 4, -38}, {38, 42, 46}, turned(0, 10, 0)),
               ellipsoid({30, -10, 22}, {72, 42, 34}, turned(0, 10, -6)),
               ellipsoid({78, -14, 20}, {34, 28, 16}, turned(0, 12, -6))},
              9);
  return common(lobes, above_stomach, 6);
}

ImplicitFunction liver_tumour() {
  return blended(
      {ball(kTumour, 12), ball(kTumour + Point(9, -3, 5), 8), ball(kTumour + Point(-6, 6, 8), 8.5),
       ball(kTumour + Point(-4, -8, -6), 8), ball(kTumour + Point(7, 7, -6), 7)},
      1.6);
}

std::vector<Capsule> liver_vessels() {
  const ImplicitFunction hull = liver_hull(), tumour = liver_tumour();
  // The hull's values are less than the distance: this is some millimetres below its surface.
  const auto inside = [&](const Point& p) { return hull(p) < -7 && tumour(p) > 7; };
  const std::vector<Point> places =
      scattered_places(kBody.lower.cast<double>(), kBody.upper.cast<double>(), 230, 11, inside);
  const VascularTree tree{.root = {12, 8, -78},
                          .direction = Point(-0.3, -0.1, 1).normalized(),
                          .trunk = 70,
                          .radius = 5.4,
                          .step = 4,
                          .thinnest = 0.95};
  return grow_vessels(tree, places);
}

Mesh liver_hull_mesh(double detail, const Progress& progress) {
  return isosurface(liver_hull(), kBody, static_cast<float>(1.9 / detail), progress);
}

Mesh liver_tumour_mesh(double detail, const Progress& progress) {
  const Vec3 middle = kTumour.cast<float>();
  return isosurface(liver_tumour(),
                    {middle - Vec3::Constant(32.0f), middle + Vec3::Constant(32.0f)},
                    static_cast<float>(0.9 / detail), progress);
}

Mesh liver_vessels_mesh(double detail, const Progress& progress) {
  return capsule_surface(liver_vessels(), 0.45, static_cast<float>(1.0 / std::max(detail, 0.5)),
                         progress);
}

Mesh needle_mesh(double detail, const Progress& progress) {
  const Point out = Point(0.45, -0.72, 0.62).normalized();
  const std::vector<Capsule> parts = {{Point::Zero(), 9 * out, 0.25, 1.5},
                                      {9 * out, 95 * out, 1.5, 1.5},
                                      {95 * out, 125 * out, 3.6, 4.2}};
  return capsule_surface(parts, 0.2, static_cast<float>(0.6 / std::min(detail, 1.5)), progress);
}

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
