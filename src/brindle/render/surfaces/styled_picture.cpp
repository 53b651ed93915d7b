#include "brindle/styled_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "brindle/error.h"
#include "brindle/mesh.h"
#include "brindle/render/surfaces/surface_picture.h"

namespace brindle {
namespace {

/// Positions relative to `origin`.
Mesh moved_to(const Mesh& mesh, const Eigen::Vector3d& origin) {
  Mesh moved = mesh;
  const Vec3 offset = (mesh.origin - origin).cast<float>();
  for (Vec3& position : moved.positions) position += offset;
  moved.origin = origin;
  return moved;
}

GlTexture color_map_texture(ColorMap map) {
  constexpr int kTexels = 256;
  std::vector<Vec3> texels;
  for (int i = 0; i < kTexels; ++i) {
    texels.push_back(linear_light(map_color(map, static_cast<float>(i) / (kTexels - 1))));
  }
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_1D, 1, &name);
  GlTexture texture(name);
  glTextureStorage1D(texture, 1, GL_RGB32F, kTexels);
  glTextureSubImage1D(texture, 0, 0, kTexels, GL_RGB, GL_FLOAT, texels.data());
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  return texture;
}

/// Distances from the camera of the nearest and the farthest point.
Eigen::Vector2f depth_range(std::span<const Vec3> points, const Camera& camera) {
  Eigen::Vector2f range(std::numeric_limits<float>::max(), 0);
  for (const Vec3& point : points) {
    const Vec3 relative = point - camera.origin;
    const float depth = -(camera.view_from_world * relative.homogeneous()).z();
    range = {std::min(range[0], depth), std::max(range[1], depth)};
  }
  if (!(range[1] > range[0])) return {0, 1};
  return range;
}

/// Frames the points in the part of the picture beside the margin.
Camera camera_beside(std::span<const Vec3> points, const RenderOptions& render, int margin) {
  const int width = render.width - margin;
  Camera camera = framed_camera(points, render.camera, width, render.height);
  const float share = static_cast<float>(width) / static_cast<float>(render.width);
  camera.clip_from_view.row(0) *= share;
  camera.clip_from_view.row(0) -= (1 - share) * camera.clip_from_view.row(3);
  return camera;
}

void check_styled_options(const StyledOptions& options) {
  check_options(options.render);
  if (!(options.occlusion >= 0 && options.occlusion <= 1)) {
    throw Error("occlusion is a number from 0 to 1, not " + std::to_string(options.occlusion));
  }
  if (options.right_margin < 0 || options.right_margin >= options.render.width) {
    throw Error("the margin of " + std::to_string(options.right_margin) +
                " pixels leaves no room for the picture");
  }
}

}  // namespace

std::vector<float> rescaled(std::span<const float> values, float lowest, float highest, float first,
                            float last) {
  std::vector<float> result(values.begin(), values.end());
  for (float& value : result) {
    if (std::isnan(value)) continue;
    const float place =
        highest > lowest ? (value - lowest) / (highest - lowest) : (value < lowest ? 0.0f : 1.0f);
    value = first + std::clamp(place, 0.0f, 1.0f) * (last - first);
  }
  return result;
}

std::vector<Vec3> framed_points(std::span<const StyledSurface> surfaces) {
  std::vector<Vec3> points;
  for (const StyledSurface& styled : surfaces) {
    const Vec3 offset = (styled.mesh.origin - surfaces.front().mesh.origin).cast<float>();
    for (const Vec3& point : points_of_triangles(styled.mesh)) points.push_back(point + offset);
  }
  return points;
}

Camera styled_camera(std::span<const StyledSurface> surfaces, const StyledOptions& options) {
  check_styled_options(options);
  if (!options.framed.empty()) {
    return camera_beside(options.framed, options.render, options.right_margin);
  }
  return camera_beside(framed_points(surfaces), options.render, options.right_margin);
}

struct StyledRenderer::State {
  SurfacePicture picture;
  std::vector<Mesh> meshes;  ///< of the surfaces, relative to the origin of the first
  std::vector<Vec3> points;  ///< of all surfaces, framed by cameras
  float diagonal = 0;

  void number_triangles();
  std::optional<GroundShadow> shadow(const Camera& camera, UpAxis up) const;
};

StyledRenderer::StyledRenderer() : state_(std::make_unique<State>()) {}

StyledRenderer::~StyledRenderer() = default;
StyledRenderer::StyledRenderer(StyledRenderer&&) noexcept = default;
StyledRenderer& StyledRenderer::operator=(StyledRenderer&&) noexcept = default;

namespace {

/// The surface without its style.
SurfaceDrawing drawing_of(const StyledSurface& styled, const Mesh& mesh) {
  SurfaceDrawing drawing{.mesh = mesh, .normals = styled.normals};
  if (!styled.strokes.empty()) {
    drawing.waves = styled.strokes.front().waves;
    drawing.z = styled.strokes.front().z;
  }
  if (styled.texture) {
    drawing.texture_waves = styled.texture->waves;
    drawing.texture_tile = &styled.texture->tiles.front().tile;
  }
  return drawing;
}

DrawnSurface drawn_surface(const StyledSurface& styled, const Mesh& mesh) {
  DrawnSurface drawn{{}, GlStyle(styled), styled.tinted, styled.sliced};
  drawn.surface.upload(drawing_of(styled, mesh));
  return drawn;
}

/// Whether buffers can be kept, with new values.
bool has_buffers_of(const DrawnSurface& drawn, const Mesh& mesh, const StyledSurface& styled) {
  return mesh.triangles == styled.mesh.triangles &&
         mesh.vertex_count() == styled.mesh.vertex_count() &&
         drawn.surface.has_normals() == !styled.normals.empty() &&
         drawn.surface.has_waves() == !styled.strokes.empty() &&
         drawn.surface.has_texture() == styled.texture.has_value();
}

void check_triangle_count(std::size_t count) {
  if (count <= std::numeric_limits<int>::max()) return;
  throw Error("the surfaces have more triangles than a picture can number");
}

}  // namespace

/// Numbers the triangles of all surfaces, and collects their points.
void StyledRenderer::State::number_triangles() {
  int number = 0;
  points.clear();
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    picture.surfaces[i].first_number = number;
    number += static_cast<int>(meshes[i].triangle_count());
    const std::vector<Vec3> more = points_of_triangles(meshes[i]);
    points.insert(points.end(), more.begin(), more.end());
  }
  Eigen::AlignedBox3f box;
  for (const Vec3& point : points) box.extend(point);
  diagonal = points.empty() ? 0 : box.diagonal().norm();
}

void StyledRenderer::upload(std::span<const StyledSurface> surfaces) {
  if (surfaces.empty()) throw Error("cannot draw a picture of no surface; add one");
  std::vector<Mesh> meshes;
  std::vector<DrawnSurface> drawn;
  std::size_t triangles = 0;
  for (const StyledSurface& styled : surfaces) {
    check_triangle_count(triangles += styled.mesh.triangle_count());
    meshes.push_back(moved_to(styled.mesh, surfaces.front().mesh.origin));
    drawn.push_back(drawn_surface(styled, meshes.back()));
  }
  state_->meshes = std::move(meshes);
  state_->picture.surfaces = std::move(drawn);
  state_->number_triangles();
}

void StyledRenderer::update(std::size_t number, const StyledSurface& surface) {
  State& s = *state_;
  if (number >= s.meshes.size()) {
    throw Error("there is no surface " + std::to_string(number) + " to update; upload it");
  }
  DrawnSurface& drawn = s.picture.surfaces[number];
  Mesh& last = s.meshes[number];
  Mesh mesh = moved_to(surface.mesh, s.meshes.front().origin);
  if (has_buffers_of(drawn, last, surface)) {
    GlStyle style(surface, &*drawn.style);
    const SurfaceDrawing drawing = drawing_of(surface, mesh);
    const bool stays = mesh.positions == last.positions;
    drawn.surface.update({.positions = stays ? std::span<const Vec3>() : mesh.positions,
                          .normals = drawing.normals,
                          .waves = drawing.waves,
                          .z = drawing.z,
                          .texture_waves = drawing.texture_waves});
    drawn.style = std::move(style);
    drawn.tinted = surface.tinted;
    drawn.sliced = surface.sliced;
    if (stays) return;
  } else {
    std::size_t triangles = surface.mesh.triangle_count();
    for (const Mesh& other : s.meshes) triangles += other.triangle_count();
    check_triangle_count(triangles - last.triangle_count());
    drawn = drawn_surface(surface, mesh);
  }
  last = std::move(mesh);
  s.number_triangles();
}

/// The ground shadow, unless nothing casts one.
std::optional<GroundShadow> StyledRenderer::State::shadow(const Camera& camera, UpAxis up) const {
  Mesh all;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const bool cut = camera.slice && picture.surfaces[i].sliced;
    append(cut ? left_by(*camera.slice, meshes[i]) : meshes[i], all);
  }
  drop_unreferenced_vertices(all);  // they would lower the ground
  GroundShadow shadow = ground_shadow(all.positions, all.triangles, ground_axes(up));
  if (shadow.missing.empty()) return std::nullopt;
  return shadow;
}

Image StyledRenderer::draw(const StyledOptions& options, const Progress& progress) const {
  check_styled_options(options);
  State& s = *state_;
  const auto framed = options.framed.empty() ? std::span<const Vec3>(s.points) : options.framed;
  PictureScene scene{camera_beside(framed, options.render, options.right_margin), options};
  scene.color_map = color_map_texture(options.scale.map);
  scene.diagonal = s.diagonal;
  if (options.depth_cue != DepthCue::none) scene.depths = depth_range(s.points, scene.camera);
  std::optional<GroundShadow> shadow;
  if (options.ground_shadow) shadow = s.shadow(scene.camera, options.render.camera.up);
  return s.picture.draw(scene, shadow, {}, progress);
}

Image render_styled(std::span<const StyledSurface> surfaces, const StyledOptions& options,
                    const Progress& progress) {
  check_styled_options(options);
  return drawn_alone<StyledRenderer>(surfaces, options, "drawing the picture", progress);
}

}  // namespace brindle
