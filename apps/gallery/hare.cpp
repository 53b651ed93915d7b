#include "gallery/hare.h"

#include <utility>

#include "gallery/items.h"

namespace brindle {
namespace {

using Point = Eigen::Vector3d;

/// A symmetric pair of parts: `side` is 1 on the left and -1 on the right.
template <class Part>
void add_pair(std::vector<ImplicitFunction>& parts, const Part& part) {
  for (const double side : {1.0, -1.0}) parts.push_back(part(side));
}

void add_body(std::vector<ImplicitFunction>& parts) {
  parts.push_back(ellipsoid({-0.12, 0, 0.56}, {0.62, 0.43, 0.52}, turned(0, -24, 0)));
  parts.push_back(ellipsoid({0.27, 0, 0.66}, {0.33, 0.32, 0.46}, turned(0, 14, 0)));
  parts.push_back(limb({0.32, 0, 0.85}, {0.44, 0, 1.16}, 0.27, 0.2));
  parts.push_back(limb({-0.72, 0, 0.3}, {-0.8, 0, 0.42}, 0.11, 0.13));  // tail
  add_pair(parts, [](double side) {
    return ellipsoid({-0.22, 0.3 * side, 0.4}, {0.4, 0.19, 0.37}, turned(8 * side, -18, 0));
  });
  add_pair(parts, [](double side) {  // hind feet
    return limb({-0.3, 0.4 * side, 0.09}, {0.28, 0.43 * side, 0.08}, 0.1, 0.085);
  });
  add_pair(parts, [](double side) {  // forelegs and paws
    return limb({0.36, 0.17 * side, 0.6}, {0.47, 0.16 * side, 0.12}, 0.13, 0.085);
  });
  add_pair(parts, [](double side) {
    return limb({0.47, 0.16 * side, 0.09}, {0.6, 0.17 * side, 0.08}, 0.09, 0.08);
  });
}

void add_head(std::vector<ImplicitFunction>& parts) {
  parts.push_back(ellipsoid({0.55, 0, 1.33}, {0.33, 0.23, 0.25}, turned(0, 16, 0)));
  parts.push_back(ellipsoid({0.78, 0, 1.23}, {0.16, 0.13, 0.125}, turned(0, 10, 0)));
  add_pair(parts, [](double side) {  // cheeks
    return ellipsoid({0.66, 0.12 * side, 1.2}, {0.16, 0.12, 0.13});
  });
}

/// An ear, hollow on its outer side.
ImplicitFunction ear(double side) {
  const Eigen::Matrix3d turn = turned(-13 * side, -24, 0);
  const Point middle(0.27, 0.17 * side, 1.88);
  const Point outwards = turn * Point(0.5, 0.85 * side, 0).normalized();
  return without(ellipsoid(middle, {0.12, 0.085, 0.48}, turn),
                 ellipsoid(middle + 0.095 * outwards, {0.075, 0.075, 0.36}, turn), 0.014);
}

}  // namespace

ImplicitFunction hare() {
  std::vector<ImplicitFunction> body, all;
  add_body(body);
  add_head(body);
  all.push_back(blended(std::move(body), 0.028));
  add_pair(all, ear);
  add_pair(all, [](double side) {
    return ellipsoid({0.7, 0.172 * side, 1.4}, {0.062, 0.055, 0.062});  // eyes
  });
  return blended(std::move(all), 0.01);
}

Mesh hare_mesh(float edge_length, const Progress& progress) {
  return isosurface(hare(), {{-1.1f, -0.7f, -0.1f}, {1.1f, 0.7f, 2.5f}}, edge_length, progress);
}

Mesh hare_pupils(float edge_length, const Progress& progress) {
  std::vector<ImplicitFunction> pupils;
  add_pair(pupils, [](double side) {
    return ellipsoid({0.712, 0.192 * side, 1.402}, {0.047, 0.042, 0.047});
  });
  return isosurface(blended(std::move(pupils), 0.001), {{0.6f, -0.3f, 1.3f}, {0.8f, 0.3f, 1.5f}},
                    edge_length, progress);
}

Mesh hare_glints(float edge_length, const Progress& progress) {
  std::vector<ImplicitFunction> glints;
  add_pair(glints, [](double side) { return ball({0.724, 0.226 * side, 1.421}, 0.0135); });
  return isosurface(blended(std::move(glints), 0.001), {{0.6f, -0.3f, 1.3f}, {0.8f, 0.3f, 1.5f}},
                    edge_length, progress);
}

Mesh fine_hare_mesh(float edge_length, const Progress& progress) {
  Mesh mesh = hare_mesh(4 * edge_length, progress.part(0, 0.5));
  mesh = subdivide(std::move(mesh), 2, progress.part(0.5, 0.6));
  settle(mesh, hare(), 0.1 * static_cast<double>(edge_length), progress.part(0.6, 1));
  return mesh;
}

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
