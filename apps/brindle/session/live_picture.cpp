#include "live_picture.h"

#include <optional>
#include <utility>

#include "brindle/headless_context.h"
#include "brindle/splats.h"
#include "brindle/styled_picture.h"
#include "picture_options.h"

namespace brindle::tool {
namespace {

constexpr std::uint64_t kNothing = ~std::uint64_t{0};

const PictureOptions& picture_of(const LiveState& state) {
  return *state.parsed->arguments().picture;
}

bool is_of_points(const LiveState& state) { return state.job->surface->mesh.triangles.empty(); }

/// The points that the camera frames: those that are drawn.
std::vector<Vec3> drawn_points(const Surface& surface) {
  std::vector<Vec3> points;
  for (std::size_t v = 0; v < surface.normals.size(); ++v) {
    if (!surface.normals[v].isZero(0)) points.push_back(surface.mesh.positions[v]);
  }
  return points;
}

}  // namespace

struct LivePicture::Drawing {
  HeadlessContext context;
  std::optional<Renderer> plain;
  std::optional<StyledRenderer> styled;
  std::optional<SplatRenderer> splats;
  std::uint64_t uploaded = kNothing;            ///< `LiveState::pattern`
  std::shared_ptr<const LiveState> kept;        ///< what `picture` refers to
  std::optional<StyledPicture> styled_picture;  ///< that was uploaded

  void upload(const LiveState& state);
  void upload_plain(const LiveState& state);
  Image draw(const LiveState& state, PictureQuality quality);
  Image draw_styled(const LiveState& state, PictureQuality quality);
};

void LivePicture::Drawing::upload_plain(const LiveState& state) {
  const Surface& surface = *state.job->surface;
  const StripePattern& pattern = state.job->result.stripes();
  if (is_of_points(state)) {
    const std::vector<float> radii = splat_radii(surface.mesh.positions, *surface.neighborhood);
    if (!splats) splats.emplace();
    return splats->upload(splat_drawing_of(surface, pattern, radii));
  }
  const Overlay overlay =
      overlay_of(picture_of(state).view, surface.mesh, pattern.waves, pattern.corners);
  if (!plain) plain.emplace();
  plain->upload(drawing_of(surface, state.job->result, overlay));
}

void LivePicture::Drawing::upload(const LiveState& state) {
  if (uploaded == state.pattern) return;
  uploaded = kNothing;
  styled_picture.reset();
  if (state.style) {
    const StyleOptions& style = state.parsed->arguments().style;
    StyledPicture picture =
        tool::styled_picture(*state.job->surface, state.job->result, state.style->patterns, style,
                             state.style->input, picture_of(state));
    if (!styled) styled.emplace();
    styled->upload(picture.surfaces);
    styled_picture.emplace(std::move(picture));
  } else {
    upload_plain(state);
  }
  uploaded = state.pattern;
}

Image LivePicture::Drawing::draw_styled(const LiveState& state, PictureQuality quality) {
  const StyleOptions& style = state.parsed->arguments().style;
  styled_picture->options = styled_options(style, picture_of(state), styled_picture->followed);
  styled_picture->options.render.quality = quality;
  Image image = styled->draw(styled_picture->options);
  draw_on_top(image, *styled_picture, style);
  return image;
}

Image LivePicture::Drawing::draw(const LiveState& state, PictureQuality quality) {
  if (state.style) return draw_styled(state, quality);
  RenderOptions render = render_options(picture_of(state));
  render.quality = quality;
  return is_of_points(state) ? splats->draw(render) : plain->draw(render);
}

LivePicture::LivePicture() : drawing_(std::make_unique<Drawing>()) {}
LivePicture::~LivePicture() = default;

Image LivePicture::draw(const std::shared_ptr<const LiveState>& state, PictureQuality quality,
                        const Progress& progress) {
  Drawing& d = *drawing_;
  progress.report("drawing", 0);
  d.context.make_current();
  d.upload(*state);
  d.kept = state;
  progress.report("drawing", 0.2);
  Image image = d.draw(*state, quality);
  d.context.check_errors("drawing the picture");
  progress.report("drawing", 1);
  return image;
}

Camera LivePicture::camera(const LiveState& state) const {
  const RenderOptions render = render_options(picture_of(state));
  if (state.style && drawing_->styled_picture) {
    StyledOptions options = drawing_->styled_picture->options;
    return styled_camera(drawing_->styled_picture->surfaces, options);
  }
  const Surface& surface = *state.job->surface;
  const std::vector<Vec3> points =
      is_of_points(state) ? drawn_points(surface) : points_of_triangles(surface.mesh);
  return framed_camera(points, render.camera, render.width, render.height);
}

const std::string& LivePicture::renderer() const { return drawing_->context.renderer(); }

}  // namespace brindle::tool
