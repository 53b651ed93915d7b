#include <algorithm>
#include <cstdio>
#include <string>

#include "gallery/aneurysm.h"
#include "gallery/flows.h"
#include "gallery/items.h"

namespace brindle {
namespace {

constexpr float kSpacing = 0.0055f;  // mm per kPa

/// Samples per mm: spacing proportional to the stress, within limits.
float frequency_of(float stress) { return 1 / std::clamp(kSpacing * stress, 0.25f, 1.5f); }

std::span<const float> floats_of(const GalleryFile& file, std::string_view name) {
  const DataArray& array = *find_array(file.arrays.points, name);
  return {reinterpret_cast<const float*>(array.bytes.data()), array.bytes.size() / sizeof(float)};
}

/// Rows x,y,z,frequency,frequency_v: the direction of the first stress, and spacings proportional
/// to the stresses in both directions.
std::string stress_field(const GalleryFile& wall, const std::vector<Vec3>& directions) {
  const std::span<const float> first = floats_of(wall, "first"), second = floats_of(wall, "second");
  std::string text = "x,y,z,frequency,frequency_v\n";
  for (std::size_t v = 0; v < directions.size(); ++v) {
    const Vec3& d = directions[v];
    char row[160];
    std::snprintf(row, sizeof row, "%.9g,%.9g,%.9g,%.9g,%.9g\n", d.x(), d.y(), d.z(),
                  frequency_of(first[v]), frequency_of(second[v]));
    text += row;
  }
  return text;
}

std::vector<GalleryFile> make_glyphs(double detail, const Progress& progress) {
  std::vector<Vec3> directions;
  GalleryFile wall = aneurysm_wall(detail, &directions, progress.part(0, 0.6));
  GalleryFile field{"stress.csv", {}, {}, stress_field(wall, directions)};
  return {hare_flow(detail, progress.part(0.6, 1)), std::move(wall), std::move(field)};
}

}  // namespace

GalleryItem glyphs_item() {
  return {"glyphs",
          "arrows and ellipses packed by a scalar",
          make_glyphs,
          {{"arrows",
            "arrows along a flow, larger and farther apart where it is faster",
            "sample {surface=flow.vtp} --field {field=array:velocity} --stripes 36 "
            "--frequency-by {values=array:speed}@0.6..1.7,inverse --glyph arrow "
            "--glyph-size 0.95 --color-by {values=array:speed} --legend {own=speed} "
            "--colors #22252b,#f1ece1,#ffffff --up z --camera 35,10,0.93",
            "640x570",
            {"stripes", "frequency-range", "glyph-size", "glyph"}},
           {"ellipses",
            "ellipses whose axes are the principal stresses of an artery's wall",
            "sample {file=aneurysm.vtp} --field {file=stress.csv} --glyph ellipse --glyph-size 0.8 "
            "--color-by array:first@60..220 "
            "--legend 'first principal stress in kPa' --colors #22252b,#f1ece1,#ffffff --up z "
            "--camera 200,12",
            "700x540",
            {"glyph-size", "color-range", "min-distance"}},
           {"decals",
            "the arrows as tiles of a texture, which bend with the surface",
            "stripe {surface=flow.vtp} --field {field=array:velocity} --oriented --texture arrows "
            "--stripes 36 --frequency-by {values=array:speed}@0.6..1.7,inverse "
            "--tile-size-by {values=array:speed}@0.7..1 "
            "--color-by {values=array:speed} --colormap coolwarm --legend {own=speed} "
            "--colors #15171c,#f1ece1,#ffffff --up z --camera 35,10,0.93",
            "640x570",
            {"stripes", "frequency-range", "tile-size-range"}}}};
}

}  // namespace brindle
