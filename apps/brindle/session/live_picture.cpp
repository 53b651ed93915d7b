#include "session/live_picture.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "brindle/base/stopwatch.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/headless_context.h"
#include "brindle/render/slice_refusal.h"
#include "brindle/splats.h"
#include "brindle/styled_picture.h"
#include "pictures/ornaments.h"
#include "pictures/picture.h"
#include "session/draft_size.h"

namespace brindle::tool {
namespace {

constexpr std::uint64_t kNothing = ~std::uint64_t{0};
constexpr float kMostOfLines = 2;  // of drafts: largest reduction of the depths that hide lines

const PictureOptions& picture_of(const LiveState& state) {
  return state.parsed->arguments().picture;
}

const Eigen::Vector3d& origin_of(const LiveState& state) { return state.job->surface->mesh.origin; }

bool is_of_points(const LiveState& state) { return state.job->surface->mesh.triangles.empty(); }

/// The drawn points, which the camera frames.
std::vector<Vec3> drawn_points(const Surface& surface) {
  std::vector<Vec3> points;
  for (std::size_t v = 0; v < surface.normals.size(); ++v) {
    if (!surface.normals[v].isZero(0)) points.push_back(surface.mesh.positions[v]);
  }
  return points;
}

/// How a picture is drawn.
struct DrawSettings {
  PictureQuality quality = PictureQuality::final;
  bool draft = false;
  double before = 0;  ///< milliseconds spent on the frame
  const Progress& progress;
};

}  // namespace

struct LivePicture::Drawing {
  HeadlessContext context;
  std::optional<Renderer> plain;
  std::optional<StyledRenderer> styled;
  std::optional<SplatRenderer> splats;
  std::uint64_t uploaded = kNothing;             ///< `LiveState::pattern`
  std::shared_ptr<const LiveState> kept;         ///< uploaded; `picture` refers to it
  std::optional<StyledPicture> styled_picture;   ///< the uploaded picture
  std::vector<std::vector<float>> other_places;  ///< in the colour map, as uploaded
  std::vector<Vec3> framed;                      ///< framed by the camera
  DraftSize draft_size;

  Image draw(const std::shared_ptr<const LiveState>& state, const DrawSettings& settings);
  void upload(const LiveState& state);
  void upload_plain(const LiveState& state, const LiveState* last);
  void upload_styled(const LiveState& state, const LiveState* last);
  void upload_ornaments(const ShownOrnaments& shown);
  Image draw_glyphs(const LiveState& state, const GlyphPicture& glyphs,
                    const DrawSettings& settings);
  Image draw_plain(const LiveState& state, const DrawSettings& settings);
  Image draw_styled(const LiveState& state, const DrawSettings& settings);
};

namespace {

bool same_mesh(const LiveState& a, const LiveState& b) {
  const Mesh &one = a.job->surface->mesh, &other = b.job->surface->mesh;
  return one.origin == other.origin && one.triangles == other.triangles &&
         one.positions == other.positions;
}

/// Whether both have stripes, or the same tile.
bool same_kind(const StripeResult& a, const StripeResult& b) {
  const Texture *one = a.texture(), *other = b.texture();
  if (one == nullptr || other == nullptr) return one == other;
  const auto* tile = std::get_if<BuiltInTile>(&one->tile);
  const auto* other_tile = std::get_if<BuiltInTile>(&other->tile);
  return tile != nullptr && other_tile != nullptr && *tile == *other_tile;
}

/// Whether only new waves need to be uploaded for a picture without a style.
bool needs_waves_alone(const LiveState& state, const LiveState* last, const Overlay& overlay) {
  if (last != nullptr && ornaments_of(*last) != nullptr) return false;
  if (last == nullptr || last->style || is_of_points(state) || is_of_points(*last)) return false;
  if (!same_kind(state.job->result, last->job->result)) return false;
  // Otherwise, old colours would stay.
  const bool had_colors = picture_of(*last).view != View::stripes;
  return overlay.triangle_colors.empty() != had_colors && same_mesh(state, *last);
}

/// Whether all surfaces but the first are unchanged.
bool same_others(const LiveState& a, const LiveState& b) {
  const RenderOptions &one = picture_of(a).render, &other = picture_of(b).render;
  return a.style->patterns.others == b.style->patterns.others &&
         a.parsed->arguments().style.others == b.parsed->arguments().style.others &&
         a.parsed->arguments().style.flat == b.parsed->arguments().style.flat &&
         one.stripe_color == other.stripe_color && one.stripe_width == other.stripe_width;
}

/// Whether strokes are measured in pixels, of which a smaller picture has fewer.
bool has_pixel_measures(std::span<const StyledSurface> surfaces) {
  return std::ranges::any_of(surfaces, [](const StyledSurface& surface) {
    return std::ranges::any_of(surface.strokes, [](const Strokes& strokes) {
      return strokes.unit == WidthUnit::pixels || strokes.spacing > 0;
    });
  });
}

RenderOptions reduced(RenderOptions render, float reduction) {
  render.mark_radius = mark_radius_of(render) / reduction;
  render.width = reduced_side(render.width, reduction);
  render.height = reduced_side(render.height, reduction);
  return render;
}

StyledOptions reduced(const StyledOptions& options, float reduction) {
  StyledOptions smaller = options;
  smaller.render = reduced(options.render, reduction);
  smaller.right_margin =
      static_cast<int>(std::lround(static_cast<float>(options.right_margin) / reduction));
  return smaller;
}

/// A reduced picture, enlarged to the size of the options.
Image in_full_size(Image image, const RenderOptions& render) {
  if (image.width == render.width && image.height == render.height) return image;
  return enlarged(image, render.width, render.height);
}

}  // namespace

void LivePicture::Drawing::upload_plain(const LiveState& state, const LiveState* last) {
  const Surface& surface = *state.job->surface;
  const StripePattern& pattern = state.job->result.stripes();
  if (is_of_points(state)) {
    const std::vector<float> radii = splat_radii(surface.mesh.positions, *surface.neighborhood);
    if (!splats) splats.emplace();
    framed = drawn_points(surface);
    return splats->upload(splat_drawing_of(surface, pattern, radii));
  }
  const Overlay overlay =
      overlay_of(picture_of(state).view, surface.mesh, pattern.waves, pattern.corners);
  const SurfaceDrawing drawing = drawing_of(surface, state.job->result, overlay);
  if (needs_waves_alone(state, last, overlay)) {
    return plain->update({.waves = drawing.waves,
                          .z = drawing.z,
                          .triangle_colors = drawing.triangle_colors,
                          .marks = drawing.marks,
                          .texture_waves = drawing.texture_waves,
                          .broken_tiles = drawing.broken_tiles});
  }
  if (!plain) plain.emplace();
  framed = points_of_triangles(surface.mesh);
  plain->upload(drawing);
}

void LivePicture::Drawing::upload_styled(const LiveState& state, const LiveState* last) {
  StyledPicture picture =
      tool::styled_picture(*state.job->surface, state.job->result, state.style->patterns,
                           state.parsed->arguments().style, state.style->input, picture_of(state));
  const bool same_colors = other_places == picture.followed.other_places;
  other_places = picture.followed.other_places;
  if (last != nullptr && last->style && same_colors && same_others(state, *last) &&
      same_mesh(state, *last)) {
    styled->update(0, picture.surfaces.front());
  } else {
    if (!styled) styled.emplace();
    styled->upload(picture.surfaces);
    framed = framed_points(picture.surfaces);
  }
  styled_picture.emplace(std::move(picture));
}

void LivePicture::Drawing::upload_ornaments(const ShownOrnaments& shown) {
  if (shown.glyphs) {
    if (!styled) styled.emplace();
    styled->upload(shown.glyphs->surfaces);
    framed = framed_points(shown.glyphs->surfaces);
    return;
  }
  if (!plain) plain.emplace();
  framed = points_of_triangles(shown.ornaments.mesh);
  plain->upload(shown.ornaments.drawing());
}

void LivePicture::Drawing::upload(const LiveState& state) {
  if (uploaded == state.pattern) return;
  const LiveState* last = uploaded == kNothing ? nullptr : kept.get();
  uploaded = kNothing;
  styled_picture.reset();
  if (const ShownOrnaments* shown = ornaments_of(state)) {
    upload_ornaments(*shown);
  } else {
    state.style ? upload_styled(state, last) : upload_plain(state, last);
  }
  uploaded = state.pattern;
}

Image LivePicture::Drawing::draw_styled(const LiveState& state, const DrawSettings& settings) {
  const float reduction = settings.draft ? draft_size.reduction() : 1;
  const StyleOptions& style = state.parsed->arguments().style;
  StyledOptions& options = styled_picture->options;
  options = styled_options(style, picture_of(state), origin_of(state), styled_picture->followed);
  options.render.quality = settings.quality;
  options.framed = framed;
  StyledOptions smaller = options;
  // Drafts omit ambient occlusion.
  if (settings.draft) smaller.occlusion = 0;
  if (!has_pixel_measures(styled_picture->surfaces)) smaller = reduced(smaller, reduction);
  Image image = in_full_size(styled->draw(smaller, settings.progress), options.render);
  // Coarser depths would leave gaps.
  const StyledOptions lines = reduced(options, std::min(reduction, kMostOfLines));
  draw_on_top(image, *styled_picture, style, lines, settings.progress);
  return image;
}

namespace {

/// For glyphs, with the state's camera and size.
StyledOptions glyph_options(const LiveState& state, const GlyphPicture& glyphs) {
  StyledOptions options = glyphs.styled;
  options.render = render_options(picture_of(state), origin_of(state));
  options.right_margin = legend_width(glyphs.legends, options.render.width, options.render.height);
  return options;
}

}  // namespace

Image LivePicture::Drawing::draw_glyphs(const LiveState& state, const GlyphPicture& glyphs,
                                        const DrawSettings& settings) {
  StyledOptions options = glyph_options(state, glyphs);
  options.render.quality = settings.quality;
  options.framed = framed;
  const float reduction = settings.draft ? draft_size.reduction() : 1;
  Image image =
      in_full_size(styled->draw(reduced(options, reduction), settings.progress), options.render);
  draw_legends(image, glyphs.legends);
  return image;
}

Image LivePicture::Drawing::draw_plain(const LiveState& state, const DrawSettings& settings) {
  const float reduction = settings.draft ? draft_size.reduction() : 1;
  RenderOptions render = render_options(picture_of(state), origin_of(state));
  render.quality = settings.quality;
  const RenderOptions smaller = reduced(render, reduction);
  return in_full_size(is_of_points(state) ? splats->draw(smaller) : plain->draw(smaller), render);
}

Image LivePicture::Drawing::draw(const std::shared_ptr<const LiveState>& state,
                                 const DrawSettings& settings) {
  settings.progress.report("drawing", 0);
  Stopwatch watch;
  context.make_current();
  upload(*state);
  kept = state;
  settings.progress.report("drawing", 0.2);
  const double before = settings.before + watch.lap();
  const ShownOrnaments* shown = ornaments_of(*state);
  Image image = shown != nullptr && shown->glyphs ? draw_glyphs(*state, *shown->glyphs, settings)
                : state->style                    ? draw_styled(*state, settings)
                                                  : draw_plain(*state, settings);
  context.check_errors("drawing the picture");
  if (settings.draft) draft_size.note(watch.lap(), before);
  settings.progress.report("drawing", 1);
  return image;
}

LivePicture::LivePicture() : drawing_(std::make_unique<Drawing>()) {}
LivePicture::~LivePicture() {
  // Objects must be freed in this context, whichever is current.
  try {
    drawing_->context.make_current();
  } catch (const Error&) {
  }
}

Image LivePicture::draw(const std::shared_ptr<const LiveState>& state, PictureQuality quality,
                        const Progress& progress) {
  return drawing_->draw(state, {quality, false, 0, progress});
}

Image LivePicture::draft(const std::shared_ptr<const LiveState>& state, double before,
                         const Progress& progress) {
  return drawing_->draw(state, {PictureQuality::interactive, true, before, progress});
}

Camera LivePicture::camera(const LiveState& state) const {
  if (const ShownOrnaments* shown = ornaments_of(state); shown != nullptr && shown->glyphs) {
    return styled_camera(shown->glyphs->surfaces, glyph_options(state, *shown->glyphs));
  }
  if (state.style && drawing_->styled_picture) {
    return styled_camera(drawing_->styled_picture->surfaces, drawing_->styled_picture->options);
  }
  const RenderOptions render = render_options(picture_of(state), origin_of(state));
  return framed_camera(drawing_->framed, render.camera, render.width, render.height);
}

std::string LivePicture::nothing_left(const LiveState& state) const {
  if (!picture_of(state).slice) return "";
  const Camera seen = camera(state);
  if (const ShownOrnaments* shown = ornaments_of(state)) {
    return shown->glyphs ? slice_refusal(shown->glyphs->surfaces, seen, "--slice")
                         : slice_refusal(shown->ornaments.mesh, seen, "--slice");
  }
  if (state.style && drawing_->styled_picture) {
    return slice_refusal(drawing_->styled_picture->surfaces, seen, "--slice");
  }
  return slice_refusal(state.job->surface->mesh, seen, "--slice");
}

namespace {

constexpr int kScaleSteps = 32;

/// As in the library's overlay.
Color color_of(TriangleKind kind) {
  Mesh mesh;
  mesh.positions.resize(3);
  mesh.triangles = {{0, 1, 2}};
  CornerPhases corners;
  corners.kind = kind;
  return branch_overlay(mesh, {&corners, 1}).marks.front().color;
}

ViewLegend branch_legend() {
  ViewLegend legend;
  legend.entries = {{color_of(TriangleKind::branch), "a stripe begins or ends"},
                    {color_of(TriangleKind::field_singularity), "singularity of the field"}};
  return legend;
}

ViewLegend error_legend() {
  ViewLegend legend{"angle between stripes and field", {}, {}, "0", ""};
  for (int i = 0; i < kScaleSteps; ++i) {
    legend.scale.push_back(error_color((static_cast<float>(i) + 0.5f) / kScaleSteps));
  }
  legend.highest = formatted("%g degrees or more", static_cast<double>(kLargestAngleErrorDeg));
  return legend;
}

ViewLegend curves_legend(const ShownCurves& curves, const PictureOptions& picture) {
  ViewLegend legend;
  if (curves.families.size() < 2) return legend;
  for (const CurveFamily& family : curves.families) {
    legend.entries.push_back(
        {ornament_color(family.name == "v", picture.render), "curves of " + family.name});
  }
  return legend;
}

}  // namespace

ViewLegend view_legend(const LiveState& state) {
  if (state.curves) return curves_legend(*state.curves, picture_of(state));
  if (ornaments_of(state) != nullptr) return {};
  switch (picture_of(state).view) {
    case View::stripes:
      return {};
    case View::branches:
      return branch_legend();
    case View::angle_error:
      return error_legend();
  }
  return {};
}

}  // namespace brindle::tool
